// SPDX-License-Identifier: GPL-3.0-or-later
// Suggests the extrema of a field on the built-in hand: the five fingertips and the wrist.
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include <iostream>

namespace Rq = CGAL::Reeb_quadrangulation;

int main() {
  const auto hand = Rq::make_shape("hand", 8000);
  if (!hand) {
    std::cerr << hand.error().message << '\n';
    return 1;
  }
  Rq::Suggestion_options options;
  options.persistence = 0.1;               // a protrusion counts from a tenth of the range
  options.axis = Eigen::Vector3d(0, 0, 1); // minima below, maxima above
  const auto suggestion = Rq::suggest_extrema(*hand, options);
  if (!suggestion) {
    std::cerr << suggestion.error().message << '\n';
    return 1;
  }
  for (const Rq::Suggested_extremum& e : suggestion->extrema)
    std::cout << (e.is_maximum ? "maximum" : "minimum") << " at vertex " << e.vertex << " ("
              << hand->points[e.vertex].transpose() << "), prominence " << e.prominence << '\n';
  return suggestion->extrema.size() == 6 ? 0 : 1;
}
