// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_samples.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/stitch_patches.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace tiny;
using namespace CGAL::Reeb_quadrangulation;
using Catch::Contains;

namespace {

double volume(const Quad_mesh& mesh) {
  double v = 0;
  for (const Quad& q : mesh.quads)
    for (int i : {1, 2}) v += mesh.points[q[0]].dot(mesh.points[q[i]].cross(mesh.points[q[i + 1]])) / 6;
  return v;
}

/// A closed mesh that passes its certificate.
Stitched_patches closed(const Quad_mesh& patches, int euler, const Stitch_patches_options& options = {}) {
  const auto stitched = stitch_patches(patches, options);
  INFO((stitched ? "" : stitched.error().message));
  REQUIRE(stitched);
  const Certificate certificate = certify({stitched->mesh});
  INFO(to_text(certificate));
  CHECK(certificate.passed);
  CHECK(certificate.check("watertight").measured == 0);
  CHECK(certificate.check("no_inverted_quads").measured == 0);
  REQUIRE(certificate.components.size() == 1);
  CHECK(certificate.components[0].euler_characteristic() == euler);
  CHECK(volume(stitched->mesh) > 0);
  CHECK(stitched->parent.size() == stitched->mesh.quads.size());
  CHECK(stitched->components == std::vector<std::pair<int, int>>{{euler, 0}});
  return *stitched;
}

Error refused(const Quad_mesh& patches, const Stitch_patches_options& options = {}) {
  const auto stitched = stitch_patches(patches, options);
  REQUIRE(!stitched);
  return stitched.error();
}

Quad_mesh cube_of_faces(const std::vector<int>& counts, double gap = 0) {
  Quad_mesh all;
  for (int axis = 0; axis < 3; ++axis)
    for (bool upper : {false, true}) {
      Quad_mesh face = cube_face(axis, upper, counts[4 * axis + 2 * upper], counts[4 * axis + 2 * upper + 1]);
      for (Point& p : face.points) p[axis] += upper ? gap : -gap;
      all = together(all, face);
    }
  return all;
}

} // namespace

TEST_CASE("halves of a torus with equal samples close without moving a vertex") {
  const Quad_mesh halves = torus_halves(10, 10);
  const Stitched_patches s = closed(halves, 0);
  CHECK(s.t_junctions == 0);
  CHECK(s.extraordinary.empty());
  CHECK(s.mesh.quads.size() == halves.quads.size());
  CHECK(s.mesh.points.size() == halves.points.size() - 20);
  CHECK(s.largest_step < 1e-15);
  CHECK(s.relaxation.moved_vertices == 0);
}

TEST_CASE("halves of a torus with unequal samples close as quads alone") {
  for (const auto& [some, others] : {std::pair(8, 16), std::pair(8, 12), std::pair(9, 14), std::pair(7, 12),
                                     std::pair(5, 20), std::pair(12, 13)}) {
    INFO(some << " and " << others << " around the tube");
    const Stitched_patches s = closed(torus_halves(some, others), 0);
    CHECK(s.t_junctions == 2 * (others - some));
    CHECK(s.mesh.quads.size() > std::size_t(8 * (some + others)));
  }
}

TEST_CASE("rims whose samples are offset meet sample for sample") {
  for (double offset : {0.2, 0.35, 0.5, 0.7}) {
    INFO(offset << " of an edge");
    const Stitched_patches s = closed(torus_halves(12, 12, offset), 0);
    CHECK(s.t_junctions == 0);
    CHECK(s.extraordinary.empty());
  }
  closed(torus_halves(8, 12, 0.4), 0);
}

