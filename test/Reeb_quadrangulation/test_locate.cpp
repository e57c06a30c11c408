// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Chart_locator.h>
#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include "layout_stages.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Mapped_chart {
  std::string name;
  Chart chart;
  Chart_parameterization map;

  bool periodic() const { return chart.kind == Chart_kind::annulus; }
  // The point of face f with these weights, in the plane.
  std::array<double, 2> at(int f, const std::array<double, 3>& w) const {
    const Triangle& t = chart.mesh.triangles[f];
    return {w[0] * map.v()[t[0]] + w[1] * (map.v()[t[1]] + map.jump(3 * f)) +
                w[2] * (map.v()[t[2]] - map.jump(3 * f + 2)),
            w[0] * map.u()[t[0]] + w[1] * map.u()[t[1]] + w[2] * map.u()[t[2]]};
  }
};

// A disc around the tip of a pointed hat: its map shrinks by a factor at every ring, in the end to less than
// a number can tell.
Mapped_chart hat(double height) {
  Mapped_chart hat{"hat of height " + std::to_string(height), {}, {}};
  Chart& chart = hat.chart;
  chart.kind = Chart_kind::disc;
  chart.mesh = tiny::disc(12, 60);
  for (Point& p : chart.mesh.points) p.z() = height * (1 - std::hypot(p.x(), p.y()) / 60);
  Walk walk;
  const std::vector<int> loop = boundary_loops(chart.mesh)[0];
  for (int h : loop) walk.vertices.push_back(chart.mesh.source(h));
  walk.edges.push_back({0, true, 0});
  chart.walks.push_back(walk);
  hat.map = *Chart_parameterization::prepare(chart);
  std::vector<double> x, y;
  for (int i = 0; i < 12; ++i) { // a rectangle of 4 x 2
    const int s[] = {i, 4, 10 - i, 0}, t[] = {0, i - 4, 2, 12 - i},
              side = i < 4    ? 0
                     : i < 6  ? 1
                     : i < 10 ? 2
                              : 3;
    x.push_back(s[side]);
    y.push_back(t[side]);
  }
  REQUIRE(bool(hat.map.solve_rectangle(chart, x, y)));
  return hat;
}

void add_charts(std::vector<Mapped_chart>& out, const std::string& name, const Triangle_surface& s,
                std::vector<int> minima, std::vector<int> maxima, std::vector<bool> loops = {}) {
  const Designed_field field = stages::harmonic(s, std::move(minima), std::move(maxima),
                                                Weight_kind::clamped_cotangent, std::move(loops));
  const Result<stages::Stages> run = stages::run(s, field, 500);
  REQUIRE(bool(run));
  for (std::size_t c = 0; c < run->maps.size(); ++c)
    out.push_back({name + ", chart " + std::to_string(c), *run->layout.atlas.charts[c], run->maps[c]});
}

const std::vector<Mapped_chart>& charts() {
  static const std::vector<Mapped_chart> all = [] {
    std::vector<Mapped_chart> out;
    add_charts(out, "tetrahedron", tiny::tetrahedron(), {0}, {1});
    add_charts(out, "smallest torus", tiny::torus(3, 3), {0}, {4});
    add_charts(out, "double torus", tiny::double_torus(8, 6), {21}, {70, 80});
    add_charts(out, "tube", tiny::open_cylinder(16, 40, 20), {}, {}, {false, true});
    const Triangle_surface hand = *make_shape("hand", 4000);
    add_charts(out, "hand", hand, {0}, {hand.number_of_vertices() / 2, hand.number_of_vertices() - 1});
    out.push_back(hat(5));
    out.push_back(hat(2000));
    return out;
  }();
  return all;
}

// The location is in the domain, and its point in the plane is the point that was sought.
void check_found(const Mapped_chart& m, const Chart_location& found, double v, double u) {
  INFO(m.name << ", point " << v << ", " << u);
  REQUIRE(found.face >= 0);
  REQUIRE(found.face < m.chart.mesh.number_of_faces());
  for (double w : found.weights) CHECK(w >= 0);
  CHECK(found.weights[0] + found.weights[1] + found.weights[2] == Approx(1));
  auto [x, y] = m.at(found.face, found.weights);
  if (m.periodic()) x -= std::round(x - v);
  CHECK(x == Approx(v).margin(1e-12));
  CHECK(y == Approx(u).margin(1e-12));
}

} // namespace

TEST_CASE("every point inside a chart's domain is found where it is") {
  tiny::Random random(11);
  for (const Mapped_chart& m : charts()) {
    const Chart_locator locator(m.chart, m.map);
    for (int i = 0; i < 500; ++i) {
      const double a = random.unit(), b = random.unit() * (1 - a);
      const auto [v, u] = m.at(random.below(m.chart.mesh.number_of_faces()), {a, b, 1 - a - b});
      check_found(m, locator.locate(v, u), v, u);
    }
  }
}

