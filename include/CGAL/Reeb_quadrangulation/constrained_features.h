// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CONSTRAINED_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_CONSTRAINED_FEATURES_H

#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>
#include <CGAL/Reeb_quadrangulation/given_features.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace internal {

// Whether named parameters say which edges and vertices are to be kept.
template <class NamedParameters>
constexpr bool has_features =
    parameters::has_parameter<CGAL::internal_np::edge_is_constrained_t, NamedParameters> ||
    parameters::has_parameter<CGAL::internal_np::vertex_is_constrained_t, NamedParameters> ||
    parameters::has_parameter<CGAL::internal_np::face_patch_t, NamedParameters>;

template <class Graph, class NamedParameters>
Given_features features_of(const Graph& graph, const Face_graph_surface<Graph>& mesh, double corner_angle,
                           const NamedParameters& np) {
  namespace tags = CGAL::internal_np;
  const Triangle_surface& surface = mesh.surface;
  std::vector<char> sharp(mesh.halfedges.size(), 0);
  std::vector<int> wanted;
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const int o = surface.opposite[std::size_t(h)];
    if (o < h) continue;
    bool is_constrained = false;
    if constexpr (parameters::has_parameter<tags::edge_is_constrained_t, NamedParameters>)
      is_constrained = get(CGAL::parameters::get_parameter(np, tags::edge_is_constrained_t()),
                           edge(mesh.halfedges[std::size_t(h)], graph));
    if constexpr (parameters::has_parameter<tags::face_patch_t, NamedParameters>) {
      const auto patch = CGAL::parameters::get_parameter(np, tags::face_patch_t());
      is_constrained = is_constrained || !(get(patch, mesh.faces[std::size_t(h / 3)]) ==
                                           get(patch, mesh.faces[std::size_t(o / 3)]));
    }
    sharp[std::size_t(h)] = sharp[std::size_t(o)] = is_constrained;
  }
  if constexpr (parameters::has_parameter<tags::vertex_is_constrained_t, NamedParameters>)
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      if (get(CGAL::parameters::get_parameter(np, tags::vertex_is_constrained_t()), mesh.vertices[v]))
        wanted.push_back(int(v));
  return given_features(surface, std::move(sharp), std::move(wanted), corner_angle);
}

} // namespace internal

/// The features that a user gives with a triangle mesh: the edges of `edge_is_constrained_map`, those between
/// two patches of `face_patch_map`, the vertices of `vertex_is_constrained_map`, and the boundary; \sa
/// `given_features()`. Indices are those of `to_triangle_surface()`, whose errors this function has. O(V +
/// F). Further named parameters: `vertex_point_map`, `geom_traits`.
template <class TriangleMesh, class NamedParameters>
Result<Given_features> constrained_features(const TriangleMesh& tmesh, const NamedParameters& np,
                                            double corner_angle = 50) {
  static_assert(
      parameters::reads_all<NamedParameters>(parameters::Point_tags() + parameters::Feature_tags()));
  const auto mesh = internal::triangle_surface(tmesh, np);
  if (!mesh) return mesh.error();
  return internal::features_of(tmesh, *mesh, corner_angle, np);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CONSTRAINED_FEATURES_H
