// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quad_connectivity.h"
#include <CGAL/Reeb_quadrangulation/merge_patches.h>

#include "stitching/meetings.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::Meetings;
using internal::Stop;

// A stretch of boundary: its vertices, the ends merged ones, in the direction of the quads' halfedges.
struct Stretch {
  std::vector<int> vertices;
};

// A closed walk along boundary edges that have no partner yet, each named by the vertex where it begins.
using Open_walk = std::vector<int>;

// Farther than this, in edges, no vertex merges with another to give a slit its end: more than the half of an
// edge that the nearest vertex may be off, less than a hole of one quad is wide.
constexpr double anchor_reach = 0.75;

// As `meet()`, of long lists in parts, whose time and memory are bounded.
internal::Meetings meet_in_parts(const std::vector<Stop>& a, const std::vector<Stop>& b) {
  if (a.size() > b.size()) {
    internal::Meetings out = meet_in_parts(b, a);
    for (std::array<int, 2>& m : out) std::swap(m[0], m[1]);
    return out;
  }
  if (a.size() < 2 || a.size() * b.size() <= std::size_t(1) << 20) return internal::meet(a, b);
  const int i = int(a.size() / 2), left = int(b.size() - a.size());
  const auto after = std::lower_bound(b.begin() + i, b.begin() + i + left, a[std::size_t(i)].at,
                                      [](const Stop& stop, double at) { return stop.at < at; });
  const int j = int(after - b.begin());
  internal::Meetings out = meet_in_parts({a.begin(), a.begin() + i}, {b.begin(), b.begin() + j});
  out.push_back({i, j});
  for (std::array<int, 2> m : meet_in_parts({a.begin() + i + 1, a.end()}, {b.begin() + j + 1, b.end()}))
    out.push_back({m[0] < 0 ? -1 : m[0] + i + 1, m[1] < 0 ? -1 : m[1] + j + 1});
  return out;
}

class Merger {
public:
  explicit Merger(const Quad_mesh& mesh)
      : m_mesh(mesh), m_group(mesh.points.size()), m_members(mesh.points.size()) {
    std::iota(m_group.begin(), m_group.end(), 0);
    for (std::size_t v = 0; v < m_members.size(); ++v) m_members[v] = {int(v)};
  }

  Result<void> connect() {
    const int n = int(m_mesh.points.size());
    for (std::size_t f = 0; f < m_mesh.quads.size(); ++f)
      for (int v : m_mesh.quads[f])
        if (v < 0 || v >= n)
          return fault("a quad has a vertex that does not exist", Element_kind::face, int(f));
    std::vector<int> opposite;
    if (const int f = internal::connect_quads(m_mesh.quads, n, opposite); f >= 0)
      return fault("a quad has an edge that another passes in the same direction", Element_kind::face, f);
    m_next.assign(n, -1);
    m_previous.assign(n, -1);
    m_edge.assign(n, -1);
    for (int h = 0; h < int(opposite.size()); ++h) {
      if (opposite[h] >= 0) continue;
      const int a = internal::source(m_mesh.quads, h), b = internal::target(m_mesh.quads, h);
      if (m_next[a] >= 0) return fault("the boundary passes a vertex twice", Element_kind::vertex, a);
      m_edge[a] = h;
      m_next[a] = b;
      m_previous[b] = a;
      m_boundary.push_back(a);
    }
    std::sort(m_boundary.begin(), m_boundary.end());
    find_patches(opposite);
    return {};
  }

