// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>

#include "field/penalty.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Updating a factor costs about a thousandth of a factorization for each row.
constexpr std::size_t most_updates = 200;
// An update by a penalty leaves errors of about 1e-9 of the solution, which a round of refinement squares.
constexpr int most_refinements = 3;
constexpr double refined_residual = 1e-15;
constexpr double tolerated_overshoot =
    1e-6; // of the constraints' range, before weights are clamped everywhere

// The smallest vertex of each vertex's component; -1 for a vertex without a face.
std::vector<int> component_representatives(const Triangle_surface& s) {
  std::vector<int> representative(s.number_of_vertices(), -1), stack;
  for (int seed = 0; seed < s.number_of_vertices(); ++seed) {
    if (representative[seed] >= 0 || s.outgoing[seed] < 0) continue;
    representative[seed] = seed;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      // Every edge of a face is seen from one of its corners, so forward edges reach the whole component.
      for (int h = s.outgoing[v]; h >= 0;) {
        for (const int u : {s.target(h), s.source(Triangle_surface::previous(h))})
          if (representative[u] < 0) {
            representative[u] = seed;
            stack.push_back(u);
          }
        h = s.rotate_ccw(h);
        if (h == s.outgoing[v]) break;
      }
    }
  }
  return representative;
}

struct Neighbour_order {
  bool lower = false, higher = false; // whether a neighbour is strictly below or above
  bool is_extremum() const { return lower != higher; }
};

// How the neighbours of v compare with it; equal values are told apart by index if `break_ties`.
Neighbour_order order_around(const Triangle_surface& s, const std::vector<double>& f, int v,
                             bool break_ties) {
  Neighbour_order order;
  const auto compare = [&](int u) {
    if (f[u] < f[v] || (break_ties && f[u] == f[v] && u < v)) order.lower = true;
    if (f[u] > f[v] || (break_ties && f[u] == f[v] && u > v)) order.higher = true;
  };
  for (int h = s.outgoing[v]; h >= 0 && !(order.lower && order.higher);) {
    compare(s.target(h));
    compare(s.source(Triangle_surface::previous(h)));
    h = s.rotate_ccw(h);
    if (h == s.outgoing[v]) break;
  }
  return order;
}

} // namespace

struct Harmonic_field::Implementation {
  Implementation(const Triangle_surface& s, const Field_solver_options& options)
      : surface(&s), component(component_representatives(s)), method(options.constraints),
        solver(options.solver()) {}

  const Triangle_surface* surface;
  std::optional<Edge_weights> weights; // cotangents, once they are asked for, unless others are set
  std::vector<int> component;
  std::map<int, double> constraints;
  Constraint_method method;
  std::optional<Laplace_system>
      system; // of the whole surface; its pattern serves all weights and constraints
  Any_linear_solver solver;
  double residual = 0;

  const Edge_weights& current_weights();
  void fill(const Edge_weights& used);
  Result<void> check_components() const;
  void eliminate(Symmetric_matrix& matrix, std::vector<double>& right_side) const;
  Result<void> factorize_by_updates(const Symmetric_matrix& unconstrained, double penalty);
  Result<void> solve_eliminated(std::vector<double>& x);
  Result<void> solve_penalized(std::vector<double>& x);
  Result<void> solve_factorized(const Symmetric_matrix& matrix, const std::vector<double>& b,
                                std::vector<double>& x, bool was_updated = false);
  Result<std::vector<double>> solve(const Edge_weights& used);
  std::vector<int> spurious_extrema(const std::vector<double>& values) const;
  int raise_weights(Edge_weights& used, const std::vector<int>& vertices, double low) const;
  bool is_acceptable(const std::vector<double>& values, const std::vector<int>& wanted) const;
};

const Edge_weights& Harmonic_field::Implementation::current_weights() {
  if (!weights) weights = cotangent_weights(*surface);
  return *weights;
}

