// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics of meshes whose numbers are known by hand.
#include "tiny_quads.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include <nlohmann/json.hpp>

#include <limits>
#include <numeric>

using namespace CGAL::Reeb_quadrangulation;

namespace {

Mesh_statistics of_quad(Point a, Point b, Point c, Point d) {
  return quad_statistics({{a, b, c, d}, {{0, 1, 2, 3}}});
}

template <class Histogram> int total(const Histogram& histogram) {
  return std::accumulate(histogram.begin(), histogram.end(), 0);
}

} // namespace

TEST_CASE("The cube has eight extraordinary vertices and perfect quads") {
  const Mesh_statistics s = quad_statistics(tiny::quad_cube());
  CHECK(s.vertices == 8);
  CHECK(s.edges == 12);
  CHECK(s.quads == 6);
  CHECK(s.extraordinary_vertices == 8);
  CHECK(s.largest_valence_difference == 1);
  CHECK(s.interior_valences == std::map<int, int>{{3, 8}});
  CHECK(s.angle.mean == Approx(90));
  CHECK(s.angle_deviation.maximum == Approx(0).margin(1e-12));
  CHECK(s.scaled_jacobian.minimum == Approx(1));
  CHECK(s.scaled_jacobian_histogram.back() == 6);
  CHECK(s.edge_length.minimum == 1);
  CHECK(s.edge_length.maximum == 1);
  CHECK(s.quad_area.mean == Approx(1));
  CHECK(s.quad_area_ratio == Approx(1));
  CHECK_FALSE(s.undersampled_area);
}

TEST_CASE("Boundary vertices are regular at valence 3, interior ones at 4") {
  CHECK(quad_statistics(tiny::quad_torus(8, 6)).extraordinary_vertices == 0);
  CHECK(quad_statistics(tiny::quad_cylinder(6, 3)).extraordinary_vertices == 0);
  CHECK(of_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)).extraordinary_vertices == 4);
}

TEST_CASE("A rhombus of 60 degrees has scaled Jacobian sin 60") {
  const double h = std::sqrt(3.0) / 2;
  const Mesh_statistics s = of_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1.5, h, 0), Point(0.5, h, 0));
  CHECK(s.scaled_jacobian.mean == Approx(h));
  CHECK(s.angle.minimum == Approx(60));
  CHECK(s.angle.maximum == Approx(120));
  CHECK(s.angle.mean == Approx(90));
  CHECK(s.angle_deviation.mean == Approx(30));
  CHECK(s.quad_area.mean == Approx(h));
}

TEST_CASE("The scaled Jacobian knows no scale and no place") {
  const auto jacobian = [](double scale, double shift) {
    const auto at = [&](double x, double y, double z) -> Point {
      return scale * Point(x, y, z) + Point(shift, shift, 0);
    };
    return of_quad(at(0, 0, 0), at(1, 0.25, 0), at(1.5, 1, 0.5), at(0, 1, 0)).scaled_jacobian.minimum;
  };
  CHECK(jacobian(1, 0) > 0.5);
  CHECK(jacobian(1, 0) < 1);
  for (double scale : {1e-150, 1e-3, 100.0, 1e150}) CHECK(jacobian(scale, 0) == Approx(jacobian(1, 0)));
  CHECK(jacobian(1, 1024) == Approx(jacobian(1, 0)));
}

TEST_CASE("An arrow has a negative scaled Jacobian, a warped quad a smaller mean angle") {
  // At the reflex corner both sides make an angle of 2 atan(1/4) with the diagonal's ends.
  const Mesh_statistics arrow = of_quad(Point(0, 0, 0), Point(1, 0, 0), Point(0.2, 0.2, 0), Point(0, 1, 0));
  const double cosine = (0.8 * -0.2 - 0.2 * 0.8) / (0.8 * 0.8 + 0.2 * 0.2);
  CHECK(arrow.scaled_jacobian.minimum == Approx(-std::sqrt(1 - cosine * cosine)));
  CHECK(arrow.inverted_quads == 1);
  const Mesh_statistics warped = of_quad(Point(0, 0, 0), Point(1, 0, 0.5), Point(1, 1, 0), Point(0, 1, 0.5));
  CHECK(warped.angle.mean == Approx(180 / std::acos(-1.0) * std::acos(0.2)));
}

TEST_CASE("Histograms count every quad and every corner once, ends included") {
  for (const Quad_mesh& mesh : {tiny::quad_torus(9, 7), tiny::quad_cube(), tiny::quad_moebius(11)}) {
    const Mesh_statistics s = quad_statistics(mesh);
    CHECK(total(s.scaled_jacobian_histogram) == s.quads);
    CHECK(total(s.angle_histogram) == 4 * s.quads);
  }
  // Angles of 0 and 180 degrees: the flat quad 0, 1, 3, 2 on a line.
  const Mesh_statistics flat = of_quad(Point(0, 0, 0), Point(1, 0, 0), Point(3, 0, 0), Point(2, 0, 0));
  CHECK(flat.angle_histogram.front() == 2);
  CHECK(flat.angle_histogram.back() == 2);
  CHECK(flat.scaled_jacobian_histogram[10] == 1); // [0, 0.1)
  CHECK(flat.inverted_quads == 1);
}