  void merge_nearest(double alpha) {
    std::vector<std::tuple<double, int, int>> pairs;
    for_pairs(
        m_boundary, [&](int v) { return alpha * spacing(v); },
        [&](double d, int a, int b) {
          if (d < alpha * std::min(spacing(a), spacing(b)) && !are_apart(a, b))
            pairs.push_back({d, std::min(a, b), std::max(a, b)});
        });
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [d, a, b] : pairs)
      if (merge(a, b)) ++m_out.greedy_merges;
  }

  // Slits first where both of their ends are merged vertices; then more vertices merge, one of each walk that
  // is left, so that there are such ends.
  void close_slits() {
    m_closed.assign(m_mesh.points.size(), 0);
    do
      for (const Open_walk& walk : open_walks()) close_if_slit(walk);
    while (merge_anchors(open_walks()));
    for (int a : m_boundary)
      if (is_open(a)) m_out.open.push_back({a, m_next[a]});
  }

  Result<Merged_patches> finish() {
    const int n = int(m_mesh.points.size());
    std::vector<int> number(n, -1);
    for (int v = 0; v < n; ++v) {
      if (m_group[v] != v) continue;
      number[v] = int(m_out.mesh.points.size());
      Point sum = Point::Zero();
      for (int w : m_members[v]) sum += m_mesh.points[w];
      m_out.mesh.points.push_back(sum / double(m_members[v].size()));
    }
    for (int v = 0; v < n; ++v) m_out.vertex.push_back(number[m_group[v]]);
    m_out.mesh.quads = m_mesh.quads;
    for (Quad& q : m_out.mesh.quads)
      for (int& v : q) v = m_out.vertex[v];
    std::vector<int> opposite;
    if (const int f = internal::connect_quads(m_out.mesh.quads, int(m_out.mesh.points.size()), opposite);
        f >= 0)
      return fault("the patches would have an edge with three quads", Element_kind::face, f);
    add_hanging();
    return std::move(m_out);
  }

