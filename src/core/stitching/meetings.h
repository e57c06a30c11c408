// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_STITCHING_MEETINGS_H
#define REEBQUAD_STITCHING_MEETINGS_H

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A vertex of one side of a line, at a distance along the line.
struct Stop {
  double at;
  int vertex;
};

/// Entries of two lists of stops that meet, in order; -1 for a stop that meets none.
using Meetings = std::vector<std::array<int, 2>>;

/// Stops of the two sides in the same place meet. Between two such places every stop of the side with fewer
/// meets one of the other, so that the sum of their distances is least. \pre Both lists increase.
Meetings meet(const std::vector<Stop>& a, const std::vector<Stop>& b);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_STITCHING_MEETINGS_H
