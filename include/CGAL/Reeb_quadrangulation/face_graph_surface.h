// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FACE_GRAPH_SURFACE_H
#define CGAL_REEB_QUADRANGULATION_FACE_GRAPH_SURFACE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/read_parameters.h>

#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <array>
#include <vector>

/// \file
/// Triangle and quad meshes as models of CGAL's `FaceGraph` (`Surface_mesh`, `Polyhedron_3`, ...) with points
/// of any kernel, and as the flat arrays that the stages share.
///
/// Points are converted once, coordinate by coordinate, to the nearest `double` that the number type's
/// `to_double()` gives (of its exact value, if it is evaluated lazily); everything after that is the same for
/// all kernels.

namespace CGAL {
namespace Reeb_quadrangulation {

namespace internal {

template <class FT> double coordinate(const FT& x) {
  return CGAL::to_double(x);
}
// The approximation of a lazy number depends on what was asked of it before; its exact value does not.
template <class ET> double coordinate(const CGAL::Lazy_exact_nt<ET>& x) {
  return CGAL::to_double(x.exact());
}

template <class NamedParameters, class Kernel_point>
Point point_of(const NamedParameters& np, const Kernel_point& p) {
  if constexpr (parameters::has_parameter<CGAL::internal_np::geom_traits_t, NamedParameters>) {
    const auto traits = CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits_t());
    return {coordinate(traits.compute_x_3_object()(p)), coordinate(traits.compute_y_3_object()(p)),
            coordinate(traits.compute_z_3_object()(p))};
  } else {
    return {coordinate(p.x()), coordinate(p.y()), coordinate(p.z())};
  }
}

template <class Kernel_point, class NamedParameters>
Kernel_point kernel_point(const NamedParameters& np, const Point& p) {
  if constexpr (parameters::has_parameter<CGAL::internal_np::geom_traits_t, NamedParameters>) {
    const auto traits = CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits_t());
    return traits.construct_point_3_object()(p.x(), p.y(), p.z());
  } else {
    return Kernel_point(p.x(), p.y(), p.z());
  }
}

} // namespace internal

/// A face graph as a `Triangle_surface`, and which element is which. It is valid as long as the graph exists
/// unchanged.
template <class Graph> struct Face_graph_surface {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  using Vertex_index_map =
      typename boost::property_map<Graph, CGAL::dynamic_vertex_property_t<int>>::const_type;

  Triangle_surface surface;
  std::vector<Vertex> vertices;    ///< the graph's vertex of each vertex of the surface
  std::vector<Face> faces;         ///< and its face of each face: those of `faces(graph)` in order
  std::vector<Halfedge> halfedges; ///< and its halfedge of each halfedge
  Vertex_index_map vertex_index;   ///< the surface's vertex of each of the graph's; -1 where it has no face
};

namespace internal {

// The faces' vertices get the index 0, the others -1. Fails at a face that is no triangle.
template <class Graph> Result<void> mark_triangles(const Graph& graph, Face_graph_surface<Graph>& result) {
  for (const auto v : vertices(graph)) put(result.vertex_index, v, -1);
  for (const auto f : faces(graph)) {
    const auto h = halfedge(f, graph), i = next(h, graph), j = next(i, graph);
    if (next(j, graph) != h)
      return make_error(Error_code::not_a_surface, "a face is not a triangle", Element_kind::face,
                        std::int64_t(result.faces.size()));
    for (const auto g : {h, i, j}) {
      put(result.vertex_index, target(g, graph), 0);
      result.halfedges.push_back(g);
    }
    result.faces.push_back(f);
  }
  return {};
}

template <class Graph, class NamedParameters>
Result<Face_graph_surface<Graph>> triangle_surface(const Graph& graph, const NamedParameters& np) {
  Face_graph_surface<Graph> result;
  result.vertex_index = get(CGAL::dynamic_vertex_property_t<int>(), graph);
  if (Result<void> marked = mark_triangles(graph, result); !marked) return marked.error();
  const auto points = parameters::vertex_points(np, graph);
  for (const auto v : vertices(graph)) {
    if (get(result.vertex_index, v) < 0) continue;
    const int index = int(result.vertices.size());
    result.surface.points.push_back(point_of(np, get(points, v)));
    if (!result.surface.points.back().allFinite())
      return make_error(Error_code::not_a_surface, "a coordinate of a vertex is not finite",
                        Element_kind::vertex, index);
    put(result.vertex_index, v, index);
    result.vertices.push_back(v);
  }
  const auto index = [&](auto h) { return int(get(result.vertex_index, source(h, graph))); };
  for (std::size_t h = 0; h < result.halfedges.size(); h += 3)
    result.surface.triangles.push_back(
        {index(result.halfedges[h]), index(result.halfedges[h + 1]), index(result.halfedges[h + 2])});
  if (Result<void> connected = result.surface.connect(); !connected) return connected.error();
  return result;
}

} // namespace internal

