// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_REEB_GRAPH_H
#define CGAL_REEB_QUADRANGULATION_REEB_GRAPH_H

#include <CGAL/Reeb_quadrangulation/Order_graph.h>
#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The Reeb graph of a function on a face graph; \sa `Order_graph`.
template <class Graph> struct Face_graph_reeb_graph {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  struct Node {
    Vertex vertex;
    Critical_kind kind;
    std::vector<int> lower, upper; ///< arcs
    /// The difference of values in the node's pair of `Order_graph::pairs`, of a saddle in several the
    /// greatest; infinity for saddles in none, which open or close a cycle of the graph or the surface. What
    /// is less persistent is more likely noise.
    double persistence = std::numeric_limits<double>::infinity();
  };
  std::vector<Node> nodes; ///< by increasing value
  std::vector<Order_graph::Arc> arcs;
  std::vector<std::array<int, 2>> pairs;
  int components = 0;
  int loops() const { return int(arcs.size()) - int(nodes.size()) + components; }
};

namespace internal {

// The vertices ordered by the values themselves, in whatever type, then by their indices. A value that does
// not compare, or is infinite, has no place in an order.
template <class Value>
Result<Vertex_order> order_of_values(const std::vector<Value>& values, const char* sentence) {
  Vertex_order order;
  for (int v = 0; v < int(values.size()); ++v) {
    bool is_finite = values[std::size_t(v)] == values[std::size_t(v)];
    if constexpr (std::is_floating_point<Value>::value) is_finite = std::isfinite(values[std::size_t(v)]);
    if (!is_finite) return make_error(Error_code::impossible_request, sentence, Element_kind::vertex, v);
    order.by_rank.push_back(v);
  }
  std::stable_sort(order.by_rank.begin(), order.by_rank.end(),
                   [&](int a, int b) { return values[std::size_t(a)] < values[std::size_t(b)]; });
  order.rank.resize(values.size());
  for (int r = 0; r < int(values.size()); ++r) order.rank[std::size_t(order.by_rank[std::size_t(r)])] = r;
  return order;
}

template <class Graph>
Face_graph_reeb_graph<Graph> named_graph(const Order_graph& graph, const Face_graph_surface<Graph>& mesh,
                                         const std::vector<double>& values) {
  Face_graph_reeb_graph<Graph> result;
  for (const Order_graph::Node& node : graph.nodes)
    result.nodes.push_back({mesh.vertices[std::size_t(node.vertex)], node.kind, node.lower, node.upper});
  result.arcs = graph.arcs;
  result.pairs = graph.pairs;
  result.components = graph.components;
  for (const std::array<int, 2>& pair : graph.pairs) {
    const auto value = [&](int n) { return values[std::size_t(graph.nodes[std::size_t(n)].vertex)]; };
    const double difference = std::abs(value(pair[1]) - value(pair[0]));
    for (int n : pair) {
      double& persistence = result.nodes[std::size_t(n)].persistence;
      persistence = std::isinf(persistence) ? difference : std::max(persistence, difference);
    }
  }
  return result;
}

} // namespace internal

/// The Reeb graph of the function `field`, a readable map from the vertices to numbers of any ordered type,
/// which are compared as they are. The function is what it is: none of its extrema is removed, it need not be
/// constant on the boundary (contours may end there), and the mesh may have several components. Equal values
/// count as ordered by the position of their vertices in `vertices(tmesh)`: a plateau gets the extrema and
/// saddles of that order, which are pairs of persistence 0 where they are artefacts.
///
/// Fails with `impossible_request`, naming the vertex by its place among those with a face, if a value is not
/// finite, and as `to_triangle_surface()` does. O(F + C log C) for C crossings of edges with critical
/// contours. Named parameters: `vertex_point_map`, `geom_traits`; written are `vertex_arc_map` (vertices
/// without a face are not) and `face_arc_map`.
template <class TriangleMesh, class VertexFieldMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Face_graph_reeb_graph<TriangleMesh>>
reeb_graph(const TriangleMesh& tmesh, VertexFieldMap field,
           const NamedParameters& np = CGAL::parameters::default_values()) {
  using Tags = parameters::Tag_list<parameters::vertex_arc_map_t, parameters::face_arc_map_t>;
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags() + Tags()));
  const auto mesh = internal::triangle_surface(tmesh, np);
  if (!mesh) return mesh.error();
  using Value = std::decay_t<typename boost::property_traits<VertexFieldMap>::value_type>;
  std::vector<Value> values;
  for (const auto v : mesh->vertices) values.push_back(get(field, v));
  const Result<Vertex_order> order =
      internal::order_of_values(values, "a value of the function is not finite");
  if (!order) return order.error();
  std::vector<double> rounded;
  for (const Value& value : values) rounded.push_back(internal::coordinate(value));
  const Order_graph graph = order_graph(mesh->surface, *order, rounded);
  if constexpr (parameters::has_parameter<parameters::vertex_arc_map_t, NamedParameters>) {
    const auto map = CGAL::parameters::get_parameter(np, parameters::vertex_arc_map_t());
    for (std::size_t v = 0; v < mesh->vertices.size(); ++v)
      put(map, mesh->vertices[v], graph.arc_of_vertex[v]);
  }
  if constexpr (parameters::has_parameter<parameters::face_arc_map_t, NamedParameters>) {
    const auto map = CGAL::parameters::get_parameter(np, parameters::face_arc_map_t());
    for (std::size_t f = 0; f < mesh->faces.size(); ++f) put(map, mesh->faces[f], graph.arc_of_face[f]);
  }
  return internal::named_graph(graph, *mesh, rounded);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_REEB_GRAPH_H
