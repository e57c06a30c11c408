// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/tree.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

// Spreads the lowest 21 bits of x so that two zeros follow each.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffull;
  x = (x | x << 16) & 0x001f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

// The place of p on the Morton curve through the box.
std::uint64_t curve_place(const Point& p, const Eigen::AlignedBox3d& box) {
  const double cells = double((1 << 21) - 1);
  std::uint64_t place = 0;
  for (int i = 0; i < 3; ++i) {
    const double extent = box.max()[i] - box.min()[i];
    const double t = extent > 0 ? (p[i] - box.min()[i]) / extent : 0; // NaN if the extent overflows
    const std::uint64_t cell = t >= 0 && t <= 1 ? std::uint64_t(cells * t) : 0;
    place |= spread(cell) << i;
  }
  return place;
}

double squared_segment_distance(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a, r = p - a;
  const double dd = d.squaredNorm();
  const double t = dd > 0 ? std::min(1.0, std::max(0.0, r.dot(d) / dd)) : 0;
  return (r - t * d).squaredNorm();
}

} // namespace

Triangle_tree::Triangle_tree(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
    : m_points(points), m_triangles(triangles), m_order(triangles.size()) {
  const int n = int(triangles.size());
  Box all;
  for (int t = 0; t < n; ++t) all.extend(box(t));
  std::vector<std::pair<std::uint64_t, int>> places(n);
  for (int t = 0; t < n; ++t) places[t] = {curve_place(box(t).center(), all), t};
  std::sort(places.begin(), places.end());
  for (int i = 0; i < n; ++i) m_order[i] = places[i].second;

  while (m_leaves * leaf_size < n) m_leaves *= 2;
  m_nodes.resize(2 * std::size_t(m_leaves));
  for (int node = m_leaves; node < 2 * m_leaves; ++node)
    for (int i = leaf_begin(node); i < leaf_end(node); ++i) m_nodes[node].extend(box(m_order[i]));
  for (int node = m_leaves - 1; node > 0; --node)
    m_nodes[node] = m_nodes[2 * node].merged(m_nodes[2 * node + 1]);
}

Eigen::AlignedBox3d Triangle_tree::box(int triangle) const {
  const Triangle& t = m_triangles[triangle];
  Box result(m_points[t[0]]);
  return result.extend(m_points[t[1]]).extend(m_points[t[2]]);
}

double Triangle_tree::squared_distance(const Point& query, int triangle) const {
  const Triangle& t = m_triangles[triangle];
  const Point &a = m_points[t[0]], &b = m_points[t[1]], &c = m_points[t[2]];
  const Point normal = (b - a).cross(c - a);
  const double nn = normal.squaredNorm();
  const bool outside[3] = {normal.dot((b - a).cross(query - a)) < 0, normal.dot((c - b).cross(query - b)) < 0,
                           normal.dot((a - c).cross(query - c)) < 0};
  // Over the inside of the triangle its plane is the nearest; everywhere else a side that the query lies
  // beyond.
  const bool beyond = outside[0] || outside[1] || outside[2];
  if (!beyond && nn > 0) {
    const double height = normal.dot(query - a);
    return height * height / nn;
  }
  double least = std::numeric_limits<double>::infinity();
  if (outside[0] || !beyond) least = squared_segment_distance(query, a, b);
  if (outside[1] || !beyond) least = std::min(least, squared_segment_distance(query, b, c));
  if (outside[2] || !beyond) least = std::min(least, squared_segment_distance(query, c, a));
  return least;
}

Triangle_tree::Nearest Triangle_tree::nearest(const Point& query, int hint) const {
  Nearest best{hint, hint >= 0 ? squared_distance(query, hint) : std::numeric_limits<double>::infinity()};
  std::array<std::pair<double, int>, 64> stack; // the tree's depth is below 32
  int top = 0;
  stack[top++] = {0.0, 1};
  while (top > 0) {
    const auto [bound, node] = stack[--top];
    if (bound > best.squared_distance) continue;
    if (node >= m_leaves) {
      for (int i = leaf_begin(node); i < leaf_end(node); ++i) {
        const double d = squared_distance(query, m_order[i]);
        // Of several at the same distance (a shared vertex, an edge), the smallest index.
        if (d < best.squared_distance ||
            (d == best.squared_distance && (best.triangle < 0 || m_order[i] < best.triangle)))
          best = {m_order[i], d};
      }
      continue;
    }
    for (int child : {2 * node + 1, 2 * node})
      if (!m_nodes[child].isEmpty()) stack[top++] = {m_nodes[child].squaredExteriorDistance(query), child};
    const bool both = top > 1 && stack[top - 1].second == 2 * node && stack[top - 2].second == 2 * node + 1;
    if (both && stack[top - 1].first > stack[top - 2].first) // the nearer child comes first
      std::swap(stack[top - 1], stack[top - 2]);
  }
  // Distances that overflow compare with nothing.
  if (best.triangle < 0) best = {m_order[0], std::numeric_limits<double>::infinity()};
  return best;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
