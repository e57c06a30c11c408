// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/Surface_editor.h"
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/prepare_surface.h>

#include "model_files.h"
#include "tiny_surfaces.h"

#include <Eigen/Geometry>

#include <algorithm>

using namespace CGAL::Reeb_quadrangulation;
using tiny::connected;

namespace {

double volume(const Triangle_surface& s) {
  double sum = 0;
  for (const Triangle& t : s.triangles) sum += s.points[t[0]].cross(s.points[t[1]]).dot(s.points[t[2]]) / 6;
  return sum;
}

double diagonal(const Triangle_surface& s) {
  Point low = s.points[0], high = low;
  for (const Point& p : s.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

double longest_edge(const Triangle_surface& s) {
  double longest = 0;
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    longest = std::max(longest, (s.points[s.target(h)] - s.points[s.source(h)]).norm());
  return longest;
}

// The connectivity that was kept up in place is the one computed anew; boundary vertices start at the
// boundary.
void require_consistent(const Triangle_surface& s) {
  Triangle_surface fresh = s;
  const auto result = fresh.connect();
  if (!result) INFO(result.error().message);
  REQUIRE(bool(result));
  REQUIRE(fresh.opposite == s.opposite);
  bool right = true;
  for (int v = 0; v < s.number_of_vertices(); ++v) {
    const int h = s.outgoing[v], g = fresh.outgoing[v];
    right = right && (h < 0) == (g < 0);
    if (h >= 0 && g >= 0) right = right && s.source(h) == v && s.is_boundary(h) == fresh.is_boundary(g);
  }
  REQUIRE(right);
}

// Same topology, same place: what every preparation promises.
void require_same_surface(const Triangle_surface& before, const Prepared_surface& after, double tolerance) {
  const Triangle_surface& s = after.surface;
  require_consistent(s);
  CHECK(euler_characteristic(s) == euler_characteristic(before));
  CHECK(connected_components(s).second == connected_components(before).second);
  CHECK(boundary_loops(s).size() == boundary_loops(before).size());
  const double size = diagonal(before);
  CHECK(area(s) == Approx(area(before)).epsilon(10 * tolerance));
  CHECK(std::abs(volume(s) - volume(before)) <= tolerance * size * size * size);
  const Surface_projector projector(before);
  double farthest = 0;
  for (const Point& p : s.points) farthest = std::max(farthest, projector.closest(p).squared_distance);
  CHECK(std::sqrt(farthest) <= tolerance * size);
  REQUIRE(after.input_vertex.size() == s.points.size());
  REQUIRE(after.working_vertex.size() == before.points.size());
  bool vertices = true;
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    const int w = after.input_vertex[v];
    if (w >= 0) vertices = vertices && after.working_vertex[w] == int(v) && before.points[w] == s.points[v];
  }
  CHECK(vertices);
  CHECK(after.report.faces_before == before.number_of_faces());
  CHECK(after.report.faces_after == s.number_of_faces());
  CHECK(after.report.min_angle_after == smallest_angle(s));
}

bool has_chord(const Triangle_surface& s) {
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    if (!s.is_boundary(h) && s.is_boundary(s.outgoing[s.source(h)]) && s.is_boundary(s.outgoing[s.target(h)]))
      return true;
  return false;
}

// Triangles with an angle below 5 degrees.
int poor_triangles(const Triangle_surface& s) {
  int count = 0;
  for (const Triangle& t : s.triangles) {
    const Triangle_surface one{{s.points[t[0]], s.points[t[1]], s.points[t[2]]}, {{0, 1, 2}}, {}, {}};
    count += smallest_angle(one) < 5;
  }
  return count;
}

// The unit square as a fan of needles from one corner: n points along the two opposite sides.
Triangle_surface needle_square(int n) {
  Triangle_surface s;
  s.points.emplace_back(0, 0, 0);
  for (int i = 0; i <= n; ++i) s.points.emplace_back(1, double(i) / n, 0);
  for (int i = n - 1; i >= 0; --i) s.points.emplace_back(double(i) / n, 1, 0);
  for (int i = 1; i + 1 < int(s.points.size()); ++i) s.triangles.push_back({0, i, i + 1});
  return connected(std::move(s));
}

// A prism over a regular n-gon whose lids are fans from a corner, as a modeller writes them.
Triangle_surface prism(int n) {
  Triangle_surface s;
  const double tau = 2 * std::acos(-1.0);
  for (double z : {0.0, 0.3})
    for (int i = 0; i < n; ++i) s.points.emplace_back(std::cos(tau * i / n), std::sin(tau * i / n), z);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    s.triangles.push_back({i, j, n + j});
    s.triangles.push_back({i, n + j, n + i});
  }
  for (int i = 1; i + 1 < n; ++i) {
    s.triangles.push_back({0, i + 1, i});
    s.triangles.push_back({n, n + i, n + i + 1});
  }
  return connected(std::move(s));
}

Prepared_surface prepared(const Triangle_surface& s, const Prepare_options& options = {}) {
  auto result = prepare_surface(s, options);
  REQUIRE(bool(result));
  return *result;
}

} // namespace

