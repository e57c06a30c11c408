// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/sampling.h>

#include "sampling/count_problem.h"

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::Count_problem;
using internal::Count_row;
using internal::Count_variable;
using Kind = Sampling_chart::Kind;

constexpr double largest_count = 1e8;

// What the counts are to be: near length / h, near the previous counts, and few (each quad costs
// `quad_price`).
struct Wish {
  double h = 0; ///< 0: only few
  double quad_price = 0;
};

int fewest_rows_of(const Sampling_chart& c) {
  return c.locked_rows > 0 ? c.locked_rows : c.fewest_rows;
}

Result<void> check(const Sampling_problem& problem, const Sampling_options& options) {
  const int edges = int(problem.edges.size());
  CGAL_precondition(options.previous_counts.empty() || int(options.previous_counts.size()) == edges);
  CGAL_precondition(options.previous_rows.empty() || options.previous_rows.size() == problem.charts.size());
  CGAL_USE(options);
  for (int e = 0; e < edges; ++e) {
    const Sampling_edge& edge = problem.edges[e];
    CGAL_precondition(edge.step == 1 || edge.step == 2);
    CGAL_precondition(edge.minimum >= 1 && edge.locked >= 0);
    if (!(edge.length > 0) || !std::isfinite(edge.length))
      return make_error(Error_code::impossible_request,
                        "contour edge " + std::to_string(e) + " has no positive, finite length",
                        Element_kind::contour, e);
    if (edge.locked > 0 && (edge.locked < edge.minimum || edge.locked % edge.step != 0))
      return make_error(Error_code::infeasible_sampling,
                        "contour edge " + std::to_string(e) + " is locked to a count of " +
                            std::to_string(edge.locked) + ", but needs a multiple of " +
                            std::to_string(edge.step) + " that is at least " + std::to_string(edge.minimum),
                        Element_kind::contour, e);
  }
  for (const Sampling_chart& chart : problem.charts) {
    CGAL_precondition(chart.fewest_rows >= 2 && chart.columns_gained % 2 == 0);
    CGAL_precondition(chart.free_gain >= 0 && chart.free_gain % 2 == 0);
    CGAL_precondition(chart.kind == Kind::disc ? chart.low.empty() != chart.high.empty()
                                               : !chart.low.empty() && !chart.high.empty());
    for (const std::vector<int>* walk : {&chart.low, &chart.high})
      for (int e : *walk) {
        CGAL_precondition(0 <= e && e < edges);
        CGAL_USE(e);
      }
  }
  return {};
}

const std::vector<int>& boundary(const Sampling_chart& disc) {
  return disc.low.empty() ? disc.high : disc.low;
}

Count_row row(const std::vector<int>& plus, const std::vector<int>& minus, int chart) {
  std::map<int, int> coefficient;
  for (int e : plus) ++coefficient[e];
  for (int e : minus) --coefficient[e];
  Count_row result;
  result.chart = chart;
  for (const auto& term : coefficient)
    if (term.second != 0) result.terms.push_back(term);
  return result;
}

std::vector<int> side_of_rectangle(const Sampling_chart& disc, int side) {
  const std::vector<int>& walk = boundary(disc);
  const int n = int(walk.size());
  std::vector<int> edges;
  for (int i = disc.corners[side]; i % n != disc.corners[(side + 1) % 4] || edges.empty(); ++i)
    edges.push_back(walk[i % n]);
  return edges;
}

int sum(const std::vector<int>& counts, const std::vector<int>& edges) {
  int total = 0;
  for (int e : edges) total += counts[e];
  return total;
}

// A disc has an even perimeter of at least four. Where the steps and minima of its edges do not imply that,
// an unknown for half of the perimeter does.
void add_disc(const Sampling_problem& problem, int chart, Count_problem& counts) {
  const std::vector<int>& walk = boundary(problem.charts[chart]);
  if (walk.size() == 1 && !counts.variables[walk[0]].fixed)
    counts.variables[walk[0]].minimum = std::max(4, counts.variables[walk[0]].minimum);
  Count_row perimeter = row(walk, {}, chart);
  int smallest = 0;
  bool even = true;
  for (const auto& [e, coefficient] : perimeter.terms) {
    const Count_variable& v = counts.variables[e];
    smallest += coefficient * v.minimum;
    even = even && coefficient * (v.fixed ? v.minimum : v.step) % 2 == 0;
  }
  if (even && smallest >= 4) return;
  Count_variable half;
  half.step = 1;
  perimeter.terms.emplace_back(int(counts.variables.size()), -2);
  counts.variables.push_back(half);
  counts.rows.push_back(std::move(perimeter));
}

