// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas/region_curve.h"

#include "atlas/chart_lines.h"
#include "base/refusal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The vertices around a vertex, counterclockwise; around one on the border from the first edge inside to the
// last.
struct Fan {
  std::vector<int> vertices;
  std::vector<int> halfedges; // halfedge i is opposite to the vertex, from vertices i to i + 1
  bool is_closed = true;
};

Fan fan_of(const Triangle_surface& mesh, int v) {
  Fan fan;
  const int first = mesh.outgoing[v];
  int h = first;
  do {
    fan.vertices.push_back(mesh.target(h));
    fan.halfedges.push_back(Triangle_surface::next(h));
    const int last = Triangle_surface::previous(h);
    h = mesh.opposite[last];
    if (h < 0) {
      fan.vertices.push_back(mesh.source(last));
      fan.is_closed = false;
    }
  } while (h >= 0 && h != first);
  return fan;
}

Error no_room() {
  return refuse("there is no room between the contours for another course");
}

class Parting {
public:
  Parting(const Open_region& region, const Region_sides& asked)
      : m_region(region), m_mesh(region.chart.mesh), m_asked(asked), m_side(asked.home.size(), 0) {}

  Result<std::vector<signed char>> run() {
    for (std::size_t v = 0; v < m_region.walls.size(); ++v) m_side[v] = m_asked.home[v];
    for (int v : m_asked.held) m_side[v] = m_asked.home[v];
    for (int end : {m_asked.from, m_asked.to})
      if (end >= 0) m_side[end] = 0;
    if (!order_ends()) return no_room();
    for (signed char side : {static_cast<signed char>(1), static_cast<signed char>(-1)})
      if (!connect(side, true) && !connect(side, false)) return no_room();
    flood();
    return std::move(m_side);
  }

private:
  bool is_end(int v) const { return v == m_asked.from || v == m_asked.to; }
  double against(int v, int side) const { return std::max(0.0, -side * m_asked.wish[v]); }
  double length(int v, int w) const { return (m_mesh.points[v] - m_mesh.points[w]).norm(); }

  // Fixes the sides around the ends, so that the curve leaves and arrives there once.
  bool order_ends() {
    if (m_asked.from < 0) return true;
    if (m_asked.from == m_asked.to) return order_loop();
    return order_end(m_asked.from, -1) && order_end(m_asked.to, 1);
  }

  // What it is worth to have a vertex of a fan on the left; large where it is there already.
  double gain(int end, int v) const {
    if (is_end(v)) return 0;
    if (m_side[v] != 0) return 1e6 * m_side[v];
    const double far = length(end, v);
    return far > 0 ? std::max(-1.0, std::min(1.0, m_asked.wish[v] / far)) : 0;
  }

  bool fix(int v, signed char side) {
    if (is_end(v)) return true;
    if (m_side[v] == -side) return false;
    m_side[v] = side;
    return true;
  }
  bool fix_run(const Fan& fan, int first, int count, signed char side) {
    for (int i = 0; i < count; ++i)
      if (!fix(fan.vertices[std::size_t(first + i) % fan.vertices.size()], side)) return false;
    return true;
  }

  // Around an end on the border: first one side, then the other.
  bool order_end(int end, signed char first_side) {
    const Fan fan = fan_of(m_mesh, end);
    if (fan.is_closed) return false;
    const int n = int(fan.vertices.size());
    double sum = 0, best = -std::numeric_limits<double>::infinity();
    int split = -1;
    for (int i = 0; i + 1 < n; ++i) {
      sum += first_side * gain(end, fan.vertices[std::size_t(i)]);
      double rest = 0;
      for (int k = i + 1; k < n; ++k) rest -= first_side * gain(end, fan.vertices[std::size_t(k)]);
      if (sum + rest <= best) continue;
      best = sum + rest;
      split = i + 1;
    }
    return split > 0 && fix_run(fan, 0, split, first_side) &&
           fix_run(fan, split, n - split, static_cast<signed char>(-first_side));
  }

  // Around the one end of a loop: a run of one side between those of the other; some of it has its home
  // there, unless the end has moved to where none has.
  bool order_loop() {
    const int end = m_asked.from;
    const Fan fan = fan_of(m_mesh, end);
    const int n = int(fan.vertices.size());
    const signed char inner = fan.is_closed ? static_cast<signed char>(1)
                                            : static_cast<signed char>(-m_asked.home[fan.vertices[0]]);
    double best = -std::numeric_limits<double>::infinity(), all = 0;
    for (int v : fan.vertices) all -= inner * gain(end, v);
    int first = -1, count = 0;
    const bool is_away = std::none_of(fan.vertices.begin(), fan.vertices.end(),
                                      [&](int v) { return !is_end(v) && m_asked.home[v] == inner; });
    for (int i = fan.is_closed ? 0 : 1; i < n; ++i) {
      double run = 0;
      bool has_home = is_away;
      const int most = fan.is_closed ? n - 1 : n - 1 - i;
      for (int k = 0; k < most; ++k) {
        const int v = fan.vertices[std::size_t(i + k) % std::size_t(n)];
        run += inner * gain(end, v);
        has_home = has_home || (m_asked.home[v] == inner && !is_end(v));
        if (!has_home || all + 2 * run <= best) continue;
        best = all + 2 * run;
        first = i;
        count = k + 1;
      }
    }
    return first >= 0 && fix_run(fan, first, count, inner) &&
           fix_run(fan, first + count, n - count, static_cast<signed char>(-inner));
  }

