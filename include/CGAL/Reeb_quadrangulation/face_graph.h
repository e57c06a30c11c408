// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FACE_GRAPH_H
#define CGAL_REEB_QUADRANGULATION_FACE_GRAPH_H

#include <CGAL/Reeb_quadrangulation/Quad_texture_traits.h>
#include <CGAL/Reeb_quadrangulation/Reeb_chart_traits.h>
#include <CGAL/Reeb_quadrangulation/parameters.h>

#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <array>
#include <map>
#include <vector>

/// \file
/// The package for models of CGAL's `FaceGraph` (`Surface_mesh`, `Polyhedron_3`, ...) with points of any kernel.
///
/// Points are converted once, coordinate by coordinate, to the nearest `double` that the number type's `to_double()` gives (of its exact
/// value, if it is evaluated lazily); everything after that is the same for all kernels. Named parameters: see parameters.h.

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

template <class NamedParameters, class Graph>
std::vector<Placed_extremum> placed_extrema(const Graph& tmesh, const NamedParameters& np) {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  const auto points =
      parameters::parameter_or<CGAL::internal_np::vertex_point_t>(np, get(CGAL::vertex_point, tmesh));
  const std::vector<Vertex> none;
  std::vector<Placed_extremum> extrema;
  for (const bool is_maximum : {false, true})
    for (const Vertex v : is_maximum ? parameters::parameter_or<parameters::maxima_t>(np, none)
                                     : parameters::parameter_or<parameters::minima_t>(np, none)) {
      const auto& p = get(points, v);
      extrema.push_back({Point(coordinate(p.x()), coordinate(p.y()), coordinate(p.z())), is_maximum});
    }
  return extrema;
}

// The options that named parameters ask for.
template <class NamedParameters, class Graph>
Quadrangulation_options options(const Graph& tmesh, const NamedParameters& np) {
  using namespace parameters;
  Quadrangulation_options o = parameter_or<options_t>(np, Quadrangulation_options());
  if (has_parameter<number_of_quads_t, NamedParameters>) o.edge_length = 0;
  o.quads = parameter_or<number_of_quads_t>(np, o.quads);
  o.edge_length = parameter_or<edge_length_t>(np, o.edge_length);
  o.threads = parameter_or<number_of_threads_t>(np, o.threads);
  if (has_parameter<minima_t, NamedParameters> || has_parameter<maxima_t, NamedParameters>)
    o.extrema = placed_extrema(tmesh, np);
  if constexpr (has_parameter<chart_traits_t, NamedParameters>)
    o.chart_weights = [traits = CGAL::parameters::get_parameter(np, chart_traits_t())](const Chart& chart) {
      return Reeb_quadrangulation::chart_weights(chart, traits);
    };
  if constexpr (has_parameter<texture_traits_t, NamedParameters>)
    o.textures = texture_maker(CGAL::parameters::get_parameter(np, texture_traits_t()));
  return o;
}

template <class NamedParameters> Observer* observer(const NamedParameters& np) {
  return parameters::parameter_or<parameters::observer_t>(np, static_cast<Observer*>(nullptr));
}

// The extrema and the field that named parameters ask for.
template <class NamedParameters, class Graph>
Result<Designed_field> designed_field(const Graph& tmesh, const Triangle_surface& surface,
                                      const NamedParameters& np) {
  const Quadrangulation_options asked = options(tmesh, np);
  Result<Designed_field> field = choose_extrema(surface, asked, observer(np));
  if (!field) return field;
  if (Result<void> solved = solve_field(surface, asked, *field); !solved) return solved.error();
  return field;
}

// For each face of the surface the chart with the largest part of it.
inline std::vector<int> largest_charts(const Reeb_layout& layout, const Triangle_surface& surface) {
  std::vector<int> best(surface.number_of_faces(), -1);
  std::vector<std::map<int, double>> areas(surface.number_of_faces());
  const Embedding& embedding = layout.embedding;
  for (int f = 0; f < embedding.surface.number_of_faces(); ++f) {
    const Triangle& t = embedding.surface.triangles[f];
    const std::vector<Point>& p = embedding.surface.points;
    areas[embedding.base_face[f]][layout.atlas.chart_of_face[f]] +=
        (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
  }
  for (std::size_t f = 0; f < best.size(); ++f) {
    double largest = -1;
    for (const auto& [chart, area] : areas[f])
      if (area > largest) {
        largest = area;
        best[f] = chart;
      }
  }
  return best;
}

} // namespace internal

