// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the single formats; the doors to them are in IO/read_polygon_soup.h.
#ifndef REEBQUAD_IO_READERS_H
#define REEBQUAD_IO_READERS_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The largest number of points, polygons or corners: indices are of type `int`.
constexpr std::int64_t largest_count = std::numeric_limits<int>::max() - 1;

Result<Polygon_soup> parse_off(const char* data, std::size_t size);
Result<Polygon_soup> parse_obj(const char* data, std::size_t size);
Result<Polygon_soup> parse_ply(const char* data, std::size_t size);
Result<Polygon_soup> parse_stl(const char* data, std::size_t size);

/// For each point the first point with the same coordinates (-0 and 0 are the same; NaN is only itself).
std::vector<int> first_equal_points(const std::vector<Point>& points);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_IO_READERS_H
