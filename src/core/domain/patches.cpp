// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/patches.h"

#include <CGAL/Reeb_quadrangulation/stitch_patches.h>

#include "base/place.h"
#include "base/quad_connectivity.h"
#include "base/segments.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

Error no_patches(const std::string& message, Element_kind kind, int index) {
  return make_error(Error_code::not_a_surface, message, kind, index);
}

// Joins what is found to belong together; the parity tells whether a thing is turned against its root.
class Turned_sets {
public:
  explicit Turned_sets(std::size_t n) : m_parent(n), m_parity(n, 0) {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }
  // The root, and the parity against it; what is on the way then hangs on the root.
  std::pair<int, int> root(int i) {
    int root = i, parity = 0;
    for (; m_parent[root] != root; root = m_parent[root]) parity ^= m_parity[root];
    for (int k = i, left = parity; k != root;) {
      const int next = m_parent[k], next_left = left ^ m_parity[k];
      m_parent[k] = root;
      m_parity[k] = char(left);
      k = next;
      left = next_left;
    }
    return {root, parity};
  }
  // Whether a and b, `turned` against each other or not, fit what is known. The smaller root stays.
  bool join(int a, int b, int turned) {
    auto [r, p] = root(a);
    auto [s, q] = root(b);
    if (r == s) return (p ^ q) == turned;
    if (s < r) std::swap(r, s);
    m_parent[s] = r;
    m_parity[s] = char(p ^ q ^ turned);
    return true;
  }

private:
  std::vector<int> m_parent;
  std::vector<char> m_parity; ///< against the parent
};

class Orientation {
public:
  explicit Orientation(const Quad_mesh& mesh) : m_in(mesh), m_mate(4 * mesh.quads.size(), -1) {}

  Result<Oriented_patches> run() {
    if (Result<void> checked = check_quads(); !checked) return checked.error();
    if (Result<void> mated = find_mates(); !mated) return mated.error();
    if (Result<void> turned = turn_quads(); !turned) return turned.error();
    take_apart();
    if (Result<void> turned = turn_patches(); !turned) return turned.error();
    return std::move(m_out);
  }

private:
  Result<void> check_quads() const {
    if (m_in.quads.empty()) return no_patches("there is no quad", Element_kind::none, -1);
    const int n = int(m_in.points.size());
    for (int f = 0; f < int(m_in.quads.size()); ++f) {
      Quad q = m_in.quads[f];
      for (int v : q)
        if (v < 0 || v >= n || !m_in.points[v].allFinite())
          return no_patches("a quad has a vertex that does not exist or is at no finite point",
                            Element_kind::face, f);
      std::sort(q.begin(), q.end());
      if (std::adjacent_find(q.begin(), q.end()) != q.end())
        return no_patches("a quad has a vertex twice, at " + place(m_in.points[q[0]]), Element_kind::face, f);
    }
    return {};
  }

  // The other halfedge of each edge, whatever its direction.
  Result<void> find_mates() {
    std::vector<std::tuple<int, int, int>> edges;
    for (int h = 0; h < int(m_mate.size()); ++h) {
      const auto [a, b] = std::minmax({source(m_in.quads, h), target(m_in.quads, h)});
      edges.push_back({a, b, h});
    }
    std::sort(edges.begin(), edges.end());
    const auto same = [&](std::size_t i, std::size_t k) {
      return k < edges.size() && std::get<0>(edges[i]) == std::get<0>(edges[k]) &&
             std::get<1>(edges[i]) == std::get<1>(edges[k]);
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (!same(i, i + 1)) continue;
      const int h = std::get<2>(edges[i]), o = std::get<2>(edges[i + 1]);
      if (same(i, i + 2))
        return no_patches("an edge has more than two quads, at " + place(m_in.points[std::get<0>(edges[i])]),
                          Element_kind::face, quad_of(std::get<2>(edges[i + 2])));
      m_mate[h] = o;
      m_mate[o] = h;
      ++i;
    }
    return {};
  }

