// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FINISH_FACE_GRAPH_H
#define CGAL_REEB_QUADRANGULATION_FINISH_FACE_GRAPH_H

#include <CGAL/Reeb_quadrangulation/constrained_features.h>
#include <CGAL/Reeb_quadrangulation/finish_on_features.h>
#include <CGAL/Reeb_quadrangulation/quad_face_graph.h>

#include <type_traits>
#include <vector>

/// \file
/// The last stages alone, on quads of any origin: relaxing them on the surface of a triangle mesh, and laying
/// them onto its features.

namespace CGAL {
namespace Reeb_quadrangulation {

namespace internal {

// The vertices that named parameters hold.
template <class Graph, class NamedParameters>
std::vector<int> held_vertices(const Face_graph_quads<Graph>& quads, const NamedParameters& np) {
  std::vector<int> held;
  if constexpr (parameters::has_parameter<CGAL::internal_np::vertex_is_constrained_t, NamedParameters>) {
    const auto map = CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_is_constrained_t());
    for (std::size_t v = 0; v < quads.vertices.size(); ++v)
      if (get(map, quads.vertices[v])) held.push_back(int(v));
  }
  return held;
}

template <class NamedParameters> Relax_options relax_options(const NamedParameters& np) {
  Relax_options options = parameters::parameter_or<parameters::options_t>(np, Relax_options());
  options.threads = parameters::parameter_or<parameters::number_of_threads_t>(np, options.threads);
  return options;
}

using Relax_tags = parameters::Tag_list<parameters::options_t, parameters::number_of_threads_t,
                                        parameters::observer_t, CGAL::internal_np::vertex_is_constrained_t>;

} // namespace internal

/// Moves the vertices of a quad mesh over the surface of a triangle mesh so that the quads come closer to
/// rectangles. \sa `relax_quads(Quad_mesh&, ...)` for what is done and for the errors; those of
/// `to_quad_mesh()` and `to_triangle_surface()` come first. On failure nothing has moved. Named parameters:
/// of the quads `vertex_point_map` (writable), `geom_traits`, `vertex_is_constrained_map` (vertices that
/// stay), `options` (`Relax_options`), `number_of_threads`, `observer`; of the triangles `vertex_point_map`,
/// `geom_traits`.
template <class QuadMesh, class TriangleMesh,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_same<QuadMesh, Quad_mesh>::value>>
Result<Relax_report> relax_quads(QuadMesh& quads, const TriangleMesh& tmesh,
                                 const NamedParameters1& np1 = CGAL::parameters::default_values(),
                                 const NamedParameters2& np2 = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters1>(parameters::Point_tags() + internal::Relax_tags()));
  static_assert(parameters::reads_all<NamedParameters2>(parameters::Point_tags()));
  const auto before = internal::quad_mesh(quads, np1);
  if (!before) return before.error();
  const auto input = internal::triangle_surface(tmesh, np2);
  if (!input) return input.error();
  if (input->faces.empty()) return make_error(Error_code::not_a_surface, "the triangle mesh has no face");
  std::vector<char> fixed(before->vertices.size(), 0);
  for (int v : internal::held_vertices(*before, np1)) fixed[std::size_t(v)] = 1;
  Quad_mesh mesh = before->mesh;
  const Surface_projector projector(input->surface);
  Result<Relax_report> report = relax_quads(mesh, projector, Vertex_constraints(fixed),
                                            internal::relax_options(np1), parameters::observer_of(np1));
  if (report) internal::put_points(mesh, *before, quads, np1);
  return report;
}

/// Relaxes a quad mesh and lays it onto features: the user's, if the triangles' parameters give some, else
/// its sharp edges. \sa finish_on_features.h, `constrained_features()`. A quad may come to begin at another
/// of its vertices: the report's mesh says so, the graph keeps its faces. Named parameters: of the quads as
/// for `relax_quads()`; of the triangles `vertex_point_map`, `geom_traits`, `edge_is_constrained_map`,
/// `vertex_is_constrained_map`, `face_patch_map`, `options` (`Snap_options`).
template <class QuadMesh, class TriangleMesh,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_same<QuadMesh, Quad_mesh>::value>>
Result<Finished_quads> finish_quads(QuadMesh& quads, const TriangleMesh& tmesh,
                                    const NamedParameters1& np1 = CGAL::parameters::default_values(),
                                    const NamedParameters2& np2 = CGAL::parameters::default_values()) {
  using Snap_tags = parameters::Tag_list<parameters::options_t>;
  static_assert(parameters::reads_all<NamedParameters1>(parameters::Point_tags() + internal::Relax_tags()));
  static_assert(parameters::reads_all<NamedParameters2>(parameters::Point_tags() +
                                                        parameters::Feature_tags() + Snap_tags()));
  const auto before = internal::quad_mesh(quads, np1);
  if (!before) return before.error();
  const auto input = internal::triangle_surface(tmesh, np2);
  if (!input) return input.error();
  if (input->faces.empty()) return make_error(Error_code::not_a_surface, "the triangle mesh has no face");
  Snap_options snapping = parameters::parameter_or<parameters::options_t>(np2, Snap_options());
  const Relax_options relaxation = internal::relax_options(np1);
  const std::vector<int> held = internal::held_vertices(*before, np1);
  const Surface_projector projector(input->surface);
  const auto finish = [&] {
    if constexpr (internal::has_features<NamedParameters2>) {
      constexpr double corner_angle = 50; // as for sharp edges
      snapping.lines = true;
      return finish_quads(before->mesh, projector, internal::features_of(tmesh, *input, corner_angle, np2),
                          relaxation, snapping, parameters::observer_of(np1), held);
    } else {
      return finish_quads(before->mesh, projector, relaxation, snapping, parameters::observer_of(np1), held);
    }
  };
  Result<Finished_quads> finished = finish();
  if (finished) internal::put_points(finished->mesh, *before, quads, np1);
  return finished;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FINISH_FACE_GRAPH_H
