// SPDX-License-Identifier: GPL-3.0-or-later
// T-junctions: points of one side of an edge that the other side does not have.
#ifndef REEBQUAD_MEND_JUNCTIONS_H
#define REEBQUAD_MEND_JUNCTIONS_H

#include "mend/corners.h"
#include "mend/loose_triangles.h"

namespace CGAL {
namespace Reeb_quadrangulation {

/// Border points on the inside of a side that has no neighbour, in the order in which they lie on it.
struct Junctions {
  int side = -1;
  std::vector<int> points;
};

/// For each of the `sides`, which have no neighbour: the points at their ends nearer than `distance` to the
/// inside of the side, without the corners of its face. O(n log n) unless many points lie on many sides.
std::vector<Junctions> find_junctions(const std::vector<Point>& points, const Corner_mesh& mesh,
                                      const std::vector<int>& sides, double distance);

/// Divides the faces with such sides where that closes an edge and gives none more than two faces.
void mend_junctions(Loose_triangles& soup, double distance, std::vector<Mend>& mends);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_JUNCTIONS_H
