// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/surface_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

template <class Visit> void for_each_neighbour(const Triangle_surface& s, int vertex, const Visit& visit) {
  const int first = s.outgoing[vertex];
  int h = first;
  do {
    visit(s.target(h));
    const int last = Triangle_surface::previous(h);
    h = s.opposite[last];
    if (h < 0) visit(s.source(last)); // the last one before the boundary
  } while (h >= 0 && h != first);
}

} // namespace

int nearest_vertex(const Triangle_surface& surface, const Surface_point& at) {
  const std::vector<Point>& points = surface.points;
  if (at.vertex >= 0 && at.vertex < int(points.size()) && points[std::size_t(at.vertex)] == at.point)
    return at.vertex;
  const auto nearer = [&](const Point& a, const Point& b) {
    return (a - at.point).squaredNorm() < (b - at.point).squaredNorm();
  };
  return int(std::min_element(points.begin(), points.end(), nearer) - points.begin());
}

std::vector<std::pair<double, int>> vertices_within(const Triangle_surface& s, int vertex, double distance,
                                                    int until) {
  std::vector<double> far(s.points.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
  std::vector<std::pair<double, int>> reached;
  far[std::size_t(vertex)] = 0;
  queue.push({0, vertex});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > far[std::size_t(v)]) continue;
    reached.push_back({d, v});
    if (v == until) break;
    for_each_neighbour(s, v, [&, d = d, v = v](int w) {
      const double there = d + (s.points[std::size_t(w)] - s.points[std::size_t(v)]).norm();
      if (there > distance || !(there < far[std::size_t(w)])) return;
      far[std::size_t(w)] = there;
      queue.push({there, w});
    });
  }
  return reached;
}

std::vector<int> vertices_on_way(const Triangle_surface& s, int from, int to,
                                 const std::vector<double>& parts) {
  std::vector<double> far(s.points.size(), std::numeric_limits<double>::infinity());
  for (const auto& [d, v] : vertices_within(s, from, std::numeric_limits<double>::infinity(), to))
    far[std::size_t(v)] = d;
  std::vector<int> way{to}; // back to where it began: each step goes to the vertex that was reached before
  while (way.back() != from) {
    int before = -1;
    double least = std::numeric_limits<double>::infinity();
    for_each_neighbour(s, way.back(), [&](int w) {
      const double there =
          far[std::size_t(w)] + (s.points[std::size_t(w)] - s.points[std::size_t(way.back())]).norm();
      if (far[std::size_t(w)] >= far[std::size_t(way.back())] || there > least) return;
      if (there == least && w > before) return;
      least = there;
      before = w;
    });
    if (before < 0) break; // points that coincide
    way.push_back(before);
  }
  const double whole = far[std::size_t(to)];
  std::vector<int> chosen;
  for (const double part : parts) {
    const auto nearer = [&](int a, int b) {
      return std::abs(far[std::size_t(a)] - part * whole) < std::abs(far[std::size_t(b)] - part * whole);
    };
    const int v = *std::min_element(way.begin(), way.end(), nearer);
    const bool is_new = v != from && v != to && std::find(chosen.begin(), chosen.end(), v) == chosen.end();
    chosen.push_back(is_new ? v : -1);
  }
  return chosen;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
