// SPDX-License-Identifier: GPL-3.0-or-later
// Relaxing never makes a mesh worse, whatever it is given.
#include <CGAL/Reeb_quadrangulation/finish_quads.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include "model_files.h"
#include "tiny_quads.h"
#include "tiny_surfaces.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// Moves every vertex by up to `amount` in each coordinate, and back to the surface.
void shake(Quad_mesh& mesh, const Surface_projector& projector, double amount, tiny::Random& random) {
  for (Point& p : mesh.points) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    p = projector.closest(p + amount * (2 * Point(x, y, z) - Point(1, 1, 1))).point;
  }
}

/// Relaxes with every sixth vertex held; the held ones keep their bits, and the measures do not fall.
void check_relaxing(Quad_mesh mesh, const Triangle_surface& s, bool anchors) {
  std::vector<char> fixed(mesh.points.size(), 0);
  for (std::size_t v = 0; anchors && v < fixed.size(); v += 6) fixed[v] = 1;
  const std::vector<Point> points = mesh.points;
  const Mesh_statistics before = quad_statistics(mesh);
  const auto report = relax_quads(mesh, Surface_projector(s), fixed);
  REQUIRE(report);
  const Mesh_statistics after = quad_statistics(mesh);
  CHECK(after.inverted_quads <= before.inverted_quads);
  if (after.inverted_quads == before.inverted_quads)
    CHECK(after.scaled_jacobian.mean >= before.scaled_jacobian.mean - 1e-9);
  if (before.inverted_quads == 0)
    CHECK(after.scaled_jacobian.minimum >= before.scaled_jacobian.minimum - 1e-9);
  CHECK(report->inverted_after == after.inverted_quads);
  CHECK(report->mean_after == Approx(after.scaled_jacobian.mean));
  CHECK(report->worst_after == Approx(after.scaled_jacobian.minimum));
  for (std::size_t v = 0; v < fixed.size(); ++v)
    if (fixed[v]) CHECK(mesh.points[v] == points[v]);
}

/// n x n quads above a square of side 8.
template <class Height> Quad_mesh plate(int n, const Height& height) {
  Quad_mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = 8.0 * i / n, y = 8.0 * j / n;
      mesh.points.emplace_back(x, y, height(x, y));
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      mesh.quads.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  return mesh;
}

} // namespace

TEST_CASE("a spike between the vertices gets one of them, held vertices stay, and no quad becomes poor") {
  const Point tip(4.5, 4.375, 1.5);
  const auto spike = [&](double x, double y) {
    return std::max(0.0, tip.z() * (1 - std::hypot(x - tip.x(), y - tip.y()) / 0.9));
  };
  const Triangle_surface s = tiny::connected(tiny::triangulated(plate(64, spike)));
  const Surface_projector projector(s);
  const Quad_mesh flat = plate(8, [](double, double) { return 0.0; });
  Quad_mesh relaxed = flat;
  REQUIRE(relax_quads(relaxed, projector));
  REQUIRE(tiny::distance_to_quads(tip, relaxed) > 0.8);
  Snap_options no_features;
  no_features.feature_angle = 0;
  const Result<Finished_quads> finished = finish_quads(flat, projector, {}, no_features);
  REQUIRE(finished);
  CHECK(tiny::distance_to_quads(tip, finished->mesh) < 0.5);
  const Mesh_statistics after = quad_statistics(finished->mesh);
  CHECK(after.scaled_jacobian.minimum > 0.35);
  CHECK(finished->relaxation.worst_after == Approx(after.scaled_jacobian.minimum));
  CHECK(finished->relaxation.mean_after == Approx(after.scaled_jacobian.mean));
  CHECK(finished->relaxation.inverted_after == 0);

  std::vector<int> all;
  for (int v = 0; v < int(flat.points.size()); ++v) all.push_back(v);
  const Result<Finished_quads> still = finish_quads(flat, projector, {}, no_features, nullptr, all);
  REQUIRE(still);
  CHECK(still->mesh.points == flat.points);
}

TEST_CASE("shaken a little or a lot, with anchors or without: the worst quad and the mean never get worse") {
  tiny::Random random(17);
  for (const auto& [name, quads, size] :
       {std::tuple("torus", tiny::quad_torus(16, 8), 0.3),
        std::tuple("cylinder", tiny::quad_cylinder(12, 8), 0.3),
        std::tuple("cube", tiny::subdivided(tiny::subdivided(tiny::quad_cube())), 0.25)}) {
    const Triangle_surface s = tiny::connected(tiny::triangulated(quads));
    const Surface_projector projector(s);
    for (const double amount : {0.0, 0.05, 0.1, 0.2, 0.4, 0.8})
      for (const bool anchors : {false, true}) {
        INFO(name << ", shaken by " << amount << (anchors ? ", with anchors" : ""));
        Quad_mesh mesh = quads;
        shake(mesh, projector, amount * size, random);
        check_relaxing(mesh, s, anchors);
      }
  }
}

TEST_CASE("inverted quads go to zero where some position of the vertices allows it") {
  tiny::Random random(23);
  for (const auto& [quads, size] : {std::pair(tiny::quad_torus(16, 8), 0.3),
                                    std::pair(tiny::subdivided(tiny::subdivided(tiny::quad_cube())), 0.25)}) {
    const Triangle_surface s = tiny::connected(tiny::triangulated(quads));
    const Surface_projector projector(s);
    for (int round = 0; round < 5; ++round) {
      Quad_mesh mesh = quads;
      shake(mesh, projector, size, random);
      REQUIRE(quad_statistics(mesh).inverted_quads > 10);
      REQUIRE(relax_quads(mesh, projector));
      CHECK(quad_statistics(mesh).inverted_quads == 0);
    }
  }
}

void check_pipeline(const std::string& name, Triangle_surface s) {
  INFO(name);
  REQUIRE(s.connect());
  Quadrangulation_options options;
  options.quads = 600;
  options.relax = false;
  const auto made = quadrangulate(s, options);
  REQUIRE(made);
  Quad_mesh mesh = made->mesh;
  const Surface_projector projector(s);
  for (Point& p : mesh.points) p = projector.closest(p).point;
  for (const bool anchors : {false, true}) check_relaxing(mesh, s, anchors);
}

TEST_CASE("built-in shapes: what the pipeline makes is not made worse either") {
  for (const char* name : {"hand", "bitorus", "twisted-bar"}) check_pipeline(name, *make_shape(name, 3000));
}

TEST_CASE("real meshes: what the pipeline makes is not made worse either", "[models]") {
  for (const char* name :
       {"rocker_arm_2500.obj", "cow.off", "spot_6k.obj", "kitten_6k.obj", "torso_open.off"})
    if (std::optional<Triangle_surface> s = model(name)) check_pipeline(name, std::move(*s));
}
