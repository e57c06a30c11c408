// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>

#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr double penalty_factor = 1e8; // the paper's alpha, relative to the largest diagonal entry
// Updating CHOLMOD's factor costs about a hundredth of a factorization a row, and its errors add up.
constexpr std::size_t most_updates = 10;
constexpr int most_accumulated_updates = 100;
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
  explicit Implementation(const Triangle_surface& s) : surface(&s), component(component_representatives(s)) {}

  const Triangle_surface* surface;
  std::optional<Edge_weights> weights; // cotangents, once they are asked for, unless others are set
  std::vector<int> component;
  std::map<int, double> constraints;
  Constraint_method method = Constraint_method::elimination;
  std::optional<Laplace_system>
      system; // of the whole surface; its pattern serves all weights and constraints
  Multifrontal_solver solver;
  Cholmod_solver penalty_solver;
  std::vector<double> penalized_values; // the matrix of the penalty solver's factor, without the penalties
  std::vector<int> penalized;           // the constraints in it
  int accumulated_updates = 0;
  double residual = 0;

  const Edge_weights& current_weights();
  void fill(const Edge_weights& used);
  Result<void> check_components() const;
  void eliminate(Symmetric_matrix& matrix, std::vector<double>& right_side) const;
  double penalty_of(const Symmetric_matrix& matrix) const;
  Result<void> factorize_penalized(const Symmetric_matrix& unconstrained, double penalty);
  Result<void> solve_eliminated(Symmetric_matrix& matrix, std::vector<double>& b, std::vector<double>& x);
  Result<void> solve_penalized(Symmetric_matrix& matrix, std::vector<double>& b, std::vector<double>& x);
  Result<std::vector<double>> solve(const Edge_weights& used);
  std::vector<int> spurious_extrema(const std::vector<double>& values) const;
  int raise_weights(Edge_weights& used, const std::vector<int>& vertices, double low) const;
  bool is_acceptable(const std::vector<double>& values, const std::vector<int>& wanted) const;
};

const Edge_weights& Harmonic_field::Implementation::current_weights() {
  if (!weights) weights = cotangent_weights(*surface);
  return *weights;
}

// Gives the system's matrix the values of these weights; vertices without a face become unknowns of their own.
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

// The rows and columns of constrained vertices become those of the identity. The pattern stays, so that one analysis
// serves all constraints of a surface.
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

double Harmonic_field::Implementation::penalty_of(const Symmetric_matrix& m) const {
  double largest = 0;
  for (int j = 0; j < m.size; ++j) largest = std::max(largest, m.value[m.column_begin[j]]);
  return penalty_factor * largest;
}

// Updates the last factor where only few constraints came or went since, and factorizes otherwise.
Result<void> Harmonic_field::Implementation::factorize_penalized(const Symmetric_matrix& unconstrained,
                                                                 double penalty) {
  std::vector<int> wanted, changed;
  for (const auto& [v, value] : constraints) wanted.push_back(v);
  std::set_symmetric_difference(wanted.begin(), wanted.end(), penalized.begin(), penalized.end(),
                                std::back_inserter(changed));
  const bool updates = penalized_values == unconstrained.value && changed.size() <= most_updates &&
                       accumulated_updates + int(changed.size()) <= most_accumulated_updates;
  penalized_values.clear(); // until the factor is there
  if (updates) {
    std::vector<double> amounts;
    for (const int v : changed) amounts.push_back(constraints.count(v) ? penalty : -penalty);
    const Result<void> updated = penalty_solver.add_to_diagonal(changed, amounts);
    if (!updated) return updated;
    accumulated_updates += int(changed.size());
  } else {
    Symmetric_matrix matrix = unconstrained;
    for (const int v : wanted) matrix.value[matrix.column_begin[v]] += penalty;
    const Result<void> factorized = penalty_solver.factorize(matrix);
    if (!factorized) return factorized;
    accumulated_updates = 0;
  }
  penalized_values = unconstrained.value;
  penalized = std::move(wanted);
  return {};
}

Result<void> Harmonic_field::Implementation::solve_penalized(Symmetric_matrix& m, std::vector<double>& b,
                                                             std::vector<double>& x) {
  const double penalty = penalty_of(m);
  for (const auto& [v, value] : constraints) b[v] = penalty * value;
  Result<void> result = factorize_penalized(m, penalty);
  for (const auto& [v, value] : constraints) m.value[m.column_begin[v]] += penalty;
  x = b;
  return result ? penalty_solver.solve(x.data()) : result;
}

Result<void> Harmonic_field::Implementation::solve_eliminated(Symmetric_matrix& m, std::vector<double>& b,
                                                              std::vector<double>& x) {
  eliminate(m, b);
  const Result<void> factorized = solver.factorize(m);
  x = b;
  return factorized ? solver.solve(x.data()) : factorized;
}

Result<std::vector<double>> Harmonic_field::Implementation::solve(const Edge_weights& used) {
  const Result<void> determined = check_components();
  if (!determined) return determined.error();
  fill(used);
  Symmetric_matrix matrix = system->matrix;
  std::vector<double> b(matrix.size, 0.0), x;
  const Result<void> solved = method == Constraint_method::elimination ? solve_eliminated(matrix, b, x)
                                                                       : solve_penalized(matrix, b, x);
  if (!solved) return solved.error();
  residual = relative_residual(matrix, x.data(), b.data());
  if (residual <= largest_accepted_residual) return x;
  penalized_values.clear(); // the next solve starts from a new factorization
  return make_error(Error_code::solver_failure,
                    "The harmonic field's residual is too large: " + std::to_string(residual) + ".");
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

Harmonic_field::Harmonic_field(const Triangle_surface& surface)
    : m_implementation(std::make_unique<Implementation>(surface)) {}
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