TEST_CASE("a surface that needs nothing is left as it is") {
  for (const Triangle_surface& s : {tiny::tetrahedron(), tiny::octahedron(), tiny::torus(12, 8)}) {
    const Prepared_surface p = prepared(s);
    CHECK(p.surface.triangles == s.triangles);
    CHECK(p.surface.points == s.points);
    CHECK(p.report.min_angle_after == p.report.min_angle_before);
    require_same_surface(s, p, 0);
  }
}

TEST_CASE("the smallest angle is in degrees") {
  CHECK(smallest_angle(tiny::tetrahedron()) == Approx(60));
  Triangle_surface s{{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}, {}, {}};
  CHECK(smallest_angle(s) == Approx(45));
}

TEST_CASE("chords of the boundary are split, and no triangle lies on the boundary with all its corners") {
  // Two triangles that share a chord; a single triangle; a fan.
  Triangle_surface two{
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}, {}, {}};
  Triangle_surface one{{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}, {}, {}};
  for (const Triangle_surface& s :
       {connected(two), connected(one), needle_square(5), tiny::open_cylinder(5, 1)}) {
    const Prepared_surface p = prepared(s);
    require_same_surface(s, p, 1e-12);
    CHECK_FALSE(has_chord(p.surface));
    for (const Triangle& t : p.surface.triangles)
      CHECK_FALSE(std::all_of(t.begin(), t.end(),
                              [&](int v) { return p.surface.is_boundary(p.surface.outgoing[v]); }));
  }
  CHECK(prepared(connected(two)).report.chords == 1);
  Prepare_options keep;
  keep.split_chords = false;
  CHECK(prepared(connected(two), keep).report.chords == 0);
}

TEST_CASE("bisection makes edges short and keeps angles at least half as large") {
  for (const Triangle_surface& s : {tiny::tetrahedron(), tiny::octahedron(), tiny::open_cylinder(6, 2)}) {
    Prepare_options options;
    options.max_edge = 0.17;
    options.flip = false;
    options.split_chords = false;
    const Prepared_surface p = prepared(s, options);
    require_same_surface(s, p, 1e-12);
    CHECK(longest_edge(p.surface) <= 0.17);
    CHECK(p.report.bisections > 100);
    CHECK(p.report.min_angle_after >= p.report.min_angle_before / 2 - 1e-9);
  }
}

TEST_CASE("bisection stops at the number of faces that is allowed") {
  Prepare_options options;
  options.max_edge = 1e-6;
  options.max_faces = 500;
  const Prepared_surface p = prepared(tiny::tetrahedron(), options);
  CHECK(p.surface.number_of_faces() <= 500);
  CHECK(p.surface.number_of_faces() >= 499);
  require_same_surface(tiny::tetrahedron(), p, 1e-12);
}

TEST_CASE("needles on flat lids become good triangles, and the sharp edges stay") {
  const Triangle_surface s = prism(40);
  Prepare_options options;
  options.max_edge = 0.3;
  const Prepared_surface p = prepared(s, options);
  require_same_surface(s, p, 1e-12);
  CHECK(p.report.flips > 0);
  CHECK(p.report.min_angle_before < 5);
  CHECK(p.report.min_angle_after > 20);
  // Every edge of the rims is still covered by edges: none was flipped away.
  double rim = 0;
  for (int h = 0; h < p.surface.number_of_halfedges(); ++h) {
    const Point a = p.surface.points[p.surface.source(h)], b = p.surface.points[p.surface.target(h)];
    const auto on_rim = [](const Point& q) {
      return q.head<2>().norm() > std::cos(std::acos(-1.0) / 40) - 1e-9;
    };
    if (a.z() == b.z() && on_rim(a) && on_rim(b)) rim += (b - a).norm() / 2;
  }
  CHECK(rim == Approx(2 * 40 * 2 * std::sin(std::acos(-1.0) / 40)));
}

TEST_CASE("very short edges are collapsed where the link allows it") {
  // A torus of which every vertex of one ring is doubled at a tiny distance.
  Triangle_surface s = tiny::torus(9, 7);
  internal::Surface_editor editor(s);
  const int halfedges = s.number_of_halfedges();
  for (int h = 0; h < halfedges; h += 17) {
    const Point p = s.points[s.source(h)] * (1 - 1e-7) + s.points[s.target(h)] * 1e-7;
    editor.split_edge(h, p);
  }
  require_consistent(s);
  Prepare_options options;
  options.min_edge = 1e-5;
  const Prepared_surface p = prepared(s, options);
  require_same_surface(s, p, 1e-6);
  CHECK(p.report.collapses == (halfedges + 16) / 17);
  CHECK(p.surface.number_of_faces() == 2 * 9 * 7);
  CHECK(p.report.min_angle_after > 10);
}

