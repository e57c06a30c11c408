// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/dislocation_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

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

} // namespace

Dislocation_places::Dislocation_places(const Design_chart& chart, int low, double edge_length)
    : m_chart(chart), m_low(low), m_locator(*chart.chart, *chart.map) {
  m_levels = graded_rows(chart.map->profile(), chart.grid[1], chart.settings.grading);
  for (double u : m_levels) m_ideal.push_back(length_at(chart.map->profile(), u) / edge_length);
}

double Dislocation_places::cost(int row, int columns) const {
  const double n = std::max(1, columns), d = n - m_ideal[row];
  return d * d / n;
}

// For each of some dislocations, in order, the row that it begins in: least costs of all rows' columns.
std::vector<int> Dislocation_places::choose_rows(int number, int columns_each, int columns_of_last) const {
  const int rows = int(m_levels.size()) - 1;
  const auto columns = [&](int placed) {
    return m_low + placed * columns_each + (placed == number ? columns_of_last - columns_each : 0);
  };
  constexpr double never = std::numeric_limits<double>::infinity();
  for (int most_in_row = std::max(1, std::min(columns(0), columns(number)) / 8);; most_in_row *= 2) {
    std::vector<std::vector<double>> least(rows + 1, std::vector<double>(number + 1, never));
    std::vector<std::vector<int>> from(rows + 1, std::vector<int>(number + 1, 0));
    least[0][0] = 0;
    for (int r = 1; r <= rows; ++r)
      for (int j = 0; j <= number; ++j)
        for (int i = std::max(0, j - most_in_row); i <= j; ++i) {
          const double c = least[r - 1][i] + cost(r, columns(j));
          if (c >= least[r][j]) continue;
          least[r][j] = c;
          from[r][j] = i;
        }
    if (least[rows][number] == never) continue;
    std::vector<int> chosen(number);
    for (int r = rows, j = number; r > 0; --r) {
      for (int i = from[r][j]; i < j; ++i) chosen[i] = r - 1;
      j = from[r][j];
    }
    return chosen;
  }
}

// V of the place in a row of so many columns.
double Dislocation_places::best_place(int row, int columns, bool ends) const {
  const double u = m_levels[row];
  std::vector<Point> at;
  for (int i = 0; i < columns; ++i)
    at.push_back(position(*m_chart.chart, m_locator.locate(double(i) / columns, u)));
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

std::vector<Design_dislocation> Dislocation_places::place(int columns) {
  std::vector<Design_dislocation> placed;
  if (columns == 0) return placed;
  const int sign = columns < 0 ? -1 : 1, pairs = std::abs(columns) / 2;
  const int rows = int(m_levels.size()) - 1;
  const int each = std::min(pairs_in_a_row, std::max(1, rows - 2));
  const int number = (pairs + each - 1) / each, last = pairs - each * (number - 1);
  const std::vector<int> begin = choose_rows(number, 2 * sign * each, 2 * sign * last);
  int around = m_low;
  for (int i = 0; i < number; ++i) {
    const int k = i + 1 < number ? each : last, row = begin[i];
    const double v = best_place(row, std::max(4, around), sign < 0);
    const double u = 0.5 * (m_levels[row] + m_levels[std::min(rows, row + k)]);
    placed.push_back({position(*m_chart.chart, m_locator.locate(v, u)), 2 * sign * k});
    m_taken.push_back({v, double(row)});
    around += 2 * sign * k;
  }
  return placed;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
