// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_POLYGON_SOUP_H
#define CGAL_REEB_QUADRANGULATION_IO_POLYGON_SOUP_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Points and polygons as a file gives them, before anything is known about them: coordinates may be NaN or
/// infinite, polygons may have any number of corners (also fewer than three) and any connection.
///
/// The corners of polygon `p` are `corner[begin[p]] .. corner[begin[p + 1] - 1]`. Every corner is an index of
/// a point: readers guarantee it, and the functions that take a soup require it.
struct Polygon_soup {
  std::vector<Point> points;
  std::vector<int> begin = {0}; ///< number of polygons + 1 entries, not decreasing
  std::vector<int> corner;

  int number_of_points() const { return int(points.size()); }
  int number_of_polygons() const { return int(begin.size()) - 1; }
  int size_of_polygon(int p) const { return begin[p + 1] - begin[p]; }
  /// Ends the polygon whose corners were appended to `corner` since the last call.
  void close_polygon() { begin.push_back(int(corner.size())); }
};

/// The soup with the points and the triangles of `surface`.
Polygon_soup polygon_soup(const Triangle_surface& surface);

/// The soup with the points and the quads of `mesh`.
Polygon_soup polygon_soup(const Quad_mesh& mesh);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_POLYGON_SOUP_H
