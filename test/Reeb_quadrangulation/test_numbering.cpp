// SPDX-License-Identifier: GPL-3.0-or-later
// A surface whose vertices have other numbers gets quads of the same quality, though ties are decided
// otherwise.

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <catch2/catch.hpp>

#include <numeric>
#include <random>

using namespace CGAL::Reeb_quadrangulation;

namespace {

Triangle_surface renumbered(const Triangle_surface& s, unsigned seed) {
  std::vector<int> place(s.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::mt19937 random(seed);
  for (std::size_t i = place.size(); i > 1; --i) std::swap(place[i - 1], place[random() % i]);
  Triangle_surface result;
  result.points.resize(s.points.size());
  for (std::size_t v = 0; v < place.size(); ++v) result.points[std::size_t(place[v])] = s.points[v];
  for (const Triangle& t : s.triangles)
    result.triangles.push_back(
        {place[std::size_t(t[0])], place[std::size_t(t[1])], place[std::size_t(t[2])]});
  REQUIRE(bool(result.connect()));
  return result;
}

} // namespace

TEST_CASE("the numbers of vertices decide nothing but ties") {
  const auto shape = make_shape("hand", 4000);
  REQUIRE(bool(shape));
  Quadrangulation_options options;
  options.quads = 1500;
  const auto first = quadrangulate(*shape, options);
  REQUIRE(bool(first));
  for (const unsigned seed : {1u, 2u, 3u}) {
    const auto other = quadrangulate(renumbered(*shape, seed), options);
    REQUIRE(bool(other));
    CAPTURE(seed);
    CHECK(std::abs(double(other->mesh.quads.size()) - 1500) <= 75);
    CHECK(other->editor.design().extrema.size() == first->editor.design().extrema.size());
    CHECK(std::abs(other->relaxation.mean_after - first->relaxation.mean_after) < 0.02);
    CHECK(other->relaxation.inverted_after <= first->relaxation.inverted_after);
    CHECK(other->relaxation.intersections_after <= first->relaxation.intersections_after);
  }
}
