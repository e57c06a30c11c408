// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/non_manifold.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// A face at an edge, seen along the edge from its smaller point.
struct Leaf {
  int side = -1;
  double angle = 0;     ///< in [0, 2 pi)
  bool forward = false; ///< the face runs from the smaller point to the larger
  int patch = -1;
};

class Edge_cutter {
public:
  Edge_cutter(const Loose_triangles& soup, const Corner_mesh& mesh, Edge_groups& edges)
      : m_soup(soup), m_mesh(mesh), m_edges(edges), m_patches(soup.number_of_triangles()) {
    for (int e = 0; e < edges.number_of_edges(); ++e)
      if (edges.size(e) == 2) m_patches.join(edges.first(e) / 3, edges.second(e) / 3);
  }

  Edge_cuts run() {
    Edge_groups cut;
    cut.side.reserve(m_edges.side.size());
    for (int e = 0; e < m_edges.number_of_edges(); ++e) {
      if (m_edges.size(e) > 2) {
        divide(e, cut);
        continue;
      }
      cut.side.insert(cut.side.end(), m_edges.side.begin() + m_edges.begin[e],
                      m_edges.side.begin() + m_edges.begin[e + 1]);
      cut.begin.push_back(int(cut.side.size()));
    }
    m_edges = std::move(cut);
    return m_cuts;
  }

private:
  using Pairs = std::vector<std::pair<int, int>>; // positions among the leaves

  void divide(int e, Edge_groups& cut) {
    const std::vector<Leaf> leaves = leaves_at(e);
    const std::int64_t forward =
        std::count_if(leaves.begin(), leaves.end(), [](const Leaf& l) { return l.forward; });
    const bool solids = 2 * forward == std::int64_t(leaves.size());
    const Pairs pairs = solids ? wedges(leaves) : sheets(leaves);
    ++(solids ? m_cuts.solids : m_cuts.sheets);
    std::vector<std::vector<int>> groups;
    std::vector<char> paired(leaves.size(), 0);
    for (const auto& [i, j] : pairs) {
      groups.push_back({std::min(leaves[i].side, leaves[j].side), std::max(leaves[i].side, leaves[j].side)});
      paired[i] = paired[j] = 1;
    }
    for (std::size_t i = 0; i < leaves.size(); ++i)
      if (!paired[i]) groups.push_back({leaves[i].side});
    std::sort(groups.begin(), groups.end());
    for (const std::vector<int>& group : groups) {
      cut.side.insert(cut.side.end(), group.begin(), group.end());
      cut.begin.push_back(int(cut.side.size()));
    }
  }

  /// Counterclockwise. Where several lie on each other, those run through forward come first, so that a
  /// wall that two solids share has a front and a back and no inside.
  std::vector<Leaf> leaves_at(int e) {
    const int first = m_edges.first(e);
    const int low = std::min(m_mesh.source[first], m_mesh.target(first));
    const int high = std::max(m_mesh.source[first], m_mesh.target(first));
    const Point along = (m_soup.points[high] - m_soup.points[low]).normalized();
    const auto across = [&](int side) -> Point {
      const Point d = m_soup.points[m_mesh.source[m_mesh.next[m_mesh.next[side]]]] - m_soup.points[low];
      return (d - d.dot(along) * along).normalized();
    };
    const Point u = across(first), v = along.cross(u);
    constexpr double tie = 1e-7;
    std::vector<Leaf> leaves;
    for (int i = m_edges.begin[e]; i < m_edges.begin[e + 1]; ++i) {
      const int side = m_edges.side[i];
      const Point d = across(side);
      double angle = std::atan2(d.dot(v), d.dot(u));
      if (!std::isfinite(angle)) angle = 0;
      if (angle < -tie) angle += 2 * std::acos(-1.0);
      leaves.push_back({side, angle, m_mesh.source[side] == low, m_patches.find(side / 3)});
    }
    std::sort(leaves.begin(), leaves.end(), [](const Leaf& l, const Leaf& m) {
      return std::tie(l.angle, l.side) < std::tie(m.angle, m.side);
    });
    for (std::size_t i = 0, j = 0; i < leaves.size(); i = j) {
      while (j < leaves.size() && leaves[j].angle - leaves[i].angle <= tie) ++j;
      std::stable_partition(leaves.begin() + std::ptrdiff_t(i), leaves.begin() + std::ptrdiff_t(j),
                            [](const Leaf& l) { return l.forward; });
    }
    return leaves;
  }

