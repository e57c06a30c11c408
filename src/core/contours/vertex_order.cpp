// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Vertex_order.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>

namespace CGAL {
namespace Reeb_quadrangulation {

Vertex_order order_vertices(const std::vector<double>& values, const std::vector<signed char>& level) {
  Vertex_order order;
  const int n = int(values.size());
  order.by_rank.resize(n);
  std::iota(order.by_rank.begin(), order.by_rank.end(), 0);
  if (level.empty()) {
    std::sort(order.by_rank.begin(), order.by_rank.end(),
              [&](int a, int b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  } else {
    std::sort(order.by_rank.begin(), order.by_rank.end(), [&](int a, int b) {
      if (level[a] != level[b]) return level[a] < level[b];
      return values[a] != values[b] ? values[a] < values[b] : a < b;
    });
  }
  order.rank.resize(n);
  for (int r = 0; r < n; ++r) order.rank[order.by_rank[r]] = r;
  return order;
}

Closed_surface close_boundaries(const Triangle_surface& surface) {
  Closed_surface closed{surface, surface.number_of_vertices(), surface.number_of_faces()};
  Triangle_surface& s = closed.surface;
  for (const std::vector<int>& loop : boundary_loops(surface)) {
    const int apex = s.number_of_vertices(), n = int(loop.size()), first = s.number_of_halfedges();
    Point centre(0, 0, 0);
    for (int h : loop) centre += surface.points[surface.source(h)];
    s.points.push_back(centre / n);
    // Cone face i is (target, source, apex) of loop halfedge i: its halfedge 0 is opposite to the loop,
    // halfedge 1 runs source -> apex and meets halfedge 2 of the previous cone face.
    for (int i = 0; i < n; ++i) {
      s.triangles.push_back({surface.target(loop[i]), surface.source(loop[i]), apex});
      s.opposite.push_back(loop[i]);
      s.opposite.push_back(first + 3 * ((i + n - 1) % n) + 2);
      s.opposite.push_back(first + 3 * ((i + 1) % n) + 1);
      s.opposite[loop[i]] = first + 3 * i;
    }
    s.outgoing.push_back(first + 2);
  }
  return closed;
}

Critical_points critical_points(const Triangle_surface& closed, const Vertex_order& order) {
  const int n = closed.number_of_vertices();
  std::vector<int> changes(n, 0);
  for (const Triangle& t : closed.triangles) {
    const int a = order.rank[t[0]], b = order.rank[t[1]], c = order.rank[t[2]];
    const int middle = (a < b) == (b < c) ? 1 : (b < a) == (a < c) ? 0 : 2;
    ++changes[t[middle]];
  }
  Critical_points critical;
  for (int v = 0; v < n; ++v) {
    if (closed.outgoing[v] < 0 || changes[v] == 2) continue;
    if (changes[v] == 0)
      (order.rank[v] < order.rank[closed.target(closed.outgoing[v])] ? critical.minima : critical.maxima)
          .push_back(v);
    else
      critical.saddles.push_back(v);
  }
  std::sort(critical.saddles.begin(), critical.saddles.end(),
            [&](int a, int b) { return order.rank[a] < order.rank[b]; });
  for (int s : critical.saddles) critical.multiplicity.push_back(changes[s] / 2 - 1);
  return critical;
}

namespace {

// One pass of the flooding: visits all vertices from `seeds` in the order of their ranks (upward for minima),
// makes values monotone along the visit, and makes the visit the new order.
void flood(const Triangle_surface& closed, const std::vector<int>& seeds, bool upward,
           std::vector<double>& values, Vertex_order& order) {
  const int n = closed.number_of_vertices();
  const auto key = [&](int v) { return upward ? order.rank[v] : n - 1 - order.rank[v]; };
  std::priority_queue<int, std::vector<int>, std::greater<int>> queue; // of keys
  std::vector<char> queued(n, 0);
  std::vector<int> visit;
  visit.reserve(n);
  for (int v : seeds) {
    queued[v] = 1;
    queue.push(key(v));
  }
  while (!queue.empty()) {
    const int k = queue.top(), v = order.by_rank[upward ? k : n - 1 - k];
    queue.pop();
    if (!visit.empty())
      values[v] =
          upward ? std::max(values[v], values[visit.back()]) : std::min(values[v], values[visit.back()]);
    visit.push_back(v);
    int h = closed.outgoing[v];
    do {
      const int w = closed.target(h);
      if (!queued[w]) {
        queued[w] = 1;
        queue.push(key(w));
      }
      h = closed.rotate_ccw(h);
    } while (h != closed.outgoing[v]);
  }
  CGAL_assertion(int(visit.size()) == n);
  if (!upward) std::reverse(visit.begin(), visit.end());
  order.by_rank = std::move(visit);
  for (int r = 0; r < n; ++r) order.rank[order.by_rank[r]] = r;
}

} // namespace

int remove_extrema(const Triangle_surface& closed, const std::vector<int>& allowed_minima,
                   const std::vector<int>& allowed_maxima, std::vector<double>& values, Vertex_order& order) {
  CGAL_precondition(!allowed_minima.empty() && !allowed_maxima.empty());
  const auto sorted = [](std::vector<int> v) {
    std::sort(v.begin(), v.end());
    return v;
  };
  const std::vector<int> minima = sorted(allowed_minima), maxima = sorted(allowed_maxima);
  const auto subset = [](const std::vector<int>& a, const std::vector<int>& b) {
    return std::includes(b.begin(), b.end(), a.begin(), a.end());
  };
  for (int round = 0;; ++round) {
    const Critical_points critical = critical_points(closed, order);
    const bool minima_allowed = subset(critical.minima, minima),
               maxima_allowed = subset(critical.maxima, maxima);
    if (minima_allowed && maxima_allowed) return round;
    flood(closed, minima, true, values, order);
    flood(closed, maxima, false, values, order);
  }
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
