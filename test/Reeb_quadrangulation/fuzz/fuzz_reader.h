// SPDX-License-Identifier: GPL-3.0-or-later
// What every fuzz target does with its bytes: read, check, mend, and hold the promises of these three.
#ifndef REEBQUAD_FUZZ_READER_H
#define REEBQUAD_FUZZ_READER_H

#include "fuzz_promise.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <cstdint>

namespace fuzz {

using namespace CGAL::Reeb_quadrangulation;

inline int read(const std::uint8_t* data, std::size_t size, Mesh_format format) {
  const Result<Polygon_soup> soup = parse_polygon_soup(reinterpret_cast<const char*>(data), size, format);
  if (!soup) {
    promise(!soup.error().message.empty());
    return 0;
  }
  promise(soup->begin.front() == 0 && soup->begin.back() == int(soup->corner.size()));
  for (int p = 0; p < soup->number_of_polygons(); ++p) promise(soup->size_of_polygon(p) >= 0);
  for (int v : soup->corner) promise(v >= 0 && v < soup->number_of_points());

  to_json(check_surface(*soup));
  Mend_options options;
  options.fill_holes = size % 2 == 0 ? 20 : 0;
  options.cut_non_manifold_edges = size % 3 == 0;
  Result<Mended_surface> mended = mend_surface(*soup, options);
  if (!mended)
    promise(mended.error().code == Error_code::not_a_surface);
  else
    for (Mended_component& c : mended->components) {
      promise(bool(c.surface.connect()));
      promise(connected_components(c.surface).second == 1);
      promise(c.point_of_vertex.size() == c.surface.points.size());
      promise(c.face_of_triangle.size() == c.surface.triangles.size());
    }
  return 0;
}

} // namespace fuzz

#endif // REEBQUAD_FUZZ_READER_H
