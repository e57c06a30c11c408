// SPDX-License-Identifier: GPL-3.0-or-later
// Extraordinary vertices in line: a search in the integers of a layout, by its lines alone.
#include "design/layout_lines.h"
#include "edits/steps.h"
#include "surface/shapes_draft.h"

#include <CGAL/Reeb_quadrangulation/layout_sampling.h>
#include <CGAL/Reeb_quadrangulation/place_texture.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A cap whose corners span no area at all costs as much as quads whose scaled Jacobian is lower by this.
constexpr double price_of_corners = 0.3;

// What quads r times too narrow cost, beside r + 1 / r - 2.
constexpr double price_of_counts = 0.05;

// The number of quads stays within this part.
constexpr double quads_kept = 0.02;

// What the search accepts at its start though it is worse, in the unit of what a base complex e times as
// large costs.
constexpr double first_temperature = 0.6;

// What an angle between columns and rows costs beside the scaled Jacobian, per radian that it differs from a
// right one: the Jacobian hardly feels a little lean, and eyes do.
constexpr double price_of_angles = 0.25;

// Triangles of a chart that its price is told from, at most about.
constexpr int most_triangles = 500;

// The best turn of an annulus for any counts: it is linear in them, but for the division by the columns. See
// `best_turn()`.
class Turn_of_counts {
public:
  Turn_of_counts(const Chart& chart, const Contour_samples& samples, const Chart_parameterization& map) {
    const Contour_samples one{std::vector<int>(samples.counts.size(), 1), samples.parameter};
    for (int w = 0; w < 2; ++w) {
      const Walk& walk = chart.walks[w];
      const std::vector<double> x = walk_coordinates(walk, one);
      const std::vector<double>& natural = map.natural(walk.side);
      for (std::size_t k = 0; k < walk.edges.size(); ++k) {
        const std::size_t end =
            k + 1 < walk.edges.size() ? std::size_t(walk.edges[k + 1].begin) : x.size() - 1;
        Part part{walk.edges[k].edge, 0, 0};
        for (std::size_t i = std::size_t(walk.edges[k].begin); i < end; ++i) {
          const double step = natural[i + 1] - natural[i];
          part.width += step;
          part.inside += (0.5 * (x[i] + x[i + 1]) - double(k)) * step;
          m_natural[w] += 0.5 * (natural[i] + natural[i + 1]) * step;
        }
        m_parts[w].push_back(part);
      }
    }
  }

  double at(const std::vector<int>& counts) const {
    std::array<double, 2> mean{{0, 0}};
    int columns = 0;
    for (int w = 0; w < 2; ++w) {
      columns = 0;
      for (const Part& part : m_parts[w]) {
        mean[w] += columns * part.width + counts[part.edge] * part.inside;
        columns += counts[part.edge];
      }
    }
    return mean[0] - mean[1] - columns * (m_natural[0] - m_natural[1]);
  }

private:
  struct Part {
    int edge;
    double width, inside; // natural V along the contour edge; the integral of the edge's parameter over it
  };
  std::array<std::vector<Part>, 2> m_parts;
  std::array<double, 2> m_natural{{0, 0}};
};

// How much quads of an annulus lean when its columns do: told from its map, triangle by triangle. The angle
// between columns and rows does not depend on how many there are.
class Leaning {
public:
  Leaning(const Design_chart& chart) : m_step(0.5 / double(chart.grid[0])) {
    const Chart& c = *chart.chart;
    const int faces = c.mesh.number_of_faces(), stride = faces / most_triangles + 1;
    double whole = 0;
    for (int f = 0; f < faces; f += stride) {
      const Part part = part_of(c, *chart.map, f);
      if (part.weight <= 0) continue;
      m_parts.push_back(part);
      whole += part.weight;
    }
    for (Part& part : m_parts) part.weight /= whole;
    m_costs.assign(2 * std::size_t(chart.grid[0]) + 3, -1);
  }

  // The mean cost of a quad where the HIGH walk is turned by such a part of the way around from where it is.
  double at(double turn) {
    const double last = double(m_costs.size() - 1);
    const double place = std::clamp(turn / m_step + 0.5 * last, 0.0, last);
    const std::size_t i = std::min(m_costs.size() - 2, std::size_t(place));
    const double part = place - double(i);
    return (1 - part) * entry(i) + part * entry(i + 1);
  }

private:
  struct Part {
    double lean, slope, weight; // slope: of a column that is turned by the whole way around
  };

