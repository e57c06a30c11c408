// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MULTIFRONTAL_SOLVER_H
#define CGAL_REEB_QUADRANGULATION_MULTIFRONTAL_SOLVER_H

#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <memory>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A multifrontal Cholesky factorization for sparse symmetric positive definite matrices: the solver of the
/// fields and of the charts. A model of the concept `LinearSolver`.
///
/// The same matrix gives the same bits, with one thread or two, whatever the vector unit of the machine.
class Multifrontal_solver {
public:
  Multifrontal_solver();
  ~Multifrontal_solver();
  Multifrontal_solver(Multifrontal_solver&&) noexcept;
  Multifrontal_solver& operator=(Multifrontal_solver&&) noexcept;

  /// Orders the unknowns and prepares the factorization of every matrix with the pattern of `pattern` (its
  /// values are not read).
  Result<void> analyze(const Symmetric_matrix& pattern);

  /// Factorizes; analyzes first where the pattern is not the one last analyzed. Fails with `solver_failure`,
  /// naming the row, where the matrix is not positive definite.
  Result<void> factorize(const Symmetric_matrix& matrix);

  /// Replaces each of the `right_hand_sides` columns of `x` (column-major, `size()` entries each) by the
  /// solution. Uses scratch memory of the solver: call it from one thread at a time. \pre The last
  /// `factorize` succeeded.
  Result<void> solve(double* x, int right_hand_sides = 1) const;

  int size() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MULTIFRONTAL_SOLVER_H
