// SPDX-License-Identifier: GPL-3.0-or-later
// The front door: a CGAL::Surface_mesh in, a quad mesh with a chart number on every face out.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh make_torus(int around, int across) {
  Mesh torus;
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = turn * i / around, b = turn * j / across, r = 1 + 0.4 * std::cos(b);
      torus.add_vertex(Kernel::Point_3(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)));
    }
  const auto vertex = [&](int i, int j) {
    return Mesh::Vertex_index(Mesh::size_type(i % around * across + j % across));
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      torus.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      torus.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return torus;
}

int main() {
  const Mesh torus = make_torus(60, 30);
  const std::vector<Mesh::Vertex_index> left{Mesh::Vertex_index(30 * 30)}, right{Mesh::Vertex_index(0)};

  Mesh quads;
  auto chart = quads.add_property_map<Mesh::Face_index, int>("f:chart", -1).first;
  const auto result = RQ::quadrangulate(
      torus, quads, RQ::parameters::number_of_quads(1000).minima(left).maxima(right).quad_chart_map(chart));
  if (!result) {
    std::cerr << result.error().message << '\n';
    return 1;
  }

  std::vector<int> quads_of_chart(result->editor.design().charts.size());
  for (const Mesh::Face_index f : quads.faces()) ++quads_of_chart[chart[f]];
  std::cout << quads.number_of_faces() << " quads, genus " << result->genus << "; in the charts:";
  for (int n : quads_of_chart) std::cout << ' ' << n;
  std::cout << "\nvalences:";
  for (const auto& [valence, vertices] : result->valences) std::cout << "  " << vertices << " of " << valence;
  std::cout << '\n';
}