// The price of quads, shared by the two walks of each annulus.
void add_quad_prices(const Sampling_problem& problem, double price, Count_problem& counts) {
  for (const Sampling_chart& chart : problem.charts) {
    if (chart.kind == Kind::disc) {
      const std::vector<int>& walk = boundary(chart);
      if (walk.size() == 1)
        counts.variables[walk[0]].cost.cap += price;
      else // (perimeter / 4)^2 has at least the slope 1/2 from the smallest perimeter on
        for (int e : walk) counts.variables[e].cost.linear += 0.5 * price;
      continue;
    }
    for (const std::vector<int>* walk : {&chart.low, &chart.high})
      for (int e : *walk) counts.variables[e].cost.linear += 0.5 * price * fewest_rows_of(chart);
  }
}

void add_row(Count_row row, Count_problem& counts) {
  if (!row.terms.empty()) counts.rows.push_back(std::move(row));
}

// As many columns at the high walk of an annulus as at the low one, and those that it gains.
Count_row columns_row(const Sampling_chart& chart, int c, double price, Count_problem& counts) {
  Count_row columns = row(chart.low, chart.high, c);
  if (chart.columns_gained == 0 && chart.free_gain == 0) return columns;
  Count_variable gained;
  gained.minimum = chart.columns_gained - chart.free_gain;
  gained.fixed = chart.free_gain == 0;
  gained.cost.stability = price;
  gained.cost.previous = chart.columns_gained;
  gained.cost.most = chart.columns_gained + chart.free_gain;
  columns.terms.emplace_back(int(counts.variables.size()), 1);
  counts.variables.push_back(gained);
  return columns;
}

// The columns of an annulus as an unknown that has only one value.
void lock_columns(const Sampling_chart& chart, int c, Count_problem& counts) {
  if (chart.low.size() == 1) {
    Count_variable& only = counts.variables[chart.low[0]];
    only.minimum = chart.locked_columns;
    only.fixed = true;
    return;
  }
  Count_row columns = row(chart.low, {}, c);
  Count_variable wanted;
  wanted.minimum = chart.locked_columns;
  wanted.fixed = true;
  columns.terms.emplace_back(int(counts.variables.size()), -1);
  counts.variables.push_back(wanted);
  counts.rows.push_back(std::move(columns));
}

// Per contour edge: how far its count reaches into the charts on both sides, half across each.
std::vector<double> reaches(const Sampling_problem& problem) {
  std::vector<double> result(problem.edges.size(), 0);
  for (const Sampling_chart& chart : problem.charts)
    for (const std::vector<int>* walk : {&chart.low, &chart.high}) {
      double length = 0;
      for (int e : *walk) length += problem.edges[e].length;
      // A disc is a square, whose side is a quarter of its boundary.
      for (int e : *walk) result[e] += 0.5 * (chart.kind == Kind::disc ? length / 4 : chart.height);
    }
  return result;
}

