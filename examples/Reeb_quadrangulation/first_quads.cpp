// SPDX-License-Identifier: GPL-3.0-or-later
// From a mesh file (or, without arguments, a built-in shape) to a certified quad mesh: first_quads [FILE
// [QUADS.obj]]
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int fail(const RQ::Error& error) {
  std::cerr << error.message << '\n';
  return 1;
}

int main(int argc, char** argv) {
  RQ::Triangle_surface surface;
  if (argc > 1) {
    const RQ::Result<RQ::Polygon_soup> soup = RQ::read_polygon_soup(argv[1]);
    if (!soup) return fail(soup.error()); // names the file and the line or byte
    RQ::Result<RQ::Mended_surface> mended = RQ::mend_surface(*soup);
    if (!mended) return fail(mended.error());
    if (mended->components.empty()) return fail(mended->refused.front());
    surface = mended->components.front().surface;
  } else {
    const RQ::Result<RQ::Triangle_surface> shape = RQ::make_shape("bitorus", 4000);
    if (!shape) return fail(shape.error());
    surface = *shape;
  }

  RQ::Quadrangulation_options options;
  options.quads = 1500;
  const RQ::Result<RQ::Quadrangulation> result = RQ::quadrangulate(surface, options);
  if (!result) return fail(result.error());
  const RQ::Certificate certificate = RQ::certify({result->mesh, &surface, result->valences});
  std::cout << RQ::to_text(certificate);
  if (argc > 2)
    if (const auto written = RQ::write_mesh(argv[2], result->mesh); !written) return fail(written.error());
  return certificate.passed ? 0 : 1;
}
