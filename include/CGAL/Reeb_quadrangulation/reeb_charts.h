// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_REEB_CHARTS_H
#define CGAL_REEB_QUADRANGULATION_REEB_CHARTS_H

#include <CGAL/Reeb_quadrangulation/face_graph_options.h>

#include <map>
#include <vector>

/// \file
/// The first stages alone, on a triangle mesh as it is: the field, and the charts between its critical
/// contours.

namespace CGAL {
namespace Reeb_quadrangulation {

namespace internal {

// The extrema and the field that named parameters ask for.
template <class NamedParameters, class Graph>
Result<Designed_field> designed_field(const Graph& tmesh, const Face_graph_surface<Graph>& mesh,
                                      const NamedParameters& np) {
  const Result<Quadrangulation_options> asked = options(tmesh, mesh, np);
  if (!asked) return asked.error();
  if (!asked->field.empty()) return design_function(mesh.surface, asked->field, asked->field_persistence);
  Result<Designed_field> field = choose_extrema(mesh.surface, *asked, parameters::observer_of(np));
  if (!field) return field;
  if (Result<void> solved = solve_field(mesh.surface, *asked, *field); !solved) return solved.error();
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

/// Chooses extrema and writes the harmonic field between them, from 0 to 1, to `field`, a writable property
/// map of the vertices (vertices without a face are not written). Errors: those of `to_triangle_surface()`
/// and of `quadrangulate()`. Named parameters: `vertex_point_map`, `geom_traits`, `minima`, `maxima`,
/// `observer`, `options` (`Quadrangulation_options`).
template <class TriangleMesh, class VertexFieldMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Designed_field> reeb_field(const TriangleMesh& tmesh, VertexFieldMap field,
                                  const NamedParameters& np = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags() + internal::Field_tags()));
  const auto mesh = internal::triangle_surface(tmesh, np);
  if (!mesh) return mesh.error();
  Result<Designed_field> result = internal::designed_field(tmesh, *mesh, np);
  if (!result) return result;
  using Value = typename boost::property_traits<VertexFieldMap>::value_type;
  for (std::size_t v = 0; v < result->values.size(); ++v)
    put(field, mesh->vertices[v], Value(result->values[v]));
  return result;
}

/// The Reeb atlas of `reeb_field()`: writes to `chart`, a writable property map of the faces, the chart (an
/// index into `Reeb_layout::atlas`, an arc of `Reeb_layout::graph`) that has the largest part of each face,
/// the first of equal ones. The layout's vertices and base faces are those of `to_triangle_surface()`. Named
/// parameters as for `reeb_field()`, and `vertex_field_map`: a function of the user's own, as
/// `design_function()` takes it, whose atlas is then meant. Charts have no places where contours end: for a
/// function that is not constant on the boundary, `reeb_graph()` has the arc of each face (`face_arc_map`).
template <class TriangleMesh, class FaceChartMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<Reeb_layout> reeb_charts(const TriangleMesh& tmesh, FaceChartMap chart,
                                const NamedParameters& np = CGAL::parameters::default_values()) {
  using Own_function = parameters::Tag_list<parameters::vertex_field_map_t>;
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags() + internal::Field_tags() +
                                                       Own_function()));
  const auto mesh = internal::triangle_surface(tmesh, np);
  if (!mesh) return mesh.error();
  const Result<Designed_field> field = internal::designed_field(tmesh, *mesh, np);
  if (!field) return field.error();
  Result<Reeb_layout> layout = make_layout(mesh->surface, *field);
  if (!layout) return layout;
  const std::vector<int> largest = internal::largest_charts(*layout, mesh->surface);
  for (std::size_t f = 0; f < largest.size(); ++f) put(chart, mesh->faces[f], largest[f]);
  return layout;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_REEB_CHARTS_H