Count_problem count_problem(const Sampling_problem& problem, const Wish& wish,
                            const Sampling_options& options) {
  Count_problem counts;
  const std::vector<double> reach = reaches(problem);
  for (std::size_t e = 0; e < problem.edges.size(); ++e) {
    const Sampling_edge& edge = problem.edges[e];
    Count_variable v;
    v.step = edge.step;
    v.fixed = edge.locked > 0;
    v.minimum = v.fixed ? edge.locked : (edge.minimum + edge.step - 1) / edge.step * edge.step;
    if (wish.h > 0) {
      v.cost.ideal = edge.length / wish.h;
      v.cost.weight = std::max(1.0, reach[e] / wish.h); // rows of quads
      v.cost.previous = options.previous_counts.empty() ? 0 : options.previous_counts[e];
      if (v.cost.previous > 0) v.cost.stability = 2 * options.stability * v.cost.weight / v.cost.ideal;
    }
    counts.variables.push_back(v);
  }
  if (wish.quad_price > 0) add_quad_prices(problem, wish.quad_price, counts);
  for (std::size_t c = 0; c < problem.charts.size(); ++c) {
    const Sampling_chart& chart = problem.charts[c];
    if (chart.kind == Kind::disc && chart.corners[0] >= 0) {
      for (int side = 0; side < 2; ++side)
        add_row(row(side_of_rectangle(chart, side), side_of_rectangle(chart, side + 2), int(c)), counts);
    } else if (chart.kind == Kind::disc) {
      add_disc(problem, int(c), counts);
    } else {
      counts.rows.push_back(columns_row(chart, int(c), options.column_price, counts));
      if (chart.locked_columns > 0) lock_columns(chart, int(c), counts);
    }
  }
  for (const Sampling_equality& equality : problem.equalities)
    counts.rows.push_back(row(equality.first, equality.second, equality.chart));
  return counts;
}

Result<std::vector<int>> solve_counts(const Sampling_problem& problem, const Wish& wish,
                                      const Sampling_options& options) {
  const Count_problem counts = count_problem(problem, wish, options);
  Result<std::vector<int>> solution =
      internal::is_network(counts) ? internal::solve_network(counts) : internal::solve_lattice(counts);
  if (solution) solution->resize(problem.edges.size());
  return solution;
}

// Columns that a chart gains, it has in half of its rows.
int mean_columns(const Sampling& s, std::size_t chart) {
  return s.grid[chart][0] + s.gained[chart] / 2;
}

std::int64_t total(const Sampling& s) {
  std::int64_t sum = 0;
  for (std::size_t c = 0; c < s.grid.size(); ++c) sum += std::int64_t(mean_columns(s, c)) * s.grid[c][1];
  return sum;
}

int rows_for(const Sampling_chart& chart, double h, int previous, double stability) {
  if (chart.locked_rows > 0) return chart.locked_rows;
  const double ideal = std::min(chart.height / h, largest_count);
  if (previous >= chart.fewest_rows && std::abs(previous - ideal) <= 0.5 + 0.5 * stability) return previous;
  return std::max(chart.fewest_rows, int(std::floor(ideal + 0.5)));
}

// Completes counts to a sampling: rows, caps, totals.
Sampling complete(const Sampling_problem& problem, std::vector<int> counts, double h,
                  const Sampling_options& options) {
  Sampling result;
  result.counts = std::move(counts);
  result.edge_length = h;
  for (std::size_t c = 0; c < problem.charts.size(); ++c) {
    const Sampling_chart& chart = problem.charts[c];
    const bool disc = chart.kind == Kind::disc;
    int columns = 0;
    for (int e : disc ? boundary(chart) : chart.low) columns += result.counts[e];
    result.gained.push_back(disc ? 0 : sum(result.counts, chart.high) - columns);
    const int previous = options.previous_rows.empty() ? 0 : options.previous_rows[c];
    if (disc && chart.corners[0] >= 0)
      result.grid.push_back(
          {sum(result.counts, side_of_rectangle(chart, 0)), sum(result.counts, side_of_rectangle(chart, 1))});
    else if (disc)
      result.grid.push_back({columns / 2 - columns / 4, columns / 4});
    else
      result.grid.push_back({columns, rows_for(chart, h, previous, options.stability)});
  }
  result.quads = total(result);
  for (std::size_t e = 0; e < problem.edges.size(); ++e) {
    const double ratio = result.counts[e] * h / problem.edges[e].length;
    const double worse = std::max(ratio, 1 / ratio);
    if (result.worst_edge >= 0 && worse <= result.worst_ratio) continue;
    result.worst_ratio = worse;
    result.worst_edge = int(e);
  }
  return result;
}