/// A face graph as a `Triangle_surface`, and which element is which. It is valid as long as the graph exists unchanged.
template <class Graph> struct Face_graph_surface {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  using Vertex_index_map =
      typename boost::property_map<Graph, CGAL::dynamic_vertex_property_t<int>>::const_type;

  Triangle_surface surface;
  std::vector<Vertex> vertices;  ///< the graph's vertex of each vertex of the surface
  std::vector<Face> faces;       ///< and its face of each face: those of `faces(graph)` in order
  Vertex_index_map vertex_index; ///< the surface's vertex of each of the graph's; -1 where it has no face
};

/// Copies a triangle mesh. Vertices and faces keep the graph's order; vertices without a face are left out.
/// Fails with `not_a_surface`, naming the element by its place in that order, if a face is not a triangle, a coordinate is not finite, or
/// `Triangle_surface::connect()` fails. O(V + F). Named parameter: `vertex_point_map`.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Face_graph_surface<TriangleMesh>>
to_triangle_surface(const TriangleMesh& tmesh,
                    const NamedParameters& np = CGAL::parameters::default_values()) {
  Face_graph_surface<TriangleMesh> result;
  const auto points =
      parameters::parameter_or<CGAL::internal_np::vertex_point_t>(np, get(CGAL::vertex_point, tmesh));
  result.vertex_index = get(CGAL::dynamic_vertex_property_t<int>(), tmesh);
  for (const auto v : vertices(tmesh)) put(result.vertex_index, v, -1);
  for (const auto f : faces(tmesh)) {
    const auto h = halfedge(f, tmesh);
    if (next(next(next(h, tmesh), tmesh), tmesh) != h)
      return make_error(Error_code::not_a_surface, "a face is not a triangle", Element_kind::face,
                        std::int64_t(result.faces.size()));
    for (const auto g : {h, next(h, tmesh), next(next(h, tmesh), tmesh)})
      put(result.vertex_index, target(g, tmesh), 0);
    result.faces.push_back(f);
  }
  for (const auto v : vertices(tmesh)) {
    if (get(result.vertex_index, v) < 0) continue;
    const int index = int(result.vertices.size());
    const auto& p = get(points, v);
    result.surface.points.emplace_back(internal::coordinate(p.x()), internal::coordinate(p.y()),
                                       internal::coordinate(p.z()));
    if (!result.surface.points.back().allFinite())
      return make_error(Error_code::not_a_surface, "a coordinate of a vertex is not finite",
                        Element_kind::vertex, index);
    put(result.vertex_index, v, index);
    result.vertices.push_back(v);
  }
  for (const auto f : result.faces) {
    const auto h = halfedge(f, tmesh);
    const auto index = [&](auto g) { return int(get(result.vertex_index, source(g, tmesh))); };
    result.surface.triangles.push_back({index(h), index(next(h, tmesh)), index(next(next(h, tmesh), tmesh))});
  }
  if (Result<void> connected = result.surface.connect(); !connected) return connected.error();
  return result;
}

/// Adds a quad mesh to a face graph; returns its new faces in the order of the quads. Fails with `not_a_surface`, and leaves the graph as it
/// was, if the quads are not an oriented manifold, or an index is out of range. O(Q log Q).
/// Named parameter: `vertex_point_map`, writable, of `graph`.
template <class QuadMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<std::vector<typename boost::graph_traits<QuadMesh>::face_descriptor>>
to_face_graph(const Quad_mesh& quads, QuadMesh& graph,
              const NamedParameters& np = CGAL::parameters::default_values()) {
  using Traits = boost::graph_traits<QuadMesh>;
  for (std::size_t q = 0; q < quads.quads.size(); ++q)
    for (int v : quads.quads[q])
      if (v < 0 || v >= int(quads.points.size()))
        return make_error(Error_code::not_a_surface, "a quad has a vertex that does not exist",
                          Element_kind::face, std::int64_t(q));
  if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(quads.quads))
    return make_error(Error_code::not_a_surface, "the quads are not an oriented manifold");
  const auto points =
      parameters::parameter_or<CGAL::internal_np::vertex_point_t>(np, get(CGAL::vertex_point, graph));
  using Kernel_point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  std::vector<typename Traits::vertex_descriptor> vertex;
  for (const Point& p : quads.points) {
    vertex.push_back(add_vertex(graph));
    put(points, vertex.back(), Kernel_point(p.x(), p.y(), p.z()));
  }
  std::vector<typename Traits::face_descriptor> result;
  for (const Quad& q : quads.quads) {
    const std::array<typename Traits::vertex_descriptor, 4> corners = {vertex[q[0]], vertex[q[1]],
                                                                       vertex[q[2]], vertex[q[3]]};
    result.push_back(CGAL::Euler::add_face(corners, graph));
    CGAL_postcondition(result.back() != Traits::null_face());
  }
  return result;
}

