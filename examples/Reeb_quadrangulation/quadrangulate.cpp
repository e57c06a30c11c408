// SPDX-License-Identifier: GPL-3.0-or-later
// From triangles to quads in one call, then the certificate.
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

int main() {
  const auto surface = rq::make_shape("bitorus", 6000);
  if (!surface) return 1;

  rq::Quadrangulation_options options;
  options.quads = 1500;
  const auto result = rq::quadrangulate(*surface, options);
  if (!result) {
    std::cerr << result.error().message << "\n";
    return 1;
  }
  std::cout << surface->number_of_faces() << " triangles of genus " << result->genus << " became "
            << result->mesh.quads.size() << " quads in " << result->editor.design().charts.size()
            << " charts\n";
  for (const auto& [valence, number] : result->valences)
    std::cout << number << " vertices of valence " << valence << "\n";

  const rq::Certificate certificate = rq::certify({result->mesh, &*surface, result->valences});
  std::cout << rq::to_text(certificate) << "\n";
  return certificate.passed ? 0 : 1;
}
