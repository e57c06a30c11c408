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

  // Whether two dislocations in one row stay apart as long as both go on: ends draw nearer by two columns a
  // row.
  bool apart(std::size_t a, std::size_t b, int columns_between) const {
    const Dislocation &x = m_dislocations[a], &y = m_dislocations[b];
    const int rows = std::min(x.pairs() - m_state[a].done, y.pairs() - m_state[b].done);
    return columns_between >= (x.columns < 0 && y.columns < 0 ? 2 * rows + 1 : 3);
  }

  bool is_taken(int vertex) const {
    for (const std::array<int, 2>& ends : m_out.ends)
      if (ends[0] == vertex || ends[1] == vertex) return true;
    return std::any_of(m_state.begin(), m_state.end(), [&](const State& s) { return s.tip == vertex; });
  }

  bool fits(std::size_t d, int column, const std::vector<std::array<int, 2>>& placed) const {
    const int n = m_ring.size();
    if (is_taken(m_ring.id[column])) return false;
    for (const auto& [other, at] : placed) {
      const int gap = std::abs(at - column);
      if (!apart(d, std::size_t(other), std::min(gap, n - gap))) return false;
    }
    return true;
  }

  // The dislocations that have a pair in a row, with the column where it is; in no order.
  bool find_pairs(int row, std::vector<std::array<int, 2>>& placed) {
    int columns = m_ring.size();
    for (std::size_t d = 0; d < m_state.size(); ++d) {
      if (m_state[d].done == 0 || m_state[d].done == m_dislocations[d].pairs()) continue;
      const auto at = std::find(m_ring.id.begin(), m_ring.id.end(), m_state[d].tip);
      placed.push_back({int(d), int(at - m_ring.id.begin())});
      columns += m_dislocations[d].columns < 0 ? -2 : 2;
    }
    for (std::size_t d = 0; d < m_state.size(); ++d) {
      if (m_state[d].done > 0 || row < m_state[d].first) continue;
      int best = -1;
      const auto off = [&](int i) { return std::abs(wrapped_step(m_ring.v[i] - m_dislocations[d].v)); };
      for (int i = 0; i < m_ring.size(); ++i)
        if ((best < 0 || off(i) < off(best)) && fits(d, i, placed)) best = i;
      const int gained = m_dislocations[d].columns < 0 ? -2 : 2;
      if (best < 0 || columns + m_dislocations[d].columns < fewest_columns) {
        if (row == m_state[d].last) return false;
        continue;
      }
      placed.push_back({int(d), best});
      columns += gained;
    }
    return columns >= fewest_columns;
  }

  bool add_row(int row) {
    std::vector<std::array<int, 2>> placed;
    if (!find_pairs(row, placed)) return false;
    const int n = m_ring.size();
    std::vector<Role> role(n, Role::plain);
    for (const auto& [d, at] : placed) {
      const bool ends = m_dislocations[d].columns < 0;
      role[at] = ends ? Role::end : Role::beginning;
      if (ends) role[(at + 1) % n] = role[(at + n - 1) % n] = Role::beside;
    }
    Ring next;
    // Above each vertex: where the quads on its left and on its right go up to, and what is between.
    std::vector<int> left(n, -1), right(n, -1), middle(n, -1);
    for (int i = 0; i < n; ++i) add_above(row, i, role[i], next, left[i], middle[i], right[i]);
    add_quads(role, left, middle, right);
    for (const auto& [d, at] : placed) {
      State& s = m_state[std::size_t(d)];
      const bool ends = m_dislocations[d].columns < 0;
      std::array<int, 2>& marks = m_out.ends[std::size_t(d)];
      if (s.done == 0) marks[ends ? 0 : 1] = m_ring.id[at];
      s.tip = middle[at];
      ++s.done;
      if (s.done < m_dislocations[d].pairs()) continue;
      marks[ends ? 1 : 0] = s.tip;
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
