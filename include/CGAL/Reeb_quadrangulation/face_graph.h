// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FACE_GRAPH_H
#define CGAL_REEB_QUADRANGULATION_FACE_GRAPH_H

#include <CGAL/Reeb_quadrangulation/certify_quads.h>
#include <CGAL/Reeb_quadrangulation/combine_parameters.h>
#include <CGAL/Reeb_quadrangulation/constrained_features.h>
#include <CGAL/Reeb_quadrangulation/face_graph_options.h>
#include <CGAL/Reeb_quadrangulation/finish_face_graph.h>
#include <CGAL/Reeb_quadrangulation/plane_curves.h>
#include <CGAL/Reeb_quadrangulation/quad_parameters.h>
#include <CGAL/Reeb_quadrangulation/reeb_charts.h>
#include <CGAL/Reeb_quadrangulation/reeb_graph.h>
#include <CGAL/Reeb_quadrangulation/sized_quads.h>
#include <CGAL/Reeb_quadrangulation/transfer_attribute.h>

#include <cmath>
#include <type_traits>

/// \file
/// The package for models of CGAL's `FaceGraph` (`Surface_mesh`, `Polyhedron_3`, ...) with points of any
/// kernel: `quadrangulate()`, and all other functions on face graphs. Named parameters: see parameters.h.

namespace CGAL {
namespace Reeb_quadrangulation {

namespace internal {

using Quadrangulate_tags = parameters::Tag_list<
    parameters::number_of_quads_t, parameters::edge_length_t, parameters::vertex_field_map_t,
    parameters::number_of_threads_t, parameters::chart_traits_t, parameters::texture_traits_t,
    parameters::sizing_field_t, parameters::constraint_method_t, CGAL::internal_np::sparse_linear_solver_t,
    parameters::quad_chart_map_t, parameters::vertex_location_map_t, parameters::halfedge_uv_map_t>;

// The parameters of corners, if there is a map for them.
template <class NamedParameters>
Result<std::vector<Quad_parameters>> wanted_parameters(const Quadrangulation& result,
                                                       const NamedParameters&) {
  if constexpr (parameters::has_parameter<parameters::halfedge_uv_map_t, NamedParameters>)
    return quad_parameters(result);
  else
    return std::vector<Quad_parameters>();
}

template <class Graph, class HalfedgeUvMap>
void put_parameters(const Graph& graph, const Quad_mesh& mesh, const Added_elements<Graph>& added,
                    const std::vector<Quad_parameters>& corners, const HalfedgeUvMap& map) {
  using Value = typename boost::property_traits<HalfedgeUvMap>::value_type;
  for (std::size_t q = 0; q < added.faces.size(); ++q)
    for (const auto h : CGAL::halfedges_around_face(halfedge(added.faces[q], graph), graph))
      for (std::size_t i = 0; i < 4; ++i)
        if (added.vertices[std::size_t(mesh.quads[q][i])] == target(h, graph))
          put(map, h, Value(corners[q][i].x(), corners[q][i].y()));
}

// Writes the property maps that named parameters ask for.
template <class TriangleMesh, class QuadMesh, class NamedParameters>
void put_results(const Face_graph_surface<TriangleMesh>& mesh, const Quadrangulation& result,
                 const QuadMesh& quads, const Added_elements<QuadMesh>& added,
                 const std::vector<Quad_parameters>& corners, const NamedParameters& np) {
  if constexpr (parameters::has_parameter<parameters::halfedge_uv_map_t, NamedParameters>)
    put_parameters(quads, result.mesh, added, corners,
                   CGAL::parameters::get_parameter(np, parameters::halfedge_uv_map_t()));
  if constexpr (parameters::has_parameter<parameters::quad_chart_map_t, NamedParameters>) {
    const auto map = CGAL::parameters::get_parameter(np, parameters::quad_chart_map_t());
    for (std::size_t q = 0; q < added.faces.size(); ++q) put(map, added.faces[q], result.chart_of_quad[q]);
  }
  if constexpr (parameters::has_parameter<parameters::vertex_location_map_t, NamedParameters>) {
    const auto map = CGAL::parameters::get_parameter(np, parameters::vertex_location_map_t());
    const Surface_projector projector(mesh.surface);
    for (std::size_t v = 0; v < added.vertices.size(); ++v)
      put(map, added.vertices[v], location(mesh, projector, result.mesh.points[v]));
  }
}

// The sizes of a map of the vertices, interpolated.
template <class Graph, class VertexLengthMap>
Result<Size_function> size_function(const Graph& tmesh, const Face_graph_surface<Graph>& mesh,
                                    const VertexLengthMap& lengths, const Surface_projector& projector) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double length = coordinate(get(lengths, mesh.vertices[v]));
    if (!(length > 0) || !std::isfinite(length))
      return make_error(Error_code::impossible_request, "a size is not a positive number",
                        Element_kind::vertex, std::int64_t(v));
  }
  return Size_function([&tmesh, &mesh, &projector, lengths](const Point& p) {
    using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
    return coordinate(attribute_at<Vertex>(tmesh, lengths, location(mesh, projector, p)));
  });
}

template <class Graph, class NamedParameters>
Result<Quadrangulation> quads_of(const Graph& tmesh, const Face_graph_surface<Graph>& mesh,
                                 const Quadrangulation_options& options, const NamedParameters& np) {
  Observer* observer = parameters::observer_of(np);
  if constexpr (parameters::has_parameter<parameters::sizing_field_t, NamedParameters>) {
    static_assert(!parameters::has_parameter<parameters::edge_length_t, NamedParameters> &&
                      !parameters::has_parameter<parameters::number_of_quads_t, NamedParameters>,
                  "sizing_field, edge_length and number_of_quads say the same: give one of them");
    if (mesh.faces.empty()) return make_error(Error_code::not_a_surface, "the triangle mesh has no face");
    const Surface_projector projector(mesh.surface);
    const Result<Size_function> size = size_function(
        tmesh, mesh, CGAL::parameters::get_parameter(np, parameters::sizing_field_t()), projector);
    if (!size) return size.error();
    return quadrangulate(mesh.surface, *size, options, observer);
  } else {
    return quadrangulate(mesh.surface, options, observer);
  }
}

template <class NamedParameters1, class NamedParameters2> constexpr bool reads_all_of_quadrangulate() {
  return parameters::reads_all<NamedParameters1>(parameters::Point_tags() + parameters::Feature_tags() +
                                                 Field_tags() + Quadrangulate_tags()) &&
         parameters::reads_all<NamedParameters2>(parameters::Point_tags());
}

} // namespace internal