  static Part part_of(const Chart& c, const Chart_parameterization& map, int f) {
    const Triangle& t = c.mesh.triangles[f];
    const double v1 = map.v()[t[1]] + map.jump(3 * f) - map.v()[t[0]];
    const double v2 = map.v()[t[2]] - map.jump(3 * f + 2) - map.v()[t[0]];
    const double u1 = map.u()[t[1]] - map.u()[t[0]], u2 = map.u()[t[2]] - map.u()[t[0]];
    const double area = v1 * u2 - v2 * u1;
    if (!(area > 0)) return {0, 0, 0};
    const Point e1 = c.mesh.points[t[1]] - c.mesh.points[t[0]];
    const Point e2 = c.mesh.points[t[2]] - c.mesh.points[t[0]];
    const Point along_v = (u2 * e1 - u1 * e2) / area, along_u = (v1 * e2 - v2 * e1) / area;
    const double height = along_v.cross(along_u).norm();
    if (!(height > 0)) return {0, 0, 0};
    return {along_v.dot(along_u) / height, along_v.squaredNorm() / height, area};
  }

  double entry(std::size_t i) {
    if (m_costs[i] >= 0) return m_costs[i];
    const double turn = (double(i) - 0.5 * double(m_costs.size() - 1)) * m_step;
    double cost = 0;
    for (const Part& part : m_parts) {
      const double lean = part.lean - turn * part.slope;
      cost +=
          part.weight * (1 - 1 / std::sqrt(1 + lean * lean) + price_of_angles * std::atan(std::abs(lean)));
    }
    return m_costs[i] = cost;
  }

  double m_step;
  std::vector<Part> m_parts;
  std::vector<double> m_costs; // per step; negative: not asked for yet
};

// What quads lose by turns and counts, as a part of the mean scaled Jacobian.
class Price {
public:
  Price(const Draft& draft, const Layout_integers& start) : m_design(draft.before()) {
    const std::vector<Point> points = network_points(draft.surface(), draft.network);
    std::vector<double> heights;
    for (const auto& chart : m_design.charts) heights.push_back(chart->height);
    const Layout_sampling_problem layout = sampling_problem(points, draft.network, draft.atlas(), heights);
    m_wish.assign(draft.network.edges.size(), 0);
    m_weight.assign(m_wish.size(), 0);
    for (std::size_t i = 0; i < layout.edges.size(); ++i)
      m_wish[layout.edges[i]] = layout.problem.edges[i].length / m_design.edge_length;
    double whole = 0;
    for (const auto& chart : m_design.charts) whole += area(chart->chart->mesh);
    m_quads_at_start = 0;
    for (const auto& chart : m_design.charts) m_quads_at_start += chart->grid[0] * chart->grid[1];
    for (std::size_t c = 0; c < m_design.charts.size(); ++c) add_chart(int(c), start, whole);
    m_counts_at_start = counts_cost(start.counts);
    m_quads_at_start = quads(start.counts);
  }

  double best_turn(int chart, const std::vector<int>& counts) const {
    return m_turns[m_annulus[chart]].at(counts);
  }

  double of_turn(int chart, const Layout_integers& now) {
    if (m_annulus[chart] < 0) return corners(chart, now);
    const double turn = (now.turn[chart] - best_turn(chart, now.counts)) / samples(chart, now.counts);
    Leaning& leaning = m_leaning[m_annulus[chart]];
    return m_quads[chart] * std::max(0.0, leaning.at(turn - m_turn_at_start[chart]) - leaning.at(0));
  }