private:
  static Error fault(const char* message, Element_kind kind, int index) {
    return make_error(Error_code::impossible_request, message, kind, index);
  }

  void find_patches(const std::vector<int>& opposite) {
    m_patch.assign(m_mesh.quads.size(), -1);
    for (int first = 0; first < int(m_patch.size()); ++first) {
      if (m_patch[first] >= 0) continue;
      m_patch[first] = first;
      std::vector<int> list{first};
      for (std::size_t i = 0; i < list.size(); ++i)
        for (int h = 4 * list[i]; h < 4 * list[i] + 4; ++h)
          if (opposite[h] >= 0 && m_patch[opposite[h] / 4] < 0) {
            m_patch[opposite[h] / 4] = first;
            list.push_back(opposite[h] / 4);
          }
    }
  }

  // Of one patch, rims on both sides of its quads must not merge where these are narrower than their edges
  // are long, nor those on both sides of a hole that is as wide as they are.
  bool are_apart(int a, int b) const {
    return m_patch[m_edge[a] / 4] == m_patch[m_edge[b] / 4] && (is_far(a, b) || is_far(b, a));
  }
  bool is_far(int a, int b) const {
    const Quad& q = m_mesh.quads[m_edge[a] / 4];
    const int i = m_edge[a] & 3;
    const auto p = [&](int k) { return m_mesh.points[q[(i + k) % 4]]; };
    const Point inward = 0.5 * (p(2) + p(3) - p(0) - p(1)), way = m_mesh.points[b] - m_mesh.points[a];
    return way.norm() > anchor_reach * inward.norm() || way.dot(inward) > 0.5 * way.norm() * inward.norm();
  }

  double distance(int a, int b) const { return (m_mesh.points[a] - m_mesh.points[b]).norm(); }
  double spacing(int v) const { return std::min(distance(v, m_next[v]), distance(v, m_previous[v])); }
  /// Whether the boundary edge that leaves v has a partner by now.
  bool is_joined(int v) const { return has_edge(m_group[m_next[v]], m_group[v]); }
  // Whether a boundary edge runs from a group to another.
  bool has_edge(int from, int to) const {
    return std::any_of(m_members[from].begin(), m_members[from].end(),
                       [&](int v) { return m_next[v] >= 0 && m_group[m_next[v]] == to; });
  }

  // Two vertices may merge if no boundary edge becomes a point, no two boundary edges then run the same way,
  // and no quad has both.
  bool merge(int a, int b) {
    a = m_group[a];
    b = m_group[b];
    if (a == b) return false;
    for (int v : m_members[a])
      for (int w : m_members[b]) {
        if (m_next[v] == w || m_next[w] == v) return false;
        const int vn = m_group[m_next[v]], vp = m_group[m_previous[v]];
        if (vn == m_group[m_next[w]] || vp == m_group[m_previous[w]]) return false;
      }
    if (share_quad(a, b)) return false;
    if (b < a) std::swap(a, b);
    for (int w : m_members[b]) m_group[w] = a;
    m_members[a].insert(m_members[a].end(), m_members[b].begin(), m_members[b].end());
    m_members[b].clear();
    return true;
  }

  bool share_quad(int a, int b) {
    if (m_quads_at.empty()) {
      m_quads_at.resize(m_mesh.points.size());
      for (std::size_t f = 0; f < m_mesh.quads.size(); ++f)
        for (int v : m_mesh.quads[f])
          if (m_next[v] >= 0) m_quads_at[v].push_back(int(f));
    }
    for (int v : m_members[a])
      for (int w : m_members[b])
        for (int f : m_quads_at[v])
          if (std::find(m_quads_at[w].begin(), m_quads_at[w].end(), f) != m_quads_at[w].end()) return true;
    return false;
  }

  bool is_open(int a) const { return !m_closed[std::size_t(a)] && !is_joined(a); }
  Point along(int a) const { return (m_mesh.points[m_next[a]] - m_mesh.points[a]).normalized(); }
  // 1 where the boundary turns back, -1 where it goes straight on, from the edge of a to that of b.
  double turn_back(int a, int b) const { return -along(a).dot(along(b)); }

  // Where vertices have merged, a walk goes on along the edge that turns back most: that is the other side of
  // the slit.
  std::vector<Open_walk> open_walks() const {
    std::map<int, std::array<std::vector<int>, 2>> at; // per group: the edges that arrive and that leave
    for (int a : m_boundary) {
      if (!is_open(a)) continue;
      at[m_group[m_next[a]]][0].push_back(a);
      at[m_group[a]][1].push_back(a);
    }
    std::map<int, int> next;
    for (const auto& [group, edges] : at) {
      std::vector<std::tuple<double, int, int>> turns;
      for (int in : edges[0])
        for (int out : edges[1]) turns.push_back({-turn_back(in, out), in, out});
      std::sort(turns.begin(), turns.end());
      std::map<int, int> from;
      for (const auto& [turn, in, out] : turns)
        if (next.count(in) == 0 && from.count(out) == 0) next[in] = out, from[out] = in;
    }
    std::vector<Open_walk> walks;
    while (!next.empty()) {
      walks.push_back({next.begin()->first});
      for (auto step = next.begin(); step != next.end(); step = next.find(walks.back().back())) {
        const int to = step->second;
        next.erase(step);
        if (to != walks.back().front()) walks.back().push_back(to);
      }
    }
    return walks;
  }

  // Closes a walk that turns back twice, at merged vertices, and whose two sides are nowhere further apart
  // than an edge is long.
  void close_if_slit(const Open_walk& walk) {
    const std::size_t n = walk.size();
    std::vector<std::pair<double, std::size_t>> tips;
    for (std::size_t i = 0; i < n; ++i) {
      const int a = walk[i], b = walk[(i + 1) % n];
      if (m_next[a] != b && turn_back(a, b) > 0.5) tips.push_back({-turn_back(a, b), i});
    }
    std::sort(tips.begin(), tips.end());
    if (tips.size() < 2 || (tips.size() > 2 && tips[2].first < -0.8)) return;
    const auto side = [&](std::size_t after, std::size_t last) {
      Stretch s;
      for (std::size_t i = after; i != last;) s.vertices.push_back(walk[i = (i + 1) % n]);
      s.vertices.push_back(m_next[s.vertices.back()]);
      return s;
    };
    const Stretch s = side(tips[0].second, tips[1].second);
    Stretch t = side(tips[1].second, tips[0].second);
    std::reverse(t.vertices.begin(), t.vertices.end());
    if (std::max(farthest(s, t), farthest(t, s)) > std::max(longest_edge(s), longest_edge(t))) return;
    join(s, t);
  }

  // In each walk at most one vertex merges, the nearest first. Whether any did.
  bool merge_anchors(const std::vector<Open_walk>& walks) {
    std::map<int, std::size_t> walk_of;
    std::vector<int> by_x;
    for (std::size_t w = 0; w < walks.size(); ++w)
      for (int a : walks[w]) {
        walk_of[a] = w;
        by_x.push_back(a);
      }
    std::vector<std::tuple<double, int, int>> pairs;
    for_pairs(
        by_x, [&](int v) { return anchor_reach * longest_at(v); },
        [&](double d, int v, int w) {
          if (d <= anchor_reach * std::max(longest_at(v), longest_at(w)) && along(v).dot(along(w)) < 0 &&
              !are_apart(v, w))
            pairs.push_back({d, std::min(v, w), std::max(v, w)});
        });
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> used(walks.size(), 0);
    bool any = false;
    for (const auto& [d, v, w] : pairs) {
      if (used[walk_of[v]] || used[walk_of[w]] || !merge(v, w)) continue;
      used[walk_of[v]] = used[walk_of[w]] = any = true;
      ++m_out.later_merges;
    }
    return any;
  }

  double longest_at(int v) const { return std::max(distance(v, m_next[v]), distance(v, m_previous[v])); }

  // Calls `f` with the distance of each two vertices of which one is in the reach of the other.
  template <class Reach, class F>
  void for_pairs(std::vector<int> by_x, const Reach& reach, const F& f) const {
    const auto x = [&](int v) { return m_mesh.points[v].x(); };
    std::sort(by_x.begin(), by_x.end(),
              [&](int a, int b) { return std::tuple(x(a), a) < std::tuple(x(b), b); });
    double widest = 0;
    for (int v : by_x) widest = std::max(widest, reach(v));
    for (std::size_t i = 0; i < by_x.size(); ++i)
      for (std::size_t k = i + 1; k < by_x.size() && x(by_x[k]) - x(by_x[i]) <= widest; ++k) {
        const double d = distance(by_x[i], by_x[k]);
        if (d <= std::max(reach(by_x[i]), reach(by_x[k]))) f(d, by_x[i], by_x[k]);
      }
  }

  double longest_edge(const Stretch& s) const {
    double longest = 0;
    for (std::size_t i = 0; i + 1 < s.vertices.size(); ++i)
      longest = std::max(longest, distance(s.vertices[i], s.vertices[i + 1]));
    return longest;
  }

  // How far the vertices of a stretch are from another.
  double farthest(const Stretch& s, const Stretch& other) const {
    double out = 0;
    for (int v : s.vertices) {
      double nearest = 1e300;
      for (std::size_t i = 0; i + 1 < other.vertices.size(); ++i) {
        const Point &p = m_mesh.points[v], &a = m_mesh.points[other.vertices[i]],
                    d = m_mesh.points[other.vertices[i + 1]] - a;
        const double t =
            d.squaredNorm() > 0 ? std::max(0.0, std::min(1.0, (p - a).dot(d) / d.squaredNorm())) : 0;
        nearest = std::min(nearest, (a + t * d - p).norm());
      }
      out = std::max(out, nearest);
    }
    return out;
  }

  // The inner vertices of a stretch by their part of its length.
  std::vector<Stop> stops(const Stretch& s) const {
    std::vector<Stop> out;
    double length = 0;
    for (std::size_t i = 0; i + 1 < s.vertices.size(); ++i) {
      if (i > 0) out.push_back({length, s.vertices[i]});
      length += distance(s.vertices[i], s.vertices[i + 1]);
    }
    for (Stop& stop : out) stop.at /= length > 0 ? length : 1;
    return out;
  }

  // `s` and `t` run beside each other; `s` in the direction of its quads' halfedges.
  void join(const Stretch& s, const Stretch& t) {
    const std::vector<Stop> a = stops(s), b = stops(t);
    std::array<std::vector<int>, 2> line{{{s.vertices.front()}, {t.vertices.front()}}};
    std::array<std::vector<int>, 2> between;
    std::array<std::size_t, 2> closed{0, 0}; // edges of s and of t
    const auto close = [&](int v, int w, std::size_t i, std::size_t k) {
      for (; closed[0] < i; ++closed[0]) m_closed[s.vertices[closed[0]]] = 1;
      for (; closed[1] < k; ++closed[1]) m_closed[t.vertices[closed[1] + 1]] = 1;
      for (int side = 0; side < 2; ++side)
        if (!between[1 - side].empty())
          m_coarse.push_back({line[side].back(), side == 0 ? v : w, between[1 - side], side == 0});
      line = {{{v}, {w}}};
      between = {};
    };
    for (const std::array<int, 2>& m : meet_in_parts(a, b)) {
      if (m[0] >= 0 && m[1] >= 0) {
        const int v = a[m[0]].vertex, w = b[m[1]].vertex;
        if (m_group[v] != m_group[w]) {
          if (!merge(v, w)) return; // what is left stays open
          ++m_out.later_merges;
        }
        close(v, w, std::size_t(m[0]) + 1, std::size_t(m[1]) + 1);
      } else if (m[0] >= 0)
        between[0].push_back(a[m[0]].vertex);
      else
        between[1].push_back(b[m[1]].vertex);
    }
    close(s.vertices.back(), t.vertices.back(), s.vertices.size() - 1, t.vertices.size() - 1);
  }

  // A coarse edge with the vertices beside it; `forward`: as its quad's halfedge runs.
  struct Coarse_edge {
    int from, to;
    std::vector<int> between;
    bool forward;
  };

  // Found by the merged vertices: an edge may have begun at another vertex of its group.
  void add_hanging() {
    std::map<std::pair<int, int>, int> halfedges;
    for (const Coarse_edge& e : m_coarse) halfedges[ends(e)] = -1;
    for (int h = 0; h < 4 * int(m_mesh.quads.size()); ++h) {
      const auto place =
          halfedges.find({internal::source(m_out.mesh.quads, h), internal::target(m_out.mesh.quads, h)});
      if (place != halfedges.end()) place->second = h;
    }
    for (const Coarse_edge& e : m_coarse) {
      const int h = halfedges.at(ends(e));
      Hanging_edge hanging{h / 4, h & 3, {}};
      for (int v : e.between) hanging.vertices.push_back(m_out.vertex[v]);
      if (!e.forward) std::reverse(hanging.vertices.begin(), hanging.vertices.end());
      m_out.hanging.push_back(hanging);
    }
  }

  std::pair<int, int> ends(const Coarse_edge& e) const {
    const int a = m_out.vertex[e.from], b = m_out.vertex[e.to];
    return e.forward ? std::pair(a, b) : std::pair(b, a);
  }

  const Quad_mesh& m_mesh;
  Merged_patches m_out;
  std::vector<int> m_next, m_previous; ///< per vertex: along the boundary
  std::vector<int> m_edge;             ///< per vertex: its boundary halfedge
  std::vector<int> m_patch;            ///< per quad: the first quad of its patch
  std::vector<int> m_boundary;
  std::vector<int> m_group;                 ///< per vertex: the first vertex it merged with
  std::vector<std::vector<int>> m_members;  ///< of each group
  std::vector<std::vector<int>> m_quads_at; ///< of boundary vertices
  std::vector<Coarse_edge> m_coarse;
  std::vector<char>
      m_closed; ///< per vertex: its boundary edge lies beside T-junctions, or is one of a line of them
};

} // namespace

Result<Merged_patches> merge_patches(const Quad_mesh& mesh, double alpha) {
  if (!(alpha > 0 && alpha <= 0.5))
    return make_error(Error_code::impossible_request, "the ratio of distances is not in (0, 0.5]");
  Merger merger(mesh);
  if (Result<void> connected = merger.connect(); !connected) return connected.error();
  merger.merge_nearest(alpha);
  merger.close_slits();
  return merger.finish();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
