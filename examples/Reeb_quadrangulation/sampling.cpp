// SPDX-License-Identifier: GPL-3.0-or-later
// Samples the layout of a pair of pants: one leg below, two above, each closed by a cap.
#include <CGAL/Reeb_quadrangulation/sampling.h>

#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

int main() {
  using Kind = rq::Sampling_chart::Kind;
  rq::Sampling_problem problem;
  // The contours, from below: around the minimum, the two loops of the saddle, around the two maxima.
  for (double length : {4.0, 3.0, 2.5, 2.8, 2.2}) {
    rq::Sampling_edge loop;
    loop.length = length;
    loop.minimum = 4;
    problem.edges.push_back(loop);
  }
  problem.charts = {{Kind::disc, {}, {0}},           // around the minimum
                    {Kind::annulus, {0}, {1, 2}, 3}, // the body
                    {Kind::annulus, {1}, {3}, 2},    // the legs
                    {Kind::annulus, {2}, {4}, 2.5},
                    {Kind::disc, {3}, {}}, // around the maxima
                    {Kind::disc, {4}, {}}};

  const auto sampling = rq::sample_for_quads(problem, 1000);
  if (!sampling) {
    std::cerr << sampling.error().message << "\n";
    return 1;
  }
  std::cout << sampling->quads << " quads with edges of length " << sampling->edge_length << "\n";
  for (std::size_t e = 0; e < sampling->counts.size(); ++e)
    std::cout << "contour " << e << ": " << sampling->counts[e] << " edges\n";
  for (std::size_t c = 0; c < sampling->grid.size(); ++c)
    std::cout << "chart " << c << ": " << sampling->grid[c][0] << " x " << sampling->grid[c][1] << " quads\n";
  return 0;
}
