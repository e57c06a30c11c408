// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of quads as long as a function says, without and with columns that end inside of charts.
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/sized_quads.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  const RQ::Result<RQ::Triangle_surface> surface = RQ::make_shape("hand", 4000);
  if (!surface) return 1;
  const RQ::Size_function size = [](const RQ::Point& p) { return 0.095 - 0.03 * p.z(); }; // finer fingers

  RQ::Quadrangulation_options options;
  for (int dislocations : {0, 8}) {
    options.dislocations = dislocations;
    const RQ::Result<RQ::Quadrangulation> result = RQ::quadrangulate(*surface, size, options);
    if (!result) {
      std::cerr << result.error().message << '\n';
      return 1;
    }
    int extraordinary = 0;
    for (const auto& [valence, number] : result->valences)
      if (valence != 4) extraordinary += number;
    const RQ::Size_report report = RQ::size_report(result->mesh, size);
    std::cout << dislocations << " dislocations at most: " << result->mesh.quads.size() << " quads, "
              << extraordinary << " extraordinary vertices, sizes met within 20 % on " << 100 * report.met
              << " % of the area\n";
  }
}
