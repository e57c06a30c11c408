// SPDX-License-Identifier: GPL-3.0-or-later
// Uses a compiled function of the installed library: an octahedron is connected and measured.
#include <CGAL/reeb_quadrangulation.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  RQ::Triangle_surface surface;
  surface.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  surface.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                       {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  if (const RQ::Result<void> connected = surface.connect(); !connected) {
    std::cerr << connected.error().message << '\n';
    return 1;
  }
  const int chi = RQ::euler_characteristic(surface);
  std::cout << "Euler characteristic " << chi << '\n';
  return chi == 2 ? 0 : 1;
}
