// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_STRICTLY_INCREASING_H
#define REEBQUAD_BASE_STRICTLY_INCREASING_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Whether every entry is greater than the one before. NaN is not.
inline bool strictly_increasing(const std::vector<double>& x) {
  return std::adjacent_find(x.begin(), x.end(), [](double a, double b) { return !(a < b); }) == x.end();
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_STRICTLY_INCREASING_H
