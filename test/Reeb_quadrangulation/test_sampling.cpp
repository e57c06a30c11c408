// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/sampling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>

using namespace CGAL::Reeb_quadrangulation;
using Kind = Sampling_chart::Kind;

namespace {

// splitmix64: a fixed algorithm, so that every platform has the same layouts.
struct Dice {
  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  int below(int n) { return int(next() % std::uint64_t(n)); }
  double between(double a, double b) { return a + (b - a) * double(next() >> 11) * 0x1p-53; }
  double spread(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
};

// Sweeps a random Morse function upwards. The level set is a list of open charts, each annulus with its low
// walk; a birth caps a minimum, a split or merge puts a figure-8 between charts, a death caps a maximum.
class Random_layout {
public:
  Random_layout(std::uint64_t seed, int saddles, int births) : m_random{seed} {
    birth();
    for (int i = 1, s = 0; s < saddles; ++s) {
      if (i < births && m_random.below(3) == 0) {
        birth();
        ++i;
      }
      if (m_open.size() > 1 && m_random.below(2) == 0)
        merge();
      else
        split();
    }
    while (m_open.size() > 1) m_random.below(2) ? merge() : death();
    death();
  }
  Sampling_problem problem;

private:
  int edge(int minimum) {
    Sampling_edge e;
    e.length = m_random.spread(0.2, 5);
    e.minimum = minimum;
    problem.edges.push_back(e);
    return int(problem.edges.size()) - 1;
  }
  int open_chart(std::vector<int> low) {
    Sampling_chart c;
    c.low = std::move(low);
    c.height = m_random.spread(0.02, 3);
    problem.charts.push_back(c);
    m_open.push_back(int(problem.charts.size()) - 1);
    return m_open.back();
  }
  int take() {
    const int i = m_random.below(int(m_open.size())), c = m_open[i];
    m_open.erase(m_open.begin() + i);
    return c;
  }
  void cap(std::vector<int> low, std::vector<int> high) {
    Sampling_chart c;
    c.kind = Kind::disc;
    c.low = std::move(low);
    c.high = std::move(high);
    problem.charts.push_back(c);
  }
  void birth() {
    const int e = edge(4);
    cap({}, {e});
    open_chart({e});
  }
  void death() {
    const int c = take(), e = edge(4);
    problem.charts[c].high = {e};
    cap({e}, {});
  }
  void split() {
    const int c = take(), a = edge(4), b = edge(4);
    problem.charts[c].high = {a, b};
    open_chart({a});
    open_chart({b});
  }
  void merge() {
    const int c = take(), d = take(), a = edge(4), b = edge(4);
    problem.charts[c].high = {a};
    problem.charts[d].high = {b};
    open_chart({a, b});
  }
  Dice m_random;
  std::vector<int> m_open;
};

int sum(const std::vector<int>& walk, const std::vector<int>& counts) {
  int result = 0;
  for (int e : walk) result += counts[e];
  return result;
}

// All that a sampling promises, for any problem.
void require_valid(const Sampling_problem& problem, const Sampling& s) {
  REQUIRE(s.counts.size() == problem.edges.size());
  REQUIRE(s.grid.size() == problem.charts.size());
  bool in_bounds = true, conserved = true, discs = true;
  for (std::size_t e = 0; e < problem.edges.size(); ++e) {
    const Sampling_edge& edge = problem.edges[e];
    in_bounds = in_bounds && s.counts[e] >= edge.minimum && s.counts[e] % edge.step == 0;
    if (edge.locked > 0) in_bounds = in_bounds && s.counts[e] == edge.locked;
  }
  std::int64_t quads = 0;
  for (std::size_t c = 0; c < problem.charts.size(); ++c) {
    const Sampling_chart& chart = problem.charts[c];
    const int low = sum(chart.low, s.counts), high = sum(chart.high, s.counts);
    const auto [a, b] = s.grid[c];
    quads += std::int64_t(a) * b;
    if (chart.kind == Kind::annulus)
      conserved = conserved && low == high && a == low && b >= 2 &&
                  (chart.locked_rows == 0 || b == chart.locked_rows);
    else
      discs = discs && low + high >= 4 && low + high == 2 * (a + b) && b >= 1 && (a == b || a == b + 1);
  }
  for (const Sampling_equality& q : problem.equalities)
    conserved = conserved && sum(q.first, s.counts) == sum(q.second, s.counts);
  REQUIRE(in_bounds);
  REQUIRE(conserved);
  REQUIRE(discs);
  REQUIRE(quads == s.quads);
}

// What n steps on contour edge e cost: the rows beside it, times how much their quads are stretched.
double cost(const Sampling_problem& problem, std::size_t e, double n, double h) {
  double reach = 0;
  for (const Sampling_chart& c : problem.charts)
    for (const std::vector<int>& walk : {c.low, c.high}) {
      double length = 0;
      for (int f : walk) length += problem.edges[std::size_t(f)].length;
      const double across = c.kind == Kind::annulus ? c.height : length / 4;
      reach += across / 2 * double(std::count(walk.begin(), walk.end(), int(e)));
    }
  const double ideal = problem.edges[e].length / h;
  return std::max(1.0, reach / h) * (n - ideal) * (n - ideal) / n;
}

double cost(const Sampling_problem& problem, const std::vector<int>& counts, double h) {
  double total = 0;
  for (std::size_t e = 0; e < counts.size(); ++e) total += cost(problem, e, counts[e], h);
  return total;
}

// The least cost by trying every count up to `limit`.
double brute_force(const Sampling_problem& problem, double h, int limit) {
  std::vector<int> counts;
  double best = 1e300;
  const std::function<void()> extend = [&] {
    if (counts.size() == problem.edges.size()) {
      for (const Sampling_chart& c : problem.charts) {
        if (c.kind == Kind::annulus && sum(c.low, counts) != sum(c.high, counts)) return;
        const int perimeter = sum(c.low, counts) + sum(c.high, counts);
        if (c.kind == Kind::disc && (perimeter % 2 != 0 || perimeter < 4)) return;
      }
      for (const Sampling_equality& q : problem.equalities)
        if (sum(q.first, counts) != sum(q.second, counts)) return;
      best = std::min(best, cost(problem, counts, h));
      return;
    }
    const Sampling_edge& e = problem.edges[counts.size()];
    const int first = e.locked > 0 ? e.locked : e.minimum, last = e.locked > 0 ? e.locked : limit;
    for (int n = first; n <= last; n += e.step) {
      counts.push_back(n);
      extend();
      counts.pop_back();
    }
  };
  extend();
  return best;
}

Sampling_edge edge(double length, int minimum = 2, int step = 2) {
  Sampling_edge e;
  e.length = length;
  e.minimum = minimum;
  e.step = step;
  return e;
}

Sampling_chart annulus(std::vector<int> low, std::vector<int> high, double height = 1) {
  Sampling_chart c;
  c.low = std::move(low);
  c.high = std::move(high);
  c.height = height;
  return c;
}

Sampling_chart disc(std::vector<int> low, std::vector<int> high) {
  Sampling_chart c = annulus(std::move(low), std::move(high), 0);
  c.kind = Kind::disc;
  return c;
}

// A sphere: two caps and one annulus.
Sampling_problem sphere(double low, double high, double height) {
  return {{edge(low, 4), edge(high, 4)}, {disc({}, {0}), annulus({0}, {1}, height), disc({1}, {})}, {}};
}

} // namespace

TEST_CASE("the caps of a sphere share one count, a multiple of two nearest to the lengths") {
  const auto s = sample_layout(sphere(8, 8, 5), 1);
  REQUIRE(bool(s));
  CHECK(s->counts == std::vector<int>{8, 8});
  CHECK(s->grid[0] == std::array<int, 2>{2, 2});
  CHECK(s->grid[1] == std::array<int, 2>{8, 5});
  CHECK(s->quads == 4 + 40 + 4);
  CHECK(s->worst_ratio == Approx(1));
  // 6 edges around a cap: 2 x 1 quads.
  const auto t = sample_layout(sphere(6, 6, 5), 1);
  REQUIRE(bool(t));
  CHECK(t->grid[2] == std::array<int, 2>{2, 1});
}

TEST_CASE("counts have lower bounds and annuli two rows, however long the quads are wanted") {
  const auto s = sample_layout(sphere(8, 3, 5), 1000);
  REQUIRE(bool(s));
  CHECK(s->counts == std::vector<int>{4, 4});
  CHECK(s->grid[1] == std::array<int, 2>{4, 2});
  CHECK(s->worst_ratio == Approx(4 * 1000 / 3.0));
  CHECK(s->worst_edge == 1);
}

TEST_CASE("random layouts always have a sampling, exact at every chart") {
  for (int seed = 0; seed < 300; ++seed) {
    const Random_layout layout(seed, 1 + seed % 40, 1 + seed % 6);
    Dice random{std::uint64_t(1000 + seed)};
    const auto s = sample_layout(layout.problem, random.spread(0.01, 30));
    REQUIRE(bool(s));
    require_valid(layout.problem, *s);
  }
}

TEST_CASE("on tiny layouts no counts are better") {
  for (int seed = 0; seed < 60; ++seed) {
    const Random_layout layout(seed, 1, 2);
    Dice random{std::uint64_t(seed)};
    const double h = random.spread(0.4, 2);
    if (layout.problem.edges.size() > 6) continue;
    const auto s = sample_layout(layout.problem, h);
    REQUIRE(bool(s));
    const double best = brute_force(layout.problem, h, 18);
    CHECK(cost(layout.problem, s->counts, h) <= best * (1 + 1e-12) + 1e-12);
  }
}

TEST_CASE("no cycle of moves improves a large sampling") {
  // Optimality of a convex flow: no negative cycle in the residual graph, by Bellman and Ford.
  for (int seed = 0; seed < 10; ++seed) {
    const Random_layout layout(seed, 60, 4);
    const auto& edges = layout.problem.edges;
    const double h = 0.15;
    const auto s = sample_layout(layout.problem, h);
    REQUIRE(bool(s));
    const int ground = int(layout.problem.charts.size());
    std::vector<int> from(edges.size(), ground), to(edges.size(), ground);
    for (int c = 0; c < ground; ++c) {
      if (layout.problem.charts[c].kind == Kind::disc) continue;
      for (int e : layout.problem.charts[c].low) to[e] = c;
      for (int e : layout.problem.charts[c].high) from[e] = c;
    }
    std::vector<double> distance(ground + 1, 0);
    bool changed = true;
    for (int round = 0; round <= ground + 1 && changed; ++round) {
      changed = false;
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const int n = s->counts[e];
        const double now = cost(layout.problem, e, n, h), up = cost(layout.problem, e, n + 2, h) - now;
        const auto relax = [&](int a, int b, double length) {
          if (distance[a] + length >= distance[b] - 1e-9) return;
          distance[b] = distance[a] + length;
          changed = true;
        };
        relax(from[e], to[e], up);
        if (n - 2 >= edges[e].minimum) relax(to[e], from[e], cost(layout.problem, e, n - 2, h) - now);
      }
    }
    CHECK_FALSE(changed);
  }
}

