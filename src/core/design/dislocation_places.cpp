// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/dislocation_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int fewest_columns = 4;
constexpr int pairs_in_a_row = 2; // more of them turn too many quads by 45 degrees
// Places in a row are told apart by the mean length of this part of a row's edges for each dislocation.
constexpr double window = 0.25;
// Near another dislocation a place is as bad as if its edges were longer, or shorter, by this part; it is as
// good as any from so many edges on.
constexpr double repulsion = 0.5, far_enough = 10;

double length_at(const Height_profile& profile, double u) {
  const int last = int(profile.length.size()) - 1;
  const double x = std::clamp(u, 0.0, 1.0) * last;
  const int i = std::min(last - 1, int(x));
  return profile.length[i] + (x - i) * (profile.length[i + 1] - profile.length[i]);
}

// Off the sides, if there are rows enough.
int pairs_of_each(int rows) {
  return std::min(pairs_in_a_row, std::max(1, rows - 2));
}

} // namespace

Dislocation_places::Dislocation_places(const Design_chart& chart, const std::array<int, 2>& grid,
                                       double edge_length)
    : m_chart(chart), m_low(grid[0]) {
  m_levels = graded_rows(chart.map->profile(), grid[1], chart.settings.grading);
  for (double u : m_levels) m_ideal.push_back(length_at(chart.map->profile(), u) / edge_length);
}

double Dislocation_places::cost(int row, int columns) const {
  const double n = std::max(1, columns), d = n - m_ideal[row];
  return d * d / n;
}

// The least cost of a chart's columns, row by row. A state is the number of columns and the pairs that are in
// the row below: where these change, rows of pairs begin or end, each in an extraordinary vertex.
class Dislocation_places::Program {
public:
  Program(const Dislocation_places& places, int columns, double price)
      : m_places(places), m_rows(int(places.m_levels.size()) - 1), m_goal(columns / 2), m_price(price) {
    int most = 2 * std::max(places.m_low, places.m_low + columns);
    if (price > 0)
      for (double ideal : places.m_ideal) most = std::max(most, std::min(int(1.2 * ideal), 2 * most));
    m_least = -(places.m_low - fewest_columns) / 2;
    m_size = (most - places.m_low) / 2 - m_least + 1;
    const bool both = price > 0;
    m_slowest = columns <= 0 || both ? -most_in_row(columns) : 0;
    m_fastest = columns >= 0 || both ? most_in_row(columns) : 0;
    m_width = m_fastest - m_slowest + 1;
  }

  // The pairs in each row; nothing if there are too many.
  std::vector<int> run() {
    m_cost.assign(std::size_t(m_size * m_width), never);
    if (0 < m_least || 0 >= m_least + m_size) return {};
    m_cost[state(0, 0)] = 0;
    m_from.assign(std::size_t(m_rows), std::vector<int>(m_cost.size(), -1));
    for (int r = 0; r < m_rows; ++r) advance(r);
    int best = -1;
    for (int pairs = m_slowest; pairs <= m_fastest; ++pairs) {
      const int s = state(m_goal, pairs);
      if (m_cost[s] == never) continue;
      m_cost[s] += m_price * std::abs(pairs);
      if (best < 0 || m_cost[s] < m_cost[best]) best = s;
    }
    if (best < 0) return {};
    std::vector<int> pairs(static_cast<std::size_t>(m_rows));
    for (int r = m_rows - 1; r >= 0; --r) {
      pairs[std::size_t(r)] = best % m_width + m_slowest;
      best = m_from[std::size_t(r)][std::size_t(best)];
    }
    return pairs;
  }

private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  int state(int gained, int pairs) const { return (gained - m_least) * m_width + pairs - m_slowest; }
  // A few, or as many as it takes, as long as there is place between them.
  int most_in_row(int columns) const {
    const int room = std::min(m_places.m_low, m_places.m_low + columns) / 8;
    return std::max(1, std::min(room, std::max(4, 1 + std::abs(columns) / m_rows)));
  }
  // Off the sides, if there are rows enough.
  bool may_have_pairs(int row) const { return m_rows < 4 || (row > 0 && row + 1 < m_rows); }

  void advance(int row) {
    std::vector<double> next(m_cost.size(), never);
    for (int gained = m_least; gained < m_least + m_size; ++gained)
      for (int before = m_slowest; before <= m_fastest; ++before) {
        const double cost = m_cost[state(gained, before)];
        if (cost == never) continue;
        for (int pairs = m_slowest; pairs <= m_fastest; ++pairs) {
          const int after = gained + pairs;
          if (after < m_least || after >= m_least + m_size || (pairs != 0 && !may_have_pairs(row))) continue;
          const double c = cost + m_price * std::abs(pairs - before) + 1e-3 * std::abs(pairs) +
                           m_places.cost(row + 1, m_places.m_low + 2 * after);
          const int s = state(after, pairs);
          if (c >= next[s]) continue;
          next[s] = c;
          m_from[std::size_t(row)][std::size_t(s)] = state(gained, before);
        }
      }
    m_cost = std::move(next);
  }

