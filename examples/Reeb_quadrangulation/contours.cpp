// SPDX-License-Identifier: GPL-3.0-or-later
// Traces the critical contours of a rippled height on a torus: integers decide where they run.
#include <CGAL/Reeb_quadrangulation/Contour_network.h>
#include <CGAL/Reeb_quadrangulation/Embedding.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cmath>
#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

int main() {
  const auto torus = rq::make_shape("torus", 2000);
  if (!torus) {
    std::cerr << torus.error().message << "\n";
    return 1;
  }
  std::vector<double> height;
  for (const rq::Point& p : torus->points) height.push_back(p.x() + 0.02 * std::sin(30 * p.y()));

  // The ripples make pits and bumps: all but the lowest and the highest vertex go.
  rq::Vertex_order order = rq::order_vertices(height);
  const int lowest = order.by_rank.front(), highest = order.by_rank.back();
  const rq::Critical_points rough = rq::critical_points(*torus, order);
  rq::remove_extrema(*torus, {lowest}, {highest}, height, order);
  const rq::Critical_points critical = rq::critical_points(*torus, order);
  std::cout << "extrema: " << rough.minima.size() + rough.maxima.size() << " before, "
            << critical.minima.size() + critical.maxima.size() << " after the cleanup\n";

  std::vector<rq::Traced_contour> contours;
  for (int saddle : critical.saddles)
    for (rq::Traced_contour& loop : rq::trace_contour(*torus, order, saddle)) {
      std::cout << "saddle " << saddle << " at height " << height[saddle] << ": a loop across "
                << loop.halfedges.size() << " edges\n";
      contours.push_back(std::move(loop));
    }

  const rq::Contour_network network =
      rq::build_network(*torus, order, height, contours, critical.saddles, critical.multiplicity);
  const auto embedding = rq::embed(*torus, network);
  if (!embedding) {
    std::cerr << embedding.error().message << "\n";
    return 1;
  }
  std::cout << torus->number_of_faces() << " triangles, with the contours as edges "
            << embedding->surface.number_of_faces() << "\n";
  return 0;
}
