// SPDX-License-Identifier: GPL-3.0-or-later
// Convex minimum cost flow by capacity scaling (Ahuja, Magnanti, Orlin, "Network Flows", 1993, sec. 14.5).
#include "sampling/count_problem.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// A column of the equations: at most two entries, `enters` with a positive and `leaves` with a negative one.
struct Column {
  int enters = -1, leaves = -1, weight = 0;
  bool is_arc = true;
};

std::vector<Column> columns(const Count_problem& problem) {
  std::vector<Column> result(problem.variables.size());
  for (std::size_t r = 0; r < problem.rows.size(); ++r)
    for (const auto& [variable, coefficient] : problem.rows[r].terms) {
      Column& c = result[variable];
      int& end = coefficient > 0 ? c.enters : c.leaves;
      const int weight = std::abs(coefficient);
      if (end >= 0 || (c.weight != 0 && c.weight != weight)) c.is_arc = false;
      end = int(r);
      c.weight = weight;
    }
  return result;
}

// The flow on an arc is weight * n; it moves in units of two, so that one unit is one step of n.
struct Arc {
  int tail, head; // rows, or the ground node
  int variable;
  std::int64_t k; // steps above the minimum
};

class Scaled_flow {
public:
  explicit Scaled_flow(const Count_problem& problem);
  Result<std::vector<int>> solve();

private:
  // One direction of an arc as seen from a node.
  struct Dart {
    int arc, other;
    bool forward;
  };

  std::int64_t count(const Arc& a, std::int64_t k) const {
    const Count_variable& v = m_problem.variables[a.variable];
    return v.minimum + v.step * k;
  }
  // Cost per unit of pushing `delta` units along a dart; infinite if its arc would go below the minimum.
  double marginal(const Arc& a, bool forward, std::int64_t delta) const;
  void start_at_individual_optimum();
  void build_darts();
  void repair(std::int64_t delta);
  bool augment(int source, std::int64_t delta);
  void push(int arc, bool forward, std::int64_t delta);
  Error imbalance_error(int node) const;

  const Count_problem& m_problem;
  int m_ground;
  std::vector<Arc> m_arcs;
  std::vector<int> m_dart_begin;
  std::vector<Dart> m_darts;
  std::vector<std::int64_t> m_excess; // in units of two
  std::vector<double> m_potential, m_distance;
  std::vector<Dart> m_parent; // the dart of the parent that reached the node; `other` is the parent
  std::vector<char> m_state;  // 0 unseen, 1 labelled, 2 final
  std::vector<int> m_seen;
  int m_odd_row = -1;
};

Scaled_flow::Scaled_flow(const Count_problem& problem)
    : m_problem(problem), m_ground(int(problem.rows.size())), m_excess(problem.rows.size() + 1, 0),
      m_potential(m_excess.size(), 0), m_distance(m_excess.size(), 0), m_parent(m_excess.size()),
      m_state(m_excess.size(), 0) {
  const std::vector<Column> column = columns(problem);
  for (std::size_t i = 0; i < column.size(); ++i) {
    const Column& c = column[i];
    if (problem.variables[i].fixed) continue;
    m_arcs.push_back({c.leaves < 0 ? m_ground : c.leaves, c.enters < 0 ? m_ground : c.enters, int(i), 0});
  }
  start_at_individual_optimum();
  std::vector<std::int64_t> sum(m_excess.size(), 0);
  std::vector<std::int64_t> value(column.size());
  for (std::size_t i = 0; i < column.size(); ++i) value[i] = problem.variables[i].minimum;
  for (const Arc& a : m_arcs) value[a.variable] = count(a, a.k);
  for (std::size_t r = 0; r < problem.rows.size(); ++r) {
    for (const auto& [variable, coefficient] : problem.rows[r].terms) sum[r] += coefficient * value[variable];
    if (sum[r] % 2 != 0 && m_odd_row < 0) m_odd_row = int(r);
    m_excess[r] = sum[r] / 2;
    m_excess[m_ground] -= m_excess[r];
  }
  build_darts();
}

double Scaled_flow::marginal(const Arc& a, bool forward, std::int64_t delta) const {
  if (!forward && a.k < delta) return std::numeric_limits<double>::infinity();
  const Count_cost& f = m_problem.variables[a.variable].cost;
  return (f(count(a, forward ? a.k + delta : a.k - delta)) - f(count(a, a.k))) / double(delta);
}

void Scaled_flow::start_at_individual_optimum() {
  for (Arc& a : m_arcs) {
    const Count_variable& v = m_problem.variables[a.variable];
    const double steps = (v.cost.ideal - v.minimum) / v.step;
    a.k = v.cost.weight > 0 ? std::int64_t(std::floor(std::max(0.0, steps))) : 0;
    while (marginal(a, true, 1) < 0) ++a.k;
    while (a.k > 0 && marginal(a, false, 1) < 0) --a.k;
  }
}