  Result<void> turn_quads() {
    const std::size_t n = m_in.quads.size();
    m_out.patch_of_quad.assign(n, -1);
    m_out.turned.assign(n, 0);
    for (std::size_t first = 0; first < n; ++first) {
      if (m_out.patch_of_quad[first] >= 0) continue;
      m_out.patch_of_quad[first] = m_out.patches;
      std::vector<int> list{int(first)};
      for (std::size_t i = 0; i < list.size(); ++i)
        for (int h = 4 * list[i]; h < 4 * list[i] + 4; ++h) {
          if (m_mate[h] < 0) continue;
          const int other = quad_of(m_mate[h]);
          const bool against = source(m_in.quads, h) == source(m_in.quads, m_mate[h]);
          const char turned = char(m_out.turned[list[i]] ^ char(against));
          if (m_out.patch_of_quad[other] < 0) {
            m_out.patch_of_quad[other] = m_out.patches;
            m_out.turned[other] = turned;
            list.push_back(other);
          } else if (m_out.turned[other] != turned)
            return no_patches("a patch is one-sided, as a Moebius band is, at " +
                                  place(m_in.points[source(m_in.quads, h)]),
                              Element_kind::face, other);
        }
      ++m_out.patches;
    }
    return {};
  }

  // Every fan of quads gets a vertex of its own: corners of quads that share an edge are of one fan.
  void take_apart() {
    Turned_sets fans(m_mate.size());
    for (int h = 0; h < int(m_mate.size()); ++h) {
      if (m_mate[h] < h) continue;
      const bool against = source(m_in.quads, h) == source(m_in.quads, m_mate[h]);
      fans.join(h, against ? m_mate[h] : next(m_mate[h]), 0);
      fans.join(next(h), against ? next(m_mate[h]) : m_mate[h], 0);
    }
    std::map<std::pair<int, int>, int>
        number; // in the order of the vertices: they keep theirs if none is split
    for (int h = 0; h < int(m_mate.size()); ++h) number[{source(m_in.quads, h), fans.root(h).first}] = 0;
    for (auto& [fan, k] : number) {
      k = int(m_out.mesh.points.size());
      m_out.vertex_origin.push_back(fan.first);
      m_out.mesh.points.push_back(m_in.points[fan.first]);
    }
    m_out.mesh.quads = m_in.quads;
    for (int h = 0; h < int(m_mate.size()); ++h)
      m_out.mesh.quads[h / 4][h & 3] = number.at({source(m_in.quads, h), fans.root(h).first});
    for (std::size_t f = 0; f < m_in.quads.size(); ++f)
      if (m_out.turned[f]) m_out.mesh.quads[f] = turned_around(m_out.mesh.quads[f]);
  }

  // Every rim edge votes for how its patch lies to that of the nearest edge beside it.
  Result<void> turn_patches() {
    const std::vector<Rim_edge> rims = rim_edges(m_out);
    std::map<std::pair<int, int>, std::array<double, 2>> votes; // length against each other, and alike
    for (const auto& [e, f] : nearest_edges(rims)) {
      const Rim_edge &s = rims[e], &t = rims[f];
      if (s.patch == t.patch) continue;
      votes[std::minmax(s.patch, t.patch)][along(s).dot(along(t)) > 0] += along(s).norm();
    }
    std::vector<std::tuple<double, int, int, int>> order;
    for (const auto& [patches, length] : votes)
      order.push_back(
          {-std::abs(length[1] - length[0]), patches.first, patches.second, length[1] > length[0]});
    std::sort(order.begin(), order.end());
    Turned_sets sets(m_out.patches);
    for (const auto& [weight, p, q, turned] : order)
      // A patch that only touches a corner may vote wrongly: what is little beside the most does not count.
      if (!sets.join(p, q, turned) && weight < 0.5 * std::get<0>(order.front()))
        return no_patches("patches cannot be turned so that all agree: the surface would be one-sided",
                          Element_kind::face, first_quad(q));
    for (std::size_t f = 0; f < m_out.mesh.quads.size(); ++f)
      if (sets.root(m_out.patch_of_quad[f]).second) {
        m_out.mesh.quads[f] = turned_around(m_out.mesh.quads[f]);
        m_out.turned[f] ^= 1;
      }
    return {};
  }

