// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/tree.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

// A triangle in the order that the tree gives them.
struct Item {
  Point centre; // of its box
  int triangle;
};

// Halves the items at `middle` across the longer way that their centres spread.
void halve(std::vector<Item>& items, int begin, int middle, int end) {
  Eigen::AlignedBox3d box;
  for (int i = begin; i < end; ++i) box.extend(items[i].centre);
  int axis = 0;
  (box.max() - box.min()).maxCoeff(&axis);
  std::nth_element(items.begin() + begin, items.begin() + middle, items.begin() + end,
                   [axis](const Item& a, const Item& b) {
                     return std::make_pair(a.centre[axis], a.triangle) <
                            std::make_pair(b.centre[axis], b.triangle);
                   });
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
  std::vector<Item> items(triangles.size());
  for (int t = 0; t < n; ++t) items[t] = {box(t).center(), t};
  while (m_leaves * leaf_size < n) m_leaves *= 2;
  for (int parts = 1; parts < m_leaves; parts *= 2) {
    const int leaves = m_leaves / parts;
    for (int first = m_leaves; first < 2 * m_leaves; first += leaves)
      halve(items, leaf_begin(first), leaf_begin(first + leaves / 2), leaf_begin(first + leaves));
  }
  for (int i = 0; i < n; ++i) m_order[i] = items[i].triangle;

  std::vector<Box> level(static_cast<std::size_t>(m_leaves));
  for (int node = m_leaves; node < 2 * m_leaves; ++node)
    for (int i = leaf_begin(node); i < leaf_end(node); ++i) level[node - m_leaves].extend(box(m_order[i]));
  m_children.resize(std::size_t(m_leaves));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int first = m_leaves / 2; first > 0; first /= 2) // the first node of the level above
    for (int i = 0; i < first; ++i) {
      for (int k = 0; k < 2; ++k)
        for (int axis = 0; axis < 3; ++axis) {
          const Box& child = level[2 * i + k];
          m_children[first + i].low[axis][k] = child.isEmpty() ? infinity : child.min()[axis];
          m_children[first + i].high[axis][k] = child.isEmpty() ? -infinity : child.max()[axis];
        }
      level[i] = level[2 * i].merged(level[2 * i + 1]);
    }
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

Triangle_tree::Nearest Triangle_tree::nearest(const Point& query, int hint, double enough) const {
  Nearest best{hint, hint >= 0 ? squared_distance(query, hint) : std::numeric_limits<double>::infinity()};
  std::array<std::pair<double, int>, 64> stack; // the tree's depth is below 32
  int top = 0;
  stack[top++] = {0.0, 1};
  while (top > 0 && !(best.squared_distance <= enough)) {
    const auto [bound, node] = stack[--top];
    if (bound > best.squared_distance) continue;
    if (node >= m_leaves) {
      for (int i = leaf_begin(node); i < leaf_end(node); ++i) {
        const int t = m_order[i];
        const double d = squared_distance(query, t);
        // Of several at the same distance (a shared vertex, an edge), the smallest index.
        if (d < best.squared_distance ||
            (d == best.squared_distance && (best.triangle < 0 || t < best.triangle)))
          best = {t, d};
      }
      continue;
    }
    const Both distance = m_children[node].squared_distance(query);
    const int nearer = distance[0] <= distance[1] ? 0 : 1; // it comes first
    if (distance[1 - nearer] <= best.squared_distance)
      stack[top++] = {distance[1 - nearer], 2 * node + 1 - nearer};
    if (distance[nearer] <= best.squared_distance) stack[top++] = {distance[nearer], 2 * node + nearer};
  }
  // Distances that overflow compare with nothing.
  if (best.triangle < 0) best = {m_order[0], std::numeric_limits<double>::infinity()};
  return best;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
