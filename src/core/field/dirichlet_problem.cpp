// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>

#include "field/penalty.h"

#include <CGAL/assertions.h>

#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The unknowns in the order asked for, those of vertices that it leaves out last.
std::vector<int> order_of_unknowns(const Laplace_system& system, const std::vector<int>& vertices) {
  std::vector<int> order;
  std::vector<char> is_listed(system.matrix.size, 0);
  order.reserve(system.matrix.size);
  for (int v : vertices)
    if (const int i = system.unknown_of_vertex[v]; i >= 0) {
      order.push_back(i);
      is_listed[i] = 1;
    }
  for (int i = 0; i < system.matrix.size; ++i)
    if (!is_listed[i]) order.push_back(i);
  return order;
}

} // namespace

Result<Dirichlet_problem> Dirichlet_problem::factorize(const Triangle_surface& mesh, Edge_weights weights,
                                                       const std::vector<char>& is_fixed,
                                                       const std::vector<int>& elimination_order,
                                                       const Field_solver_options& options) {
  CGAL_precondition(int(weights.of_halfedge.size()) == mesh.number_of_halfedges());
  Dirichlet_problem problem;
  problem.m_weights = std::move(weights);
  problem.m_is_fixed = is_fixed;
  Laplace_system& system = problem.m_system;
  Symmetric_matrix& matrix = system.matrix;
  if (options.constraints == Constraint_method::elimination) {
    system = assemble(mesh, problem.m_weights, is_fixed);
  } else {
    system = assemble(mesh, problem.m_weights);
    problem.m_penalty = internal::penalty_of(matrix);
    for (int v = 0; v < matrix.size; ++v)
      if (is_fixed[v]) matrix.value[matrix.column_begin[v]] += problem.m_penalty;
  }
  auto solver = std::make_shared<Any_linear_solver>(options.solver());
  if (matrix.size > 0) {
    if (!elimination_order.empty())
      if (Result<void> analyzed = solver->analyze(matrix, order_of_unknowns(system, elimination_order));
          !analyzed)
        return analyzed.error();
    if (Result<void> factorized = solver->factorize(matrix); !factorized) return factorized.error();
  }
  problem.m_solver = std::move(solver);
  return problem;
}

Result<void> Dirichlet_problem::solve(const Triangle_surface& mesh, std::vector<double>& values,
                                      const std::vector<signed char>& jump) const {
  CGAL_precondition(int(values.size()) == mesh.number_of_vertices());
  CGAL_precondition(jump.empty() || int(jump.size()) == mesh.number_of_halfedges());
  const std::vector<int>& unknown = m_system.unknown_of_vertex;
  std::vector<double> x(m_system.matrix.size, 0.0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    const int i = unknown[mesh.source(h)], target = mesh.target(h);
    if (i < 0) continue;
    const double known = unknown[target] < 0 ? values[target] : 0.0;
    x[i] += m_weights.of_halfedge[h] * (jump.empty() ? known : known + jump[h]);
  }
  std::vector<int> penalized;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (const int v = m_system.vertex_of_unknown[i]; m_is_fixed[v]) {
      x[i] += m_penalty * values[v];
      penalized.push_back(int(i));
    }
  if (x.empty()) return {};
  const std::vector<double> right_side = x;
  if (Result<void> solved = m_solver->solve(x.data()); !solved) return solved;
  const double residual =
      internal::penalized_residual(m_system.matrix, penalized, x.data(), right_side.data());
  if (!(residual <= largest_accepted_residual))
    return make_error(Error_code::solver_failure,
                      "The residual of a harmonic function is too large: " + std::to_string(residual) + ".");
  for (std::size_t i = 0; i < x.size(); ++i)
    if (const int v = m_system.vertex_of_unknown[i]; !m_is_fixed[v]) values[v] = x[i];
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
