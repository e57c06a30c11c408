// SPDX-License-Identifier: GPL-3.0-or-later
#include "automatic/coarse_copy.h"

#include <CGAL/Reeb_quadrangulation/decimate.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// Three patches that meet in a face become a triangle of their centres.
Triangle_surface dual(const Triangle_surface& surface, const Metric_graph& graph) {
  Triangle_surface copy;
  std::vector<int> vertex(std::size_t(graph.size()), -1);
  for (const Triangle& t : surface.triangles) {
    Triangle patches;
    for (int i = 0; i < 3; ++i) patches[i] = graph.node_of_vertex[t[i]];
    if (patches[0] == patches[1] || patches[1] == patches[2] || patches[2] == patches[0]) continue;
    for (int& node : patches) {
      if (vertex[node] < 0) {
        vertex[node] = copy.number_of_vertices();
        copy.points.push_back(graph.position[node]);
      }
      node = vertex[node];
    }
    copy.triangles.push_back(patches);
  }
  return copy;
}

bool same_topology(const Triangle_surface& a, const Triangle_surface& b) {
  return connected_components(b).second == 1 && euler_characteristic(a) == euler_characteristic(b) &&
         boundary_loops(a).size() == boundary_loops(b).size();
}

} // namespace

std::optional<Triangle_surface> coarse_copy(const Triangle_surface& surface, int triangles) {
  for (; 3 * std::int64_t(triangles) < surface.number_of_faces(); triangles *= 2) {
    Triangle_surface copy = dual(surface, decimate(surface, triangles / 2));
    if (copy.number_of_faces() > 0 && copy.connect() && same_topology(surface, copy)) return copy;
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
