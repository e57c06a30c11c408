// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a quad mesh: extraordinary vertices as dots, then the quality of its quads, then a chart of that
// quality.
#include <CGAL/Reeb_quadrangulation/render.h>

#include <cmath>
#include <iostream>

namespace rq = CGAL::Reeb_quadrangulation;

namespace {

/// A cube of n x n quads a side, blown up towards a sphere: eight extraordinary vertices of valence 3.
rq::Quad_mesh round_cube(int n) {
  rq::Quad_mesh mesh;
  std::vector<int> id((n + 1) * (n + 1) * (n + 1), -1);
  const auto vertex = [&](int i, int j, int k) {
    int& v = id[(i * (n + 1) + j) * (n + 1) + k];
    if (v < 0) {
      v = int(mesh.points.size());
      const rq::Point p = rq::Point(i, j, k) * (2.0 / n) - rq::Point(1, 1, 1);
      mesh.points.push_back(0.35 * p + 0.65 * p.normalized());
    }
    return v;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (const int end : {0, n}) {
          const auto corner = [&](int a, int b) {
            int at[3] = {};
            at[axis] = end, at[(axis + 1) % 3] = a, at[(axis + 2) % 3] = b;
            return vertex(at[0], at[1], at[2]);
          };
          rq::Quad quad{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
          if (end == 0) std::swap(quad[1], quad[3]);
          mesh.quads.push_back(quad);
        }
  return mesh;
}

} // namespace

int main() {
  const rq::Quad_mesh mesh = round_cube(16);
  const rq::Camera camera = rq::camera(rq::View::three_quarter, rq::Up_axis::z);

  rq::Histogram chart;
  chart.bins.assign(20, 0);
  for (const double jacobian : rq::scaled_jacobians(mesh))
    if (jacobian > 0) ++chart.bins[std::min(int(jacobian * 20), 19)];
  chart.title = "Quality of the quads";
  chart.x_label = "scaled Jacobian";
  chart.colours = rq::quality_colours();

  const auto quads = rq::write_png(rq::render(rq::quad_scene(mesh), camera, 800, 600), "draw_quads.png");
  const auto quality =
      rq::write_png(rq::render(rq::quality_scene(mesh), camera, 800, 600), "draw_quads_quality.png");
  const auto bars = rq::write_png(rq::histogram_image(chart), "draw_quads_histogram.png");
  for (const auto* result : {&quads, &quality, &bars})
    if (!*result) {
      std::cerr << result->error().message << '\n';
      return 1;
    }
  std::cout << "draw_quads.png, draw_quads_quality.png, draw_quads_histogram.png\n";
  return 0;
}
