// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_ORDER_GRAPH_H
#define CGAL_REEB_QUADRANGULATION_ORDER_GRAPH_H

#include <CGAL/Reeb_quadrangulation/Vertex_order.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What the contours through a critical vertex do as the function rises past it.
enum class Critical_kind : signed char {
  minimum, ///< one begins
  maximum, ///< one ends
  saddle,  ///< others go on than came, or the same otherwise
  touch    ///< one contour goes on as one, but gets or loses ends: it meets the boundary, or leaves it
};

/// The Reeb graph of any function on a surface, with or without boundary, of any number of components:
/// contours (the connected parts of level sets) are closed or end on the boundary, each is a point of the
/// graph. Only the order of the values enters.
struct Order_graph {
  struct Node {
    int vertex; ///< critical: the numbers of vertices around it that are lower and higher are not each one
                ///< run
    Critical_kind kind;
    std::vector<int> lower, upper; ///< arcs, in increasing order
  };
  struct Arc {
    int low, high; ///< nodes
  };
  std::vector<Node> nodes; ///< by increasing rank
  std::vector<Arc> arcs;
  std::vector<int>
      arc_of_vertex;            ///< per vertex of the surface: -1 for critical ones, and those without a face
  std::vector<int> arc_of_face; ///< the arc with the largest part of each face, the lowest of equal ones
  int components = 0;
  /// Pairs of nodes by the elder rule, in the order of the first: a minimum or maximum, and the saddle at
  /// which its component of the sublevel or superlevel sets joins an older one; the lowest minimum of each
  /// component of the surface with its highest maximum.
  std::vector<std::array<int, 2>> pairs;

  /// Number of independent cycles. On a closed surface with simple saddles it is the genus.
  int loops() const { return int(arcs.size()) - int(nodes.size()) + components; }
};

/// Traces the contours of all critical vertices over the surface, by integers, and joins what is between
/// them. `values`, one a vertex, in the order's sense not decreasing, only measure `arc_of_face`. O(F + C log
/// C) for C crossings of these contours with edges.
/// \pre `surface` is connected by `connect()`; the order has all its vertices.
Order_graph order_graph(const Triangle_surface& surface, const Vertex_order& order,
                        const std::vector<double>& values);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_ORDER_GRAPH_H