  double of_counts(const std::vector<int>& counts) const {
    return std::max(0.0, counts_cost(counts) - m_counts_at_start);
  }
  bool keeps_quads(const std::vector<int>& counts) const {
    return std::abs(quads(counts) - m_quads_at_start) <= quads_kept * m_quads_at_start;
  }

private:
  void add_chart(int c, const Layout_integers& start, double whole) {
    const Design_chart& chart = *m_design.charts[c];
    const bool annulus = chart.chart->kind == Chart_kind::annulus;
    m_share.push_back(area(chart.chart->mesh) / whole);
    m_quads.push_back(chart.grid[0] * chart.grid[1] / m_quads_at_start);
    m_annulus.push_back(annulus ? int(m_turns.size()) : -1);
    m_turn_at_start.push_back(0);
    if (annulus) {
      m_turns.emplace_back(*chart.chart, m_design.samples, *chart.map);
      m_leaning.emplace_back(chart);
      m_turn_at_start[c] = (start.turn[c] - best_turn(c, start.counts)) / samples(c, start.counts);
    }
    for (const Walk& walk : chart.chart->walks) {
      double wishes = 0;
      for (const Walk_edge& e : walk.edges) wishes += m_wish[e.edge];
      for (const Walk_edge& e : walk.edges)
        m_weight[e.edge] += m_share.back() / double(chart.chart->walks.size()) * m_wish[e.edge] / wishes;
    }
    m_corners.emplace_back();
  }

  int samples(int chart, const std::vector<int>& counts) const {
    int n = 0;
    for (const Walk_edge& e : m_design.charts[chart]->chart->walks[0].edges) n += counts[e.edge];
    return n;
  }

  double counts_cost(const std::vector<int>& counts) const {
    double cost = 0;
    for (std::size_t e = 0; e < counts.size(); ++e)
      if (m_wish[e] > 0) cost += m_weight[e] * (counts[e] / m_wish[e] + m_wish[e] / counts[e] - 2);
    return price_of_counts * cost;
  }

  double quads(const std::vector<int>& counts) const {
    double number = 0;
    for (std::size_t c = 0; c < m_design.charts.size(); ++c) {
      const int n = samples(int(c), counts);
      number += m_annulus[c] >= 0 ? n * m_design.charts[c]->grid[1] : n * n / 16.0;
    }
    return number;
  }

  // For all corners at once, since they are asked for again and again.
  double corners(int chart, const Layout_integers& now) {
    const Chart& c = *m_design.charts[chart]->chart;
    std::vector<int> key;
    for (const Walk_edge& e : c.walks[0].edges) key.push_back(now.counts[e.edge]);
    std::vector<double>& costs = m_corners[chart][key];
    if (costs.empty()) {
      costs = areas_between_corners(c, Contour_samples{now.counts, m_design.samples.parameter});
      const double largest = *std::max_element(costs.begin(), costs.end());
      for (double& cost : costs)
        cost = largest > 0 ? price_of_corners * m_share[chart] * (1 - cost / largest) : 0;
    }
    return costs[now.turn[chart] % int(costs.size())];
  }

  const Design& m_design;
  std::vector<double> m_wish, m_weight; // per contour edge
  std::vector<double> m_share, m_quads; // per chart: its part of the area, and of the quads
  std::vector<double> m_turn_at_start;  // per chart: beyond the best turn, as a part of the way around
  std::vector<int> m_annulus;           // per chart: which of the turns, or -1
  std::vector<Turn_of_counts> m_turns;
  std::vector<Leaning> m_leaning;
  std::vector<std::map<std::vector<int>, std::vector<double>>>
      m_corners; // per chart, by the counts around it
  double m_counts_at_start = 0, m_quads_at_start = 0;
};

// Contour edges that can get more or fewer steps together: a cycle of charts, with the sign of each.
using Cycle = std::vector<std::pair<int, int>>;

