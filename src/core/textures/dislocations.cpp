// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/dislocations.h>

#include "textures/texture_plane.h"

#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

int rows_for_dislocations(int most_pairs) {
  return std::max(2, most_pairs + 1);
}

namespace {

constexpr int fewest_columns = 4;
constexpr int ring_sweeps = 10; // that even out a level line after columns have ended or begun there

double wrapped_step(double v) {
  return v - std::round(v);
}

// Builds a texture from the low side up, ring by ring. A ring is a level line's vertices, V increasing.
class Dislocated_annulus {
public:
  Dislocated_annulus(int columns, const std::vector<double>& levels,
                     const std::vector<Dislocation>& dislocations)
      : m_levels(levels), m_dislocations(dislocations), m_rows(int(levels.size()) - 1) {
    m_out.ends.assign(dislocations.size(), {{-1, -1}});
    m_state.resize(dislocations.size());
    for (int i = 0; i < columns; ++i) {
      m_ring.v.push_back(double(i) / columns);
      m_ring.id.push_back(add_vertex(0));
    }
    m_out.texture.sides.push_back(m_ring.id);
  }

  // Nothing if there is no room where each dislocation begins at most `earlier` rows below its place.
  std::optional<Dislocated_texture> run(int earlier) {
    for (std::size_t d = 0; d < m_state.size(); ++d)
      if (!choose_rows(d, earlier)) return std::nullopt;
    for (int r = 0; r < m_rows; ++r)
      if (!add_row(r)) return std::nullopt;
    close();
    return std::move(m_out);
  }

private:
  struct Ring {
    std::vector<int> id;
    std::vector<double> v;
    int size() const { return int(id.size()); }
  };
  struct State {
    int first = 0, last = 0; // the rows where it may begin
    int done = 0;            // pairs
    int tip = -1;            // the vertex that the next pair begins in
  };
  enum class Role : signed char { plain, end, beginning, beside }; // beside: a column that an end takes

  int add_vertex(int row) {
    m_out.texture.v.push_back(0);
    m_out.texture.u.push_back(m_levels[row]);
    return int(m_out.texture.v.size()) - 1;
  }

  // Rows that keep off the walks, if there are enough.
  bool choose_rows(std::size_t d, int earlier) {
    const Dislocation& x = m_dislocations[d];
    const int k = x.pairs();
    int low = x.columns < 0 ? 1 : 0, high = x.columns < 0 ? m_rows - k : m_rows - 1 - k;
    if (high < low) return false;
    if (m_rows - 1 - k >= 1) {
      low = 1;
      high = m_rows - 1 - k;
    }
    int best = low;
    const auto off = [&](int r) { return std::abs(0.5 * (m_levels[r] + m_levels[r + k]) - x.u); };
    for (int r = low; r <= high; ++r)
      if (off(r) < off(best)) best = r;
    m_state[d].first = std::max(low, best - earlier);
    m_state[d].last = high;
    return true;
  }

  using Placed = std::vector<std::array<int, 2>>; // dislocations, and the columns where they are in a row

  int pairs_left(int d) const {
    return m_dislocations[std::size_t(d)].pairs() - m_state[std::size_t(d)].done;
  }
  bool is_end(int d) const { return m_dislocations[std::size_t(d)].columns < 0; }

  // Whether dislocations in one row have a regular column between them as long as they go on: in each row an
  // end takes one column on either side.
  bool stay_apart(Placed placed) const {
    std::sort(placed.begin(), placed.end(), [](const auto& x, const auto& y) { return x[1] < y[1]; });
    const int number = int(placed.size()), n = m_ring.size();
    for (int i = 0; i < number; ++i) {
      const auto [d, from] = placed[std::size_t(i)];
      std::vector<int> between; // rows left of the ends on the way
      for (int j = 1; j < number; ++j) {
        const auto [e, at] = placed[std::size_t((i + j) % number)];
        const int rows = std::min(pairs_left(d), pairs_left(e)) - 1;
        int gap = (at - from + n) % n - (is_end(d) && is_end(e) ? 2 * rows : 0);
        for (int k : between) gap -= 2 * std::min(rows, k);
        if (gap < 3) return false;
        if (is_end(e)) between.push_back(pairs_left(e));
      }
    }
    return true;
  }

  bool is_taken(int vertex) const {
    for (const std::array<int, 2>& ends : m_out.ends)
      if (ends[0] == vertex || ends[1] == vertex) return true;
    return std::any_of(m_state.begin(), m_state.end(), [&](const State& s) { return s.tip == vertex; });
  }

  // The column nearest to the place of a dislocation where it can begin beside the others, or -1.
  int column_for(int d, const Placed& placed) const {
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < m_ring.size(); ++i)
      order.emplace_back(std::abs(wrapped_step(m_ring.v[i] - m_dislocations[std::size_t(d)].v)), i);
    std::sort(order.begin(), order.end());
    Placed tried = placed;
    tried.push_back({d, -1});
    for (const auto& [off, i] : order) {
      tried.back()[1] = i;
      if (!is_taken(m_ring.id[i]) && stay_apart(tried)) return i;
    }
    return -1;
  }