TEST_CASE("a target number of quads is met within five percent if possible, and mostly within one") {
  int within_one = 0, runs = 0;
  for (int seed = 0; seed < 40; ++seed) {
    const Random_layout layout(seed, seed % 12, 1 + seed % 4);
    const auto least = fewest_quads(layout.problem);
    REQUIRE(bool(least));
    for (int target : {300, 1000, 3000, 10000, 30000}) {
      const auto s = sample_for_quads(layout.problem, target);
      REQUIRE(bool(s));
      require_valid(layout.problem, *s);
      const double off = std::abs(double(s->quads) / target - 1);
      CHECK(s->target_met == (off <= 0.05));
      if (least->quads > target) {
        CHECK(s->quads == least->quads);
        continue;
      }
      CHECK(off <= 0.05);
      ++runs;
      within_one += off <= 0.01;
    }
  }
  CHECK(runs > 150);
  CHECK(within_one >= runs * 9 / 10);
}

TEST_CASE("quads are near squares where the layout has room for them") {
  Sampling_problem p;
  p.edges = {edge(4, 4), edge(3, 4), edge(2.5, 4), edge(2.8, 4), edge(2.2, 4)};
  p.charts = {disc({}, {0}),          annulus({0}, {1, 2}, 3), annulus({1}, {3}, 2),
              annulus({2}, {4}, 2.5), disc({3}, {}),           disc({4}, {})};
  for (int target : {200, 500, 1000, 5000, 20000}) {
    const auto s = sample_for_quads(p, target);
    REQUIRE(bool(s));
    require_valid(p, *s);
    CHECK(std::abs(double(s->quads) / target - 1) <= 0.02);
    CHECK(s->worst_ratio < 1.7);
    for (int c : {1, 2, 3})
      CHECK(s->grid[c][1] * s->edge_length / p.charts[c].height == Approx(1).epsilon(0.5));
  }
}

