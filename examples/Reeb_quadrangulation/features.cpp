// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the sharp edges of a shape: the run moves quad vertices onto them and onto their corners,
// and begins quads where their diagonal lies on one.
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

int main() {
  const Result<Triangle_surface> bar = make_shape("twisted-bar", 4000);
  if (!bar) {
    std::cerr << bar.error().message << '\n';
    return 1;
  }
  Quadrangulation_options options;
  options.quads = 1000;
  options.features.feature_angle = 40; // degrees between the normals of two faces
  const Result<Quadrangulation> result = quadrangulate(*bar, options);
  if (!result) {
    std::cerr << result.error().message << '\n';
    return 1;
  }
  const Snap_report& features = result->features;
  std::cout << features.vertices << " vertices lie on sharp edges, " << features.corners << " on corners; "
            << features.missed_corners << " corners have no vertex near enough\n"
            << result->relaxation.inverted_after << " of " << result->mesh.quads.size()
            << " quads are inverted\n";
  const Mesh_statistics statistics = quad_statistics(result->mesh, &*bar);
  std::cout << 100 * *statistics.folded_sharp_edges
            << " % of the sharp edges of 45 degrees run along edges or first diagonals of quads\n";
  return features.missed_corners == 0 && *statistics.folded_sharp_edges > 0.8 ? 0 : 1;
}
