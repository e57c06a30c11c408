// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/adapt_quads.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include "tiny_quads.h"
#include "tiny_surfaces.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace CGAL::Reeb_quadrangulation;

namespace {

std::string faults(const Quad_mesh& mesh, const Triangle_surface& s, const std::map<int, int>& valences) {
  Certificate_options options;
  options.measure_shape = options.find_self_intersections = false;
  std::string text;
  for (const Certificate_check& check : certify({mesh, &s, valences}, options).checks)
    if (check.status == Check_status::failed && check.name != "no_inverted_quads" && check.name != "outward")
      text += check.name + ": " + check.message + "; ";
  return text;
}

double area(const Quad_mesh& mesh, const Quad& q) {
  return 0.5 * (mesh.points[q[2]] - mesh.points[q[0]]).cross(mesh.points[q[3]] - mesh.points[q[1]]).norm();
}

/// Rank correlation (Spearman) of two lists.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const auto ranks = [](const std::vector<double>& values) {
    std::vector<int> order(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = int(i);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
    std::vector<double> rank(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = double(i);
    return rank;
  };
  const std::vector<double> a = ranks(x), b = ranks(y);
  const double mean = 0.5 * double(a.size() - 1);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean) * (b[i] - mean);
    aa += (a[i] - mean) * (a[i] - mean);
    bb += (b[i] - mean) * (b[i] - mean);
  }
  return ab / std::sqrt(aa * bb);
}

/// Valences of a mesh's inner vertices, as the certificate counts them.
std::map<int, int> valences(const Quad_mesh& mesh) {
  return certify({mesh, nullptr}, {false, false}).interior_valences;
}

std::map<int, int> sum(std::map<int, int> a, const std::map<int, int>& b) {
  for (const auto& [valence, number] : b)
    if ((a[valence] += number) == 0) a.erase(valence);
  return a;
}

} // namespace

TEST_CASE("any marked quads are refined: all quads, watertight, valences as predicted") {
  tiny::Random random(3);
  for (const Quad_mesh& mesh : {tiny::quad_torus(9, 7), tiny::quad_cylinder(7, 5),
                                tiny::subdivided(tiny::subdivided(tiny::quad_cube())), tiny::quad_cube(),
                                tiny::together(tiny::quad_torus(5, 4), tiny::quad_cylinder(5, 3))}) {
    const Triangle_surface s = tiny::connected(tiny::triangulated(mesh));
    for (int round = 0; round < 40; ++round) {
      std::vector<char> marked;
      const int odds = 1 + random.below(6);
      for (std::size_t q = 0; q < mesh.quads.size(); ++q) marked.push_back(random.below(odds) == 0);
      const auto fine = refine_quads(mesh, marked);
      REQUIRE(fine);
      REQUIRE(fine->parent.size() == fine->mesh.quads.size());
      CHECK(faults(fine->mesh, s, sum(valences(mesh), fine->valence_changes)) == "");
      for (std::size_t v = 0; v < mesh.points.size(); ++v) REQUIRE(fine->mesh.points[v] == mesh.points[v]);
      std::vector<int> parts(mesh.quads.size(), 0);
      for (int p : fine->parent) ++parts[p];
      for (std::size_t q = 0; q < parts.size(); ++q) CHECK(parts[q] >= (marked[q] ? 4 : 1));
    }
  }
}

TEST_CASE("nothing marked changes nothing, everything marked is global subdivision") {
  const Quad_mesh mesh = tiny::quad_torus(9, 7);
  const auto same = refine_quads(mesh, std::vector<char>(63, 0));
  REQUIRE(same);
  CHECK(same->mesh.quads == mesh.quads);
  CHECK(same->valence_changes.at(4) == 0);
  const auto fine = refine_quads(mesh, std::vector<char>(63, 1));
  REQUIRE(fine);
  CHECK(fine->mesh.quads.size() == 4 * 63);
  CHECK(fine->t_junctions == 0);
  CHECK(valences(fine->mesh) == std::map<int, int>{{4, 4 * 63}});
}

TEST_CASE("a size field is followed to within a step") {
  const Quad_mesh mesh = tiny::quad_torus(24, 12);
  const Triangle_surface s = tiny::connected(tiny::triangulated(mesh));
  Adaptive_options options;
  options.ratio = 4;
  options.lines.turn_cost = 4; // far lines would make quads finer than they need to be
  options.size = [](const Point& p) { return p.x() > 0.8 ? 0.05 : p.x() > 0 ? 0.1 : 1; };
  const auto fine = adapt_quads(mesh, Surface_projector(s), options);
  REQUIRE(fine);
  CHECK(faults(fine->mesh, s, sum(valences(mesh), fine->valence_changes)) == "");
  double at_front = 0, at_back = 0;
  int front = 0, back = 0;
  for (const Quad& q : fine->mesh.quads) {
    const Point p = 0.25 * (fine->mesh.points[q[0]] + fine->mesh.points[q[1]] + fine->mesh.points[q[2]] +
                            fine->mesh.points[q[3]]);
    const double length = std::sqrt(area(fine->mesh, q));
    if (p.x() > 1) at_front += length, ++front;
    if (p.x() < -0.5) at_back += length, ++back;
  }
  CHECK(at_front / front < 0.05 * std::sqrt(2.0) * 1.2);
  CHECK(at_back / back > 3 * at_front / front);
}