double longest(const Sampling_problem& problem) {
  double length = 0;
  for (const Sampling_edge& e : problem.edges) length = std::max(length, e.length);
  for (const Sampling_chart& c : problem.charts) length = std::max(length, c.height);
  return length;
}

Result<void> check_length(const Sampling_problem& problem, double h) {
  if (!(h > 0) || !std::isfinite(h) || longest(problem) / h > largest_count)
    return make_error(Error_code::impossible_request,
                      "the edge length must be positive, finite, and not below 10^-8 of the longest contour");
  return {};
}

Result<Sampling> solve(const Sampling_problem& problem, const Wish& wish, double row_length,
                       const Sampling_options& options) {
  Result<std::vector<int>> counts = solve_counts(problem, wish, options);
  if (!counts) return counts.error();
  return complete(problem, std::move(*counts), row_length, options);
}

// The area of the charts if they were cylinders and squares.
double rough_area(const Sampling_problem& problem) {
  double area = 0;
  const auto length = [&](const std::vector<int>& walk) {
    double sum = 0;
    for (int e : walk) sum += problem.edges[e].length;
    return sum;
  };
  for (const Sampling_chart& chart : problem.charts) {
    const double low = length(chart.low), high = length(chart.high);
    area += chart.kind == Kind::disc ? (low + high) * (low + high) / 16 : (low + high) / 2 * chart.height;
  }
  return area > 0 ? area : longest(problem) * longest(problem);
}

// Searches for a target number of quads: first by h, then by rows, then by the h of the counts alone.
class Target_search {
public:
  Target_search(const Sampling_problem& problem, std::int64_t target, const Sampling_options& options)
      : m_problem(problem), m_target(target), m_options(options) {}

  Result<Sampling> run() {
    const double natural = std::sqrt(rough_area(m_problem) / double(m_target));
    const double start = m_options.previous_edge_length > 0 ? m_options.previous_edge_length : natural;
    if (Result<void> ok = check_length(m_problem, start); !ok) return ok.error();
    if (Result<void> ok = search_length(start); !ok) return ok.error();
    if (!near()) tune_rows(m_best);
    if (!near())
      if (Result<void> ok = search_counts(); !ok) return ok.error();
    if (m_best.quads > m_target && !met())
      if (Result<void> ok = search_price(natural); !ok) return ok.error();
    m_best.target_met = met();
    if (m_best.target_met) return m_best;
    const Result<Sampling> least = fewest_quads(m_problem);
    if (!least) return least.error();
    if (least->quads > m_target) m_best = *least;
    m_best.fewest = least->quads;
    m_best.target_met = false;
    return m_best;
  }

private:
  bool near() const { return off(m_best) <= 0.01 * double(m_target); }
  bool met() const { return off(m_best) <= 0.05 * double(m_target); }
  double off(const Sampling& s) const { return std::abs(double(s.quads - m_target)); }
  void keep(Sampling s) {
    if (m_best.counts.empty() || off(s) < off(m_best)) m_best = std::move(s);
  }