/// Copies a triangle mesh. Vertices and faces keep the graph's order; vertices without a face are left out.
/// Fails with `not_a_surface`, naming the element by its place in that order, if a face is not a triangle, a
/// coordinate is not finite, or `Triangle_surface::connect()` fails. O(V + F). Named parameters:
/// `vertex_point_map`, `geom_traits`.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Face_graph_surface<TriangleMesh>>
to_triangle_surface(const TriangleMesh& tmesh,
                    const NamedParameters& np = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags()));
  return internal::triangle_surface(tmesh, np);
}

/// The vertices and faces that a mesh became in a graph, in its order.
template <class Graph> struct Added_elements {
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<Graph>::face_descriptor> faces;
};

namespace internal {

template <class Polygon, class Graph, class NamedParameters>
Result<Added_elements<Graph>> add_polygons(const std::vector<Point>& points,
                                           const std::vector<Polygon>& polygons, Graph& graph,
                                           const NamedParameters& np) {
  using Traits = boost::graph_traits<Graph>;
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (int v : polygons[f])
      if (v < 0 || v >= int(points.size()))
        return make_error(Error_code::not_a_surface, "a face has a vertex that does not exist",
                          Element_kind::face, std::int64_t(f));
  if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(polygons))
    return make_error(Error_code::not_a_surface, "the faces are not an oriented manifold");
  const auto point_map = parameters::vertex_points(np, graph);
  using Kernel_point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  Added_elements<Graph> result;
  for (const Point& p : points) {
    result.vertices.push_back(add_vertex(graph));
    put(point_map, result.vertices.back(), kernel_point<Kernel_point>(np, p));
  }
  for (const Polygon& polygon : polygons) {
    std::array<typename Traits::vertex_descriptor, std::tuple_size<Polygon>::value> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = result.vertices[std::size_t(polygon[i])];
    result.faces.push_back(CGAL::Euler::add_face(corners, graph));
    CGAL_postcondition(result.faces.back() != Traits::null_face());
  }
  return result;
}

} // namespace internal

/// Adds a quad mesh to a face graph; returns its new elements in the order of the mesh. Fails with
/// `not_a_surface`, and leaves the graph as it was, if the quads are not an oriented manifold, or an index is
/// out of range. O(Q log Q). Named parameters: `vertex_point_map`, writable, of `graph`; `geom_traits`.
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Added_elements<Graph>> to_face_graph(const Quad_mesh& quads, Graph& graph,
                                            const NamedParameters& np = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags()));
  return internal::add_polygons(quads.points, quads.quads, graph, np);
}

/// The same with a triangle surface; `points` and `triangles` are read.
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Added_elements<Graph>> to_face_graph(const Triangle_surface& surface, Graph& graph,
                                            const NamedParameters& np = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags()));
  return internal::add_polygons(surface.points, surface.triangles, graph, np);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FACE_GRAPH_SURFACE_H
