// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/surface_as_read.h>

#include "mend/loops.h"

namespace CGAL {
namespace Reeb_quadrangulation {

Triangle_surface surface_as_read(const Polygon_soup& soup, const Mended_surface& mended) {
  Triangle_surface result;
  result.points = soup.points;
  result.triangles = triangulate_polygons(soup, result.points).triangles;
  for (const Mended_component& component : mended.components)
    for (std::size_t t = 0; t < component.face_of_triangle.size(); ++t) {
      if (component.face_of_triangle[t] >= 0) continue;
      const int first = result.number_of_vertices();
      for (int v : component.surface.triangles[t]) result.points.push_back(component.surface.points[v]);
      result.triangles.push_back({first, first + 1, first + 2});
    }
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
