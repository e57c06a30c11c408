// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_TREE_H
#define REEBQUAD_CERTIFICATE_TREE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <Eigen/Geometry>

#include <array>
#include <vector>

/// \file
/// A bounding volume tree over triangles for the certificate and the statistics. The triangles are sorted
/// along a space-filling curve (Lauterbach et al., "Fast BVH construction on GPUs", 2009) and the tree over
/// them is implicit: node i has the children 2 i and 2 i + 1.

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

class Triangle_tree {
public:
  /// Keeps references to both arrays. Triangles must have valid indices and finite points. O(n log n).
  Triangle_tree(const std::vector<Point>& points, const std::vector<Triangle>& triangles);

  struct Nearest {
    int triangle = -1;
    double squared_distance = 0;
  };
  /// The triangle nearest to `query`. `hint` is a triangle that is likely near, or -1. \pre the tree is not
  /// empty.
  Nearest nearest(const Point& query, int hint = -1) const;
  double squared_distance(const Point& query, int triangle) const;

  /// Calls `visit(t)` for every triangle t > `triangle` whose closed box meets that of `triangle`.
  template <class Visit> void for_boxes_meeting(int triangle, Visit&& visit) const {
    for_boxes_meeting(box(triangle), [&](int t) {
      if (t > triangle) visit(t);
    });
  }
  /// The same for every triangle whose closed box meets a box.
  template <class Visit> void for_boxes_meeting(const Eigen::AlignedBox3d& query, Visit&& visit) const;
  /// Whether a triangle that is no farther than that fulfils a condition.
  template <class Condition>
  bool any_within(const Point& query, double squared_distance, Condition&& fulfils) const;

  bool empty() const { return m_triangles.empty(); }
  Eigen::AlignedBox3d box(int triangle) const;

private:
  using Box = Eigen::AlignedBox3d;
  static constexpr int leaf_size = 4;

  int leaf_begin(int node) const { return (node - m_leaves) * leaf_size; }
  int leaf_end(int node) const { return std::min(leaf_begin(node) + leaf_size, int(m_order.size())); }

  const std::vector<Point>& m_points;
  const std::vector<Triangle>& m_triangles;
  std::vector<int> m_order; // triangles along the curve
  std::vector<Box> m_nodes; // 1-based heap; leaves are m_leaves .. 2 m_leaves - 1, some of them empty
  int m_leaves = 1;
};

template <class Visit>
void Triangle_tree::for_boxes_meeting(const Eigen::AlignedBox3d& query, Visit&& visit) const {
  std::array<int, 64> stack; // the tree's depth is below 32
  int top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const int node = stack[--top];
    if (!m_nodes[node].intersects(query)) continue;
    if (node < m_leaves) {
      stack[top++] = 2 * node + 1;
      stack[top++] = 2 * node;
      continue;
    }
    for (int i = leaf_begin(node); i < leaf_end(node); ++i)
      if (box(m_order[i]).intersects(query)) visit(m_order[i]);
  }
}

template <class Condition>
bool Triangle_tree::any_within(const Point& query, double squared, Condition&& fulfils) const {
  std::array<int, 64> stack;
  int top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const int node = stack[--top];
    if (m_nodes[node].isEmpty() || m_nodes[node].squaredExteriorDistance(query) > squared) continue;
    if (node < m_leaves) {
      stack[top++] = 2 * node + 1;
      stack[top++] = 2 * node;
      continue;
    }
    for (int i = leaf_begin(node); i < leaf_end(node); ++i)
      if (squared_distance(query, m_order[i]) <= squared && fulfils(m_order[i])) return true;
  }
  return false;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_TREE_H
