// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/polygon_mesh.h>

#include "tiny_quads.h"

#include <catch2/catch.hpp>

#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Counts {
  int vertices = 0, edges = 0, faces = 0, boundary_edges = 0;
  int misoriented = 0;         ///< directed edges that two polygons pass
  std::map<int, int> valences; ///< of inner vertices
  int euler() const { return vertices - edges + faces; }
};

Counts count(const Polygon_soup& mesh) {
  Counts out;
  std::map<std::pair<int, int>, int> directed;
  std::map<int, int> valence;
  for (int p = 0; p < mesh.number_of_polygons(); ++p)
    for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) {
      const int next = c + 1 < mesh.begin[p + 1] ? c + 1 : mesh.begin[p];
      out.misoriented += ++directed[{mesh.corner[c], mesh.corner[next]}] > 1;
      ++valence[mesh.corner[c]];
    }
  std::set<int> boundary;
  for (const auto& [edge, times] : directed) {
    const bool is_boundary = directed.count({edge.second, edge.first}) == 0;
    out.boundary_edges += is_boundary;
    out.edges += is_boundary || edge.first < edge.second;
    if (is_boundary) boundary.insert({edge.first, edge.second});
  }
  out.vertices = int(valence.size());
  out.faces = mesh.number_of_polygons();
  for (const auto& [v, n] : valence)
    if (boundary.count(v) == 0) ++out.valences[n];
  return out;
}

std::vector<std::pair<Quad_mesh, int>> meshes_and_euler() {
  return {{tiny::subdivided(tiny::quad_cube()), 2},
          {tiny::quad_cube(), 2},
          {tiny::quad_torus(8, 6), 0},
          {tiny::quad_torus(5, 7), 0},
          {tiny::quad_cylinder(6, 4), 0},
          {tiny::two_cubes(), 4}};
}

} // namespace

TEST_CASE("polygons keep the surface: the Euler characteristic, the orientation, the boundary") {
  for (const auto& [mesh, euler] : meshes_and_euler())
    for (const Polygon_kind kind : {Polygon_kind::dual, Polygon_kind::diagonal, Polygon_kind::hexagons}) {
      INFO(name(kind) << ", " << mesh.quads.size() << " quads");
      const auto polygons = polygon_mesh(mesh, kind);
      REQUIRE(polygons);
      const Counts counts = count(*polygons), before = count(polygon_soup(mesh));
      CHECK(counts.euler() == euler);
      CHECK(counts.misoriented == 0);
      CHECK(counts.boundary_edges == (kind == Polygon_kind::diagonal ? 1 : 2) * before.boundary_edges);
    }
}

TEST_CASE("three hexagons meet in every inner corner") {
  for (const auto& entry : meshes_and_euler()) {
    const auto polygons = polygon_mesh(entry.first, Polygon_kind::hexagons);
    REQUIRE(polygons);
    for (const auto& [valence, number] : count(*polygons).valences) CHECK(valence == 3);
  }
}

TEST_CASE("a regular torus becomes hexagons alone; of odd length, five and seven sides balance") {
  const auto even = polygon_mesh(tiny::quad_torus(8, 6), Polygon_kind::hexagons);
  REQUIRE(even);
  CHECK(polygon_sizes(*even) == std::map<int, int>{{6, 48}});
  for (const auto& [mesh, euler] : meshes_and_euler()) {
    const auto polygons = polygon_mesh(mesh, Polygon_kind::hexagons);
    REQUIRE(polygons);
    if (count(*polygons).boundary_edges > 0) continue;
    int curvature = 0; // 6 V - 6 E + 6 F with three polygons a corner
    for (const auto& [sides, number] : polygon_sizes(*polygons)) curvature += (6 - sides) * number;
    CHECK(curvature == 6 * euler);
  }
}

TEST_CASE("the dual has a polygon for each vertex, of as many sides as quads meet; the dual of a cube an "
          "octahedron") {
  const auto octahedron = polygon_mesh(tiny::quad_cube(), Polygon_kind::dual);
  REQUIRE(octahedron);
  CHECK(polygon_sizes(*octahedron) == std::map<int, int>{{3, 8}});
  CHECK(octahedron->number_of_points() == 6);
  const auto dual = polygon_mesh(tiny::subdivided(tiny::quad_cube()), Polygon_kind::dual);
  REQUIRE(dual);
  CHECK(polygon_sizes(*dual) == std::map<int, int>{{3, 8}, {4, 18}});
}

TEST_CASE("along the diagonals there is a quad for every edge") {
  const auto rhombic =
      polygon_mesh(tiny::quad_cube(), Polygon_kind::diagonal); // the rhombic dodecahedron's mesh
  REQUIRE(rhombic);
  CHECK(polygon_sizes(*rhombic) == std::map<int, int>{{4, 12}});
  const auto open = polygon_mesh(tiny::quad_cylinder(6, 4), Polygon_kind::diagonal);
  REQUIRE(open);
  CHECK(polygon_sizes(*open) == std::map<int, int>{{3, 12}, {4, 42}});
}

TEST_CASE("polygons are written as they are, with the comment") {
  const auto hexagons = polygon_mesh(tiny::quad_torus(8, 6), Polygon_kind::hexagons);
  REQUIRE(hexagons);
  for (const Mesh_format format : {Mesh_format::obj, Mesh_format::off, Mesh_format::ply}) {
    const auto encoded = encode_mesh(*hexagons, format, false, "not all-quad: 48 hexagons");
    REQUIRE(encoded);
    CHECK(encoded->warnings.empty());
    CHECK(encoded->bytes.find("not all-quad: 48 hexagons") != std::string::npos);
    const auto again = parse_polygon_soup(encoded->bytes.data(), encoded->bytes.size(), format);
    REQUIRE(again);
    CHECK(again->corner == hexagons->corner);
    CHECK(again->begin == hexagons->begin);
  }
}

TEST_CASE("quads that are not a surface have no polygons") {
  const auto result = polygon_mesh(tiny::quad_moebius(5), Polygon_kind::dual);
  REQUIRE(!result);
  CHECK(result.error().code == Error_code::not_a_surface);
}
