// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <algorithm>

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

std::vector<char> on_curves(const Vertex_constraints& constraints, const Quad_mesh& mesh) {
  std::vector<char> result(mesh.points.size(), 0);
  for (const Vertex_constraints::Place& place : constraints.places) result[place.vertex] = 1;
  return result;
}

} // namespace

TEST_CASE("grid lines that run near a sharp edge come to lie on it, and nothing else moves") {
  const int n = 8;
  const Triangle_surface input = folded_square(n);
  Quad_mesh mesh = shifted_grid(n, 0.2);
  const Quad_mesh before = mesh;
  Vertex_constraints found;
  const Snap_report report = snap_to_features(mesh, Surface_projector(input), {}, found);
  CHECK(report.vertices == n - 1); // the two ends are on the boundary, which is not ours to move
  REQUIRE(found.places.size() == std::size_t(n - 1));
  const std::vector<char> moved = on_curves(found, mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    CHECK_FALSE(found.fixed[v]);
    if (moved[v]) {
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
  options.crossings = false;
  const auto vertices = [&](Quad_mesh& mesh) {
    Vertex_constraints found;
    return snap_to_features(mesh, Surface_projector(input), options, found).vertices;
  };
  Quad_mesh far = shifted_grid(n, 0.45);
  options.reach = 0.3;
  CHECK(vertices(far) == 0);
  options.reach = 0.5;
  options.feature_angle = 100; // the fold is no feature
  Quad_mesh blunt = shifted_grid(n, 0.2);
  CHECK(vertices(blunt) == 0);
  options.feature_angle = 45;
  options.shortest_chain = 100; // too short to count
  CHECK(vertices(blunt) == 0);
}

TEST_CASE("a line that runs beside a sharp edge is laid onto it, and its neighbours give way") {
  const int n = 10;
  const Triangle_surface input = folded_square(n);
  const Surface_projector projector(input);
  // From 0.55 steps on one side of the fold to 0.65 on the other.
  const Quad_mesh before = shifted_grid(n, -0.55, 0.12);
  Quad_mesh single = before, lines = before;
  Vertex_constraints found, others;
  Snap_options options;
  options.crossings = false;
  options.shortest_chain = 3;
  snap_to_features(single, projector, options, others);
  CHECK(*quad_statistics(single, &input).covered_sharp_edges < 0.95);
  options.lines = true;
  const Snap_report report = snap_to_features(lines, projector, options, found);
  CHECK(report.on_lines == n - 1);
  CHECK(*quad_statistics(lines, &input).covered_sharp_edges >
        *quad_statistics(single, &input).covered_sharp_edges + 0.1);
  for (const Vertex_constraints::Place& place : found.places)
    CHECK(lines.points[place.vertex].x() == Approx(0.5 * n));
  for (const Quad& q : lines.quads)
    CHECK(scaled_jacobian(lines.points[q[0]], lines.points[q[1]], lines.points[q[2]], lines.points[q[3]]) >
          0.5);
}

TEST_CASE("with no reach, or no sharp edge, no line is laid") {
  const Triangle_surface input = folded_square(8);
  const Surface_projector projector(input);
  Snap_options options;
  options.lines = true;
  const auto on_lines = [&] {
    Quad_mesh far = shifted_grid(8, 0.3);
    Vertex_constraints found;
    return snap_to_features(far, projector, options, found).on_lines;
  };
  options.line_reach = 0.1;
  CHECK(on_lines() == 0);
  options.line_reach = 0.8;
  options.feature_angle = 100;
  CHECK(on_lines() == 0);
}

TEST_CASE(
    "every edge that crosses a sharp edge gets an end on it, which then runs along edges and diagonals") {
  const int n = 10;
  const Triangle_surface input = folded_square(n);
  const Surface_projector projector(input);
  // The grid's lines cross the fold obliquely: by 1.8 steps from one end to the other.
  const Quad_mesh before = shifted_grid(n, -0.9, 0.18);
  Snap_options options;
  options.crossings = false;
  Quad_mesh near = before, all = before;
  Vertex_constraints first, second;
  snap_to_features(near, projector, options, first);
  turn_to_features(near, first);
  options.crossings = true;
  const Snap_report report = snap_to_features(all, projector, options, second);
  CHECK(report.missed_crossings == 0);
  CHECK(turn_to_features(all, second) > 0);
  CHECK(*quad_statistics(all, &input).folded_sharp_edges >
        *quad_statistics(near, &input).folded_sharp_edges + 0.1);
  CHECK(*quad_statistics(all, &input).folded_sharp_edges > 0.75); // not at the ends, on the boundary
  const std::vector<char> on = on_curves(second, all);
  for (const Quad& q : all.quads)
    for (int i = 0; i < 4; ++i) {
      const int a = q[i], b = q[(i + 1) % 4];
      const bool inside =
          all.points[a].y() > 0 && all.points[a].y() < n && all.points[b].y() > 0 && all.points[b].y() < n;
      if (inside && !on[a] && !on[b]) CHECK((all.points[a].z() < 0) == (all.points[b].z() < 0));
    }
  for (const Quad& q : all.quads)
    CHECK(scaled_jacobian(all.points[q[0]], all.points[q[1]], all.points[q[2]], all.points[q[3]]) >= 0.3);
}

TEST_CASE("quads begin where their diagonal lies on a sharp edge, and are the same quads") {
  const int n = 10;
  const Triangle_surface input = folded_square(n);
  Quad_mesh mesh = shifted_grid(n, -0.9, 0.18);
  Vertex_constraints found;
  snap_to_features(mesh, Surface_projector(input), {}, found);
  const Quad_mesh before = mesh;
  const std::vector<char> on = on_curves(found, mesh);
  const int turned = turn_to_features(mesh, found);
  int along = 0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    Quad quad = mesh.quads[q];
    along += on[quad[0]] && on[quad[2]];
    CHECK_FALSE((on[quad[1]] && on[quad[3]] && !on[quad[0]]));
    const auto first = std::find(quad.begin(), quad.end(), before.quads[q][0]);
    std::rotate(quad.begin(), first, quad.end());
    CHECK(quad == before.quads[q]);
  }
  CHECK(along == turned);
  CHECK(turned > 0);
}

TEST_CASE("vertices on a sharp edge slide along it while quads are relaxed, and never pass each other") {
  const int n = 10;
  const Triangle_surface input = folded_square(n);
  const Surface_projector projector(input);
  Quad_mesh mesh = shifted_grid(n, 0);
  const auto id = [&](int x, int y) { return y * (n + 1) + x; };
  // The middle line lies on the fold; its vertices are pushed together at one end.
  for (int y = 1; y < n; ++y) mesh.points[id(n / 2, y)].y() = 0.1 + 0.6 * y;
  Vertex_constraints constraints;
  constraints.curves.push_back(make_surface_curve({Point(0.5 * n, 0, 0), Point(0.5 * n, n, 0)}, false));
  constraints.curves[0].normals = {Point(-1, 0, 1).normalized()};
  for (int y = 1; y < n; ++y) constraints.places.push_back({id(n / 2, y), 0, mesh.points[id(n / 2, y)].y()});
  Vertex_constraints held;
  held.fixed.assign(mesh.points.size(), 0);
  for (int y = 1; y < n; ++y) held.fixed[id(n / 2, y)] = 1;
  Quad_mesh stiff = mesh;
  const auto slid = relax_quads(mesh, projector, constraints);
  const auto stood = relax_quads(stiff, projector, held);
  REQUIRE(slid);
  REQUIRE(stood);
  CHECK(slid->mean_after > stood->mean_after);
  for (int y = 1; y < n; ++y) {
    CHECK(mesh.points[id(n / 2, y)].x() == Approx(0.5 * n));
    CHECK(mesh.points[id(n / 2, y)].z() == Approx(0).margin(1e-12));
    CHECK(mesh.points[id(n / 2, y)].y() > mesh.points[id(n / 2, y - 1)].y());
  }
  CHECK(mesh.points[id(n / 2, 5)].y() > 3.5); // 3.1 before, 5 if even
}

TEST_CASE(
    "vertices that slide give the same bytes with one thread and with several, whatever quads they share") {
  const int n = 60;
  const Triangle_surface input = folded_square(n);
  const Surface_projector projector(input);
  const Quad_mesh mesh = shifted_grid(n, 0);
  Vertex_constraints constraints;
  constraints.curves.push_back(make_surface_curve({Point(0.5 * n, 0, 0), Point(0.5 * n, n, 0)}, false));
  constraints.curves[0].normals = {Point(-1, 0, 1).normalized()};
  // Every second vertex of the middle line slides, so neighbours on the curve share no quad, and pushed
  // together, so that they bound each other.
  for (int y = 2; y < n - 1; y += 2) constraints.places.push_back({y * (n + 1) + n / 2, 0, 0.55 * y + 0.2});
  Relax_options one, four;
  four.threads = 4;
  for (int run = 0; run < 5; ++run) {
    Quad_mesh a = mesh, b = mesh;
    REQUIRE(relax_quads(a, projector, constraints, one));
    REQUIRE(relax_quads(b, projector, constraints, four));
    CHECK(a.points == b.points);
  }
}

TEST_CASE("the arc length of a point of a curve is found again, on closed curves beyond the ends too") {
  const Surface_curve square = make_surface_curve(
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 0, 0)}, true);
  CHECK(square.length() == 4);
  CHECK(square.points.size() == 5); // equal neighbours are taken once
  for (int i = -20; i < 60; ++i) {
    const double t = 0.1 * i + 0.03;
    CHECK(square.nearest(square.at(t), t - 1.5, t + 1.5) == Approx(t));
    CHECK((square.at(t) - square.at(t + 4)).norm() < 1e-12);
  }
  const Surface_curve open = make_surface_curve({Point(0, 0, 0), Point(1, 0, 0), Point(1, 2, 0)}, false);
  CHECK(open.at(-1) == Point(0, 0, 0));
  CHECK(open.at(5) == Point(1, 2, 0));
  CHECK(open.tangent(2) == Point(0, 1, 0));
  CHECK(open.nearest(Point(0.5, 1, 0), 0, 1) == Approx(0.5)); // only as far as asked
  CHECK(open.nearest(Point(0.5, 1, 0), 1, 3) == Approx(2));
  const Surface_curve point = make_surface_curve({Point(1, 1, 1), Point(1, 1, 1)}, true);
  CHECK(point.at(7) == Point(1, 1, 1));
  CHECK(point.nearest(Point(0, 0, 0), 0, 1) == 0);
}

