// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CHOLMOD_SOLVER_H
#define CGAL_REEB_QUADRANGULATION_CHOLMOD_SOLVER_H

#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <memory>
#include <vector>

#ifndef REEBQUAD_WITHOUT_CHOLMOD // as the library was built

namespace CGAL {
namespace Reeb_quadrangulation {

/// CHOLMOD's Cholesky factorization (Chen, Davis, Hager and Rajamanickam 2008): a model of the concept
/// `LinearSolver`, and the one whose factor can be updated. Its bits depend on the BLAS library and its
/// threads.
///
/// Factorizations are supernodal; the first update after one converts the factor to the simplicial form.
class Cholmod_solver {
public:
  /// How `analyze` orders the unknowns; nested dissection takes longer and leaves fewer entries.
  enum class Ordering { minimum_degree, nested_dissection };

  explicit Cholmod_solver(Ordering ordering = Ordering::minimum_degree);
  ~Cholmod_solver();
  Cholmod_solver(Cholmod_solver&&) noexcept;
  Cholmod_solver& operator=(Cholmod_solver&&) noexcept;

  /// Whether the factor is kept as `factorize()` made it when updates change it, for twice the memory. Then
  /// `factorize()` of the same matrix goes back to it, which undoes the updates without a trace. Off at
  /// first.
  void set_incremental(bool incremental);

  /// Orders the unknowns and counts the factor's entries; the values of `pattern` are not read.
  Result<void> analyze(const Symmetric_matrix& pattern);

  /// The same without the search for an order: `order` lists all unknowns as they are to be eliminated, but
  /// for changes that leave the fill as it is.
  Result<void> analyze(const Symmetric_matrix& pattern, const std::vector<int>& order);

  /// Factorizes; analyzes first where the pattern is new. Fails with `solver_failure` where CHOLMOD's status
  /// says so and, naming the row, where a pivot is not above 1e-13 of the diagonal entry it was.
  Result<void> factorize(const Symmetric_matrix& matrix);

  /// Replaces each of the `right_hand_sides` columns of `x` (column-major, `size()` entries each) by the
  /// solution.
  Result<void> solve(double* x, int right_hand_sides = 1) const;

  /// Adds `amounts[k]` to the diagonal of row `rows[k]` by rank-one updates, or downdates where negative. A
  /// downdate that would leave the matrix indefinite fails and leaves no factor. Errors accumulate over many
  /// updates: see the residual. About 0.2 ms a row for 200,000 unknowns.
  Result<void> add_to_diagonal(const std::vector<int>& rows, const std::vector<double>& amounts);

  /// The unknowns as they are eliminated; empty before the first `analyze()`.
  const std::vector<int>& elimination_order() const;
  int size() const; ///< unknowns

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_WITHOUT_CHOLMOD

#endif // CGAL_REEB_QUADRANGULATION_CHOLMOD_SOLVER_H
