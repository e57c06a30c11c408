// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/duplicates.h"

#include "mend/corners.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

class Duplicates {
public:
  Duplicates(Loose_triangles& soup, std::vector<Mend>& mends) : m_soup(soup), m_mends(mends) {}

  void run() {
    const int n = m_soup.number_of_triangles();
    std::vector<int> order(n);
    std::vector<Triangle> sorted = m_soup.triangles;
    for (Triangle& t : sorted) std::sort(t.begin(), t.end());
    std::iota(order.begin(), order.end(), 0);
    if (!bring_equal_together(sorted, order)) return;
    m_first_of.resize(n);
    m_copies.assign(n, 0);
    for (int i = 0, first = 0; i < n; ++i) {
      if (sorted[order[i]] != sorted[order[first]]) first = i;
      m_first_of[order[i]] = order[first];
      ++m_copies[order[first]];
    }
    const std::vector<char> wall = inner_walls();
    std::int64_t walls = 0;
    const std::int64_t dropped = m_soup.keep([&](std::size_t f) {
      walls += wall[m_first_of[f]];
      return m_first_of[f] == int(f) && !wall[m_first_of[f]];
    });
    say(m_mends, walls, "face of a double sheet inside a surface was dropped",
        "faces of double sheets inside a surface were dropped");
    say(m_mends, dropped - walls, "duplicate face was dropped", "duplicate faces were dropped");
  }

private:
  /// Sorts the faces by their corners; false if no two are equal.
  bool bring_equal_together(const std::vector<Triangle>& sorted, std::vector<int>& order) const {
    std::vector<int> begin(m_soup.points.size() + 1, 0), bucket(order.size());
    for (const Triangle& t : sorted) ++begin[t[0] + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> end(begin.begin(), begin.end() - 1);
    for (int f : order) bucket[end[sorted[f][0]]++] = f;
    bool any = false;
    for (int v = 0; v < m_soup.number_of_points(); ++v) {
      std::sort(bucket.begin() + begin[v], bucket.begin() + begin[v + 1],
                [&](int f, int g) { return sorted[f] != sorted[g] ? sorted[f] < sorted[g] : f < g; });
      for (int i = begin[v] + 1; i < begin[v + 1]; ++i) any |= sorted[bucket[i]] == sorted[bucket[i - 1]];
    }
    order.swap(bucket);
    return any;
  }

  /// For each first copy whether it belongs to a wall. A patch of doubled faces is none if it ends freely,
  /// or at an edge whose other faces are doubled in part, or anything but two: then it is what the surface
  /// is made of.
  std::vector<char> inner_walls() const {
    const int n = m_soup.number_of_triangles();
    std::vector<Triangle> unique;
    std::vector<int> id;
    for (int f = 0; f < n; ++f)
      if (m_first_of[f] == f) {
        unique.push_back(m_soup.triangles[f]);
        id.push_back(f);
      }
    const Corner_mesh mesh = corner_mesh(unique);
    const Edge_groups edges = group_edges(mesh, m_soup.number_of_points());
    Disjoint_sets patches(n);
    std::vector<char> ends_at_surface(n, 0), ends_elsewhere(n, 0), wall(n, 0);
    for (int e = 0; e < edges.number_of_edges(); ++e) {
      const int first = id[edges.first(e) / 3];
      int singles = 0;
      for (int i = edges.begin[e]; i < edges.begin[e + 1]; ++i)
        singles += m_copies[id[edges.side[i] / 3]] == 1;
      if (edges.size(e) == 2 && singles == 0) patches.join(first, id[edges.second(e) / 3]);
      const bool inside = singles == 0 && edges.size(e) > 1;
      for (int i = edges.begin[e]; i < edges.begin[e + 1]; ++i) {
        const int f = id[edges.side[i] / 3];
        if (singles == 2)
          ends_at_surface[f] = 1;
        else if (!inside)
          ends_elsewhere[f] = 1;
      }
    }
    std::vector<char> touching(n, 0), open(n, 0);
    for (int f : id) {
      if (ends_at_surface[f]) touching[patches.find(f)] = 1;
      if (ends_elsewhere[f]) open[patches.find(f)] = 1;
    }
    for (int f : id) {
      const int patch = patches.find(f);
      wall[f] = m_copies[f] > 1 && touching[patch] && !open[patch];
    }
    return wall;
  }

  Loose_triangles& m_soup;
  std::vector<Mend>& m_mends;
  std::vector<int> m_first_of, m_copies; ///< per face; copies count at the first one
};

/// Whether a triangle is nowhere wider than `height`.
bool is_thin(const Loose_triangles& soup, const Triangle& t, double height) {
  const Point &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
  if (!a.allFinite() || !b.allFinite() || !c.allFinite()) return false;
  if (are_collinear(a, b, c)) return true;
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return (b - a).cross(c - a).norm() <= height * longest;
}

} // namespace

void drop_duplicate_faces(Loose_triangles& soup, std::vector<Mend>& mends) {
  Duplicates(soup, mends).run();
}

void drop_flaps(Loose_triangles& soup, double height, std::vector<Mend>& mends) {
  std::int64_t dropped = 0;
  // A flap may hang on a flap.
  for (int round = 0; round < 8; ++round) {
    const Corner_mesh mesh = corner_mesh(soup.triangles);
    const Edge_groups edges = group_edges(mesh, soup.number_of_points());
    std::vector<char> held(soup.triangles.size(), 0), crowded(soup.triangles.size(), 0);
    bool any = false;
    for (int e = 0; e < edges.number_of_edges(); ++e)
      for (int i = edges.begin[e]; i < edges.begin[e + 1]; ++i) {
        if (edges.size(e) == 2) held[edges.side[i] / 3] = 1;
        if (edges.size(e) <= 2) continue;
        crowded[edges.side[i] / 3] = 1;
        any = true;
      }
    if (!any) break;
    const std::int64_t now = soup.keep(
        [&](std::size_t f) { return held[f] || !crowded[f] || !is_thin(soup, soup.triangles[f], height); });
    dropped += now;
    if (now == 0) break;
  }
  say(mends, dropped, "face without area that hung on others was dropped",
      "faces without area that hung on others were dropped");
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
