// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetric shape, meshed so that the quads equal their mirror image to the bit.
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mirror_check.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

int main() {
  const auto surface = rq::make_shape("torus", 4000);
  if (!surface) return 1;

  // Which planes there are.
  const rq::Surface_projector projector(*surface);
  for (const rq::Found_mirror& mirror : rq::find_mirror_planes(projector))
    std::cout << rq::to_text(mirror.plane) << ": the surface deviates from its mirror image by up to "
              << 100 * mirror.deviation.largest << " % of its diagonal\n";

  // The best of them, or one that is asked for.
  rq::Quadrangulation_options options;
  options.quads = 1000;
  options.mirror.emplace();
  options.mirror->choice = rq::Mirror_choice::across_x;
  const auto result = rq::quadrangulate(*surface, options);
  if (!result) {
    std::cerr << result.error().message << "\n";
    return 1;
  }

  // What was promised is checked: that the images pair vertices and quads, and that no bit differs.
  const rq::Mirror_report& mirror = *result->mirror;
  const rq::Mirror_check check = rq::check_mirror(result->mesh, mirror.mirror.plane, mirror.image);
  std::cout << "the mesh of " << result->mesh.quads.size() << " quads "
            << rq::to_text(check, mirror.mirror.plane) << "; " << check.on_plane
            << " vertices lie on the plane\n";
  const rq::Certificate certificate = rq::certify({result->mesh, &*surface, result->valences});
  return check.is_exact && certificate.passed ? 0 : 1;
}
