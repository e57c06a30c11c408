// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgReebQuadrangulationConcepts
\cgalConcept

The concept `LinearSolver` describes a direct solver for sparse symmetric positive definite matrices whose
three steps can be repeated one without the other: many matrices share an analysis, many right-hand sides a
factorization.

A solver is default constructible and movable. It is used by one thread at a time, `solve()` included, because
scratch memory belongs to it; different solvers are independent. Failures come back as results with
`Error_code::solver_failure`; after one the solver may be used again as if it were new.

Fields and charts' maps take any model: `sparse_linear_solver<Solver>()` in `Field_solver_options`. They check
the residual of what it finds.

A model may also have the members of the second group below. `Any_linear_solver` finds them when the model is
put in, and does without what is missing.

\cgalHasModel `CGAL::Reeb_quadrangulation::Multifrontal_solver`
\cgalHasModel `CGAL::Reeb_quadrangulation::Cholmod_solver`
\cgalHasModel `CGAL::Reeb_quadrangulation::Eigen_solver`
\cgalHasModel `CGAL::Reeb_quadrangulation::Any_linear_solver`
*/
class LinearSolver {
public:
  /// Prepares the factorization of every matrix that has the pattern of `pattern`, whose values are not read.
  /// Fails if the arrays are not those of a lower triangle with its diagonal first and increasing rows.
  Result<void> analyze(const Symmetric_matrix& pattern);

  /// Factorizes `matrix`, after analyzing it where its pattern is not the one last analyzed. Fails where the
  /// matrix is not positive definite, or is singular but for rounding; the error's index is then a row of the
  /// matrix at which the elimination fails, where the model knows it. Models agree on what is refused as long
  /// as no pivot comes close to 1e-13 of the diagonal entry it was.
  Result<void> factorize(const Symmetric_matrix& matrix);

  /// Replaces the columns of `x` by the solutions: column-major, `size()` numbers a column. Fails if the last
  /// `factorize()` did not succeed. That a solution is accurate is for the caller to check: see
  /// `relative_residual()`.
  Result<void> solve(double* x, int right_hand_sides = 1) const;

  /// The number of unknowns of the matrix last analyzed.
  int size() const;

  /// \name Optional
  /// @{

  /// The same as `analyze(pattern)` without the search for an order: `order` lists all unknowns as they are
  /// to be eliminated. The charts' systems are parts of the field's, so that one order serves them all.
  Result<void> analyze(const Symmetric_matrix& pattern, const std::vector<int>& order);

  /// The unknowns as they are eliminated, since the last `analyze()`; returned by reference.
  const std::vector<int>& elimination_order() const;

  /// The number of threads; the solution's bits must not depend on it.
  void set_threads(int threads);

  /// Whether later factorizations of matrices with the same pattern may reuse what this one found. The
  /// solution's bits must not depend on it.
  void set_incremental(bool incremental);

  /// Adds `amounts[k]`, which may be negative, to the diagonal entry of row `rows[k]` of the factorized
  /// matrix. Additions come first. `factorize()` begins anew from its matrix. Needed for the penalties'
  /// updates.
  Result<void> add_to_diagonal(const std::vector<int>& rows, const std::vector<double>& amounts);
  /// @}
};
