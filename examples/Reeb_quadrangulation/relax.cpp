// SPDX-License-Identifier: GPL-3.0-or-later
// Relax a distorted quad mesh of a sphere on a fine triangulation of the same sphere.
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <cmath>
#include <iostream>
#include <map>

using namespace CGAL::Reeb_quadrangulation;

// An n x n grid on each side of a cube, blown up to the unit sphere. `bend` distorts the grid.
static Quad_mesh cube_sphere(int n, double bend) {
  Quad_mesh mesh;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](std::array<int, 3> c) {
    const auto [it, added] = index.try_emplace(c, int(mesh.points.size()));
    if (added) {
      Point p(2.0 * c[0] / n - 1, 2.0 * c[1] / n - 1, 2.0 * c[2] / n - 1);
      p += bend * Point(std::sin(9 * p.y()), std::sin(9 * p.z()), std::sin(9 * p.x()));
      mesh.points.push_back(p.normalized());
    }
    return it->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side <= n; side += n)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int di, int dj) {
            std::array<int, 3> c;
            c[axis] = side;
            c[(axis + 1) % 3] = i + di;
            c[(axis + 2) % 3] = j + dj;
            return vertex(c);
          };
          if (side == n)
            mesh.quads.push_back({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
          else
            mesh.quads.push_back({at(0, 0), at(0, 1), at(1, 1), at(1, 0)});
        }
  return mesh;
}

int main() {
  Triangle_surface sphere;
  const Quad_mesh fine = cube_sphere(60, 0);
  sphere.points = fine.points;
  for (const Quad& q : fine.quads) {
    sphere.triangles.push_back({q[0], q[1], q[2]});
    sphere.triangles.push_back({q[0], q[2], q[3]});
  }
  if (!sphere.connect()) return 1;

  Quad_mesh mesh = cube_sphere(12, 0.08);
  const Surface_projector projector(sphere);
  const auto report = relax_quads(mesh, projector);
  if (!report) {
    std::cerr << report.error().message << "\n";
    return 1;
  }
  std::cout << mesh.quads.size() << " quads, mean scaled Jacobian " << report->mean_before << " -> "
            << report->mean_after << ", worst " << report->worst_before << " -> " << report->worst_after
            << "\n";
  return report->worst_after > report->worst_before ? 0 : 1;
}
