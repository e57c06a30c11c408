// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FACE_GRAPH_OPTIONS_H
#define CGAL_REEB_QUADRANGULATION_FACE_GRAPH_OPTIONS_H

#include <CGAL/Reeb_quadrangulation/Quad_texture_traits.h>
#include <CGAL/Reeb_quadrangulation/Reeb_chart_traits.h>
#include <CGAL/Reeb_quadrangulation/constrained_features.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <vector>

/// \file
/// What the named parameters of the functions on face graphs mean as options of the library.

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

// The tags of the parameters that choose a field.
using Field_tags = parameters::Tag_list<parameters::minima_t, parameters::maxima_t, parameters::observer_t,
                                        parameters::options_t>;

template <class NamedParameters, class Graph>
Result<std::vector<Placed_extremum>> placed_extrema(const Face_graph_surface<Graph>& mesh,
                                                    const NamedParameters& np, bool is_part) {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  const std::vector<Vertex> none;
  std::vector<Placed_extremum> extrema;
  const auto place = [&](const auto& list, bool is_maximum) -> Result<void> {
    for (const Vertex v : list) {
      const int index = get(mesh.vertex_index, v);
      if (index < 0 && is_part) continue;
      if (index < 0)
        return make_error(Error_code::impossible_request, "an extremum is a vertex without a face",
                          Element_kind::vertex, std::int64_t(extrema.size()));
      extrema.push_back({mesh.surface.points[std::size_t(index)], is_maximum});
    }
    return {};
  };
  Result<void> placed = place(parameters::parameter_or<parameters::minima_t>(np, none), false);
  if (placed) placed = place(parameters::parameter_or<parameters::maxima_t>(np, none), true);
  if (!placed) return placed.error();
  return extrema;
}

// The options that named parameters ask for. Of a part of a mesh, for which extrema elsewhere are not meant.
template <class NamedParameters, class Graph>
Result<Quadrangulation_options> options(const Graph& tmesh, const Face_graph_surface<Graph>& mesh,
                                        const NamedParameters& np, bool is_part = false) {
  using namespace parameters;
  Quadrangulation_options o = parameter_or<options_t>(np, Quadrangulation_options());
  if (has_parameter<number_of_quads_t, NamedParameters>) o.edge_length = 0;
  o.quads = parameter_or<number_of_quads_t>(np, o.quads);
  o.edge_length = parameter_or<edge_length_t>(np, o.edge_length);
  o.threads = parameter_or<number_of_threads_t>(np, o.threads);
  o.solver = parameter_or<CGAL::internal_np::sparse_linear_solver_t>(np, o.solver);
  o.constraints = parameter_or<constraint_method_t>(np, o.constraints);
  if constexpr (has_parameter<edge_length_t, NamedParameters>)
    if (!(o.edge_length > 0)) return make_error(Error_code::impossible_request, "an edge length is positive");
  if (has_parameter<minima_t, NamedParameters> || has_parameter<maxima_t, NamedParameters>) {
    Result<std::vector<Placed_extremum>> extrema = placed_extrema(mesh, np, is_part);
    if (!extrema) return extrema.error();
    o.extrema = std::move(*extrema);
  }
  if constexpr (has_parameter<vertex_field_map_t, NamedParameters>) {
    static_assert(!has_parameter<minima_t, NamedParameters> && !has_parameter<maxima_t, NamedParameters>,
                  "a function has its own extrema: give vertex_field_map, or minima and maxima");
    const auto field = CGAL::parameters::get_parameter(np, vertex_field_map_t());
    o.field.clear();
    for (const auto v : mesh.vertices) o.field.push_back(coordinate(get(field, v)));
  }
  if constexpr (has_parameter<chart_traits_t, NamedParameters>)
    o.chart_weights = [traits = CGAL::parameters::get_parameter(np, chart_traits_t())](const Chart& chart) {
      return Reeb_quadrangulation::chart_weights(chart, traits);
    };
  if constexpr (has_parameter<texture_traits_t, NamedParameters>)
    o.textures = texture_maker(CGAL::parameters::get_parameter(np, texture_traits_t()));
  constexpr double corner_angle = 50; // as for sharp edges
  if constexpr (has_features<NamedParameters>) {
    o.given_features = features_of(tmesh, mesh, corner_angle, np);
    o.features.lines = true;
  }
  (void)tmesh;
  return o;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FACE_GRAPH_OPTIONS_H
