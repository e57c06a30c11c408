// SPDX-License-Identifier: GPL-3.0-or-later
// Quads of a mesh whose points are elsewhere, and where they lie on it: the vertices' locations give back
// their points.
#include "torus.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  Mesh mesh = torus(), quads;
  auto large = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:large").first;
  for (const auto v : mesh.vertices()) large[v] = CGAL::ORIGIN + 3 * (mesh.point(v) - CGAL::ORIGIN);
  auto place = quads.add_property_map<Mesh::Vertex_index, RQ::Face_location<Mesh>>("v:place").first;
  const auto theirs = CGAL::parameters::vertex_point_map(large).geom_traits(Kernel());
  const auto result = RQ::quadrangulate(
      mesh, quads, RQ::parameters::combine(theirs).number_of_quads(1000).vertex_location_map(place));
  if (!result) return std::cerr << result.error().message << '\n', 1;
  double farthest = 0;
  for (const auto v : quads.vertices()) {
    const auto p = CGAL::Polygon_mesh_processing::construct_point(place[v], mesh, theirs);
    farthest = std::max(farthest, CGAL::to_double(CGAL::squared_distance(p, quads.point(v))));
  }
  std::cout << quads.number_of_faces() << " quads, off by " << std::sqrt(farthest) << '\n';
  return std::abs(double(quads.number_of_faces()) - 1000) <= 50 && farthest < 1e-12 ? 0 : 1;
}
