// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_DIRICHLET_PROBLEM_H
#define CGAL_REEB_QUADRANGULATION_DIRICHLET_PROBLEM_H

#include <CGAL/Reeb_quadrangulation/Field_solver_options.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Harmonic functions on a mesh with given values at some vertices: one factorization for any values there.
/// With elimination the system has the free vertices only, with penalties all of them. Where the fixed
/// vertices change from solve to solve, see `Harmonic_field`. Copies share the factorization; use them from
/// one thread at a time.
class Dirichlet_problem {
public:
  /// `elimination_order` may list vertices, each once, in an order in which the solver does well to eliminate
  /// them; free vertices that it leaves out follow. Without it, and by solvers that take no order, one is
  /// searched for. Fails with `solver_failure` if the system is not positive definite: weights are negative,
  /// or a component has no fixed vertex. \pre `weights` are symmetric, one for each halfedge; `is_fixed` has
  /// one entry for each vertex.
  static Result<Dirichlet_problem> factorize(const Triangle_surface& mesh, Edge_weights weights,
                                             const std::vector<char>& is_fixed,
                                             const std::vector<int>& elimination_order = {},
                                             const Field_solver_options& options = {});

  /// Replaces the values of the free vertices; fails with `solver_failure` if the residual is too large. With
  /// `jump`, one for each halfedge, the value of a halfedge's target counts as that much more when it is seen
  /// from its source. \pre `mesh` is the one that was factorized.
  Result<void> solve(const Triangle_surface& mesh, std::vector<double>& values,
                     const std::vector<signed char>& jump = {}) const;

  bool is_fixed(int vertex) const { return m_is_fixed[vertex] != 0; }
  const Edge_weights& weights() const { return m_weights; }

private:
  Edge_weights m_weights;
  std::vector<char> m_is_fixed;
  Laplace_system m_system;
  double m_penalty = 0; // 0: elimination
  std::shared_ptr<const Any_linear_solver> m_solver;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_DIRICHLET_PROBLEM_H
