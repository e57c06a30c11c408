// SPDX-License-Identifier: GPL-3.0-or-later
// Maps the charts of a torus to the plane: U from contour to contour, V around.
#include <CGAL/Reeb_quadrangulation/Chart_parameterization.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Quad_texture.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <algorithm>
#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

int main() {
  const auto torus = rq::make_shape("torus", 2000);
  if (!torus) return 1;
  const auto by_x = [](const rq::Point& a, const rq::Point& b) { return a.x() < b.x(); };
  const auto [low, high] = std::minmax_element(torus->points.begin(), torus->points.end(), by_x);
  rq::Designed_field field;
  field.minima = {int(low - torus->points.begin())};
  field.maxima = {int(high - torus->points.begin())};
  rq::Harmonic_field harmonic(*torus);
  harmonic.set_weights(rq::Weight_kind::clamped_cotangent);
  if (!harmonic.set_constraint(field.minima[0], 0) || !harmonic.set_constraint(field.maxima[0], 1)) return 1;
  const auto values = harmonic.solve();
  if (!values) return 1;
  field.values = *values;
  const auto layout = rq::make_layout(*torus, field);
  if (!layout) return 1;

  int flipped = 0;
  for (const auto& shared_chart : layout->atlas.charts) {
    const rq::Chart& chart = *shared_chart;
    if (chart.kind != rq::Chart_kind::annulus) continue;
    auto map = rq::Chart_parameterization::prepare(chart);
    if (!map || !map->solve_columns(chart, map->natural(rq::Side::low), map->natural(rq::Side::high)))
      return 1;
    flipped += map->flipped(chart);
    const rq::Height_profile& profile = map->profile();
    std::cout << "annulus of height " << profile.total() << " between contours of length "
              << profile.length.front() << " and " << profile.length.back();
    const auto middle = rq::locate(chart, *map, {0.5}, {profile.level_at(0.5)});
    std::cout << ", opposite of its first column in the middle row: ("
              << rq::position(chart, middle[0]).transpose() << ")\n";
  }
  std::cout << flipped << " flipped triangles\n";
  return flipped == 0 ? 0 : 1;
}
