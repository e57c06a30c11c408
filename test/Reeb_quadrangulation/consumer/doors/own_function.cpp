// SPDX-License-Identifier: GPL-3.0-or-later
// Quads and charts of a function of the user's own, the distance from a point of the torus: its extrema are
// those of the design, and the quads' recipe keeps it.
#include "torus.h"

#include <CGAL/Reeb_quadrangulation/face_graph.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
namespace params = CGAL::Reeb_quadrangulation::parameters;

int main() {
  Mesh mesh = torus(), quads;
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  auto chart = mesh.add_property_map<Mesh::Face_index, int>("f:chart", -1).first;
  const Kernel::Point_3 from(-1.4, 0.03, 0.01);
  for (const auto v : mesh.vertices()) distance[v] = std::sqrt(CGAL::squared_distance(from, mesh.point(v)));
  const auto np = params::vertex_field_map(distance);
  const auto layout = RQ::reeb_charts(mesh, chart, np);
  if (!layout) return std::cerr << layout.error().message << '\n', 1;
  const auto result = RQ::quadrangulate(mesh, quads, np.number_of_quads(1000));
  if (!result) return std::cerr << result.error().message << '\n', 1;
  int nearest = 0;
  for (const auto v : mesh.vertices())
    if (distance[v] < distance[Mesh::Vertex_index(unsigned(nearest))]) nearest = int(unsigned(v));
  const auto* edit = std::get_if<RQ::Set_field>(&result->recipe.edits.front());
  std::cout << quads.number_of_faces() << " quads in " << layout->atlas.charts.size() << " charts\n";
  return CGAL::is_closed(quads) && edit && layout->critical.minima == std::vector<int>{nearest} &&
                 layout->graph.loops() == 1 && result->valences.at(3) >= 8
             ? 0
             : 1;
}
