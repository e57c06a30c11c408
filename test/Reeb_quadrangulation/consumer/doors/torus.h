// SPDX-License-Identifier: GPL-3.0-or-later
// A torus as the consumers' own mesh.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline Mesh torus(int around = 60, int across = 30) {
  Mesh mesh;
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = turn * i / around, b = turn * j / across, r = 1 + 0.4 * std::cos(b);
      mesh.add_vertex(Kernel::Point_3(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)));
    }
  const auto at = [&](int i, int j) {
    return Mesh::Vertex_index(unsigned(i % around * across + j % across));
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}