/// Turns a connected triangle mesh, closed or with boundary loops, into a quad mesh, which is added to
/// `quads`; the result has the same mesh as flat arrays, and how it came about. \sa `quadrangulate(const
/// Triangle_surface&, ...)` for the errors; those of `to_triangle_surface()` come first. On failure `quads`
/// is as it was.
///
/// Named parameters: `vertex_point_map` and `geom_traits` of `tmesh`; `number_of_quads`, `edge_length`, or
/// `sizing_field` (see sized_quads.h); `minima`, `maxima`, or `vertex_field_map`; `chart_traits`,
/// `texture_traits`, `sparse_linear_solver`, `constraint_method`, `edge_is_constrained_map`,
/// `vertex_is_constrained_map`, `face_patch_map`, `number_of_threads`, `observer`, `options`
/// (`Quadrangulation_options`); written are `quad_chart_map`, `halfedge_uv_map` and `vertex_location_map` of
/// `quads`. In a second chain: `vertex_point_map` and `geom_traits` of `quads`.
template <class TriangleMesh, class QuadMesh,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_same<TriangleMesh, Triangle_surface>::value>>
Result<Quadrangulation> quadrangulate(const TriangleMesh& tmesh, QuadMesh& quads,
                                      const NamedParameters1& np1 = CGAL::parameters::default_values(),
                                      const NamedParameters2& np2 = CGAL::parameters::default_values()) {
  static_assert(internal::reads_all_of_quadrangulate<NamedParameters1, NamedParameters2>());
  const auto mesh = internal::triangle_surface(tmesh, np1);
  if (!mesh) return mesh.error();
  const Result<Quadrangulation_options> options = internal::options(tmesh, *mesh, np1);
  if (!options) return options.error();
  Result<Quadrangulation> result = internal::quads_of(tmesh, *mesh, *options, np1);
  if (!result) return result;
  const auto corners = internal::wanted_parameters(*result, np1);
  if (!corners) return corners.error();
  const auto added = to_face_graph(result->mesh, quads, np2);
  if (!added) return added.error();
  internal::put_results(*mesh, *result, quads, *added, *corners, np1);
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FACE_GRAPH_H
