// SPDX-License-Identifier: GPL-3.0-or-later
// Prepares a prism with needles on its lids: flips and bisections give triangles on which contours can be
// traced.
#include <CGAL/Reeb_quadrangulation/prepare_surface.h>

#include <cmath>
#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

int main() {
  // A prism over a polygon with 60 corners; each lid is a fan of triangles around its first corner.
  const int n = 60;
  const double tau = 2 * std::acos(-1.0);
  rq::Triangle_surface prism;
  for (double z : {0.0, 1.0})
    for (int i = 0; i < n; ++i) prism.points.emplace_back(std::cos(tau * i / n), std::sin(tau * i / n), z);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    prism.triangles.push_back({i, j, n + j});
    prism.triangles.push_back({i, n + j, n + i});
    if (i == 0 || j == 0) continue;
    prism.triangles.push_back({0, j, i});
    prism.triangles.push_back({n, n + i, n + j});
  }
  if (!prism.connect()) return 1;

  rq::Prepare_options options;
  options.max_edge = 0.2;
  const auto prepared = rq::prepare_surface(std::move(prism), options);
  if (!prepared) return 1;
  const rq::Prepare_report& report = prepared->report;
  std::cout << report.faces_before << " triangles, smallest angle " << report.min_angle_before << " degrees\n"
            << report.faces_after << " triangles, smallest angle " << report.min_angle_after << " degrees\n"
            << report.flips << " flips, " << report.bisections << " bisections\n";
  return 0;
}