// Gives the system's matrix the values of these weights; vertices without a face become unknowns of their
// own.
void Harmonic_field::Implementation::fill(const Edge_weights& used) {
  const Triangle_surface& s = *surface;
  if (!system) system = assemble(s, used);
  Symmetric_matrix& m = system->matrix;
  for (int v = 0; v < m.size; ++v) m.value[m.column_begin[v]] = component[v] < 0 ? 1 : 0;
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    if (s.edge(h) != h) continue;
    const double w = used.of_halfedge[h];
    m.value[system->entry_of_halfedge[h]] = -w;
    m.value[m.column_begin[s.source(h)]] += w;
    m.value[m.column_begin[s.target(h)]] += w;
  }
}

Result<void> Harmonic_field::Implementation::check_components() const {
  std::vector<char> constrained(component.size(), 0);
  for (const auto& [v, value] : constraints)
    if (component[v] >= 0) constrained[component[v]] = 1;
  for (std::size_t v = 0; v < component.size(); ++v)
    if (component[v] >= 0 && !constrained[component[v]])
      return make_error(Error_code::impossible_request,
                        "The component of vertex " + std::to_string(v) +
                            " has no constraint, so its harmonic function is not determined.",
                        Element_kind::vertex, std::int64_t(v));
  return {};
}

// The rows and columns of constrained vertices become those of the identity. The pattern stays, so that one
// analysis serves all constraints of a surface.
void Harmonic_field::Implementation::eliminate(Symmetric_matrix& m, std::vector<double>& b) const {
  std::vector<char> fixed(m.size, 0);
  for (const auto& [v, value] : constraints) {
    fixed[v] = 1;
    b[v] = value;
  }
  for (int j = 0; j < m.size; ++j) {
    if (fixed[j]) m.value[m.column_begin[j]] = 1;
    for (int k = m.column_begin[j] + 1; k < m.column_begin[j + 1]; ++k) {
      const int i = m.row[k];
      if (!fixed[i] && !fixed[j]) continue;
      if (!fixed[i]) b[i] -= m.value[k] * b[j];
      if (!fixed[j]) b[j] -= m.value[k] * b[i];
      m.value[k] = 0;
    }
  }
}

// Solves with the last factorization. Of a factor that was updated the solution is mended by that of its
// residual.
Result<void> Harmonic_field::Implementation::solve_factorized(const Symmetric_matrix& matrix,
                                                              const std::vector<double>& b,
                                                              std::vector<double>& x, bool was_updated) {
  std::vector<int> penalized;
  if (method == Constraint_method::penalty)
    for (const auto& [v, value] : constraints) penalized.push_back(v);
  x = b;
  if (const Result<void> solved = solver.solve(x.data()); !solved) return solved;
  residual = internal::penalized_residual(matrix, penalized, x.data(), b.data());
  for (int round = 0; was_updated && round < most_refinements && residual > refined_residual; ++round) {
    std::vector<double> correction(x.size());
    multiply(matrix, x.data(), correction.data());
    for (std::size_t i = 0; i < b.size(); ++i) correction[i] = b[i] - correction[i];
    if (const Result<void> solved = solver.solve(correction.data()); !solved) return solved;
    for (std::size_t i = 0; i < b.size(); ++i) x[i] += correction[i];
    residual = internal::penalized_residual(matrix, penalized, x.data(), b.data());
  }
  if (residual <= largest_accepted_residual) return {};
  return make_error(Error_code::solver_failure,
                    "The harmonic field's residual is too large: " + std::to_string(residual) + ".");
}

Result<void> Harmonic_field::Implementation::solve_eliminated(std::vector<double>& x) {
  Symmetric_matrix matrix = system->matrix;
  std::vector<double> b(matrix.size, 0.0);
  eliminate(matrix, b);
  const Result<void> factorized = solver.factorize(matrix);
  return factorized ? solve_factorized(matrix, b, x) : factorized;
}

