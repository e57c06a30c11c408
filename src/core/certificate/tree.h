// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_TREE_H
#define REEBQUAD_CERTIFICATE_TREE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

/// \file
/// A bounding volume tree over triangles for the certificate and the statistics: halves of equal number
/// across the longest axis, so that the tree over them is implicit: node i has the children 2 i and 2 i + 1.

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
  /// The triangle nearest to `query`, or any whose squared distance is not greater than `enough`. `hint` is a
  /// triangle that is likely near, or -1. \pre the tree is not empty.
  Nearest nearest(const Point& query, int hint = -1, double enough = -1) const;
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
  using Both = Eigen::Array2d; // a number of each child
  static constexpr int leaf_size = 2;

  // The boxes of a node's two children. Empty ones are infinitely far from everything.
  struct Children {
    std::array<Both, 3> low, high;

    Both squared_distance(const Point& p) const {
      Both sum = Both::Zero();
      for (int i = 0; i < 3; ++i) sum += (low[i] - p[i]).max(p[i] - high[i]).max(0.0).square();
      return sum;
    }
    std::array<bool, 2> meet(const Box& box) const {
      std::array<bool, 2> result;
      for (int k = 0; k < 2; ++k)
        result[k] = low[0][k] <= box.max()[0] && low[1][k] <= box.max()[1] && low[2][k] <= box.max()[2] &&
                    high[0][k] >= box.min()[0] && high[1][k] >= box.min()[1] && high[2][k] >= box.min()[2];
      return result;
    }
  };

  // Where the triangles of a leaf begin in the order; of the node after the last leaf, where they end.
  int leaf_begin(int node) const {
    return int(std::int64_t(node - m_leaves) * std::int64_t(m_order.size()) / m_leaves);
  }
  int leaf_end(int node) const { return leaf_begin(node + 1); }

  const std::vector<Point>& m_points;
  const std::vector<Triangle>& m_triangles;
  std::vector<int> m_order;         // triangles leaf by leaf
  std::vector<Children> m_children; // of the nodes 1 .. m_leaves - 1
  int m_leaves = 1;                 // the nodes m_leaves .. 2 m_leaves - 1 are leaves, some of them empty
};

template <class Visit>
void Triangle_tree::for_boxes_meeting(const Eigen::AlignedBox3d& query, Visit&& visit) const {
  std::array<int, 64> stack; // the tree's depth is below 32
  int top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const int node = stack[--top];
    if (node < m_leaves) {
      const std::array<bool, 2> meet = m_children[node].meet(query);
      if (meet[1]) stack[top++] = 2 * node + 1;
      if (meet[0]) stack[top++] = 2 * node;
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
    if (node < m_leaves) {
      const Both distance = m_children[node].squared_distance(query);
      if (distance[1] <= squared) stack[top++] = 2 * node + 1;
      if (distance[0] <= squared) stack[top++] = 2 * node;
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