  // Joins the pieces of a side by paths, through vertices that have their home there, or through any.
  bool connect(signed char side, bool at_home) {
    const int n = int(m_side.size());
    std::vector<char> joined(std::size_t(n), 0);
    std::vector<int> tree;
    const auto join = [&](int start) {
      std::vector<int> stack{start};
      joined[start] = 1;
      while (!stack.empty()) {
        const int v = stack.back();
        stack.pop_back();
        tree.push_back(v);
        for (int w : fan_of(m_mesh, v).vertices)
          if (m_side[w] == side && !joined[w]) {
            joined[w] = 1;
            stack.push_back(w);
          }
      }
    };
    const auto first = std::find(m_side.begin(), m_side.end(), side);
    if (first == m_side.end()) return false;
    join(int(first - m_side.begin()));
    for (;;) {
      const bool all = [&] {
        for (int v = 0; v < n; ++v)
          if (m_side[v] == side && !joined[v]) return false;
        return true;
      }();
      if (all) return true;
      const int reached = grow(side, at_home, tree, joined);
      if (reached < 0) return false;
      join(reached);
    }
  }

  // The shortest way from the tree to another piece, which then belongs to the side; returns where it ends,
  // or -1.
  int grow(signed char side, bool at_home, const std::vector<int>& tree, std::vector<char>& joined) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<double> distance(m_side.size(), std::numeric_limits<double>::infinity());
    std::vector<int> before(m_side.size(), -1);
    for (int v : tree) {
      distance[v] = 0;
      queue.push({0, v});
    }
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance[v]) continue;
      if (m_side[v] == side && !joined[v]) {
        for (int w = before[v]; w >= 0 && !joined[w]; w = before[w]) m_side[w] = side;
        return v;
      }
      for (int w : fan_of(m_mesh, v).vertices) {
        const bool is_open = m_side[w] == 0 && (!at_home || m_asked.home[w] == side);
        if (is_end(w) || (m_side[w] != side && !is_open)) continue;
        const double far = length(v, w), next = d + far + 4 * std::min(far, against(w, side));
        if (next >= distance[w]) continue;
        distance[w] = next;
        before[w] = v;
        queue.push({next, w});
      }
    }
    return -1;
  }

  void flood() {
    using Entry = std::tuple<double, int, int>; // against the wish so far, vertex, side
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<signed char> done(m_side.size(), 0);
    double most = 0;
    for (double w : m_asked.wish) most = std::max(most, std::abs(w));
    for (std::size_t v = 0; v < m_side.size(); ++v)
      if (m_side[v] != 0) queue.push({0, int(v), m_side[v]});
    while (!queue.empty()) {
      const auto [key, v, side] = queue.top();
      queue.pop();
      if (done[v] || is_end(v)) continue;
      done[v] = 1;
      m_side[v] = static_cast<signed char>(side);
      for (int w : fan_of(m_mesh, v).vertices)
        if (!done[w] && m_side[w] == 0 && !is_end(w))
          queue.push({key + length(v, w) * (against(w, side) + 1e-9 * most), w, side});
    }
  }

  const Open_region& m_region;
  const Triangle_surface& m_mesh;
  const Region_sides& m_asked;
  std::vector<signed char> m_side;
};

// Follows the line between the sides; it leaves faces over halfedges that run from the right to the left
// side.
class Line_tracer {
public:
  Line_tracer(const Open_region& region, const std::vector<signed char>& sides, int from, int to)
      : m_mesh(region.chart.mesh), m_sides(sides), m_from(from), m_to(to) {}

  Result<std::vector<int>> run() const {
    int crossed = 0, first = -1;
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      if (!leaves(h)) continue;
      if (m_mesh.opposite[h] < 0) return no_room();
      ++crossed;
      if (first < 0) first = h;
    }
    if (m_from >= 0) first = first_exit();
    if (first < 0) return no_room();
    std::vector<int> exits;
    if (!follow(first, exits) || int(exits.size()) != crossed) return no_room();
    return exits;
  }

