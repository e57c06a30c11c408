// SPDX-License-Identifier: GPL-3.0-or-later
// Certifies a torus of quads against a finer torus of triangles, then a damaged copy, which fails.
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include <cmath>
#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

// m x n quads on a torus of revolution.
Quad_mesh torus(int m, int n) {
  Quad_mesh mesh;
  const double tau = 2 * std::acos(-1.0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = tau * i / m, b = tau * j / n, r = 1 + 0.4 * std::cos(b);
      mesh.points.emplace_back(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
      const int k = (i + 1) % m, l = (j + 1) % n;
      mesh.quads.push_back({i * n + j, k * n + j, k * n + l, i * n + l});
    }
  return mesh;
}

int main() {
  Triangle_surface input;
  const Quad_mesh fine = torus(160, 80);
  input.points = fine.points;
  for (const Quad& q : fine.quads) {
    input.triangles.push_back({q[0], q[1], q[2]});
    input.triangles.push_back({q[0], q[2], q[3]});
  }

  Quad_mesh quads = torus(40, 20);
  const std::map<int, int> no_extraordinary_vertex;
  const Certificate certificate = certify({quads, &input, no_extraordinary_vertex});
  std::cout << to_text(certificate) << '\n' << to_text(quad_statistics(quads, &input)) << '\n';

  quads.quads.pop_back();
  const Certificate damaged = certify({quads, &input, no_extraordinary_vertex});
  std::cout << "Without its last quad: " << damaged.check("watertight").message << '\n';
  return certificate.strictly_valid && !damaged.passed ? 0 : 1;
}
