// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUADRANGULATE_COMPONENTS_H
#define CGAL_REEB_QUADRANGULATION_QUADRANGULATE_COMPONENTS_H

#include <CGAL/Reeb_quadrangulation/face_graph.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace internal {

// The component of a number as a surface of its own; the descriptors are those of the whole graph.
template <class Graph>
Result<Face_graph_surface<Graph>> component(const Graph& graph, const Face_graph_surface<Graph>& whole,
                                            const std::vector<int>& component_of_face, int number) {
  Face_graph_surface<Graph> part;
  part.vertex_index = get(CGAL::dynamic_vertex_property_t<int>(), graph);
  for (const auto v : vertices(graph)) put(part.vertex_index, v, -1);
  std::vector<int> index(whole.vertices.size(), -1);
  for (std::size_t f = 0; f < whole.faces.size(); ++f) {
    if (component_of_face[f] != number) continue;
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = std::size_t(whole.surface.triangles[f][i]);
      if (index[v] < 0) {
        index[v] = int(part.vertices.size());
        part.vertices.push_back(whole.vertices[v]);
        part.surface.points.push_back(whole.surface.points[v]);
        put(part.vertex_index, whole.vertices[v], index[v]);
      }
      t[i] = index[v];
      part.halfedges.push_back(whole.halfedges[3 * f + i]);
    }
    part.surface.triangles.push_back(t);
    part.faces.push_back(whole.faces[f]);
  }
  if (Result<void> connected = part.surface.connect(); !connected) return connected.error();
  return part;
}

// A component's share of the quads, by its area. The smallest mesh of two caps has 24.
inline int share_of_quads(int quads, const Triangle_surface& part, const Triangle_surface& whole) {
  constexpr int least = 24;
  const double total = area(whole);
  return std::max(least, total > 0 ? int(std::lround(quads * area(part) / total)) : least);
}

} // namespace internal

/// As `quadrangulate()`, for triangle meshes of any number of connected components, each a run of its own:
/// the results are ordered as the components' first faces are, and so are the quads added. `number_of_quads`
/// is shared by area, `edge_length` and `sizing_field` are the same for all, `minima` and `maxima` count for
/// the component that they lie on; one with none of them gets suggested ones. An error's element is one of
/// the component, and its message says which. On failure `quads` is as it was. Named parameters as for
/// `quadrangulate()`.
template <class TriangleMesh, class QuadMesh,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters>
Result<std::vector<Quadrangulation>>
quadrangulate_components(const TriangleMesh& tmesh, QuadMesh& quads,
                         const NamedParameters1& np1 = CGAL::parameters::default_values(),
                         const NamedParameters2& np2 = CGAL::parameters::default_values()) {
  static_assert(internal::reads_all_of_quadrangulate<NamedParameters1, NamedParameters2>());
  const auto whole = internal::triangle_surface(tmesh, np1);
  if (!whole) return whole.error();
  const Result<Quadrangulation_options> asked = internal::options(tmesh, *whole, np1);
  if (!asked) return asked.error();
  if (const Result<Recipe> fine = automatic_recipe(*asked); !fine) return fine.error();
  if (whole->faces.empty()) return make_error(Error_code::not_a_surface, "the triangle mesh has no face");
  const auto [component_of_face, number] = connected_components(whole->surface);
  std::vector<Face_graph_surface<TriangleMesh>> parts;
  std::vector<Quadrangulation> results;
  std::vector<std::vector<Quad_parameters>> corners;
  for (int c = 0; c < number; ++c) {
    auto part = internal::component(tmesh, *whole, component_of_face, c);
    if (!part) return part.error();
    Result<Quadrangulation_options> options = internal::options(tmesh, *part, np1, true);
    if (!options) return options.error();
    options->quads = internal::share_of_quads(options->quads, part->surface, whole->surface);
    Result<Quadrangulation> result = internal::quads_of(tmesh, *part, *options, np1);
    if (!result) {
      Error error = result.error();
      error.message += " (component " + std::to_string(c) + ")";
      return error;
    }
    auto parameters = internal::wanted_parameters(*result, np1);
    if (!parameters) return parameters.error();
    corners.push_back(std::move(*parameters));
    parts.push_back(std::move(*part));
    results.push_back(std::move(*result));
  }
  for (int c = 0; c < number; ++c) {
    const auto added = to_face_graph(results[std::size_t(c)].mesh, quads, np2);
    if (!added) return added.error();
    internal::put_results(parts[std::size_t(c)], results[std::size_t(c)], quads, *added,
                          corners[std::size_t(c)], np1);
  }
  return results;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUADRANGULATE_COMPONENTS_H
