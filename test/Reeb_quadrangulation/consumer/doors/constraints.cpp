// SPDX-License-Identifier: GPL-3.0-or-later
// Two tori in one mesh, a ring of constrained edges on each, one length for all edges of quads.
#include "torus.h"

#include <CGAL/Reeb_quadrangulation/quadrangulate_components.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
namespace params = CGAL::Reeb_quadrangulation::parameters;

int main() {
  Mesh mesh = torus(), far = torus(), quads;
  for (const auto v : far.vertices()) far.point(v) = far.point(v) + Kernel::Vector_3(4, 0, 0);
  CGAL::copy_face_graph(far, mesh);
  auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:ring", false).first;
  auto size = mesh.add_property_map<Mesh::Vertex_index, double>("v:size", 0.12).first;
  const auto column = [](Mesh::Vertex_index v) { return unsigned(v) % 1800 / 30; };
  for (const auto e : mesh.edges())
    is_constrained[e] = column(mesh.vertex(e, 0)) == 11 && column(mesh.vertex(e, 1)) == 11;
  const auto result = RQ::quadrangulate_components(
      mesh, quads, params::edge_is_constrained_map(is_constrained).sizing_field(size));
  if (!result) return std::cerr << result.error().message << '\n', 1;
  double mean = 0;
  for (const auto e : quads.edges())
    mean +=
        std::sqrt(CGAL::squared_distance(quads.point(quads.vertex(e, 0)), quads.point(quads.vertex(e, 1))));
  mean /= quads.number_of_edges();
  const int on_first = (*result)[0].features.vertices, on_second = (*result)[1].features.vertices;
  std::cout << result->size() << " components, " << on_first << " and " << on_second
            << " vertices on the rings, edges of " << mean << '\n';
  return result->size() == 2 && on_first > 10 && on_second > 10 && std::abs(mean / 0.12 - 1) < 0.15 ? 0 : 1;
}