  // The dislocations that have a pair in a row, with the column where it is; in no order.
  bool find_pairs(int row, Placed& placed) {
    int columns = m_ring.size();
    for (std::size_t d = 0; d < m_state.size(); ++d) {
      if (m_state[d].done == 0 || m_state[d].done == m_dislocations[d].pairs()) continue;
      const auto at = std::find(m_ring.id.begin(), m_ring.id.end(), m_state[d].tip);
      placed.push_back({int(d), int(at - m_ring.id.begin())});
      columns += is_end(int(d)) ? -2 : 2;
    }
    for (std::size_t d = 0; d < m_state.size(); ++d) {
      if (m_state[d].done > 0 || row < m_state[d].first) continue;
      const int best = columns + m_dislocations[d].columns < fewest_columns ? -1 : column_for(int(d), placed);
      if (best < 0) {
        if (row == m_state[d].last) return false;
        continue;
      }
      placed.push_back({int(d), best});
      columns += is_end(int(d)) ? -2 : 2;
    }
    return columns >= fewest_columns && stay_apart(placed);
  }

  bool add_row(int row) {
    Placed placed;
    if (!find_pairs(row, placed)) return false;
    const int n = m_ring.size();
    std::vector<Role> role(n, Role::plain);
    for (const auto& [d, at] : placed) {
      role[at] = is_end(d) ? Role::end : Role::beginning;
      if (is_end(d)) role[(at + 1) % n] = role[(at + n - 1) % n] = Role::beside;
    }
    Ring next;
    // Above each vertex: where the quads on its left and on its right go up to, and what is between.
    std::vector<int> left(n, -1), right(n, -1), middle(n, -1);
    for (int i = 0; i < n; ++i) add_above(row, i, role[i], next, left[i], middle[i], right[i]);
    add_quads(role, left, middle, right);
    for (const auto& [d, at] : placed) {
      State& s = m_state[std::size_t(d)];
      std::array<int, 2>& marks = m_out.ends[std::size_t(d)];
      if (s.done == 0) marks[is_end(d) ? 0 : 1] = m_ring.id[at];
      s.tip = middle[at];
      ++s.done;
      if (s.done < m_dislocations[d].pairs()) continue;
      marks[is_end(d) ? 1 : 0] = s.tip;
      s.tip = -1;
    }
    m_ring = std::move(next);
    even_out();
    return true;
  }

  void add_above(int row, int i, Role role, Ring& next, int& left, int& middle, int& right) {
    const auto push = [&](double v) {
      next.v.push_back(v);
      next.id.push_back(add_vertex(row + 1));
      return next.id.back();
    };
    const int n = m_ring.size();
    if (role == Role::plain) {
      left = right = push(m_ring.v[i]);
    } else if (role == Role::end) {
      middle = push(m_ring.v[i]);
    } else if (role == Role::beginning) {
      const double before = i > 0 ? m_ring.v[i - 1] : m_ring.v[n - 1] - 1;
      const double after = i + 1 < n ? m_ring.v[i + 1] : m_ring.v[0] + 1;
      left = push(m_ring.v[i] + 0.4 * (before - m_ring.v[i]));
      middle = push(m_ring.v[i]);
      right = push(m_ring.v[i] + 0.4 * (after - m_ring.v[i]));
    }
  }

  void add_quads(const std::vector<Role>& role, std::vector<int>& left, const std::vector<int>& middle,
                 std::vector<int>& right) {
    const int n = m_ring.size();
    std::vector<Quad>& quads = m_out.texture.quads;
    const std::vector<int>& id = m_ring.id;
    for (int i = 0; i < n; ++i) {
      const int a = (i + n - 1) % n, b = (i + 1) % n;
      if (role[i] == Role::end) {
        left[a] = right[b] = middle[i];
        quads.push_back({id[a], id[i], id[b], middle[i]});
      } else if (role[i] == Role::beginning)
        quads.push_back({id[i], right[i], middle[i], left[i]});
    }
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      if (role[i] == Role::end || role[j] == Role::end) continue;
      quads.push_back({id[i], id[j], left[j], right[i]});
    }
  }

  // Above columns that have ended or begun the others spread, row by row.
  void even_out() {
    const int n = m_ring.size();
    std::vector<double> v;
    for (int k = 0; k < ring_sweeps; ++k) {
      v = m_ring.v;
      for (int i = 0; i < n; ++i)
        v[i] = 0.5 * m_ring.v[i] + 0.25 * ((i > 0 ? m_ring.v[i - 1] : m_ring.v[n - 1] - 1) +
                                           (i + 1 < n ? m_ring.v[i + 1] : m_ring.v[0] + 1));
      m_ring.v = v;
    }
    for (int i = 0; i < n; ++i) m_out.texture.v[m_ring.id[i]] = m_ring.v[i];
  }

  // The high side's vertices lie at equal steps from V = 0, as near as they can to where they are.
  void close() {
    const int n = m_ring.size();
    double mean = 0;
    for (int i = 0; i < n; ++i) mean += i - n * m_ring.v[i];
    const int shift = int(std::lround(mean / n));
    std::vector<int> side;
    for (int j = 0; j < n; ++j) {
      side.push_back(m_ring.id[((j + shift) % n + n) % n]);
      m_out.texture.v[side.back()] = double(j) / n;
    }
    m_out.texture.sides.push_back(std::move(side));
    const internal::Texture_plane plane(true);
    const int low = int(m_out.texture.sides[0].size());
    for (int i = 0; i < low; ++i) m_out.texture.v[i] = double(i) / low;
    for (double& v : m_out.texture.v) v = v >= 0 && v < 1 ? v : plane.wrapped(v);
  }

  const std::vector<double>& m_levels;
  const std::vector<Dislocation>& m_dislocations;
  int m_rows;
  Ring m_ring;
  std::vector<State> m_state; // per dislocation
  Dislocated_texture m_out;
};

} // namespace