void Scaled_flow::build_darts() {
  m_dart_begin.assign(m_excess.size() + 1, 0);
  for (const Arc& a : m_arcs)
    if (a.tail != a.head) {
      ++m_dart_begin[a.tail + 1];
      ++m_dart_begin[a.head + 1];
    }
  for (std::size_t v = 0; v < m_excess.size(); ++v) m_dart_begin[v + 1] += m_dart_begin[v];
  m_darts.resize(m_dart_begin.back());
  std::vector<int> end(m_dart_begin.begin(), m_dart_begin.end() - 1);
  for (std::size_t i = 0; i < m_arcs.size(); ++i) {
    const Arc& a = m_arcs[i];
    if (a.tail == a.head) continue;
    m_darts[end[a.tail]++] = {int(i), a.head, true};
    m_darts[end[a.head]++] = {int(i), a.tail, false};
  }
}

void Scaled_flow::push(int arc, bool forward, std::int64_t delta) {
  Arc& a = m_arcs[arc];
  const std::int64_t d = forward ? delta : -delta;
  a.k += d;
  m_excess[a.tail] -= d;
  m_excess[a.head] += d;
}

// Pushes along each dart whose reduced cost became negative when delta was halved.
void Scaled_flow::repair(std::int64_t delta) {
  for (std::size_t i = 0; i < m_arcs.size(); ++i) {
    const Arc& a = m_arcs[i];
    if (a.tail == a.head) continue;
    const double slope = m_potential[a.tail] - m_potential[a.head];
    if (marginal(a, true, delta) - slope < 0)
      push(int(i), true, delta);
    else if (marginal(a, false, delta) + slope < 0)
      push(int(i), false, delta);
  }
}

// Sends delta units from `source` to the nearest node that lacks as many. Ties go to the node of smaller
// index.
bool Scaled_flow::augment(int source, std::int64_t delta) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  m_seen.assign(1, source);
  m_distance[source] = 0;
  m_state[source] = 1;
  queue.emplace(0.0, source);
  int sink = -1;
  while (!queue.empty() && sink < 0) {
    const int v = queue.top().second;
    queue.pop();
    if (m_state[v] == 2) continue;
    m_state[v] = 2;
    if (m_excess[v] <= -delta) {
      sink = v;
      break;
    }
    for (int i = m_dart_begin[v]; i < m_dart_begin[v + 1]; ++i) {
      const Dart& dart = m_darts[i];
      if (m_state[dart.other] == 2) continue;
      const double cost = marginal(m_arcs[dart.arc], dart.forward, delta);
      if (cost == std::numeric_limits<double>::infinity()) continue;
      // Rounding may leave a reduced cost a hair below zero.
      const double reduced = std::max(0.0, cost - m_potential[v] + m_potential[dart.other]);
      const double distance = m_distance[v] + reduced;
      if (m_state[dart.other] == 1 && distance >= m_distance[dart.other]) continue;
      if (m_state[dart.other] == 0) m_seen.push_back(dart.other);
      m_state[dart.other] = 1;
      m_distance[dart.other] = distance;
      m_parent[dart.other] = {dart.arc, v, dart.forward};
      queue.emplace(distance, dart.other);
    }
  }
  for (int v : m_seen) {
    if (sink >= 0 && m_state[v] == 2) m_potential[v] += m_distance[sink] - m_distance[v];
    m_state[v] = 0;
  }
  if (sink < 0) return false;
  for (int v = sink; v != source; v = m_parent[v].other) push(m_parent[v].arc, m_parent[v].forward, delta);
  return true;
}

Error Scaled_flow::imbalance_error(int node) const {
  const int chart = node < m_ground ? m_problem.rows[node].chart : -1;
  return make_error(Error_code::infeasible_sampling,
                    "the counts around chart " + std::to_string(chart) +
                        " cannot be balanced: no contour edge that is free to change leads on from it",
                    Element_kind::chart, chart);
}

Result<std::vector<int>> Scaled_flow::solve() {
  if (m_odd_row >= 0) {
    const int chart = m_problem.rows[m_odd_row].chart;
    return make_error(Error_code::infeasible_sampling,
                      "the locked counts around chart " + std::to_string(chart) + " differ by an odd number",
                      Element_kind::chart, chart);
  }
  std::int64_t largest = 0;
  for (std::int64_t e : m_excess) largest = std::max(largest, std::abs(e));
  std::int64_t delta = 1;
  while (2 * delta <= largest) delta *= 2;
  for (; delta > 0; delta /= 2) {
    repair(delta);
    for (int v = 0; v <= m_ground; ++v)
      while (m_excess[v] >= delta && augment(v, delta)) {
      }
  }
  // Units that are left over have nowhere to go; blame a chart rather than the ground.
  for (int v = 0; v <= m_ground; ++v)
    if (m_excess[v] != 0) return imbalance_error(v);
  std::vector<int> counts(m_problem.variables.size());
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = m_problem.variables[i].minimum;
  for (const Arc& a : m_arcs) {
    const std::int64_t n = count(a, a.k);
    if (n > std::numeric_limits<int>::max() / 4)
      return make_error(Error_code::impossible_request,
                        "the sampling needs more than 10^8 edges on one contour");
    counts[a.variable] = int(n);
  }
  return counts;
}

} // namespace

bool is_network(const Count_problem& problem) {
  const std::vector<Column> column = columns(problem);
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (problem.variables[i].fixed) continue;
    const Column& c = column[i];
    if (!c.is_arc || (c.weight != 0 && c.weight * problem.variables[i].step != 2)) return false;
  }
  return true;
}

Result<std::vector<int>> solve_network(const Count_problem& problem) {
  CGAL_precondition(is_network(problem));
  return Scaled_flow(problem).solve();
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
