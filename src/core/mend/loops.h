// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations of closed loops of points: polygons with more than three corners, and holes.
#ifndef REEBQUAD_MEND_LOOPS_H
#define REEBQUAD_MEND_LOOPS_H

#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The triangulation of a loop that costs least: area, and a little for long sides. `allowed(i, j)` tells
/// whether positions i < j of the loop, which are no neighbours, may be joined. Appends n - 2 triples of
/// increasing positions; false if there is no triangulation. O(n^3). By dynamic programming, after Barequet
/// and Sharir, "Filling gaps in the boundary of a polyhedron", 1995.
bool triangulate_loop(const std::vector<Point>& loop, const std::function<bool(int, int)>& allowed,
                      std::vector<Triangle>& triangles);

/// Triangles instead of polygons; `face_of_triangle` gives each its polygon. A polygon whose diagonals are
/// edges already, or whose triangulation would take too long, gets a point in its middle, appended to
/// `points`. Corners that repeat their predecessor are skipped; polygons with fewer than three corners left
/// are dropped.
struct Triangulated_polygons {
  std::vector<Triangle> triangles;
  std::vector<int> face_of_triangle;
  std::int64_t polygons = 0; ///< triangulated, with more than three corners
  std::int64_t dropped = 0;
};
Triangulated_polygons triangulate_polygons(const Polygon_soup& soup, std::vector<Point>& points);

/// Fills the boundary loops of at most `largest` edges of a connected surface; the number filled. The new
/// triangles have face -1 in `component`. `connect()` is due afterwards.
int fill_holes(Mended_component& component, int largest);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_LOOPS_H
