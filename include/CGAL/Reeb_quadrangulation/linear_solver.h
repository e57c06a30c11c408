// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_LINEAR_SOLVER_H
#define CGAL_REEB_QUADRANGULATION_LINEAR_SOLVER_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The lower triangle, diagonal included, of a sparse symmetric matrix in compressed columns; row indices of
/// a column increase, so the diagonal comes first.
struct Symmetric_matrix {
  int size = 0;
  std::vector<int> column_begin; ///< size + 1 entries
  std::vector<int> row;
  std::vector<double> value;
};

/// Checks the form that `Symmetric_matrix` promises: consistent array sizes, increasing rows, a diagonal
/// entry first in every column. Fails with `solver_failure`, naming the row. O(entries).
Result<void> check_pattern(const Symmetric_matrix& matrix);

/// Whether two matrices store the same entries, whatever their values. O(entries).
bool same_pattern(const Symmetric_matrix& a, const Symmetric_matrix& b);

/// y = A x for one vector of `matrix.size` entries. O(entries).
void multiply(const Symmetric_matrix& matrix, const double* x, double* y);

/// The normwise backward error |b - A x| / (|A| |x| + |b|), in the maximum norm: about 1e-16 for a stable
/// solve, whatever the scale of the matrix and its condition. With `row_scale`, one factor for each row, of
/// the equations multiplied by these. Not-a-number and infinite entries give infinity. O(entries).
double relative_residual(const Symmetric_matrix& matrix, const double* x, const double* b,
                         const std::vector<double>& row_scale = {});

/// The largest `relative_residual` that the solves of this library accept.
constexpr double largest_accepted_residual = 1e-10;

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_LINEAR_SOLVER_H