TEST_CASE("if the layout cannot be so coarse, the fewest quads are given and named") {
  const Random_layout layout(3, 40, 5);
  const auto s = sample_for_quads(layout.problem, 50);
  REQUIRE(bool(s));
  require_valid(layout.problem, *s);
  CHECK_FALSE(s->target_met);
  CHECK(s->fewest == s->quads);
  CHECK(s->quads > 50);
  // Every one of them is at least what any sampling of the same layout has.
  for (double h : {0.5, 2.0, 8.0, 100.0}) {
    const auto t = sample_layout(layout.problem, h);
    REQUIRE(bool(t));
    CHECK(t->quads >= s->fewest);
  }
}

TEST_CASE("after a small edit only the counts that must change do") {
  int kept = 0, kept_cold = 0, all = 0;
  for (int seed = 0; seed < 20; ++seed) {
    Random_layout layout(seed, 20, 3);
    const auto before = sample_for_quads(layout.problem, 5000);
    REQUIRE(bool(before));
    Sampling_options warm;
    warm.previous_counts = before->counts;
    for (const auto& g : before->grid) warm.previous_rows.push_back(g[1]);
    warm.previous_edge_length = before->edge_length;
    // Nothing changed: the same solution.
    const auto same = sample_layout(layout.problem, before->edge_length, warm);
    REQUIRE(bool(same));
    CHECK(same->counts == before->counts);
    // A contour moves: one length and one height change.
    layout.problem.edges[seed % layout.problem.edges.size()].length *= 1.15;
    const auto after = sample_for_quads(layout.problem, 5000, warm);
    const auto cold = sample_for_quads(layout.problem, 5000);
    REQUIRE(bool(after));
    REQUIRE(bool(cold));
    require_valid(layout.problem, *after);
    CHECK(after->target_met);
    for (std::size_t e = 0; e < before->counts.size(); ++e) {
      ++all;
      kept += after->counts[e] == before->counts[e];
      kept_cold += cold->counts[e] == before->counts[e];
    }
  }
  CHECK(kept >= all * 95 / 100);
  CHECK(kept >= kept_cold);
}

