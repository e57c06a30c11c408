// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MULTIFRONTAL_SOLVER_H
#define CGAL_REEB_QUADRANGULATION_MULTIFRONTAL_SOLVER_H

#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A multifrontal Cholesky factorization (Duff and Reid 1983, Liu 1992) for sparse symmetric positive
/// definite matrices: the solver of the fields and of the charts. A model of the concept `LinearSolver`.
///
/// Unknowns are ordered by approximate minimum degree and eliminated in dense fronts along the elimination
/// tree. The same matrix gives the same bits: with one thread or more, incrementally or from scratch,
/// whatever the machine's vector unit and the build.
///
/// For the Laplacian of a surface with n vertices: about 40 n numbers of memory and O(n^1.5) time, little
/// more than linear in practice.
class Multifrontal_solver {
public:
  /// Nested dissection takes up to twice the time of minimum degree to find; on surfaces with more than some
  /// ten thousand vertices the factorization then needs half of the operations and less of them after a local
  /// change.
  enum class Ordering { by_size, minimum_degree, nested_dissection };

  Multifrontal_solver();
  ~Multifrontal_solver();
  Multifrontal_solver(Multifrontal_solver&&) noexcept;
  Multifrontal_solver& operator=(Multifrontal_solver&&) noexcept;

  /// The number of threads for factorizations, 1 at first. Changes nothing but the time.
  void set_threads(int threads);

  /// How the next `analyze` orders the unknowns. At first `by_size`: nested dissection from 30,000 unknowns
  /// on.
  void set_ordering(Ordering ordering);

  /// Whether a factorization keeps the fronts' update matrices, which doubles the memory. Then the next one,
  /// of a matrix of the same pattern, eliminates again only the fronts that depend on changed entries. Off at
  /// first.
  void set_incremental(bool incremental);

  /// Orders the unknowns and prepares the factorization of every matrix with the pattern of `pattern` (its
  /// values are not read). Nearly linear.
  Result<void> analyze(const Symmetric_matrix& pattern);

  /// The same without the search for an order: `order` lists all unknowns as they are to be eliminated. What
  /// an order that serves a matrix leaves of a part of its unknowns serves that part, with no more fill.
  Result<void> analyze(const Symmetric_matrix& pattern, const std::vector<int>& order);

  /// Factorizes; analyzes first where the pattern is not the one last analyzed. Fails with `solver_failure`,
  /// naming the row as the error's index, where a pivot is not above 1e-13 of the diagonal entry it was:
  /// there the matrix is not positive definite, or is singular but for rounding.
  Result<void> factorize(const Symmetric_matrix& matrix);

  /// Replaces each of the `right_hand_sides` columns of `x` (column-major, `size()` entries each) by the
  /// solution, whose bits do not depend on the other columns. Fails with `solver_failure` if the last
  /// `factorize` did not succeed. Uses scratch memory of the solver: call it from one thread at a time.
  Result<void> solve(double* x, int right_hand_sides = 1) const;

  /// The unknowns as they are eliminated; empty before the first `analyze`.
  const std::vector<int>& elimination_order() const;
  int size() const; ///< unknowns
  int number_of_fronts() const;
  int eliminated_fronts() const;   ///< by the last factorization
  std::size_t factor_size() const; ///< numbers that the factor stores
  double operations() const;       ///< multiplications and additions of a full factorization

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MULTIFRONTAL_SOLVER_H
