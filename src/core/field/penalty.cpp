// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/penalty.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

double penalty_of(const Symmetric_matrix& m) {
  double largest = 0;
  for (int j = 0; j < m.size; ++j) largest = std::max(largest, m.value[m.column_begin[j]]);
  return penalty_factor * largest;
}

double penalized_residual(const Symmetric_matrix& m, const std::vector<int>& penalized, const double* x,
                          const double* b) {
  if (penalized.empty()) return relative_residual(m, x, b);
  std::vector<double> scale(m.size, 1.0);
  for (const int v : penalized) scale[v] = 1 / penalty_factor;
  return relative_residual(m, x, b, scale);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