TEST_CASE("quads are smaller where the surface bends more, and the certificate passes with the predicted "
          "valences") {
  // An ellipsoid of semi-axes 1, 0.7, 2 bends most at its tips; a wavy body nearly everywhere.
  for (const char* name : {"ellipsoid", "hand"})
    for (const int ratio : {2, 4}) {
      INFO(name << ", ratio " << ratio);
      const Triangle_surface s = *make_shape(name, 6000);
      Quadrangulation_options options;
      options.quads = 1500;
      options.keep_features = false;
      const auto plain = quadrangulate(s, options);
      options.adaptive.ratio = ratio;
      const auto adapted = quadrangulate(s, options);
      REQUIRE(plain);
      REQUIRE(adapted);
      CHECK(adapted->subdivided_quads > 0);
      CHECK(faults(adapted->mesh, s, adapted->valences) == "");
      CHECK(certify({adapted->mesh, &s, adapted->valences}).passed);
      CHECK(std::abs(double(adapted->mesh.quads.size()) / 1500 - 1) < 0.15);
      REQUIRE(adapted->chart_of_quad.size() == adapted->mesh.quads.size());
      // Bending at a quad: the angle between the normals of the faces within a fixed distance of its middle.
      const Surface_projector projector(s);
      const auto correlation = [&](const Quad_mesh& mesh) {
        std::vector<double> bending, size;
        for (const Quad& q : mesh.quads) {
          const Point middle =
              0.25 * (mesh.points[q[0]] + mesh.points[q[1]] + mesh.points[q[2]] + mesh.points[q[3]]);
          const Closest_point found = projector.closest(middle);
          const Point n = projector.normal(found.face), a = n.unitOrthogonal(), b = n.cross(a);
          double least = 1;
          for (int k = 0; k < 8; ++k) {
            const double angle = k * std::acos(-1.0) / 4;
            const Closest_point beside =
                projector.closest(found.point + 0.06 * (std::cos(angle) * a + std::sin(angle) * b));
            least = std::min(least, n.dot(projector.normal(beside.face)));
          }
          bending.push_back(std::acos(std::max(-1.0, least)));
          size.push_back(area(mesh, q));
        }
        return rank_correlation(bending, size);
      };
      const double before = correlation(plain->mesh), after = correlation(adapted->mesh);
      CAPTURE(before, after);
      CHECK(after < -0.2);
      CHECK(after < before - 0.15);
    }
}

TEST_CASE("quads at sharp edges are much smaller than those on the flat sides") {
  const Triangle_surface s = *make_shape("l-shape", 6000);
  Quadrangulation_options options;
  options.quads = 1500;
  options.adaptive.ratio = 2;
  const auto adapted = quadrangulate(s, options);
  REQUIRE(adapted);
  CHECK(faults(adapted->mesh, s, adapted->valences) == "");
  CHECK(std::abs(double(adapted->mesh.quads.size()) / 1500 - 1) < 0.15);
  // The sharp edges of the three unit cubes run along integer coordinates: how many of the three are near an
  // integer?
  double at_edges = 0, inside = 0;
  int edges = 0, insides = 0;
  for (const Quad& q : adapted->mesh.quads) {
    const Point middle = 0.25 * (adapted->mesh.points[q[0]] + adapted->mesh.points[q[1]] +
                                 adapted->mesh.points[q[2]] + adapted->mesh.points[q[3]]);
    int near = 0, far = 0;
    for (int i = 0; i < 3; ++i) {
      const double distance = std::abs(middle[i] - std::round(middle[i]));
      near += distance < 0.05;
      far += distance > 0.25;
    }
    if (near >= 2) at_edges += area(adapted->mesh, q), ++edges;
    if (far >= 2) inside += area(adapted->mesh, q), ++insides;
  }
  REQUIRE(edges > 50);
  REQUIRE(insides > 50);
  CHECK(at_edges / edges < 0.6 * inside / insides);
}

TEST_CASE(
    "the borders of regions are short: few extraordinary vertices, and no quad is inverted at any ratio") {
  const Triangle_surface s = *make_shape("hand", 6000);
  Quadrangulation_options options;
  options.quads = 1500;
  const auto plain = quadrangulate(s, options);
  REQUIRE(plain);
  for (const int ratio : {2, 4, 8}) {
    INFO("ratio " << ratio);
    options.adaptive.ratio = ratio;
    const auto adapted = quadrangulate(s, options);
    REQUIRE(adapted);
    CHECK(adapted->subdivided_quads > 50);
    CHECK(adapted->relaxation.inverted_after == 0);
    int extraordinary = 0;
    for (const auto& [valence, number] : adapted->valences)
      if (valence != 4) extraordinary += number;
    CHECK(extraordinary < 150); // of about 30 in the layout
    CHECK(certify({adapted->mesh, &s, adapted->valences}).passed);
  }
}

TEST_CASE("options out of range are impossible requests") {
  const Quad_mesh mesh = tiny::quad_torus(9, 7);
  const Triangle_surface s = tiny::connected(tiny::triangulated(mesh));
  Adaptive_options options;
  options.ratio = 3;
  CHECK(!adapt_quads(mesh, Surface_projector(s), options));
  options.ratio = 2;
  options.quads = -1;
  CHECK(!adapt_quads(mesh, Surface_projector(s), options));
}