private:
  bool leaves(int h) const { return m_sides[m_mesh.source(h)] < 0 && m_sides[m_mesh.target(h)] > 0; }
  int first_exit() const {
    for (int h : fan_of(m_mesh, m_from).halfedges)
      if (leaves(h)) return h;
    return -1;
  }
  bool follow(int exit, std::vector<int>& exits) const {
    const int first = exit;
    do {
      if (int(exits.size()) > m_mesh.number_of_halfedges()) return false;
      exits.push_back(exit);
      const int entry = m_mesh.opposite[exit], apex = m_mesh.target(Triangle_surface::next(entry));
      if (m_to >= 0 && apex == m_to) return true;
      if (m_sides[apex] == 0) return false;
      exit = m_sides[apex] > 0 ? Triangle_surface::next(entry) : Triangle_surface::previous(entry);
    } while (exit != first);
    return m_to < 0;
  }

  const Triangle_surface& m_mesh;
  const std::vector<signed char>& m_sides;
  int m_from, m_to;
};

} // namespace

double straight_crossing(const Point& source, const Point& target, const Point& before, const Point& after) {
  const Eigen::Vector3d d = target - source;
  const double length = d.squaredNorm();
  if (!(length > 0)) return 0.5;
  const Eigen::Vector3d a = before - source, b = after - source;
  const double sa = a.dot(d) / length, sb = b.dot(d) / length;
  const double ha = (a - sa * d).norm(), hb = (b - sb * d).norm();
  return ha + hb > 0 ? (sa * hb + sb * ha) / (ha + hb) : 0.5;
}

Result<std::vector<signed char>> part_region(const Open_region& region, const Region_sides& asked) {
  return Parting(region, asked).run();
}

Result<Region_curve> curve_between(const Open_region& region, const std::vector<signed char>& sides,
                                   const Region_sides& asked) {
  const Triangle_surface& mesh = region.chart.mesh;
  Result<std::vector<int>> exits = Line_tracer(region, sides, asked.from, asked.to).run();
  if (!exits) return exits.error();
  Region_curve curve;
  curve.exits = std::move(*exits);
  std::vector<char> is_loose;
  const auto between = [&](int h, double t) { // farther from contours than from other vertices
    const double low = region.is_on_border(mesh.source(h)) ? 0.2 : 0.03,
                 high = region.is_on_border(mesh.target(h)) ? 0.8 : 0.97;
    return std::min(high, std::max(low, t));
  };
  for (int h : curve.exits) {
    const double a = asked.wish[mesh.source(h)], b = asked.wish[mesh.target(h)];
    is_loose.push_back(!(a < 0 && b > 0));
    curve.t.push_back(is_loose.back() ? 0.5 : between(h, -a / (b - a)));
  }
  const int n = int(curve.exits.size());
  const auto point = [&](int i) -> Point {
    if (asked.from >= 0 && i < 0) return mesh.points[asked.from];
    if (asked.from >= 0 && i >= n) return mesh.points[asked.to];
    const int k = (i + n) % n, h = curve.exits[k];
    return mesh.points[mesh.source(h)] +
           curve.t[k] * (mesh.points[mesh.target(h)] - mesh.points[mesh.source(h)]);
  };
  for (int sweep = 0; sweep < 10; ++sweep)
    for (int i = 0; i < n; ++i)
      if (const int h = curve.exits[i]; is_loose[i])
        curve.t[i] = between(h, straight_crossing(mesh.points[mesh.source(h)], mesh.points[mesh.target(h)],
                                                  point(i - 1), point(i + 1)));
  return curve;
}

namespace {

// The crossings of a region's curve with edges of the surface; those of edges that only the region has are
// left out.
std::vector<Line_crossing> surface_crossings(const Triangle_surface& surface, const Open_region& region,
                                             const Region_curve& curve, const Contour_network& network) {
  const Chart& chart = region.chart;
  std::vector<Line_crossing> crossings;
  for (std::size_t k = 0; k < curve.exits.size(); ++k) {
    const int h = curve.exits[k];
    if (const auto crossing =
            surface_crossing(surface, chart, network, h, curve.t[k], chart.mesh.opposite[h] / 3))
      crossings.push_back(*crossing);
  }
  return crossings;
}

} // namespace

Result<Contour_edge> contour_of_curve(const Triangle_surface& surface, const Open_region& region,
                                      const Region_curve& curve, int from, int to, Contour_network& network) {
  std::vector<Line_crossing> crossings = surface_crossings(surface, region, curve, network);
  Contour_edge made;
  if (from < 0) {
    pull_loop_tight(crossings);
    if (crossings.size() < 3) return no_room();
  } else {
    int first_face = region.chart.face_origin[curve.exits[0] / 3];
    pull_tight(surface, network, from, to, first_face, crossings);
    if (crossings.empty() && from == to) return no_room();
    if (crossings.empty() && are_on_one_edge(surface, network, from, to)) first_face = -1;
    made.vertices.push_back(from);
    made.faces.push_back(first_face);
  }
  append_crossings(crossings, network, made);
  made.vertices.push_back(from < 0 ? made.vertices.front() : to);
  return made;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
