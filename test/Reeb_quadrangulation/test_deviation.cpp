// SPDX-License-Identifier: GPL-3.0-or-later
// Where quads do not keep a surface: exact on cubes, whose quads and distances are known.
#include <CGAL/Reeb_quadrangulation/deviation.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// The cube from 0 to 1 with n x n quads on each side.
Quad_mesh cube_of_quads(int n) {
  Quad_mesh mesh;
  const auto vertex = [&](const Point& p) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if ((mesh.points[v] - p).norm() < 1e-9) return int(v);
    mesh.points.push_back(p);
    return int(mesh.points.size()) - 1;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            Point p;
            p[axis] = high;
            p[(axis + 1) % 3] = double(u) / n;
            p[(axis + 2) % 3] = double(v) / n;
            return vertex(p);
          };
          Quad quad{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if (!high) std::reverse(quad.begin(), quad.end());
          mesh.quads.push_back(quad);
        }
  return mesh;
}

/// The same cube of triangles, moved to where the quads are.
Triangle_surface cube() {
  Triangle_surface surface = *make_shape("cube", 600);
  Eigen::AlignedBox3d box;
  for (const Point& p : surface.points) box.extend(p);
  for (Point& p : surface.points) p -= box.min();
  return surface;
}

} // namespace

TEST_CASE("quads on a cube's sides deviate by nothing and keep its twelve edges and eight corners") {
  const Result<Deviation> d = measure_deviation(cube_of_quads(4), cube());
  REQUIRE(d);
  CHECK(d->greatest_of_quads < 1e-12);
  CHECK(d->greatest_of_surface < 1e-12);
  CHECK(d->worst.empty());
  CHECK(d->corners == 8);
  CHECK(d->lost_corners.empty());
  CHECK(std::abs(d->sharp_length - 12) < 1e-9);
  CHECK(d->lost_sharp_length < 1e-9);
  CHECK(d->lost_sharp_edges.empty());
}

TEST_CASE("a corner that is pulled in is lost, the worst place, and told from the surface's side") {
  Quad_mesh quads = cube_of_quads(4);
  const auto corner = std::find_if(quads.points.begin(), quads.points.end(),
                                   [](const Point& p) { return (p - Point(1, 1, 1)).norm() < 1e-9; });
  REQUIRE(corner != quads.points.end());
  *corner = Point(0.9, 0.9, 0.9);
  const Result<Deviation> d = measure_deviation(quads, cube());
  REQUIRE(d);
  REQUIRE(d->lost_corners.size() == 1);
  CHECK((d->lost_corners[0] - Point(1, 1, 1)).norm() < 1e-9);
  REQUIRE(!d->worst.empty());
  CHECK(d->worst[0].on_surface);
  CHECK((d->worst[0].point - Point(1, 1, 1)).norm() < 1e-9);
  CHECK(d->worst[0].distance == d->greatest_of_surface);
  CHECK(d->greatest_of_surface <= 0.1 * std::sqrt(3.0) + 1e-12);
  CHECK(std::abs(d->greatest_of_quads - 0.1) < 1e-12); // the moved vertex is that far from three sides
  // What is near the corner counts for its quads, elsewhere there is nothing.
  for (std::size_t q = 0; q < quads.quads.size(); ++q) {
    const bool touches =
        std::count(quads.quads[q].begin(), quads.quads[q].end(), int(corner - quads.points.begin())) > 0;
    CHECK((d->of_quads[q] > 1e-9) == touches);
  }
  CHECK(d->lost_sharp_length > 0.2);
  CHECK(d->lost_sharp_length < 3.0);
}

TEST_CASE("what a mesh lacks is measured from the surface, and bad corners are passed over") {
  Quad_mesh quads = cube_of_quads(2);
  quads.points.push_back(Point::Constant(std::numeric_limits<double>::quiet_NaN()));
  quads.quads.push_back({0, 1, 2, int(quads.points.size()) - 1});
  quads.quads.push_back({0, 0, 1, 2});
  // Without the side z = 1.
  quads.quads.erase(std::remove_if(quads.quads.begin(), quads.quads.end(),
                                   [&](const Quad& q) {
                                     return std::all_of(q.begin(), q.end(), [&](int v) {
                                       return quads.points[v].z() > 1 - 1e-9;
                                     });
                                   }),
                    quads.quads.end());
  const Result<Deviation> d = measure_deviation(quads, cube());
  REQUIRE(d);
  CHECK(d->greatest_of_quads < 1e-12);
  CHECK(d->greatest_of_surface > 0.3); // the middle of the missing side
  CHECK(d->worst[0].on_surface);
  CHECK(d->of_quads.size() == quads.quads.size());
}

TEST_CASE("nothing to measure, and a cancelled measure, are refused") {
  struct Cancelled : Observer {
    void progress(const std::string&, double) override {}
    bool cancelled() const override { return true; }
  } observer;
  CHECK(measure_deviation(Quad_mesh(), cube()).error().code == Error_code::impossible_request);
  CHECK(measure_deviation(cube_of_quads(1), Triangle_surface()).error().code ==
        Error_code::impossible_request);
  Deviation_options options;
  options.observer = &observer;
  CHECK(measure_deviation(cube_of_quads(1), cube(), options).error().code == Error_code::cancelled);
}
