// SPDX-License-Identifier: GPL-3.0-or-later
// Makes every built-in shape with about 2,000 triangles and prints what it is.
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

namespace Rq = CGAL::Reeb_quadrangulation;

int main() {
  for (const Rq::Shape_info& shape : Rq::shape_names()) {
    const std::string name = shape.name == "genus-N" ? "genus-4" : shape.name;
    const auto info = Rq::shape_info(name);
    const auto surface = Rq::make_shape(name, 2000);
    if (!info || !surface) return 1;
    std::cout << name << " (" << info->description << "): " << surface->number_of_vertices() << " vertices, "
              << surface->number_of_faces() << " triangles, Euler characteristic "
              << Rq::euler_characteristic(*surface) << '\n';
  }
  return 0;
}
