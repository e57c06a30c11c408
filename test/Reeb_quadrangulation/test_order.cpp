// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the vertices and its critical points: integers alone.
#include <CGAL/Reeb_quadrangulation/Vertex_order.h>

#include "tiny_surfaces.h"

#include <algorithm>
#include <numeric>

using namespace CGAL::Reeb_quadrangulation;
using tiny::Random;

namespace {

std::vector<double> noise(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(n);
  for (double& v : values) v = random.below(40) / 40.0; // with many ties
  return values;
}

std::vector<double> heights(const Triangle_surface& s) {
  std::vector<double> z;
  for (const Point& p : s.points) z.push_back(p.z());
  return z;
}

int total(const Critical_points& c) {
  return int(c.minima.size() + c.maxima.size()) -
         std::accumulate(c.multiplicity.begin(), c.multiplicity.end(), 0);
}

void require_permutation(const Vertex_order& order) {
  std::vector<int> sorted = order.rank;
  std::sort(sorted.begin(), sorted.end());
  for (int i = 0; i < int(sorted.size()); ++i) {
    REQUIRE(sorted[i] == i);
    REQUIRE(order.rank[order.by_rank[i]] == i);
  }
}

std::vector<Triangle_surface> closed_surfaces() {
  return {tiny::tetrahedron(),
          tiny::octahedron(),
          tiny::cube(),
          tiny::bipyramid(6),
          tiny::torus(3, 3),
          tiny::torus(3, 3, 0.4, 1),
          tiny::torus(4, 5),
          tiny::torus(8, 7),
          tiny::double_torus(3, 3),
          tiny::double_torus(6, 5),
          tiny::boxes({"###", "#.#", "###"}),
          tiny::boxes({"#####", "#.#.#", "#####"})};
}

} // namespace

TEST_CASE("tiny surfaces are what their names say") {
  const auto genus = [](const Triangle_surface& s) { return 1 - euler_characteristic(s) / 2; };
  CHECK(genus(tiny::cube()) == 0);
  CHECK(genus(tiny::bipyramid(5)) == 0);
  CHECK(genus(tiny::torus(3, 3, 0.4, 2)) == 1);
  CHECK(genus(tiny::double_torus(3, 3)) == 2);
  CHECK(genus(tiny::boxes({"#####", "#.#.#", "#####"})) == 2);
  CHECK(boundary_loops(tiny::disc(5, 2)).size() == 1);
  CHECK(boundary_loops(tiny::open_cylinder(5, 2)).size() == 2);
  CHECK(boundary_loops(tiny::pair_of_pants()).size() == 3);
  CHECK(euler_characteristic(tiny::pair_of_pants()) == -1);
  CHECK(tiny::subdivided(tiny::torus(3, 3)).number_of_faces() == 72);
}

TEST_CASE("rank is a permutation that follows the values, ties by index") {
  const std::vector<double> values{0.5, 0.25, 0.5, -1, 0.25};
  const Vertex_order order = order_vertices(values);
  require_permutation(order);
  CHECK(order.by_rank == std::vector<int>{3, 1, 4, 0, 2});
  // Levels come before values: a boundary loop lies below or above everything.
  CHECK(order_vertices(values, {0, 0, -1, 1, 0}).by_rank == std::vector<int>{2, 1, 4, 0, 3});
}

TEST_CASE("minima + maxima - saddles with multiplicity = Euler characteristic, for any values") {
  for (const Triangle_surface& s : closed_surfaces())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Vertex_order order = order_vertices(noise(s.number_of_vertices(), seed));
      require_permutation(order);
      const Critical_points critical = critical_points(s, order);
      REQUIRE(total(critical) == euler_characteristic(s));
      REQUIRE(std::is_sorted(critical.saddles.begin(), critical.saddles.end(),
                             [&](int a, int b) { return order.rank[a] < order.rank[b]; }));
    }
}