// Begins every time with a factor that surface and weights alone decide, so that the bits of the solution do
// not depend on what was solved before, nor errors of updates add up. There a vertex of each component is
// held by a conductance of the size of the others: unlike a penalty it can be taken off again without loss.
Result<void> Harmonic_field::Implementation::factorize_by_updates(const Symmetric_matrix& unconstrained,
                                                                  double penalty) {
  Symmetric_matrix held = unconstrained;
  const double conductance = penalty / internal::penalty_factor;
  std::map<int, double> change;
  for (int v = 0; v < held.size; ++v)
    if (component[v] == v) {
      held.value[held.column_begin[v]] += conductance;
      change[v] -= conductance;
    }
  for (const auto& [v, value] : constraints) change[v] += penalty;
  std::vector<int> rows;
  std::vector<double> amounts;
  for (const auto& [v, amount] : change) {
    rows.push_back(v);
    amounts.push_back(amount);
  }
  const Result<void> factorized = solver.factorize(held);
  return factorized ? solver.add_to_diagonal(rows, amounts) : factorized;
}

Result<void> Harmonic_field::Implementation::solve_penalized(std::vector<double>& x) {
  const Symmetric_matrix& unconstrained = system->matrix;
  const double penalty = internal::penalty_of(unconstrained);
  Symmetric_matrix matrix = unconstrained;
  std::vector<double> b(matrix.size, 0.0);
  for (const auto& [v, value] : constraints) {
    matrix.value[matrix.column_begin[v]] += penalty;
    b[v] = penalty * value;
  }
  if (solver.can_update() && constraints.size() <= most_updates &&
      factorize_by_updates(unconstrained, penalty) && solve_factorized(matrix, b, x, true))
    return {};
  const Result<void> factorized = solver.factorize(matrix);
  return factorized ? solve_factorized(matrix, b, x) : factorized;
}

Result<std::vector<double>> Harmonic_field::Implementation::solve(const Edge_weights& used) {
  if (const Result<void> determined = check_components(); !determined) return determined.error();
  fill(used);
  std::vector<double> x;
  const Result<void> solved =
      method == Constraint_method::elimination ? solve_eliminated(x) : solve_penalized(x);
  if (!solved) return solved.error();
  return x;
}

std::vector<int> Harmonic_field::Implementation::spurious_extrema(const std::vector<double>& f) const {
  std::vector<int> spurious;
  for (int v = 0; v < surface->number_of_vertices(); ++v)
    if (component[v] >= 0 && order_around(*surface, f, v, true).is_extremum() && !constraints.count(v))
      spurious.push_back(v);
  return spurious;
}

int Harmonic_field::Implementation::raise_weights(Edge_weights& used, const std::vector<int>& vertices,
                                                  double low) const {
  const Triangle_surface& s = *surface;
  int raised = 0;
  const auto raise = [&](int h) {
    if (used.of_halfedge[h] >= low) return;
    used.of_halfedge[h] = low;
    if (!s.is_boundary(h)) used.of_halfedge[s.opposite[h]] = low;
    ++raised;
  };
  for (const int v : vertices)
    for (int h = s.outgoing[v]; h >= 0;) {
      raise(h);
      raise(Triangle_surface::previous(h));
      h = s.rotate_ccw(h);
      if (h == s.outgoing[v]) break;
    }
  return raised;
}

bool Harmonic_field::Implementation::is_acceptable(const std::vector<double>& f,
                                                   const std::vector<int>& wanted) const {
  for (const int v : wanted) {
    const Neighbour_order order = order_around(*surface, f, v, false);
    if (order.lower && order.higher) return false;
  }
  if (constraints.empty()) return true; // and no face
  double low = constraints.begin()->second, high = low;
  for (const auto& [v, value] : constraints) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const double margin = tolerated_overshoot * (high - low);
  for (std::size_t v = 0; v < f.size(); ++v)
    if (component[v] >= 0 && (f[v] < low - margin || f[v] > high + margin)) return false;
  return true;
}

Harmonic_field::Harmonic_field(const Triangle_surface& surface, const Field_solver_options& options)
    : m_implementation(std::make_unique<Implementation>(surface, options)) {}