TEST_CASE("a collapse that would change the topology is refused") {
  // On a 3 x 3 torus every edge lies on a closed path of three edges without a face.
  Triangle_surface s = tiny::torus(3, 3);
  internal::Surface_editor editor(s);
  for (int h = 0; h < s.number_of_halfedges(); ++h) CHECK_FALSE(editor.can_collapse(h));
  Triangle_surface t = tiny::tetrahedron();
  internal::Surface_editor tetrahedron(t);
  for (int h = 0; h < t.number_of_halfedges(); ++h) {
    CHECK_FALSE(tetrahedron.can_collapse(h));
    CHECK_FALSE(tetrahedron.can_flip(h));
  }
}

TEST_CASE("random local changes keep the connectivity right") {
  for (Triangle_surface s : {tiny::torus(6, 5), tiny::open_cylinder(6, 3), tiny::octahedron()}) {
    const int chi = euler_characteristic(s);
    const std::size_t loops = boundary_loops(s).size();
    internal::Surface_editor editor(s);
    std::uint32_t state = 1;
    int flips = 0, collapses = 0;
    for (int i = 0; i < 3000; ++i) {
      state = state * 1664525u + 1013904223u;
      const int h = int((state >> 8) % unsigned(s.number_of_halfedges()));
      if (editor.is_dead(h / 3)) continue;
      const int kind = int(state >> 30);
      if (kind == 0 && s.number_of_faces() < 400)
        editor.split_edge(h, 0.5 * (s.points[s.source(h)] + s.points[s.target(h)]));
      if (kind == 1 && s.number_of_faces() < 400) editor.split_face(h / 3, s.points[s.source(h)]);
      if (kind >= 2 && editor.can_flip(h)) {
        editor.flip(h);
        ++flips;
      } else if (kind == 3 && editor.can_collapse(h)) {
        editor.collapse(h);
        ++collapses;
      }
      if (i % 500 == 0 && collapses == 0) require_consistent(s);
    }
    CHECK(flips > 100);
    editor.compact();
    require_consistent(s);
    CHECK(euler_characteristic(s) == chi);
    CHECK(boundary_loops(s).size() == loops);
  }
}

TEST_CASE("the same surface is prepared to the same bytes") {
  Prepare_options options;
  options.max_edge = 0.1;
  const Prepared_surface a = prepared(prism(17), options), b = prepared(prism(17), options);
  CHECK(a.surface.points == b.surface.points);
  CHECK(a.surface.triangles == b.surface.triangles);
}

TEST_CASE("an observer can stop the preparation") {
  struct Stop : Observer {
    bool cancelled() const override { return true; }
  } stop;
  Prepare_options options;
  options.max_edge = 0.001;
  const auto result = prepare_surface(tiny::octahedron(), options, &stop);
  REQUIRE_FALSE(bool(result));
  CHECK(result.error().code == Error_code::cancelled);
}

TEST_CASE("CAD models get usable triangles", "[models]") {
  for (const char* name : {"fandisk.obj", "block.off", "casting.off", "joint_cad.off", "anchor_g4.off",
                           "coupling_g9.off", "helmet_g3.off", "plane_27holes.obj", "holes_7loops.off"}) {
    const std::optional<Triangle_surface> found = model(name);
    if (!found) continue;
    const Triangle_surface& s = *found;
    INFO(name);
    Prepare_options options;
    options.max_edge = std::sqrt(area(s) / 3000);
    options.min_edge = 1e-3 * options.max_edge;
    const Prepared_surface p = prepared(s, options);
    require_same_surface(s, p, 2e-4);
    CHECK(longest_edge(p.surface) <= options.max_edge * (1 + 1e-9));
    CHECK_FALSE(has_chord(p.surface));
    if (p.report.min_angle_before < 1) CHECK(p.report.min_angle_after > p.report.min_angle_before);
  }
}

TEST_CASE("on scanned models little is done", "[models]") {
  for (const char* name : {"rocker_arm.obj", "turbineblade_200k.ply", "camelhead.off"}) {
    const std::optional<Triangle_surface> found = model(name);
    if (!found) continue;
    const Triangle_surface& s = *found;
    const double target = std::sqrt(area(s) / 3000);
    Prepare_options options;
    options.max_edge = target;
    options.min_edge = 1e-3 * target;
    const Prepared_surface p = prepared(s, options);
    INFO(name);
    require_same_surface(s, p, 2e-4);
    // Fewer poor triangles, and no more work than the poor and long ones ask for.
    CHECK(poor_triangles(p.surface) < poor_triangles(s));
    CHECK(p.report.flips < s.number_of_faces() / 10);
  }
}