TEST_CASE("a patch that is turned around is turned back, as are quads of one patch that disagree") {
  const double pi = std::acos(-1.0);
  const Quad_mesh some = torus_part(0, pi, 8, 8), others = torus_part(pi, 2 * pi, 8, 12);
  const Stitched_patches straight = closed(together(some, others), 0);
  CHECK(straight.turned == std::vector<char>{0, 0});
  const Stitched_patches second = closed(together(some, turned_around(others)), 0);
  CHECK(second.turned == std::vector<char>{0, 1});
  CHECK(second.mesh.points.size() == straight.mesh.points.size());
  CHECK(closed(together(turned_around(some), turned_around(others)), 0).turned == std::vector<char>{1, 1});
  Quad_mesh mixed = together(some, others);
  for (std::size_t q = 1; q < mixed.quads.size(); q += 3) std::swap(mixed.quads[q][1], mixed.quads[q][3]);
  CHECK(closed(mixed, 0).mesh.points.size() == straight.mesh.points.size());
}

TEST_CASE("six faces of a cube close, whatever their counts") {
  CHECK(closed(cube_of_faces({4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4}), 2).t_junctions == 0);
  closed(cube_of_faces({4, 4, 8, 8, 4, 4, 4, 4, 4, 4, 4, 4}), 2);
  closed(cube_of_faces({3, 4, 5, 6, 7, 8, 9, 4, 5, 3, 6, 8}), 2);
  closed(cube_of_faces({3, 4, 5, 6, 7, 8, 9, 4, 5, 3, 6, 8}, 0.02), 2);
  closed(cube_of_faces({1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 1, 3}), 2);
}

TEST_CASE(
    "a side of one patch meets the sides of two, of which neither has a vertex at the end of the other") {
  // A tube of which one half is whole and the other in two parts, whose common rim meets the middle of an
  // edge.
  const double pi = std::acos(-1.0);
  const auto part = [&](double from, double to, int n, int along, double low, double high) {
    return quad_grid(along, n, false, [=](double s, double t) {
      const double a = from + t * (to - from);
      return Point(std::cos(a), std::sin(a), high + s * (low - high));
    });
  };
  Quad_mesh all = part(0, pi, 8, 5, 0, 2);
  all = together(all, part(pi, 2 * pi, 8, 3, 0, 0.97));
  all = together(all, part(pi, 2 * pi, 7, 4, 0.97, 2));
  Stitch_patches_options options;
  options.may_stay_open = true;
  const auto tube = stitch_patches(all, options);
  REQUIRE(tube);
  CHECK(tube->components == std::vector<std::pair<int, int>>{{0, 2}});
  Certificate_input input{tube->mesh};
  input.predicted_components = tube->components;
  const Certificate certificate = certify(input);
  INFO(to_text(certificate));
  CHECK(certificate.passed);
  CHECK(certificate.check("no_inverted_quads").measured == 0);
}

TEST_CASE("a gap narrower than an edge closes, a wider one is refused with its place") {
  closed(torus_halves(12, 12, 0, 0.03), 0);
  closed(torus_halves(8, 13, 0, 0.05), 0);
  const Quad_mesh apart = torus_halves(12, 12, 0, 0.6);
  const Error error = refused(apart);
  CHECK(error.code == Error_code::impossible_request);
  CHECK_THAT(error.message, Contains("a rim meets no other, at (") && Contains("away"));
  REQUIRE(error.element == Element_kind::vertex);
  CHECK(error.index >= 0);
  CHECK(error.index < int(apart.points.size()));
}

TEST_CASE("rims that meet nothing are the boundary only where that is asked for") {
  const double pi = std::acos(-1.0);
  const Quad_mesh bend = together(torus_part(0, 1, 4, 8), torus_part(1, pi, 4, 11));
  CHECK_THAT(refused(bend).message, Contains("meets no other"));
  Stitch_patches_options options;
  options.may_stay_open = true;
  const auto open = stitch_patches(bend, options);
  REQUIRE(open);
  CHECK(open->components == std::vector<std::pair<int, int>>{{0, 2}});
  // A hole of one quad is no slit.
  Quad_mesh holed = quad_torus(10, 8);
  holed.quads.erase(holed.quads.begin() + 17);
  const auto kept = stitch_patches(holed, options);
  REQUIRE(kept);
  CHECK(kept->components == std::vector<std::pair<int, int>>{{-1, 1}});
  CHECK(kept->mesh.quads.size() == holed.quads.size());
  holed = quad_torus(10, 8);
  for (int q : {25, 17}) holed.quads.erase(holed.quads.begin() + q); // narrower than its quads are long
  const auto wide = stitch_patches(holed, options);
  REQUIRE(wide);
  CHECK(wide->mesh.quads.size() == holed.quads.size());
}