Harmonic_field::~Harmonic_field() = default;
Harmonic_field::Harmonic_field(Harmonic_field&&) noexcept = default;
Harmonic_field& Harmonic_field::operator=(Harmonic_field&&) noexcept = default;

void Harmonic_field::set_weights(Weight_kind kind) {
  const Triangle_surface& s = *m_implementation->surface;
  switch (kind) {
  case Weight_kind::cotangent: m_implementation->weights = cotangent_weights(s); break;
  case Weight_kind::clamped_cotangent: m_implementation->weights = clamped_cotangent_weights(s); break;
  case Weight_kind::uniform: m_implementation->weights = uniform_weights(s); break;
  }
}

void Harmonic_field::set_weights(Edge_weights weights) {
  CGAL_precondition(int(weights.of_halfedge.size()) == m_implementation->surface->number_of_halfedges());
  m_implementation->weights = std::move(weights);
}

void Harmonic_field::set_method(Constraint_method method) {
  m_implementation->method = method;
}

void Harmonic_field::set_threads(int threads) {
  m_implementation->solver.set_threads(threads);
}

void Harmonic_field::set_incremental(bool incremental) {
  m_implementation->solver.set_incremental(incremental);
}

Result<void> Harmonic_field::set_constraint(int vertex, double value) {
  if (vertex < 0 || vertex >= m_implementation->surface->number_of_vertices())
    return make_error(Error_code::impossible_request,
                      "There is no vertex " + std::to_string(vertex) + " to constrain.", Element_kind::vertex,
                      vertex);
  if (!std::isfinite(value))
    return make_error(Error_code::impossible_request,
                      "The value for vertex " + std::to_string(vertex) + " is not a finite number.",
                      Element_kind::vertex, vertex);
  m_implementation->constraints[vertex] = value;
  return {};
}

bool Harmonic_field::remove_constraint(int vertex) {
  return m_implementation->constraints.erase(vertex) > 0;
}

void Harmonic_field::clear_constraints() {
  m_implementation->constraints.clear();
}

const std::map<int, double>& Harmonic_field::constraints() const {
  return m_implementation->constraints;
}

Result<std::vector<double>> Harmonic_field::solve() {
  return m_implementation->solve(m_implementation->current_weights());
}

Result<Locally_clamped_field>
Harmonic_field::solve_with_local_clamping(const std::vector<int>& wanted_extrema, int most_rounds, double low,
                                          double high) {
  Implementation& impl = *m_implementation;
  CGAL_precondition(0 < low && low <= high);
  CGAL_precondition(std::all_of(wanted_extrema.begin(), wanted_extrema.end(),
                                [&](int v) { return 0 <= v && v < impl.surface->number_of_vertices(); }));
  Edge_weights used = impl.current_weights();
  Result<std::vector<double>> solved = impl.solve(used);
  if (!solved) return solved.error();
  Locally_clamped_field field;
  std::vector<int> spurious = impl.spurious_extrema(*solved);
  for (; !spurious.empty() && field.rounds < most_rounds; ++field.rounds) {
    const int raised = impl.raise_weights(used, spurious, low);
    if (raised == 0) break; // rounding in a flat region, which no weight can mend
    field.raised_edges += raised;
    solved = impl.solve(used);
    if (!solved) return solved.error();
    spurious = impl.spurious_extrema(*solved);
  }
  if (!impl.is_acceptable(*solved, wanted_extrema)) {
    field.clamped_everywhere = true;
    for (double& w : used.of_halfedge) w = std::clamp(w, low, high);
    solved = impl.solve(used);
    if (!solved) return solved.error();
    spurious = impl.spurious_extrema(*solved);
  }
  field.values = std::move(*solved);
  field.spurious_extrema = int(spurious.size());
  return field;
}

const std::vector<int>& Harmonic_field::elimination_order() const {
  return m_implementation->solver.elimination_order();
}

double Harmonic_field::residual() const {
  return m_implementation->residual;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