/// Turns a connected triangle mesh, closed or with boundary loops, into a quad mesh, which is added to `quads`; the result has the same mesh
/// as flat arrays, and how it came about. \sa `quadrangulate(const Triangle_surface&, ...)` for the errors; those of
/// `to_triangle_surface()` come first. On failure `quads` is as it was.
///
/// Named parameters: `vertex_point_map` (of `tmesh`), `number_of_quads`, `edge_length`, `minima`, `maxima`, `number_of_threads`,
/// `observer`, `chart_traits`, `texture_traits`, `quad_chart_map` (of `quads`), `options`.
template <class TriangleMesh, class QuadMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_same<TriangleMesh, Triangle_surface>::value>>
Result<Quadrangulation> quadrangulate(const TriangleMesh& tmesh, QuadMesh& quads,
                                      const NamedParameters& np = CGAL::parameters::default_values()) {
  auto converted = to_triangle_surface(tmesh, np);
  if (!converted) return converted.error();
  Result<Quadrangulation> result =
      quadrangulate(converted->surface, internal::options(tmesh, np), internal::observer(np));
  if (!result) return result;
  const auto faces = to_face_graph(result->mesh, quads);
  if (!faces) return faces.error();
  if constexpr (parameters::has_parameter<parameters::quad_chart_map_t, NamedParameters>) {
    const auto chart_map = CGAL::parameters::get_parameter(np, parameters::quad_chart_map_t());
    for (std::size_t q = 0; q < faces->size(); ++q) put(chart_map, (*faces)[q], result->chart_of_quad[q]);
  }
  return result;
}

/// The first stages alone, on the mesh as it is: chooses extrema and writes the harmonic field between them, from 0 to 1, to `field`, a
/// writable property map of the vertices (vertices without a face are not written). Named parameters: `vertex_point_map`, `minima`,
/// `maxima`, `observer`, `options`.
template <class TriangleMesh, class VertexFieldMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Designed_field> reeb_field(const TriangleMesh& tmesh, VertexFieldMap field,
                                  const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto converted = to_triangle_surface(tmesh, np);
  if (!converted) return converted.error();
  Result<Designed_field> result = internal::designed_field(tmesh, converted->surface, np);
  if (!result) return result;
  using Value = typename boost::property_traits<VertexFieldMap>::value_type;
  for (std::size_t v = 0; v < result->values.size(); ++v)
    put(field, converted->vertices[v], Value(result->values[v]));
  return result;
}

/// The Reeb atlas of `reeb_field()`: writes to `chart`, a writable property map of the faces, the chart (an index into
/// `Reeb_layout::atlas`, an arc of `Reeb_layout::graph`) that has the largest part of each face, the first of equal ones.
/// The layout's vertices and base faces are those of `to_triangle_surface()`. Named parameters as for `reeb_field()`.
template <class TriangleMesh, class FaceChartMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Reeb_layout> reeb_charts(const TriangleMesh& tmesh, FaceChartMap chart,
                                const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto converted = to_triangle_surface(tmesh, np);
  if (!converted) return converted.error();
  const Result<Designed_field> field = internal::designed_field(tmesh, converted->surface, np);
  if (!field) return field.error();
  Result<Reeb_layout> layout = make_layout(converted->surface, *field);
  if (!layout) return layout;
  const std::vector<int> largest = internal::largest_charts(*layout, converted->surface);
  for (std::size_t f = 0; f < largest.size(); ++f) put(chart, converted->faces[f], largest[f]);
  return layout;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FACE_GRAPH_H
