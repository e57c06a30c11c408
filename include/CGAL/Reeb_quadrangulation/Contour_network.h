// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CONTOUR_NETWORK_H
#define CGAL_REEB_QUADRANGULATION_CONTOUR_NETWORK_H

#include <CGAL/Reeb_quadrangulation/Index.h>
#include <CGAL/Reeb_quadrangulation/Vertex_order.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The two walks that can bound a chart: where its height parameter U is 0 and where it is 1.
enum class Side : signed char { low, high };

/// A point where contours cross an edge of the surface.
struct Edge_crossing {
  int halfedge; ///< the edge's representative `surface.edge(h)`, or -1: a crossing that was removed
  double t;     ///< position from its source to its target, in (0, 1); unique on the edge
};

enum class Node_kind : signed char {
  saddle,         ///< a critical point
  regular,        ///< a regular point, where a contour begins and ends (caps, subdivisions)
  boundary,       ///< on a boundary loop of the surface
  half_pole,      ///< an end of a segment that is an extremum
  half_saddle,    ///< where a loop and a middle segment meet
  quarter_saddle, ///< a corner of a rectangle
  corner,         ///< of a cap that is a rectangle
  anchor          ///< a regular point that divides a contour, so that its parts move alone
};

struct Contour_node {
  int vertex; ///< of the network, see `Contour_network`
  Node_kind kind = Node_kind::regular;
  int multiplicity = 0; ///< of a saddle
};

/// A piece of a contour between two nodes. The upper side is on its left: it belongs to the LOW walk of the
/// chart on its left and to the HIGH walk of the chart on its right, unless it is a ridge (declared by `left`
/// and `right`).
struct Contour_edge {
  int from = -1, to = -1;    ///< nodes
  std::vector<int> vertices; ///< network vertices, from node to node, at least two
  std::vector<int> faces; ///< the face crossed by each segment, or -1 if it runs along an edge of the surface
  double value = 0;       ///< the field's value on it
  Side left = Side::low;  ///< the walk of the chart on the left that holds it
  Side right = Side::high; ///< and of the chart on the right; ignored on a boundary loop
};

/// Contours embedded in a surface: the central structure from which charts are cut. A network vertex `i` is
/// vertex `i` of the surface if `i < surface_vertices`, else the crossing `i - surface_vertices`. Contours
/// meet in nodes only. Indices are for life: a crossing that was removed has no halfedge, an edge that was
/// removed has no vertices.
struct Contour_network {
  int surface_vertices = 0;
  std::vector<Edge_crossing> crossings;
  std::vector<Contour_node> nodes;
  std::vector<Contour_edge> edges;

  bool is_removed(const Contour_edge& edge) const { return edge.vertices.empty(); }
  bool is_crossing(int vertex) const { return vertex >= surface_vertices; }
  const Edge_crossing& crossing(int vertex) const { return crossings[vertex - surface_vertices]; }
  Point position(const Triangle_surface& surface, int vertex) const;
};

/// The points of all network vertices, by their numbers. O(V + crossings)
std::vector<Point> network_points(const Triangle_surface& surface, const Contour_network& network);

/// Adds a crossing and returns its network vertex.
int add_crossing(Contour_network& network, const Edge_crossing& crossing);

/// Adds a node at a network vertex and returns its index.
int add_node(Contour_network& network, int vertex, Node_kind kind = Node_kind::regular);

/// Per node: whether a contour edge begins or ends there.
std::vector<char> nodes_in_use(const Contour_network& network);

/// Turns a contour edge around; its sides' declarations stay.
void reverse(Contour_edge& edge);

/// Removes a contour edge and its crossings. Its nodes stay.
void remove_edge(Contour_network& network, int edge);

/// Cuts a contour edge at its vertex number `at`, which becomes a node of the given kind (the edge itself is
/// removed, its crossings stay). Returns the two new edges; for a loop at a node of kind `regular` that no
/// other edge has, the only one. If `at` is 0, or the last vertex, nothing is cut and the edge is returned.
std::vector<int> split_edge(Contour_network& network, Contour_id edge, int at,
                            Node_kind kind = Node_kind::regular);

/// A contour as it is traced, before it is placed: the halfedges that it crosses, in order, each from its
/// lower to its higher end, so that the upper side is on the left.
struct Traced_contour {
  int seed = -1;              ///< the vertex it goes through, or -1
  int threshold = -1;         ///< else it separates ranks <= threshold from the higher ones
  std::vector<int> halfedges; ///< a loop from the seed to the seed, or closed
};

/// The loops of the contour through `seed`, one more than its multiplicity if it is a saddle, one if it is
/// regular. Integers only; O(crossings). \pre `seed` is not an extremum of `order`.
std::vector<Traced_contour> trace_contour(const Triangle_surface& closed, const Vertex_order& order,
                                          int seed);

/// The contour between ranks `threshold` and `threshold + 1` that crosses the edge of `halfedge`, which must
/// run from a vertex of rank <= threshold to a higher one.
Traced_contour trace_threshold(const Triangle_surface& closed, const Vertex_order& order, Rank threshold,
                               Halfedge_index halfedge);

/// Places traced contours of one order on the surface: crossings on an edge are ordered by the contours'
/// ranks, put where the field has their value, and spread so that neighbours keep a distance (the least is 3
/// % of the edge, or 1 / (crossings + 2)); positions are constructed last and decide nothing.
Contour_network build_network(const Triangle_surface& surface, const Vertex_order& order,
                              const std::vector<double>& values, const std::vector<Traced_contour>& contours,
                              const std::vector<int>& saddles, const std::vector<int>& multiplicity);

/// Adds a boundary loop (halfedges in order, face on the left) as a contour: the LOW walk of its chart if it
/// is a minimum of the field, else the HIGH walk.
void add_boundary_contour(const Triangle_surface& surface, const std::vector<int>& loop, bool is_maximum,
                          double value, Contour_network& network);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CONTOUR_NETWORK_H