  const Dislocation_places& m_places;
  int m_rows, m_goal;
  double m_price;
  int m_least = 0, m_size = 0; // of the pairs gained
  int m_slowest = 0, m_fastest = 0, m_width = 1;
  std::vector<double> m_cost;
  std::vector<std::vector<int>> m_from;
};

int Dislocation_places::choose_rows(int columns, double price_of_end) {
  m_begins.clear();
  const std::vector<int> pairs = Program(*this, columns, price_of_end).run();
  const int rows = int(m_levels.size()) - 1, each = pairs_of_each(rows);
  std::vector<std::array<int, 2>> open; // begins that may go on: index, pairs so far
  int left = columns / 2;
  for (int r = 0; r < int(pairs.size()); ++r) {
    std::vector<std::array<int, 2>> next;
    for (int i = std::abs(pairs[std::size_t(r)]); i > 0; --i) {
      const int sign = pairs[std::size_t(r)] < 0 ? -1 : 1;
      const auto on = std::find_if(open.begin(), open.end(), [&](const std::array<int, 2>& o) {
        return o[1] < each && m_begins[std::size_t(o[0])].pairs * sign > 0;
      });
      if (on == open.end()) {
        m_begins.push_back({r, sign});
        next.push_back({int(m_begins.size()) - 1, 1});
      } else {
        m_begins[std::size_t((*on)[0])].pairs += sign;
        next.push_back({(*on)[0], (*on)[1] + 1});
        open.erase(on);
      }
      left -= sign;
    }
    open = std::move(next);
  }
  // What no rows had room for: it is seen there whether there is.
  for (; left != 0; left += left < 0 ? 1 : -1) m_begins.push_back({rows / 2, left < 0 ? -1 : 1});
  return int(m_begins.size());
}

// V of the place in a row of so many columns.
double Dislocation_places::best_place(const Chart_locator& locator, int row, int columns, bool ends) const {
  const double u = m_levels[row];
  std::vector<Point> at;
  for (int i = 0; i < columns; ++i)
    at.push_back(position(*m_chart.chart, locator.locate(double(i) / columns, u)));
  std::vector<double> edge;
  double sum = 0;
  for (int i = 0; i < columns; ++i) {
    edge.push_back((at[(i + 1) % columns] - at[i]).norm());
    sum += edge.back();
  }
  int in_row = 1;
  for (const std::array<double, 2>& t : m_taken) in_row += int(t[1]) == row;
  const int reach = std::max(2, int(window * columns / in_row));
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < columns; ++i) {
    double length = 0, weights = 0;
    for (int k = -reach; k < reach; ++k) {
      const double weight = 1 - std::abs(k + 0.5) / reach;
      length += weight * edge[((i + k) % columns + columns) % columns];
      weights += weight;
    }
    double nearest = far_enough;
    for (const std::array<double, 2>& t : m_taken)
      nearest = std::min(nearest,
                         std::hypot(std::remainder(t[0] - double(i) / columns, 1.0) * columns, t[1] - row));
    const double bad = (ends ? 1 : -1) * length / weights * columns / std::max(sum, 1e-300) -
                       repulsion * nearest / far_enough;
    if (bad >= least - 1e-9) continue;
    least = bad;
    best = i;
  }
  return double(best) / columns;
}

std::int64_t Dislocation_places::quads() const {
  std::int64_t sum = 0;
  int around = m_low;
  std::size_t next = 0;
  for (int r = 0; r + 1 < int(m_levels.size()); ++r) {
    const int below = around;
    for (; next < m_begins.size() && m_begins[next].row <= r; ++next) around += 2 * m_begins[next].pairs;
    sum += (below + around) / 2;
  }
  return sum;
}

std::vector<Design_dislocation> Dislocation_places::place() {
  std::vector<Design_dislocation> placed;
  if (m_begins.empty()) return placed;
  const Chart_locator locator(*m_chart.chart, *m_chart.map);
  const int rows = int(m_levels.size()) - 1;
  m_taken.clear();
  int around = m_low;
  for (const Begin& b : m_begins) {
    const double v = best_place(locator, b.row, std::max(fewest_columns, around), b.pairs < 0);
    const double u = 0.5 * (m_levels[b.row] + m_levels[std::min(rows, b.row + std::abs(b.pairs))]);
    placed.push_back({position(*m_chart.chart, locator.locate(v, u)), 2 * b.pairs});
    m_taken.push_back({v, double(b.row)});
    around += 2 * b.pairs;
  }
  return placed;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