// Counts are a flow from the charts below to those above; discs and what lies outside of the surface take and
// give what there is.
class Cycles {
public:
  Cycles(const Draft& draft, const Layout_lines& lines) : m_ground(lines.number_of_charts()) {
    const Contour_network& network = draft.network;
    m_arcs.assign(network.edges.size(), {-1, -1});
    m_at.resize(m_ground + 1);
    for (int e = 0; e < int(network.edges.size()); ++e) {
      if (network.is_removed(network.edges[e]) || !is_free(draft, lines, e)) continue;
      for (int side = 0; side < 2; ++side) {
        const int c = draft.atlas().charts_of_edge[e][side];
        m_arcs[e][1 - side] = c < 0 || lines.is_disc(c) ? m_ground : c; // the left chart is above
      }
      for (int node : m_arcs[e]) m_at[node].push_back(e);
    }
    for (int e = 0; e < int(m_arcs.size()); ++e)
      if (m_arcs[e][0] >= 0) find(e);
  }
  const std::vector<Cycle>& all() const { return m_cycles; }

private:
  static bool is_free(const Draft& draft, const Layout_lines& lines, int e) {
    const Contour_edge& edge = draft.network.edges[e];
    const std::array<int, 2>& sides = draft.atlas().charts_of_edge[e];
    if (sides[0] == sides[1] || edge.left != Side::low || edge.right != Side::high) return false;
    for (int c : sides) {
      if (c < 0) continue;
      const Chart_settings& settings = draft.before().charts[c]->settings;
      if (lines.is_rectangle(c) || settings.locked || settings.columns > 0) return false;
    }
    return true;
  }

  // For each contour edge that can follow e, the shortest cycle.
  void find(int e) {
    const int from = m_arcs[e][0], to = m_arcs[e][1];
    if (from == to) return m_cycles.push_back({{e, 1}});
    for (int second : m_at[to]) {
      if (second == e) continue;
      const int end = m_arcs[second][0] == to ? m_arcs[second][1] : m_arcs[second][0];
      Cycle cycle{{e, 1}, {second, m_arcs[second][0] == to ? 1 : -1}};
      if (end == to || !close(cycle, end, from, to)) continue;
      m_cycles.push_back(std::move(cycle));
    }
  }

  // Goes on from a chart to the cycle's beginning, on the shortest way that does not pass `without`.
  bool close(Cycle& cycle, int at, int beginning, int without) const {
    std::vector<int> by(m_at.size(), -1);
    std::deque<int> queue{beginning};
    std::vector<char> seen(m_at.size(), 0);
    seen[beginning] = seen[without] = 1;
    while (!queue.empty() && !seen[at]) {
      const int node = queue.front();
      queue.pop_front();
      for (int e : m_at[node]) {
        const int other = m_arcs[e][0] == node ? m_arcs[e][1] : m_arcs[e][0];
        if (seen[other]) continue;
        seen[other] = 1;
        by[other] = e;
        queue.push_back(other);
      }
    }
    if (!seen[at]) return false;
    while (at != beginning) {
      const int e = by[at];
      const bool up = m_arcs[e][0] == at;
      cycle.push_back({e, up ? 1 : -1});
      at = m_arcs[e][up ? 1 : 0];
    }
    return true;
  }

  int m_ground;
  std::vector<std::array<int, 2>> m_arcs; // per contour edge: from the chart below to the chart above, or -1
  std::vector<std::vector<int>> m_at;     // per chart, and the ground: its contour edges
  std::vector<Cycle> m_cycles;
};

// A descent from the best of a walk that accepts worse layouts less and less (Kirkpatrick, Gelatt, Vecchi
// 1983).
class Alignment {
public:
  Alignment(const Draft& draft, Layout_lines& lines, const Align_layout& edit)
      : m_draft(draft), m_lines(lines), m_edit(edit), m_start(lines.integers()), m_price(draft, m_start),
        m_now(m_start), m_best(m_start) {
    const Sampling_edges limits = limits_of(draft);
    m_least = limits.first;
    m_most = limits.second;
    m_turn_prices.assign(lines.number_of_charts(), 0);
    for (int c = 0; c < lines.number_of_charts(); ++c) {
      m_turn_prices[c] = m_price.of_turn(c, m_now);
      if (!draft.before().charts[c]->settings.locked && !lines.is_rectangle(c)) m_free.push_back(c);
    }
    if (edit.counts > 1) m_cycles = Cycles(draft, lines).all();
    m_energy = m_best_energy = energy();
    m_patches = m_tried_patches;
  }

  Layout_integers run() {
    if (m_free.empty()) return m_best;
    descend();
    const int begin = m_tries;
    while (m_tries < m_edit.tries) {
      const double left = 1 - double(m_tries - begin) / (m_edit.tries - begin);
      m_temperature = first_temperature * m_edit.strength * left * left;
      step();
    }
    m_temperature = 0;
    restore(m_best);
    descend();
    return m_best;
  }

private:
  using Sampling_edges = std::pair<std::vector<int>, std::vector<int>>;

