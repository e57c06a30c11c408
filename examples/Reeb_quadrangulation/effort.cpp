// SPDX-License-Identifier: GPL-3.0-or-later
// A hand by suggested extrema, and by searched ones: what the search has changed, and what that is worth.
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

int main() {
  const Result<Triangle_surface> hand = make_shape("hand", 6000);
  if (!hand) return 1;
  Quadrangulation_options options;
  options.quads = 1000;
  options.suggestion.persistence = 0.5; // the suggestion finds the longest fingers only
  for (const Effort effort : {Effort::fast, Effort::normal}) {
    options.effort = effort;
    const Result<Quadrangulation> result = quadrangulate(*hand, options);
    if (!result) {
      std::cerr << result.error().message << '\n';
      return 1;
    }
    for (const Search_step& step : result->search) std::cout << "  " << step.reason << '\n';
    Stitched_mesh quads;
    quads.mesh = result->mesh;
    quads.valences = result->valences;
    const Design_energy energy = design_energy(quads, Surface_projector(*hand), sample_surface(*hand, 5000));
    std::cout << (effort == Effort::fast ? "suggested: " : "searched: ") << energy.extraordinary
              << " extraordinary vertices, mean scaled Jacobian " << 1 - energy.angle
              << ", the surface at most " << energy.farthest << " edges away\n";
  }
}