  // quads ~ 1 / h^2, so h sqrt(quads / target) is a good guess; bisection where it leaves the bracket.
  Result<void> search_length(double h) {
    double fine = 0, coarse = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 40 && h < 16 * longest(m_problem); ++i) {
      Result<Sampling> s = solve(m_problem, {h, 0}, h, m_options);
      if (!s) return s.error();
      const double ratio = double(s->quads) / double(m_target);
      (ratio > 1 ? fine : coarse) = h;
      keep(std::move(*s));
      if (near() || coarse < fine * (1 + 1e-6)) break;
      h *= std::sqrt(ratio);
      if (h <= fine || h >= coarse || i > 6)
        h = coarse == std::numeric_limits<double>::infinity() ? 2 * fine
            : fine == 0                                       ? coarse / 2
                                                              : std::sqrt(fine * coarse);
      if (Result<void> ok = check_length(m_problem, h); !ok) return ok;
    }
    return {};
  }

  // Very long edges leave two rows everywhere, and counts that are few but not the fewest. There every quad
  // gets a price, which rises until there are few enough.
  Result<void> search_price(double natural) {
    double low = 1e-6, high = 1e9;
    for (int i = 0; i < 40 && !near(); ++i) {
      const double price = std::sqrt(low * high);
      Result<Sampling> s =
          solve(m_problem, {16 * longest(m_problem), price}, 16 * longest(m_problem), m_options);
      if (!s) return s.error();
      (s->quads > m_target ? low : high) = price;
      if (off(*s) >= off(m_best)) continue;
      const auto grid = s->grid;
      m_best = complete(m_problem, std::move(s->counts), natural, m_options);
      m_best.grid = grid;
      m_best.quads = total(m_best);
    }
    tune_rows(m_best);
    return {};
  }

  // Other counts, same rows: h times 0.98^i and 1.02^i, the smallest change that comes near.
  Result<void> search_counts() {
    const double h = m_best.edge_length;
    for (int i = 1; i <= 12 && !near(); ++i)
      for (int sign : {-1, 1}) {
        Result<Sampling> s = solve(m_problem, {h * std::pow(1.02, sign * i), 0}, h, m_options);
        if (!s) return s.error();
        tune_rows(*s);
        keep(std::move(*s));
      }
    return {};
  }

  // Adds or removes rows, one at a time, where that takes the rows least away from height / h,
  // and never further than a quarter.
  void tune_rows(Sampling& s) const {
    while (off(s) > 0.005 * double(m_target)) {
      const int step = s.quads < m_target ? 1 : -1;
      int chosen = -1;
      double least = 0;
      for (std::size_t c = 0; c < m_problem.charts.size(); ++c) {
        const Sampling_chart& chart = m_problem.charts[c];
        const int rows = s.grid[c][1];
        if (chart.kind == Kind::disc || chart.locked_rows > 0 || rows + step < chart.fewest_rows) continue;
        if (mean_columns(s, c) >= 2 * off(s)) continue;
        const double ideal = chart.height / s.edge_length;
        if (std::abs(rows + step - ideal) > std::max(1.0, 0.25 * ideal) && (rows + step - ideal) * step > 0)
          continue;
        const double change = (2 * step * (rows - ideal) + 1) / std::max(1.0, ideal);
        if (chosen >= 0 && change >= least) continue;
        chosen = int(c);
        least = change;
      }
      if (chosen < 0) return;
      s.grid[chosen][1] += step;
      s.quads += step * mean_columns(s, std::size_t(chosen));
    }
  }

  const Sampling_problem& m_problem;
  std::int64_t m_target;
  const Sampling_options& m_options;
  Sampling m_best;
};

} // namespace

Result<Sampling> sample_layout(const Sampling_problem& problem, double h, const Sampling_options& options) {
  if (Result<void> ok = check(problem, options); !ok) return ok.error();
  if (Result<void> ok = check_length(problem, h); !ok) return ok.error();
  return solve(problem, {h, 0}, h, options);
}

Result<Sampling> sample_for_edge_length(const Sampling_problem& problem, double edge_length,
                                        const Sampling_options& options) {
  return sample_layout(problem, edge_length, options);
}

Result<Sampling> fewest_quads(const Sampling_problem& problem) {
  if (Result<void> ok = check(problem, {}); !ok) return ok.error();
  Result<std::vector<int>> counts = solve_counts(problem, {0, 1}, {});
  if (!counts) return counts.error();
  // With rows for an infinite h there are as few as may be; then h is what an even distribution would have.
  Sampling result = complete(problem, *counts, std::numeric_limits<double>::infinity(), {});
  const auto grid = result.grid;
  result = complete(problem, std::move(*counts), std::sqrt(rough_area(problem) / double(result.quads)), {});
  result.grid = grid;
  result.quads = result.fewest = total(result);
  return result;
}

Result<Sampling> sample_for_quads(const Sampling_problem& problem, std::int64_t target,
                                  const Sampling_options& options) {
  if (Result<void> ok = check(problem, options); !ok) return ok.error();
  if (target < 1 || double(target) > largest_count)
    return make_error(Error_code::impossible_request, "the number of quads must be between 1 and 10^8");
  if (problem.edges.empty())
    return make_error(Error_code::impossible_request, "the layout has no contour edge");
  return Target_search(problem, target, options).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