  Sampling_edges limits_of(const Draft& draft) const {
    const std::vector<Point> points = network_points(draft.surface(), draft.network);
    const Layout_sampling_problem layout = sampling_problem(
        points, draft.network, draft.atlas(), std::vector<double>(draft.before().charts.size(), 1.0));
    Sampling_edges limits{m_start.counts, m_start.counts};
    for (std::size_t i = 0; i < layout.edges.size(); ++i) {
      const int e = layout.edges[i], n = m_start.counts[e];
      limits.first[e] =
          std::min(n, std::max(layout.problem.edges[i].minimum, int(std::ceil(n / m_edit.counts))));
      // A short contour edge may always get one step more.
      limits.second[e] = m_edit.counts > 1 ? std::max(n + 2, int(n * m_edit.counts)) : n;
    }
    return limits;
  }

  double real() { return 0.5 * (m_random.next() + 1); }
  int below(int n) { return std::min(n - 1, int(real() * n)); }

  double energy() {
    ++m_tries;
    double price = m_price.of_counts(m_now.counts);
    for (double turn : m_turn_prices) price += turn;
    m_tried_patches = double(m_lines.patches());
    return m_edit.strength * std::log(m_tried_patches) + price;
  }

  // Keeps the present layout if it is good enough.
  bool accept() {
    const double tried = energy();
    const double worse = tried - m_energy;
    if (worse >= 0 && (m_temperature <= 0 || real() >= std::exp(-worse / m_temperature))) return false;
    m_energy = tried;
    m_patches = m_tried_patches;
    if (m_energy < m_best_energy - 1e-12) {
      m_best_energy = m_energy;
      m_best = m_now;
    }
    return true;
  }

  void turn(int chart, int to) {
    m_now.turn[chart] = m_lines.is_disc(chart) ? (to + m_lines.samples(chart)) % m_lines.samples(chart) : to;
    m_lines.set_turn(chart, m_now.turn[chart]);
    m_turn_prices[chart] = m_price.of_turn(chart, m_now);
  }

  bool try_turn(int chart, int by) {
    const int before = m_now.turn[chart];
    const double price = m_turn_prices[chart];
    turn(chart, before + by);
    if (m_turn_prices[chart] - price <= most_price() && accept()) return true;
    turn(chart, before);
    return false;
  }

  // Dearer turns could not pay if one patch were left.
  double most_price() const { return m_edit.strength * std::log(m_patches) + 3 * m_temperature; }

  void restore(const Layout_integers& layout) {
    m_now = layout;
    m_lines.set(layout);
    for (int c = 0; c < m_lines.number_of_charts(); ++c) m_turn_prices[c] = m_price.of_turn(c, m_now);
    m_energy = energy();
    m_patches = m_tried_patches;
  }

  // Two annuli that are turned against each other leave what lies beyond in line.
  bool try_two_turns(int first, int second, int by) {
    const int before = m_now.turn[first], other = m_now.turn[second];
    const double price = m_turn_prices[first] + m_turn_prices[second];
    turn(first, before + by);
    turn(second, other - by);
    if (m_turn_prices[first] + m_turn_prices[second] - price <= most_price() && accept()) return true;
    turn(first, before);
    turn(second, other);
    return false;
  }

  // Columns that lean stay as they are, as far as whole columns can.
  bool try_counts(const Cycle& cycle, int by) {
    for (const auto& [e, sign] : cycle)
      if (m_now.counts[e] + sign * by < m_least[e] || m_now.counts[e] + sign * by > m_most[e]) return false;
    const Layout_integers before = m_now;
    const double energy_before = m_energy;
    Layout_integers fresh = m_now;
    for (const auto& [e, sign] : cycle) fresh.counts[e] += sign * by;
    if (!m_price.keeps_quads(fresh.counts)) return false;
    for (int c = 0; c < m_lines.number_of_charts(); ++c)
      if (!m_lines.is_disc(c))
        fresh.turn[c] += int(std::lround(m_price.best_turn(c, fresh.counts)) -
                             std::lround(m_price.best_turn(c, before.counts)));
    m_lines.set(fresh);
    m_now = fresh;
    for (int c = 0; c < m_lines.number_of_charts(); ++c) {
      if (m_lines.is_disc(c) && !m_lines.is_rectangle(c) && m_now.turn[c] >= m_lines.samples(c))
        turn(c, m_now.turn[c] % m_lines.samples(c));
      m_turn_prices[c] = m_price.of_turn(c, m_now);
    }
    if (accept()) return true;
    m_now = before;
    m_lines.set(before);
    for (int c = 0; c < m_lines.number_of_charts(); ++c) m_turn_prices[c] = m_price.of_turn(c, m_now);
    m_energy = energy_before;
    return false;
  }