Result<Dislocated_texture> dislocated_annulus_texture(int columns, const std::vector<double>& levels,
                                                      const std::vector<Dislocation>& dislocations) {
  CGAL_precondition(columns >= fewest_columns && levels.size() >= 3);
  int most = 1;
  for (const Dislocation& d : dislocations) {
    CGAL_precondition(Dislocation::is_number(d.columns));
    most = std::max(most, d.pairs());
  }
  // Where dislocations that belong to the uppermost rows do not fit in them, all begin some rows lower.
  const int rows = int(levels.size()) - 1;
  if (rows >= rows_for_dislocations(most))
    for (int earlier = 0; earlier < rows; ++earlier)
      if (auto made = Dislocated_annulus(columns, levels, dislocations).run(earlier)) return std::move(*made);
  return make_error(Error_code::impossible_request, "a chart of " + std::to_string(columns) +
                                                        " columns and " + std::to_string(rows) +
                                                        " rows has no room for its dislocations");
}

namespace {

// The vertices that may move, within some edges of others, and the neighbours of each.
struct Surroundings {
  std::vector<int> vertices;
  std::vector<std::vector<int>> neighbours; // per vertex of the texture
  std::vector<std::vector<int>> quads;      // per vertex of the texture
};

Surroundings surroundings(const Quad_texture& texture, const std::vector<int>& from, int rings) {
  Surroundings out;
  out.neighbours.resize(texture.v.size());
  out.quads.resize(texture.v.size());
  for (std::size_t f = 0; f < texture.quads.size(); ++f)
    for (int i = 0; i < 4; ++i) {
      const Quad& q = texture.quads[f];
      out.quads[q[i]].push_back(int(f));
      out.neighbours[q[i]].push_back(q[(i + 1) % 4]);
      out.neighbours[q[(i + 1) % 4]].push_back(q[i]);
    }
  for (std::vector<int>& list : out.neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  std::vector<char> reached(texture.v.size(), 0), fixed(texture.v.size(), 0);
  for (const std::vector<int>& side : texture.sides)
    for (int v : side) fixed[v] = 1;
  std::vector<int> front = from, all;
  for (int v : front) reached[v] = 1;
  for (int k = 0; k <= rings; ++k) {
    all.insert(all.end(), front.begin(), front.end());
    std::vector<int> next;
    for (int v : front)
      for (int w : out.neighbours[v])
        if (!reached[w]) {
          reached[w] = 1;
          next.push_back(w);
        }
    front = std::move(next);
  }
  std::sort(all.begin(), all.end());
  for (int v : all)
    if (!fixed[v]) out.vertices.push_back(v);
  return out;
}

} // namespace

void smooth_around(const std::vector<int>& vertices, int rings, int steps, const Chart& chart,
                   const Chart_parameterization& map, Placed_texture& placed) {
  Quad_texture& texture = placed.texture;
  const Surroundings near = surroundings(texture, vertices, rings);
  const internal::Texture_plane plane(texture.sides.size() == 2);
  const Chart_locator locator(chart, map);
  for (int step = 0; step < steps; ++step)
    for (int v : near.vertices) {
      const Point p = position(chart, placed.location[v]);
      Point mean = Point::Zero();
      for (int w : near.neighbours[v]) mean += position(chart, placed.location[w]);
      mean /= double(near.neighbours[v].size());
      const Eigen::Vector2d way = parameter_displacement(chart, map, placed.location[v], 0.5 * (mean - p));
      const double before_v = texture.v[v], before_u = texture.u[v];
      texture.v[v] = plane.is_periodic() ? plane.wrapped(before_v + way.x()) : before_v + way.x();
      texture.u[v] = before_u + way.y();
      const bool valid =
          way.allFinite() && std::all_of(near.quads[v].begin(), near.quads[v].end(), [&](int f) {
            return plane.is_valid(texture.v, texture.u, texture.quads[f]);
          });
      if (valid) {
        placed.location[v] = locator.locate(texture.v[v], texture.u[v]);
        continue;
      }
      texture.v[v] = before_v;
      texture.u[v] = before_u;
    }
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