TEST_CASE("locked edges and rows keep theirs, and others follow") {
  Sampling_problem p = sphere(8, 9, 5);
  p.edges[0].locked = 14;
  p.charts[1].locked_rows = 3;
  const auto s = sample_layout(p, 1);
  REQUIRE(bool(s));
  CHECK(s->counts == std::vector<int>{14, 14});
  CHECK(s->grid[1] == std::array<int, 2>{14, 3});
  p.edges[1].locked = 16;
  const auto t = sample_layout(p, 1);
  REQUIRE_FALSE(bool(t));
  CHECK(t.error().code == Error_code::infeasible_sampling);
  CHECK(t.error().element == Element_kind::chart);
  CHECK(t.error().index == 1);
  p.edges[1].locked = 3;
  const auto u = sample_layout(p, 1);
  REQUIRE_FALSE(bool(u));
  CHECK(u.error().element == Element_kind::contour);
  CHECK(u.error().index == 1);
}

TEST_CASE("a segment that one walk passes twice is a pole of the flow") {
  // Half-pole m under an annulus, dumbbell e1 m e2 m^-1 above it, two caps.
  Sampling_problem p;
  p.edges = {edge(3, 2, 1), edge(4, 4), edge(5, 4), edge(1.4, 2, 1), edge(4, 4), edge(5, 4)};
  p.charts = {annulus({0, 0}, {1, 2, 3, 3}), annulus({1}, {4}), annulus({2}, {5}), disc({4}, {}),
              disc({5}, {})};
  const auto s = sample_layout(p, 0.5);
  REQUIRE(bool(s));
  require_valid(p, *s);
  CHECK(cost(p, s->counts, 0.5) <= brute_force(p, 0.5, 16) * (1 + 1e-12));
}