TEST_CASE("a patch that is narrower than its edges are long does not merge with itself") {
  // A band of two quads across, each a tenth as wide as long.
  const Quad_mesh band = quad_grid(12, 2, true, [](double s, double t) {
    const double a = 2 * std::acos(-1.0) * s;
    return Point(std::cos(a), std::sin(a), 0.1 * t);
  });
  Stitch_patches_options options;
  options.may_stay_open = true;
  const auto open = stitch_patches(band, options);
  REQUIRE(open);
  CHECK(open->mesh.quads == band.quads);
  CHECK(open->components == std::vector<std::pair<int, int>>{{0, 2}});
}

TEST_CASE("patches that share a vertex are joined along their rims all the same") {
  Quad_mesh halves = torus_halves(10, 15);
  const int first = 8 * 10, other = 9 * 10; // the same point
  REQUIRE((halves.points[first] - halves.points[other]).norm() < 1e-12);
  for (Quad& q : halves.quads)
    for (int& v : q)
      if (v == other) v = first;
  closed(halves, 0);
}

TEST_CASE("what is no patch of quads is refused by its element") {
  Quad_mesh bad = quad_cube();
  bad.quads[2][1] = 17;
  CHECK(refused(bad).element == Element_kind::face);
  CHECK(refused(bad).index == 2);
  bad = quad_cube();
  bad.quads[3][2] = bad.quads[3][0];
  CHECK_THAT(refused(bad).message, Contains("twice"));
  bad = quad_cube();
  bad.points.push_back(Point(2, 2, 2));
  bad.points.push_back(Point(2, 2, 3));
  bad.quads.push_back({0, 1, 8, 9});
  CHECK_THAT(refused(bad).message, Contains("more than two quads, at (0, 0, 0)"));
  CHECK_THAT(refused(quad_moebius(9)).message, Contains("one-sided"));
  CHECK_THAT(refused(Quad_mesh()).message, Contains("no quad"));
}

TEST_CASE("patches of a one-sided surface are refused") {
  // A Moebius band in three parts, each of which has two sides.
  const Quad_mesh band = quad_moebius(9);
  Quad_mesh parts;
  for (int k = 0; k < 3; ++k) {
    Quad_mesh part{band.points, {band.quads.begin() + 3 * k, band.quads.begin() + 3 * k + 3}};
    parts = together(parts, part);
  }
  Stitch_patches_options options;
  options.may_stay_open = true;
  CHECK_THAT(refused(parts, options).message, Contains("one-sided"));
}

TEST_CASE("quads know of which patch they are, and patches are counted by their common edges") {
  const Quad_mesh halves = torus_halves(8, 12);
  const std::vector<int> patch = patches_of_quads(halves);
  CHECK(std::count(patch.begin(), patch.end(), 0) == 64);
  CHECK(std::count(patch.begin(), patch.end(), 1) == 96);
  const Stitched_patches s = closed(halves, 0);
  for (std::size_t q = 0; q < s.parent.size(); ++q)
    CHECK(s.patch_of_quad[q] == patch[std::size_t(s.parent[q])]);
}

TEST_CASE("on their surface stitched patches are relaxed") {
  const Triangle_surface surface = [] {
    Triangle_surface s = triangulated(quad_torus(48, 32));
    REQUIRE(s.connect());
    return s;
  }();
  const Surface_projector projector(surface);
  Stitch_patches_options options;
  options.relaxation = Stitch_relaxation::all;
  const auto s = stitch_patches(torus_halves(8, 12), options, &projector);
  REQUIRE(s);
  CHECK(s->relaxation.moved_vertices > 0);
  const Certificate certificate = certify({s->mesh, &surface});
  INFO(to_text(certificate));
  CHECK(certificate.passed);
  for (const Point& p : s->mesh.points) CHECK(projector.closest(p).squared_distance < 1e-20);
}