  // A face that runs backward has the solid behind it, counterclockwise; one that runs forward, before it:
  // they close like brackets, round the edge.
  static Pairs wedges(const std::vector<Leaf>& leaves) {
    Pairs pairs;
    std::vector<int> opened;
    std::vector<char> closed(leaves.size(), 0);
    for (std::size_t turn = 0; turn < 2 * leaves.size(); ++turn) {
      const int i = int(turn % leaves.size());
      if (closed[i]) continue;
      if (!leaves[i].forward) {
        if (turn < leaves.size()) opened.push_back(i);
      } else if (!opened.empty()) {
        pairs.emplace_back(opened.back(), i);
        closed[opened.back()] = closed[i] = 1;
        opened.pop_back();
      }
    }
    return pairs;
  }

  static Pairs sheets(const std::vector<Leaf>& leaves) {
    struct Candidate {
      int rank;
      double bend;
      int i, j;
    };
    constexpr std::size_t most = 64; // of a fan of very many sheets none is flat
    const double pi = std::acos(-1.0);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < std::min(leaves.size(), most); ++i)
      for (std::size_t j = i + 1; j < std::min(leaves.size(), most); ++j) {
        const double bend = std::abs(std::abs(leaves[j].angle - leaves[i].angle) - pi);
        const bool same = leaves[i].patch == leaves[j].patch;
        if (!same && bend > pi / 4) continue;
        const bool alike = leaves[i].forward != leaves[j].forward;
        candidates.push_back({same ? alike ? 0 : 1 : 2, bend, int(i), int(j)});
      }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& c, const Candidate& d) {
      return std::tie(c.rank, c.bend) < std::tie(d.rank, d.bend);
    });
    Pairs pairs;
    std::vector<char> taken(leaves.size(), 0);
    for (const Candidate& c : candidates) {
      if (taken[c.i] || taken[c.j]) continue;
      taken[c.i] = taken[c.j] = 1;
      pairs.emplace_back(c.i, c.j);
    }
    return pairs;
  }

  const Loose_triangles& m_soup;
  const Corner_mesh& m_mesh;
  Edge_groups& m_edges;
  Disjoint_sets m_patches;
  Edge_cuts m_cuts;
};

} // namespace

Edge_cuts cut_edges(const Loose_triangles& soup, const Corner_mesh& mesh, Edge_groups& edges) {
  return Edge_cutter(soup, mesh, edges).run();
}

bool divide_cut_edges(Loose_triangles& soup, const Corner_mesh& mesh, const Edge_groups& edges,
                      const std::vector<int>& fan) {
  const auto low = [&](int e) { return std::min(mesh.source[edges.first(e)], mesh.target(edges.first(e))); };
  const auto high = [&](int e) { return std::max(mesh.source[edges.first(e)], mesh.target(edges.first(e))); };
  const auto fans = [&](int e) {
    const int s = edges.first(e), t = mesh.next[s];
    return mesh.source[s] < mesh.source[t] ? std::make_pair(fan[s], fan[t]) : std::make_pair(fan[t], fan[s]);
  };
  std::vector<int> middle(mesh.source.size(), -1); // per side: the point to be put into it
  bool any = false;
  for (int e = 0, last = 0; e < edges.number_of_edges(); e = last) {
    std::vector<std::pair<int, int>> ends;
    for (last = e; last < edges.number_of_edges() && low(last) == low(e) && high(last) == high(e); ++last)
      ends.push_back(fans(last));
    std::sort(ends.begin(), ends.end());
    if (std::adjacent_find(ends.begin(), ends.end()) == ends.end()) continue;
    any = true;
    for (int group = e; group < last; ++group) {
      for (int i = edges.begin[group]; i < edges.begin[group + 1]; ++i)
        middle[edges.side[i]] = soup.number_of_points();
      soup.points.push_back((soup.points[low(e)] + soup.points[high(e)]) / 2);
      soup.point_of.push_back(-1);
    }
  }
  if (!any) return false;
  const Loose_triangles whole = soup;
  soup.triangles.clear();
  soup.face_of.clear();
  for (int f = 0; f < whole.number_of_triangles(); ++f) {
    std::array<std::vector<int>, 3> on_side;
    for (int i = 0; i < 3; ++i)
      if (middle[3 * f + i] >= 0) on_side[i] = {middle[3 * f + i]};
    for (const Triangle& t : divided(whole.triangles[f], on_side)) {
      soup.triangles.push_back(t);
      soup.face_of.push_back(whole.face_of[f]);
    }
  }
  return true;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
