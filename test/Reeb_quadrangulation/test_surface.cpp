// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

using namespace CGAL::Reeb_quadrangulation;

TEST_CASE("closed surfaces have no boundary and the right Euler characteristic") {
  for (const auto& [surface, chi] : {std::pair(tiny::tetrahedron(), 2), std::pair(tiny::octahedron(), 2),
                                     std::pair(tiny::torus(3, 3), 0), std::pair(tiny::torus(8, 7), 0)}) {
    CHECK(euler_characteristic(surface) == chi);
    CHECK(boundary_loops(surface).empty());
    CHECK(connected_components(surface).second == 1);
    for (int h = 0; h < surface.number_of_halfedges(); ++h) {
      CHECK(surface.opposite[surface.opposite[h]] == h);
      CHECK(surface.source(surface.opposite[h]) == surface.target(h));
    }
  }
}

TEST_CASE("an open cylinder has two boundary loops of equal length") {
  const auto loops = boundary_loops(tiny::open_cylinder(7, 3));
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].size() == 7);
  CHECK(loops[1].size() == 7);
}

TEST_CASE("connect refuses what is not an oriented manifold and names the element") {
  const std::vector<Point> p(5, Point(0, 0, 0));
  Triangle_surface fin{p, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {}, {}};
  REQUIRE_FALSE(fin.connect());
  Triangle_surface bow_tie{p, {{0, 1, 2}, {0, 3, 4}}, {}, {}};
  const auto refused = bow_tie.connect();
  REQUIRE_FALSE(refused);
  CHECK(refused.error().element == Element_kind::vertex);
  CHECK(refused.error().index == 0);
  Triangle_surface out_of_range{p, {{0, 1, 7}}, {}, {}};
  REQUIRE_FALSE(out_of_range.connect());
}
