// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

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
Quad_mesh shifted_grid(int n, double shift) {
  Quad_mesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const double at = x == 0 || x == n ? x : x + shift, over = std::max(0.0, at - 0.5 * n);
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
  const Snap_report report = snap_to_features(mesh, input, {}, fixed);
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
  CHECK(snap_to_features(far, input, options, fixed).vertices == 0);
  options.reach = 0.5;
  options.feature_angle = 100; // the fold is no feature
  Quad_mesh blunt = shifted_grid(n, 0.2);
  CHECK(snap_to_features(blunt, input, options, fixed).vertices == 0);
  options.feature_angle = 45;
  options.shortest_chain = 100; // too short to count
  CHECK(snap_to_features(blunt, input, options, fixed).vertices == 0);
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
