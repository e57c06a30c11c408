// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_LINEAR_SMALLEST_PIVOT_H
#define REEBQUAD_LINEAR_SMALLEST_PIVOT_H

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A pivot this small against the diagonal entry it was is what rounding leaves of zero.
constexpr double smallest_pivot_ratio = 1e-13;

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_LINEAR_SMALLEST_PIVOT_H
