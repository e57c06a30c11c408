// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_EIGEN_SOLVER_H
#define CGAL_REEB_QUADRANGULATION_EIGEN_SOLVER_H

#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <memory>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Eigen's simplicial LDL' factorization: a small, slower model of the concept `LinearSolver` that depends on
/// nothing else, kept as an independent reference.
class Eigen_solver {
public:
  Eigen_solver();
  ~Eigen_solver();
  Eigen_solver(Eigen_solver&&) noexcept;
  Eigen_solver& operator=(Eigen_solver&&) noexcept;

  /// Orders the unknowns by approximate minimum degree and counts the factor's entries.
  Result<void> analyze(const Symmetric_matrix& pattern);

  /// Factorizes; analyzes first where the pattern is new. Eigen accepts indefinite and singular matrices
  /// here; this refuses a pivot that is not above 1e-13 of its diagonal entry, with `solver_failure` and the
  /// row.
  Result<void> factorize(const Symmetric_matrix& matrix);

  /// Replaces each of the `right_hand_sides` columns of `x` (column-major, `size()` entries each) by the
  /// solution.
  Result<void> solve(double* x, int right_hand_sides = 1) const;

  int size() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_EIGEN_SOLVER_H
