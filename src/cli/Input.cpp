// SPDX-License-Identifier: GPL-3.0-or-later
#include "Input.h"

#include "Failure.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

Polygon_soup read_soup(const std::string& file) {
  return value_or_fail(read_polygon_soup(file), file);
}

Quad_mesh quads_of(const Polygon_soup& soup, const std::string& file) {
  Quad_mesh mesh;
  mesh.points = soup.points;
  mesh.quads.reserve(std::size_t(soup.number_of_polygons()));
  for (int p = 0; p < soup.number_of_polygons(); ++p) {
    if (soup.size_of_polygon(p) != 4)
      throw Failure(Exit_code::not_a_surface, file + ": face " + std::to_string(p) + " has " +
                                                  std::to_string(soup.size_of_polygon(p)) +
                                                  " corners; a quad mesh is needed");
    const int* corner = soup.corner.data() + soup.begin[p];
    mesh.quads.push_back({corner[0], corner[1], corner[2], corner[3]});
  }
  return mesh;
}

Triangle_surface joined(const Mended_surface& mended) {
  Triangle_surface all;
  for (const Mended_component& component : mended.components) {
    const int first = all.number_of_vertices();
    all.points.insert(all.points.end(), component.surface.points.begin(), component.surface.points.end());
    for (const Triangle& t : component.surface.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

} // namespace reebquad
