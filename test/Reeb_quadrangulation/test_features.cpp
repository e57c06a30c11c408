// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// The square [0, n]^2 folded along x = n / 2 by a right angle, as triangles.
Triangle_surface folded_square(int n) {
  Triangle_surface s;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const double over = std::max(0.0, x - 0.5 * n);
      s.points.emplace_back(x - over, y, -over);
    }
  const auto id = [&](int x, int y) { return y * (n + 1) + x; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      s.triangles.push_back({id(x, y), id(x + 1, y), id(x + 1, y + 1)});
      s.triangles.push_back({id(x, y), id(x + 1, y + 1), id(x, y + 1)});
    }
  return tiny::connected(std::move(s));
}

// A grid of quads on it whose lines miss the fold by `shift` of a step.
Quad_mesh shifted_grid(int n, double shift, double slope = 0) {
  Quad_mesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const double at = x == 0 || x == n ? x : x + shift + slope * y, over = std::max(0.0, at - 0.5 * n);
      mesh.points.emplace_back(at - over, y, -over);
    }
  const auto id = [&](int x, int y) { return y * (n + 1) + x; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      mesh.quads.push_back({id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1)});
  return mesh;
}

} // namespace

TEST_CASE("grid lines that run near a sharp edge come to lie on it, and nothing else moves") {
  const int n = 8;
  const Triangle_surface input = folded_square(n);
  Quad_mesh mesh = shifted_grid(n, 0.2);
  const Quad_mesh before = mesh;
  std::vector<char> fixed;
  const Snap_report report = snap_to_features(mesh, Surface_projector(input), {}, fixed);
  CHECK(report.vertices == n - 1); // the two ends are on the boundary, which is not ours to move
  REQUIRE(fixed.size() == mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (fixed[v]) {
      CHECK(mesh.points[v].x() == Approx(0.5 * n));
      CHECK(mesh.points[v].z() == Approx(0).margin(1e-12));
    } else {
      CHECK(mesh.points[v] == before.points[v]);
    }
  }
}

TEST_CASE("no vertex is moved farther than its reach, or where a quad would become bad") {
  const int n = 8;
  const Triangle_surface input = folded_square(n);
  Snap_options options;
  std::vector<char> fixed;
  Quad_mesh far = shifted_grid(n, 0.45);
  options.reach = 0.3;
  CHECK(snap_to_features(far, Surface_projector(input), options, fixed).vertices == 0);
  options.reach = 0.5;
  options.feature_angle = 100; // the fold is no feature
  Quad_mesh blunt = shifted_grid(n, 0.2);
  CHECK(snap_to_features(blunt, Surface_projector(input), options, fixed).vertices == 0);
  options.feature_angle = 45;
  options.shortest_chain = 100; // too short to count
  CHECK(snap_to_features(blunt, Surface_projector(input), options, fixed).vertices == 0);
}

TEST_CASE("a line that runs beside a sharp edge is laid onto it, and its neighbours give way") {
  const int n = 10;
  const Triangle_surface input = folded_square(n);
  const Surface_projector projector(input);
  // From 0.55 steps on one side of the fold to 0.65 on the other.
  const Quad_mesh before = shifted_grid(n, -0.55, 0.12);
  Quad_mesh single = before, lines = before;
  std::vector<char> fixed, others;
  Snap_options options;
  snap_to_features(single, projector, options, others);
  CHECK(*quad_statistics(single, &input).covered_sharp_edges < 0.95);
  options.lines = true;
  options.shortest_chain = 3;
  const Snap_report report = snap_to_features(lines, projector, options, fixed);
  CHECK(report.on_lines == n - 1);
  CHECK(*quad_statistics(lines, &input).covered_sharp_edges >
        *quad_statistics(single, &input).covered_sharp_edges + 0.1);
  for (std::size_t v = 0; v < fixed.size(); ++v)
    if (fixed[v]) CHECK(lines.points[v].x() == Approx(0.5 * n));
  for (const Quad& q : lines.quads)
    CHECK(scaled_jacobian(lines.points[q[0]], lines.points[q[1]], lines.points[q[2]], lines.points[q[3]]) >
          0.5);
}

TEST_CASE("with no reach, or no sharp edge, no line is laid") {
  const Triangle_surface input = folded_square(8);
  const Surface_projector projector(input);
  std::vector<char> fixed;
  Snap_options options;
  options.lines = true;
  options.line_reach = 0.1;
  Quad_mesh far = shifted_grid(8, 0.3);
  CHECK(snap_to_features(far, projector, options, fixed).on_lines == 0);
  options.line_reach = 0.8;
  options.feature_angle = 100;
  CHECK(snap_to_features(far, projector, options, fixed).on_lines == 0);
}

TEST_CASE("the run keeps sharp edges of the L-shape without inverting a quad") {
  const Result<Triangle_surface> surface = make_shape("l-shape", 5000);
  REQUIRE(surface);
  Quadrangulation_options options;
  options.quads = 1500;
  const Result<Quadrangulation> with = quadrangulate(*surface, options);
  REQUIRE(with);
  CHECK(with->features.vertices > 40);
  CHECK(with->relaxation.inverted_after == 0);
  options.keep_features = false;
  const Result<Quadrangulation> without = quadrangulate(*surface, options);
  REQUIRE(without);
  CHECK(without->features.vertices == 0);
  CHECK(with->mesh.quads == without->mesh.quads); // only positions differ
  CHECK(with->mesh.points != without->mesh.points);
}
