// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUAD_FACE_GRAPH_H
#define CGAL_REEB_QUADRANGULATION_QUAD_FACE_GRAPH_H

#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A face graph as a `Quad_mesh`, and which element is which. It is valid as long as the graph exists
/// unchanged.
template <class Graph> struct Face_graph_quads {
  Quad_mesh mesh;
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<Graph>::face_descriptor> faces;
};

namespace internal {

template <class Graph, class NamedParameters>
Result<Face_graph_quads<Graph>> quad_mesh(const Graph& graph, const NamedParameters& np) {
  Face_graph_quads<Graph> result;
  const auto points = parameters::vertex_points(np, graph);
  const auto index = get(CGAL::dynamic_vertex_property_t<int>(), graph);
  for (const auto v : vertices(graph)) {
    put(index, v, int(result.vertices.size()));
    result.vertices.push_back(v);
    result.mesh.points.push_back(point_of(np, get(points, v)));
  }
  for (const auto f : faces(graph)) {
    Quad quad{};
    int sides = 0;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, graph), graph)) {
      if (sides < 4) quad[std::size_t(sides)] = get(index, source(h, graph));
      ++sides;
    }
    if (sides != 4)
      return make_error(Error_code::not_a_surface, "a face is not a quad", Element_kind::face,
                        std::int64_t(result.faces.size()));
    result.mesh.quads.push_back(quad);
    result.faces.push_back(f);
  }
  return result;
}

// Puts the points of a mesh that was moved back into the graph.
template <class Graph, class NamedParameters>
void put_points(const Quad_mesh& mesh, const Face_graph_quads<Graph>& from, Graph& graph,
                const NamedParameters& np) {
  const auto points = parameters::vertex_points(np, graph);
  using Kernel_point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  for (std::size_t v = 0; v < from.vertices.size(); ++v)
    if (mesh.points[v] != from.mesh.points[v])
      put(points, from.vertices[v], kernel_point<Kernel_point>(np, mesh.points[v]));
}

} // namespace internal

/// Copies a quad mesh; vertices and faces keep the graph's order, each quad begins at the source of its
/// halfedge. Fails with `not_a_surface`, naming the face by its place in that order, if a face is not a quad.
/// O(V + F). Named parameters: `vertex_point_map`, `geom_traits`.
template <class QuadMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Face_graph_quads<QuadMesh>>
to_quad_mesh(const QuadMesh& quads, const NamedParameters& np = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags()));
  return internal::quad_mesh(quads, np);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUAD_FACE_GRAPH_H