TEST_CASE("Quads that cannot be measured are skipped and counted") {
  Quad_mesh mesh = tiny::quad_cube();
  mesh.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  mesh.quads.push_back({0, 1, 2, 8});
  mesh.quads.push_back({0, 1, 2, 9});
  mesh.quads.push_back({0, 1, 2, 2});
  mesh.quads.push_back({0, 1, 3, 2});
  const Mesh_statistics s = quad_statistics(mesh);
  CHECK(s.skipped_quads == 4);
  CHECK(s.quads == 6);
  CHECK(s.vertices == 8);
  CHECK(s.angle.mean == Approx(90));
}

TEST_CASE("An empty mesh has zeros, and its undersampled area is unknown") {
  const Triangle_surface input = tiny::tetrahedron();
  const Mesh_statistics s = quad_statistics({}, &input);
  CHECK(s.quads == 0);
  CHECK(s.scaled_jacobian.mean == 0);
  CHECK(s.quad_area_ratio == 0);
  CHECK_FALSE(s.undersampled_area);
}

TEST_CASE("A limb under one great quad is undersampled") {
  // A strip of 40 quads of side 1, then one of length 100: the mean area is 140/41, and 100 is above ten of
  // it.
  Quad_mesh mesh;
  for (int i = 0; i <= 41; ++i)
    for (int y : {0, 1}) mesh.points.emplace_back(i <= 40 ? i : 140, y, 0);
  for (int i = 0; i < 41; ++i) mesh.quads.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  const Triangle_surface input = [] {
    Triangle_surface s;
    for (int i = 0; i <= 140; ++i)
      for (int y : {0, 1}) s.points.emplace_back(i, y, 0);
    for (int i = 0; i < 140; ++i) {
      s.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
      s.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    return s;
  }();
  Statistics_options options;
  for (int samples : {0, 20000, 140}) {
    options.input_samples = samples;
    CHECK(quad_statistics(mesh, &input, options).undersampled_area.value() == Approx(100.0 / 140));
  }
  CHECK(quad_statistics(tiny::quad_cube(), &input).undersampled_area.value() == 0);
}

TEST_CASE("The sharp edges of a cube are covered by quads whose edges are there, and by no others") {
  const Quad_mesh cube = tiny::quad_cube();
  Triangle_surface surface{cube.points, {}, {}, {}};
  for (const Quad& q : cube.quads) {
    surface.triangles.push_back({q[0], q[1], q[2]});
    surface.triangles.push_back({q[0], q[2], q[3]});
  }
  CHECK(quad_statistics(cube, &surface).covered_sharp_edges.value() == Approx(1));
  // One corner moves inwards: its three edges of twelve are off by more than a twentieth but for their far
  // ends.
  Quad_mesh dented = cube;
  const Point centre = 0.5 * (cube.points[cube.quads[0][0]] + cube.points[cube.quads[0][2]]);
  Point& corner = dented.points[cube.quads[0][0]];
  corner += 0.3 * (centre - corner);
  const double covered = quad_statistics(dented, &surface).covered_sharp_edges.value();
  CHECK(covered > 0.7);
  CHECK(covered < 0.9);
  CHECK(quad_statistics(dented, &surface).folded_sharp_edges.value() == covered);
  Statistics_options options;
  options.feature_angle = 95; // those of a cube are not sharp
  CHECK_FALSE(quad_statistics(cube, &surface, options).covered_sharp_edges);
  CHECK_FALSE(quad_statistics(cube).covered_sharp_edges);
}

TEST_CASE("A sharp edge that runs along the diagonal of a quad is folded if the quad begins there") {
  // A square folded by a right angle along the diagonal from (0, 0, 0) to (2, 2, 0).
  Quad_mesh mesh{{{0, 0, 0}, {1, 1, -1.4}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3}}};
  const Triangle_surface surface{mesh.points, {{0, 1, 2}, {0, 2, 3}}, {}, {}};
  CHECK(quad_statistics(mesh, &surface).covered_sharp_edges.value() == 0);
  CHECK(quad_statistics(mesh, &surface).folded_sharp_edges.value() == Approx(1));
  mesh.quads[0] = {1, 2, 3, 0};
  CHECK(quad_statistics(mesh, &surface).folded_sharp_edges.value() < 0.2);
}

TEST_CASE("The JSON of the statistics can be read back; what is not finite is null") {
  // The second quad has no area: the area ratio is infinite.
  const Quad_mesh mesh{
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(2, 0, 0), Point(3, 0, 0)},
      {{0, 1, 2, 3}, {0, 1, 4, 5}}};
  const auto json = nlohmann::json::parse(to_json(quad_statistics(mesh)));
  CHECK(json.at("quads") == 2);
  CHECK(json.at("quad_area_ratio").is_null());
  CHECK(json.at("undersampled_area").is_null());
  CHECK(json.at("scaled_jacobian_histogram").size() == 20);
  CHECK(json.at("angle_histogram").size() == 18);
  CHECK(json.at("scaled_jacobian").at("maximum") == 1.0);
  CHECK(to_text(quad_statistics(mesh)).find("inverted quads") != std::string::npos);
}