TEST_CASE("a theta half-saddle is no flow, and is sampled all the same") {
  // A below the theta has x and y; B above x and m, C above y and m.
  Sampling_problem p;
  p.edges = {edge(6, 4), edge(3.1), edge(2.9), edge(1.2), edge(4, 4), edge(5, 4)};
  p.charts = {disc({}, {0}),        annulus({0}, {1, 2}), annulus({1, 3}, {4}),
              annulus({2, 3}, {5}), disc({4}, {}),        disc({5}, {})};
  for (double h : {0.3, 0.5, 0.8, 2.0}) {
    const auto s = sample_layout(p, h);
    REQUIRE(bool(s));
    require_valid(p, *s);
    CHECK(cost(p, s->counts, h) <= brute_force(p, h, 24) * (1 + 1e-12));
  }
}

TEST_CASE("pinned corners make opposite sides of a disc equal") {
  Sampling_problem p;
  p.edges = {edge(3), edge(1), edge(2), edge(1.5), edge(8, 4)};
  p.charts = {disc({}, {0, 1, 2, 3}), annulus({0, 1, 2, 3}, {4}), disc({4}, {})};
  p.equalities = {{{0}, {2}, 0}, {{1}, {3}, 0}};
  for (double h : {0.1, 0.25, 0.4, 1.0}) {
    const auto s = sample_layout(p, h);
    REQUIRE(bool(s));
    require_valid(p, *s);
    if (h >= 0.25) CHECK(cost(p, s->counts, h) <= brute_force(p, h, 34) * (1 + 1e-12));
  }
}

TEST_CASE("equations that force a count to nothing are named") {
  // A's upper walk is e1 m e2 m^-1 and B stands on e1 alone; a chain asks n_A = n_B.
  Sampling_problem p;
  p.edges = {edge(4, 4), edge(2, 2, 1), edge(4, 4), edge(6, 4), edge(4, 4), edge(4, 4)};
  p.charts = {disc({}, {3}), annulus({3}, {0, 1, 1, 2}), annulus({0}, {4}), annulus({2}, {5}), disc({4}, {}),
              disc({5}, {})};
  REQUIRE(bool(sample_layout(p, 1)));
  p.equalities = {{{3}, {4}, 1}};
  const auto s = sample_layout(p, 1);
  REQUIRE_FALSE(bool(s));
  CHECK(s.error().code == Error_code::infeasible_sampling);
  CHECK(s.error().element == Element_kind::chart);
  CHECK((s.error().index == 1 || s.error().index == 2));
}

TEST_CASE("open ends need no caps") {
  Sampling_problem p;
  p.edges = {edge(7, 4), edge(5, 4)};
  p.charts = {annulus({0}, {1}, 3)};
  const auto s = sample_layout(p, 0.5);
  REQUIRE(bool(s));
  require_valid(p, *s);
  CHECK(s->counts[0] == 12);
}

TEST_CASE("nonsense is refused with a reason") {
  CHECK(sample_layout(sphere(1, 1, 1), 0).error().code == Error_code::impossible_request);
  CHECK(sample_layout(sphere(1, 1, 1), std::nan("")).error().code == Error_code::impossible_request);
  CHECK(sample_layout(sphere(1, 1, 1), 1e-12).error().code == Error_code::impossible_request);
  CHECK(sample_layout(sphere(1, -1, 1), 1).error().index == 1);
  CHECK(sample_for_quads(sphere(1, 1, 1), 0).error().code == Error_code::impossible_request);
}

TEST_CASE("samplings are fast enough to follow a drag", "[time]") {
  const auto milliseconds = [](const Sampling_problem& p, double h) {
    const auto start = std::chrono::steady_clock::now();
    const auto s = sample_layout(p, h);
    REQUIRE(bool(s));
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  };
  const Random_layout small(1, 6, 2), large(2, 270, 5);
  CHECK(milliseconds(small.problem, 0.1) < 100); // generous: sanitizers and shared machines
  CHECK(milliseconds(large.problem, 0.1) < 2000);
}