  // Every chart in turn to the best place, as long as that helps.
  void descend() {
    for (bool again = true; again && m_tries < 2 * m_edit.tries;) {
      again = false;
      for (int c : m_free) {
        const int reach = m_lines.is_disc(c) ? m_lines.turns_of_disc(c) / 2 : m_lines.samples(c) / 4;
        for (int sign : {1, -1})
          for (int by = 1; by <= reach; ++by)
            if (try_turn(c, sign * by)) again = true;
      }
    }
  }

  void step() {
    const int kind = m_cycles.empty() ? below(3) : below(4);
    const int tries = m_tries;
    if (kind == 3) {
      const Cycle& cycle = m_cycles[below(int(m_cycles.size()))];
      try_counts(cycle, below(2) == 0 ? 2 : -2);
    } else if (kind == 2 && m_free.size() > 1) {
      const int first = m_free[below(int(m_free.size()))];
      const int second = m_free[below(int(m_free.size()))];
      if (first != second) try_two_turns(first, second, below(2) == 0 ? 1 : -1);
    } else {
      const int by = 1 + below(3), sign = below(2) == 0 ? 1 : -1;
      try_turn(m_free[below(int(m_free.size()))], sign * by);
    }
    if (m_tries == tries) ++m_tries; // a try, though one that was not looked at
  }

  const Draft& m_draft;
  Layout_lines& m_lines;
  const Align_layout& m_edit;
  const Layout_integers m_start;
  Price m_price;
  Layout_integers m_now, m_best;
  std::vector<int> m_least, m_most; // per contour edge
  std::vector<int> m_free;          // charts that may be turned
  std::vector<Cycle> m_cycles;
  std::vector<double> m_turn_prices; // per chart
  double m_energy = 0, m_best_energy = 0, m_temperature = 0;
  double m_patches = 1, m_tried_patches = 1;
  int m_tries = 0;
  shapes::Random_sequence m_random;
};

Result<void> check(const Align_layout& edit) {
  if (!(edit.strength > 0 && edit.strength <= 1))
    return make_error(Error_code::impossible_request, "the strength of an alignment is in (0, 1]");
  if (!(edit.counts >= 1 && edit.counts <= 4))
    return make_error(Error_code::impossible_request, "counts of an alignment change by a factor of 1 to 4");
  if (edit.tries < 1 || edit.tries > 100000000)
    return make_error(Error_code::impossible_request, "an alignment tries 1 to 100,000,000 layouts");
  return {};
}

} // namespace

Result<void> apply_edit(Draft& draft, const Align_layout& edit) {
  if (Result<void> fine = check(edit); !fine) return fine;
  const Design& before = draft.before();
  if (before.charts.empty()) return refuse("there is no chart");
  std::optional<Layout_lines> lines = Layout_lines::of(before);
  if (!lines) return refuse("the textures of the charts are not all regular", "reset them first");
  const Layout_integers start = lines->integers();
  const Layout_integers best = Alignment(draft, *lines, edit).run();
  draft.counts = best.counts; // also where they stay: sampled anew, others might do as well
  const Contour_samples samples{best.counts, before.samples.parameter};
  for (int c = 0; c < lines->number_of_charts(); ++c) {
    const Design_chart& chart = *before.charts[c];
    if (chart.settings.locked || lines->is_rectangle(c)) continue;
    Chart_settings& settings = draft.settings[chart.id];
    if (!lines->is_disc(c))
      settings.shift = best.turn[c] - int(std::lround(best_turn(*chart.chart, samples, *chart.map)));
    else if (best.turn[c] != start.turn[c] || best.counts != start.counts)
      settings.corner = best.turn[c];
  }
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
