// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CREATE_EDITOR_H
#define CGAL_REEB_QUADRANGULATION_CREATE_EDITOR_H

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/Quad_texture_traits.h>
#include <CGAL/Reeb_quadrangulation/Reeb_chart_traits.h>
#include <CGAL/Reeb_quadrangulation/Surface_point.h>
#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Begins an editing session on a triangle mesh, which is copied; \sa `Editor::create()` for the errors;
/// those of `to_triangle_surface()` come first. Points of edits are points of the mesh, see
/// `surface_point()`; the quads go into a graph by `to_face_graph(editor.quads().mesh, graph)`. Named
/// parameters: `vertex_point_map`, `geom_traits`, `number_of_quads`, `edge_length`, `chart_traits`,
/// `texture_traits`, `sparse_linear_solver`, `constraint_method`, `number_of_threads`, `observer`, `options`
/// (`Editor_options`).
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Editor> create_editor(const TriangleMesh& tmesh,
                             const NamedParameters& np = CGAL::parameters::default_values()) {
  using namespace parameters;
  using Tags =
      Tag_list<number_of_quads_t, edge_length_t, chart_traits_t, texture_traits_t, number_of_threads_t,
               observer_t, options_t, constraint_method_t, CGAL::internal_np::sparse_linear_solver_t>;
  static_assert(reads_all<NamedParameters>(Point_tags() + Tags()));
  auto mesh = Reeb_quadrangulation::internal::triangle_surface(tmesh, np);
  if (!mesh) return mesh.error();
  Editor_options options = parameter_or<options_t>(np, Editor_options());
  if (has_parameter<number_of_quads_t, NamedParameters>) options.edge_length = 0;
  options.quads = parameter_or<number_of_quads_t>(np, options.quads);
  options.edge_length = parameter_or<edge_length_t>(np, options.edge_length);
  options.threads = parameter_or<number_of_threads_t>(np, options.threads);
  options.solver = parameter_or<CGAL::internal_np::sparse_linear_solver_t>(np, options.solver);
  options.constraints = parameter_or<constraint_method_t>(np, options.constraints);
  if constexpr (has_parameter<edge_length_t, NamedParameters>)
    if (!(options.edge_length > 0))
      return make_error(Error_code::impossible_request, "an edge length is positive");
  if constexpr (has_parameter<chart_traits_t, NamedParameters>)
    options.chart_weights = [traits = CGAL::parameters::get_parameter(np, chart_traits_t())](
                                const Chart& chart) { return chart_weights(chart, traits); };
  if constexpr (has_parameter<texture_traits_t, NamedParameters>)
    options.textures = texture_maker(CGAL::parameters::get_parameter(np, texture_traits_t()));
  return Editor::create(std::move(mesh->surface), options, observer_of(np));
}

/// A vertex of a mesh as the point that edits of a session on it take. Named parameters: `vertex_point_map`,
/// `geom_traits`.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Surface_point surface_point(const TriangleMesh& tmesh,
                            typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                            const NamedParameters& np = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags()));
  return {internal::point_of(np, get(parameters::vertex_points(np, tmesh), v)), -1};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CREATE_EDITOR_H