  int first_quad(int patch) const {
    return int(std::find(m_out.patch_of_quad.begin(), m_out.patch_of_quad.end(), patch) -
               m_out.patch_of_quad.begin());
  }

  Point along(const Rim_edge& e) const { return m_out.mesh.points[e.b] - m_out.mesh.points[e.a]; }

  // Per edge the nearest one that has no vertex of it, lies beside its middle, not farther than the longer of
  // the two is long, and runs about as it does or against it.
  std::vector<std::pair<std::size_t, std::size_t>> nearest_edges(const std::vector<Rim_edge>& rims) const {
    std::vector<std::tuple<double, std::size_t>> by_x;
    std::vector<Point> middle;
    double longest = 0;
    for (std::size_t e = 0; e < rims.size(); ++e) {
      middle.push_back(0.5 * (m_out.mesh.points[rims[e].a] + m_out.mesh.points[rims[e].b]));
      longest = std::max(longest, along(rims[e]).norm());
      by_x.push_back({middle.back().x(), e});
    }
    std::sort(by_x.begin(), by_x.end());
    std::vector<std::pair<double, std::size_t>> nearest(rims.size(), {-1, 0});
    const auto note = [&](std::size_t e, std::size_t f) {
      const Point s = along(rims[e]), t = along(rims[f]);
      const double reach = std::max(s.norm(), t.norm());
      const double d = std::sqrt(
          squared_distance_to_segment(middle[e], m_out.mesh.points[rims[f].a], m_out.mesh.points[rims[f].b]));
      const double beside = (middle[e] - m_out.mesh.points[rims[f].a]).dot(t) / t.squaredNorm();
      if (d > reach || !(beside > -0.01 && beside < 1.01)) return; // one goes on where the other ends
      if (std::abs(s.dot(t)) < 0.7 * s.norm() * t.norm()) return;
      if (nearest[e].first < 0 || d < nearest[e].first) nearest[e] = {d, f};
    };
    for (std::size_t i = 0; i < by_x.size(); ++i)
      for (std::size_t k = i + 1;
           k < by_x.size() && std::get<0>(by_x[k]) - std::get<0>(by_x[i]) <= 1.5 * longest; ++k) {
        const std::size_t e = std::get<1>(by_x[i]), f = std::get<1>(by_x[k]);
        if (rims[e].a == rims[f].b || rims[e].b == rims[f].a) continue;
        note(e, f);
        note(f, e);
      }
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (std::size_t e = 0; e < rims.size(); ++e)
      if (nearest[e].first >= 0) out.push_back({e, nearest[e].second});
    return out;
  }

  const Quad_mesh& m_in;
  std::vector<int> m_mate; ///< per halfedge of `m_in`
  Oriented_patches m_out;
};

} // namespace

std::vector<Rim_edge> rim_edges(const Oriented_patches& patches) {
  std::vector<int> opposite;
  connect_quads(patches.mesh.quads, int(patches.mesh.points.size()), opposite);
  std::vector<Rim_edge> out;
  for (int h = 0; h < int(opposite.size()); ++h)
    if (opposite[h] < 0)
      out.push_back(
          {source(patches.mesh.quads, h), target(patches.mesh.quads, h), patches.patch_of_quad[quad_of(h)]});
  return out;
}

Result<Oriented_patches> orient_patches(const Quad_mesh& mesh) {
  return Orientation(mesh).run();
}

} // namespace internal

std::vector<int> patches_of_quads(const Quad_mesh& mesh) {
  std::map<std::pair<int, int>, int> first; // per edge
  internal::Turned_sets sets(mesh.quads.size());
  for (int h = 0; h < 4 * int(mesh.quads.size()); ++h) {
    const auto edge = std::minmax({internal::source(mesh.quads, h), internal::target(mesh.quads, h)});
    const auto [other, added] = first.insert({edge, h / 4});
    if (!added) sets.join(other->second, h / 4, 0);
  }
  std::vector<int> out;
  std::map<int, int> number;
  for (int q = 0; q < int(mesh.quads.size()); ++q)
    out.push_back(number.insert({sets.root(q).first, int(number.size())}).first->second);
  return out;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