TEST_CASE("an upright torus has one minimum, one maximum and two simple saddles") {
  Triangle_surface s = tiny::torus(16, 12);
  for (Point& p : s.points) p = Point(p.z(), p.y(), p.x());
  for (Triangle& t : s.triangles) std::swap(t[0], t[1]);
  s = tiny::connected(std::move(s));
  const Critical_points critical = critical_points(s, order_vertices(heights(s)));
  CHECK(critical.minima.size() == 1);
  CHECK(critical.maxima.size() == 1);
  CHECK(critical.multiplicity == std::vector<int>{1, 1});
}

TEST_CASE("the apex over a ring that goes up and down n times is a saddle of multiplicity n - 1") {
  for (int n = 2; n <= 5; ++n) {
    const Triangle_surface s = tiny::bipyramid(2 * n);
    std::vector<double> values{0, -2};
    for (int i = 0; i < 2 * n; ++i) values.push_back(i % 2 == 0 ? 1 : -1);
    const Critical_points critical = critical_points(s, order_vertices(values));
    CHECK(critical.minima == std::vector<int>{1});
    CHECK(int(critical.maxima.size()) == n);
    CHECK(critical.saddles == std::vector<int>{0});
    CHECK(critical.multiplicity == std::vector<int>{n - 1});
  }
}

TEST_CASE("closing the boundaries keeps every index and gives a closed surface") {
  for (const Triangle_surface& s : {tiny::disc(6, 2), tiny::open_cylinder(4, 3), tiny::pair_of_pants()}) {
    const Closed_surface closed = close_boundaries(s);
    const int loops = int(boundary_loops(s).size());
    REQUIRE(closed.original_vertices == s.number_of_vertices());
    REQUIRE(closed.original_faces == s.number_of_faces());
    CHECK(boundary_loops(closed.surface).empty());
    CHECK(closed.surface.number_of_vertices() == s.number_of_vertices() + loops);
    CHECK(euler_characteristic(closed.surface) == euler_characteristic(s) + loops);
    CHECK(std::equal(s.triangles.begin(), s.triangles.end(), closed.surface.triangles.begin()));
    Triangle_surface anew = closed.surface;
    REQUIRE(bool(anew.connect()));
    CHECK(anew.opposite == closed.surface.opposite);
  }
}

TEST_CASE("remove_extrema leaves allowed extrema only, whatever the noise") {
  for (const Triangle_surface& s : closed_surfaces())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      std::vector<double> values = noise(s.number_of_vertices(), seed);
      Random random(seed + 99);
      std::vector<int> minima{random.below(s.number_of_vertices())}, maxima;
      do maxima.assign(1, random.below(s.number_of_vertices()));
      while (maxima == minima);
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      const double lowest = *low, highest = *high;
      Vertex_order order = order_vertices(values);
      remove_extrema(s, minima, maxima, values, order);
      require_permutation(order);
      const Critical_points critical = critical_points(s, order);
      REQUIRE(critical.minima == minima);
      REQUIRE(critical.maxima == maxima);
      REQUIRE(total(critical) == euler_characteristic(s));
      for (int r = 0; r + 1 < s.number_of_vertices(); ++r)
        REQUIRE(values[order.by_rank[r]] <= values[order.by_rank[r + 1]]);
      REQUIRE(values[order.by_rank.front()] >= lowest);
      REQUIRE(values[order.by_rank.back()] <= highest);
    }
}

TEST_CASE("remove_extrema touches nothing where nothing is to be removed") {
  const Triangle_surface s = tiny::torus(8, 7);
  std::vector<double> values = noise(s.number_of_vertices(), 5);
  Vertex_order order = order_vertices(values);
  const Critical_points critical = critical_points(s, order);
  REQUIRE(critical.minima.size() + critical.maxima.size() > 2);
  const std::vector<double> before = values;
  CHECK(remove_extrema(s, critical.minima, critical.maxima, values, order) == 0);
  CHECK(values == before);
  // One extremum less is removed, and all others stay.
  std::vector<int> fewer(critical.maxima.begin() + 1, critical.maxima.end());
  CHECK(remove_extrema(s, critical.minima, fewer, values, order) > 0);
  const Critical_points after = critical_points(s, order);
  CHECK(after.minima == critical.minima);
  CHECK(after.maxima == fewer);
}
