// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a surface of genus 2 along the contours of a harmonic field and prints its Reeb graph.
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

int main() {
  const auto surface = rq::make_shape("bitorus", 4000);
  if (!surface) return 1;
  const auto suggestion = rq::suggest_extrema(*surface);
  if (!suggestion) return 1;

  rq::Designed_field field;
  rq::Harmonic_field harmonic(*surface);
  for (const rq::Suggested_extremum& e : suggestion->extrema) {
    (e.is_maximum ? field.maxima : field.minima).push_back(e.vertex);
    if (!harmonic.set_constraint(e.vertex, e.is_maximum ? 1 : 0)) return 1;
  }
  const auto values = harmonic.solve();
  if (!values) return 1;
  field.values = *values;

  const auto layout = rq::make_layout(*surface, field);
  if (!layout) {
    std::cerr << layout.error().message << "\n";
    return 1;
  }
  std::cout << layout->critical.minima.size() << " minima, " << layout->critical.maxima.size() << " maxima, "
            << layout->critical.saddles.size() << " saddles\n";
  const rq::Reeb_graph& graph = layout->graph;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    const rq::Chart& chart = *layout->atlas.charts[a];
    std::cout << "arc " << graph.arcs[a].low << " -> " << graph.arcs[a].high << ": "
              << (chart.kind == rq::Chart_kind::disc ? "disc" : "annulus") << " of "
              << chart.mesh.number_of_faces() << " triangles\n";
  }
  std::cout << "loops of the Reeb graph: " << graph.loops() << "\n";
  return graph.loops() == 2 ? 0 : 1;
}
