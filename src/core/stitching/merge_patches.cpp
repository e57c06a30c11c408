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
    for (int h = 0; h < int(opposite.size()); ++h) {
      if (opposite[h] >= 0) continue;
      const int a = internal::source(m_mesh.quads, h), b = internal::target(m_mesh.quads, h);
      if (m_next[a] >= 0) return fault("the boundary passes a vertex twice", Element_kind::vertex, a);
      m_next[a] = b;
      m_previous[b] = a;
      m_boundary.push_back(a);
    }
    std::sort(m_boundary.begin(), m_boundary.end());
    return {};
  }

  void merge_nearest(double alpha) {
    std::vector<std::tuple<double, int, int>> pairs;
    std::vector<int> by_x = m_boundary;
    const auto x = [&](int v) { return m_mesh.points[v].x(); };
    std::sort(by_x.begin(), by_x.end(),
              [&](int a, int b) { return std::tuple(x(a), a) < std::tuple(x(b), b); });
    for (std::size_t i = 0; i < by_x.size(); ++i) {
      const int a = by_x[i];
      const double reach = alpha * spacing(a);
      for (std::size_t k = i + 1; k < by_x.size() && x(by_x[k]) - x(a) < reach; ++k) {
        const int b = by_x[k];
        const double d = distance(a, b);
        if (d < reach && d < alpha * spacing(b)) pairs.push_back({d, std::min(a, b), std::max(a, b)});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [d, a, b] : pairs)
      if (merge(a, b)) ++m_out.greedy_merges;
  }

  void join_stretches() {
    // By their ends: two stretches that run against each other between the same two merged vertices.
    std::map<std::pair<int, int>, std::vector<Stretch>> stretches;
    for (int a : m_boundary) {
      if (m_members[m_group[a]].size() < 2 || is_joined(a)) continue;
      Stretch s{{a}};
      do s.vertices.push_back(m_next[s.vertices.back()]);
      while (m_members[m_group[s.vertices.back()]].size() < 2);
      stretches[{m_group[a], m_group[s.vertices.back()]}].push_back(s);
    }
    for (const auto& [ends, list] : stretches) {
      const auto other = stretches.find({ends.second, ends.first});
      if (ends.first >= ends.second || other == stretches.end()) continue;
      join_nearest(list, other->second);
    }
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

  // Joins each stretch with the nearest that runs against it, if that is near.
  void join_nearest(const std::vector<Stretch>& some, const std::vector<Stretch>& others) {
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < some.size(); ++i)
      for (std::size_t k = 0; k < others.size(); ++k) {
        const double apart = std::max(farthest(some[i], others[k]), farthest(others[k], some[i]));
        if (apart <= std::max(longest_edge(some[i]), longest_edge(others[k]))) pairs.push_back({apart, i, k});
      }
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> used(some.size(), 0), other_used(others.size(), 0);
    for (const auto& [apart, i, k] : pairs) {
      if (used[i] || other_used[k]) continue;
      used[i] = other_used[k] = 1;
      Stretch against = others[k];
      std::reverse(against.vertices.begin(), against.vertices.end());
      join(some[i], against);
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
    const auto close = [&](int v, int w) {
      for (int side = 0; side < 2; ++side)
        if (!between[1 - side].empty())
          m_coarse.push_back({line[side].back(), side == 0 ? v : w, between[1 - side], side == 0});
      line = {{{v}, {w}}};
      between = {};
    };
    for (const std::array<int, 2>& m : internal::meet(a, b)) {
      if (m[0] >= 0 && m[1] >= 0) {
        const int v = a[m[0]].vertex, w = b[m[1]].vertex;
        if (!merge(v, w)) return; // what is left stays open
        ++m_out.later_merges;
        close(v, w);
      } else if (m[0] >= 0)
        between[0].push_back(a[m[0]].vertex);
      else
        between[1].push_back(b[m[1]].vertex);
    }
    close(s.vertices.back(), t.vertices.back());
  }

  // A coarse edge with the vertices beside it; `forward`: as its quad's halfedge runs.
  struct Coarse_edge {
    int from, to;
    std::vector<int> between;
    bool forward;
  };

  void add_hanging() {
    std::map<std::pair<int, int>, int> halfedges;
    for (const Coarse_edge& e : m_coarse) halfedges[ends(e)] = -1;
    for (int h = 0; h < 4 * int(m_mesh.quads.size()); ++h) {
      const auto place =
          halfedges.find({internal::source(m_mesh.quads, h), internal::target(m_mesh.quads, h)});
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

  static std::pair<int, int> ends(const Coarse_edge& e) {
    return e.forward ? std::pair(e.from, e.to) : std::pair(e.to, e.from);
  }

  const Quad_mesh& m_mesh;
  Merged_patches m_out;
  std::vector<int> m_next, m_previous; ///< per vertex: along the boundary
  std::vector<int> m_boundary;
  std::vector<int> m_group;                 ///< per vertex: the first vertex it merged with
  std::vector<std::vector<int>> m_members;  ///< of each group
  std::vector<std::vector<int>> m_quads_at; ///< of boundary vertices
  std::vector<Coarse_edge> m_coarse;
};

} // namespace

Result<Merged_patches> merge_patches(const Quad_mesh& mesh, double alpha) {
  if (!(alpha > 0 && alpha <= 0.5))
    return make_error(Error_code::impossible_request, "the ratio of distances is not in (0, 0.5]");
  Merger merger(mesh);
  if (Result<void> connected = merger.connect(); !connected) return connected.error();
  merger.merge_nearest(alpha);
  merger.join_stretches();
  return merger.finish();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
