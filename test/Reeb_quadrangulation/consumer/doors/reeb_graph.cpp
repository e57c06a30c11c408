// SPDX-License-Identifier: GPL-3.0-or-later
// The Reeb graph of a function of the user's own: the heights of a torus that stands have one loop; with
// holes, contours end on these.
#include "torus.h"

#include <CGAL/Reeb_quadrangulation/reeb_graph.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  Mesh mesh = torus();
  auto height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  auto arc = mesh.add_property_map<Mesh::Vertex_index, int>("v:arc", -1).first;
  for (const auto v : mesh.vertices())
    height[v] = mesh.point(v).x() + 0.01 * mesh.point(v).y() + 0.001 * mesh.point(v).z();
  const auto whole = RQ::reeb_graph(mesh, height, RQ::parameters::vertex_arc_map(arc));
  if (!whole) return std::cerr << whole.error().message << '\n', 1;
  std::size_t on_arcs = 0;
  for (const auto v : mesh.vertices()) on_arcs += arc[v] >= 0;

  // With thirty holes many contours end on the boundary.
  for (unsigned f = 0; f < 30; ++f) CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(120 * f)), mesh);
  const auto cut = RQ::reeb_graph(mesh, height);
  if (!cut) return std::cerr << cut.error().message << '\n', 1;
  std::cout << whole->arcs.size() << " arcs, " << whole->loops() << " loop, " << on_arcs
            << " vertices on arcs; cut open " << cut->arcs.size() << " arcs\n";
  return whole->loops() == 1 && whole->arcs.size() == 4 && on_arcs + 4 == mesh.number_of_vertices() &&
                 cut->arcs.size() > whole->arcs.size() && cut->components == 1
             ? 0
             : 1;
}