TEST_CASE("points on vertices and edges, and an ulp beside them, are found") {
  for (const Mapped_chart& m : charts()) {
    const Chart_locator locator(m.chart, m.map);
    const double far = std::numeric_limits<double>::infinity();
    for (int f = 0; f < m.chart.mesh.number_of_faces(); ++f)
      for (const std::array<double, 3>& w : {std::array<double, 3>{1, 0, 0}, {0, 0.5, 0.5}}) {
        const auto [v, u] = m.at(f, w);
        for (double x : {v, std::nextafter(v, far), std::nextafter(v, -far)})
          for (double y : {u, std::nextafter(u, far), std::nextafter(u, -far)})
            check_found(m, locator.locate(x, y), x, y);
      }
  }
}

TEST_CASE("every vertex of a chart is found at itself where the map is wider than numbers are") {
  for (const Mapped_chart& m : charts()) {
    if (m.name == "hat of height 2000.000000") continue; // there vertices fall together
    const Chart_locator locator(m.chart, m.map);
    for (int f = 0; f < m.chart.mesh.number_of_faces(); ++f) {
      const int vertex = m.chart.mesh.triangles[f][0];
      const auto [v, u] = m.at(f, {1, 0, 0});
      const Point found = position(m.chart, locator.locate(v, u));
      INFO(m.name << ", vertex " << vertex);
      CHECK((found - m.chart.mesh.points[vertex]).norm() < 1e-6);
    }
  }
}

TEST_CASE("a point outside goes to the nearest point of the domain") {
  const Mapped_chart disc = hat(5);
  const Chart_locator in_rectangle(disc.chart, disc.map);
  check_found(disc, in_rectangle.locate(-1, 1.25), 0, 1.25);
  check_found(disc, in_rectangle.locate(7, 1.25), 4, 1.25);
  check_found(disc, in_rectangle.locate(1.7, std::nextafter(2.0, 3.0)), 1.7, 2);
  check_found(disc, in_rectangle.locate(9, -3), 4, 0);
  for (const Mapped_chart& m : charts())
    if (m.periodic()) {
      const Chart_locator locator(m.chart, m.map);
      check_found(m, locator.locate(0.3, -0.5), 0.3, 0);
      check_found(m, locator.locate(0.3, std::nextafter(1.0, 2.0)), 0.3, 1);
      check_found(m, locator.locate(-7.25, 0.5), 0.75, 0.5); // turns do not matter
      check_found(m, locator.locate(std::nextafter(1.0, 0.0), 0.5), 1, 0.5);
    }
}

TEST_CASE("of the triangles that share a point, the one of the smallest index is taken") {
  for (const Mapped_chart& m : charts()) {
    if (m.map.flipped(m.chart) > 0) continue;
    const Chart_locator locator(m.chart, m.map);
    std::vector<int> first(m.chart.mesh.points.size(), m.chart.mesh.number_of_faces());
    for (int f = 0; f < m.chart.mesh.number_of_faces(); ++f)
      for (int v : m.chart.mesh.triangles[f]) first[v] = std::min(first[v], f);
    // On an annulus a vertex' V is rounded, but so is the point's.
    for (int f = 0; f < m.chart.mesh.number_of_faces(); ++f)
      for (int i = 0; i < 3; ++i) {
        const int v = m.chart.mesh.triangles[f][i];
        CHECK(locator.locate(m.map.v()[v], m.map.u()[v]).face == first[v]);
      }
  }
}

TEST_CASE("where the map has collapsed, points are found all the same") {
  const Mapped_chart m = hat(2000);
  CHECK(m.map.flipped(m.chart) > 0); // else this test tests nothing
  const Chart_locator locator(m.chart, m.map);
  tiny::Random random(5);
  const Point tip(m.map.v()[0], m.map.u()[0], 0);
  for (double size = 1; size > 1e-18; size /= 10)
    for (int i = 0; i < 20; ++i) {
      const double v = tip.x() + size * (random.unit() - 0.5), u = tip.y() + size * (random.unit() - 0.5);
      check_found(m, locator.locate(v, u), v, u);
    }
}

TEST_CASE("an edit with a kept locator gives the bytes of one without") {
  const Triangle_surface s = tiny::torus(12, 9);
  const Result<stages::Stages> run = stages::run(s, stages::harmonic(s, {0}, {58}), 300);
  REQUIRE(bool(run));
  for (std::size_t c = 0; c < run->maps.size(); ++c) {
    const Chart& chart = *run->layout.atlas.charts[c];
    const Chart_locator locator(chart, run->maps[c]);
    const auto kept = edit_texture(run->textures[c], chart, locator, run->samples, Subdivide_texture{}),
               fresh = edit_texture(run->textures[c], chart, run->maps[c], run->samples, Subdivide_texture{});
    REQUIRE(kept);
    REQUIRE(fresh);
    REQUIRE(kept->location.size() == kept->texture.v.size());
    for (std::size_t i = 0; i < kept->location.size(); ++i) {
      CHECK(kept->location[i].face == fresh->location[i].face);
      CHECK(kept->location[i].weights == fresh->location[i].weights);
    }
  }
}