TEST_CASE("the run keeps sharp edges of the L-shape without inverting a quad") {
  const Result<Triangle_surface> surface = make_shape("l-shape", 5000);
  REQUIRE(surface);
  Quadrangulation_options options;
  options.quads = 1500;
  options.keep_features = false;
  const Result<Quadrangulation> suggested = quadrangulate(*surface, options);
  REQUIRE(suggested);
  // The same extrema for both: else the field would follow closed lines of sharp edges where these are kept.
  for (const Design_extremum& e : suggested->editor.design().extrema)
    options.extrema.push_back({suggested->editor.working_surface().points[e.vertex], e.is_maximum});
  options.keep_features = true;
  const Result<Quadrangulation> with = quadrangulate(*surface, options);
  REQUIRE(with);
  CHECK(with->features.vertices > 40);
  CHECK(with->relaxation.inverted_after == 0);
  options.keep_features = false;
  const Result<Quadrangulation> without = quadrangulate(*surface, options);
  REQUIRE(without);
  CHECK(without->features.vertices == 0);
  // Only positions differ, and where quads begin.
  REQUIRE(with->mesh.quads.size() == without->mesh.quads.size());
  for (std::size_t q = 0; q < with->mesh.quads.size(); ++q) {
    Quad quad = with->mesh.quads[q];
    std::rotate(quad.begin(), std::find(quad.begin(), quad.end(), without->mesh.quads[q][0]), quad.end());
    CHECK(quad == without->mesh.quads[q]);
  }
  CHECK(with->features.missed_corners == 0);
  const double folded = *quad_statistics(with->mesh, &*surface).folded_sharp_edges;
  CHECK(folded > 0.95);
  CHECK(folded > *quad_statistics(without->mesh, &*surface).folded_sharp_edges + 0.3);
  CHECK(with->mesh.points != without->mesh.points);
}
