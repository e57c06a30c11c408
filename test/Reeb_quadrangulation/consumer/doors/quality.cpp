// SPDX-License-Identifier: GPL-3.0-or-later
// Quads of another origin, relaxed on the mesh and certified; an attribute of the mesh goes with them.
#include "torus.h"

#include <CGAL/Reeb_quadrangulation/face_graph.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  Mesh mesh = torus(), quads;
  RQ::Quad_mesh grid; // 24 x 12 on the torus, with every other ring displaced
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 12; ++j) {
      const double a = turn * (i + 0.3 * (j % 2)) / 24, b = turn * j / 12, r = 1 + 0.4 * std::cos(b);
      grid.points.push_back({r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)});
      const auto at = [](int k, int l) { return k % 24 * 12 + l % 12; };
      grid.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  if (const auto added = RQ::to_face_graph(grid, quads); !added) return std::cerr << added.error().message, 1;
  const auto relaxed = RQ::relax_quads(quads, mesh);
  const auto certificate = RQ::certify(quads, mesh);
  auto in = mesh.add_property_map<Mesh::Vertex_index, double>("v:x").first;
  auto out = quads.add_property_map<Mesh::Vertex_index, double>("v:x").first;
  for (const auto v : mesh.vertices()) in[v] = mesh.point(v).x();
  const auto carried = RQ::transfer_attribute(mesh, quads, in, out);
  if (!relaxed || !certificate || !carried) return std::cerr << "refused\n", 1;
  double worst = 0;
  for (const auto v : quads.vertices()) worst = std::max(worst, std::abs(out[v] - quads.point(v).x()));
  std::cout << "quality " << relaxed->mean_before << " -> " << relaxed->mean_after << ", x off by " << worst
            << '\n';
  return certificate->passed && relaxed->mean_after > relaxed->mean_before && worst < 1e-9 ? 0 : 1;
}
