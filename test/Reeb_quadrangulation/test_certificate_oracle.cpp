// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate against other people's answers: CGAL's Polygon_mesh_processing for intersections, and for
// topology a table of real meshes with the genus, boundary loops and components that their sources give.
#include "model_files.h"
#include "tiny_quads.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

using namespace CGAL::Reeb_quadrangulation;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Pairs = std::vector<std::pair<int, int>>;

namespace {

// The pairs of quads of which CGAL says that their triangles intersect; quads split as the certificate
// defines it.
Pairs pairs_by_cgal(const Quad_mesh& quads) {
  Mesh mesh;
  for (const Point& p : quads.points) mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for (const Quad& q : quads.quads) {
    const double even = (quads.points[q[2]] - quads.points[q[0]]).squaredNorm();
    const double odd = (quads.points[q[3]] - quads.points[q[1]]).squaredNorm();
    const int s =
        even < odd || (even == odd && *std::min_element(q.begin(), q.end()) == std::min(q[0], q[2])) ? 0 : 1;
    const auto v = [&](int i) { return Mesh::Vertex_index(unsigned(q[(s + i) % 4])); };
    mesh.add_face(v(0), v(1), v(2));
    mesh.add_face(v(0), v(2), v(3));
  }
  REQUIRE(mesh.number_of_faces() == 2 * quads.quads.size()); // CGAL refused none
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
  std::set<std::pair<int, int>> pairs;
  for (const auto& [f, g] : found)
    if (f.idx() / 2 != g.idx() / 2) pairs.insert(std::minmax(int(f.idx() / 2), int(g.idx() / 2)));
  return Pairs(pairs.begin(), pairs.end());
}

// Every triangle as three quads, around its centre.
Quad_mesh in_threes(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  Quad_mesh mesh{points, {}};
  std::map<std::pair<int, int>, int> middles;
  for (const Triangle& t : triangles) {
    int m[3];
    for (int i = 0; i < 3; ++i) {
      const int v = t[i], w = t[(i + 1) % 3];
      const auto [place, added] = middles.insert({std::minmax(v, w), int(mesh.points.size())});
      if (added) mesh.points.push_back(0.5 * (points[v] + points[w]));
      m[i] = place->second;
    }
    const int centre = int(mesh.points.size());
    mesh.points.push_back((points[t[0]] + points[t[1]] + points[t[2]]) / 3);
    for (int i = 0; i < 3; ++i) mesh.quads.push_back({t[i], m[i], centre, m[(i + 2) % 3]});
  }
  return mesh;
}

struct Known_model {
  std::string file;
  int vertices = 0, triangles = 0, genus = 0, boundaries = 0, components = 0;
};

std::vector<Known_model> known_models() {
  std::vector<Known_model> models;
  const std::optional<std::string> list = model_file("TABLE.tsv");
  if (!list) return models;
  std::ifstream table(*list);
  std::string line, name;
  std::getline(table, line); // the heads of the columns
  while (std::getline(table, line)) {
    Known_model m;
    std::istringstream words(line);
    if (words >> name >> m.file >> m.vertices >> m.triangles >> m.genus >> m.boundaries >> m.components)
      models.push_back(m);
  }
  return models;
}

} // namespace

TEST_CASE("Crumpled tori intersect where CGAL says so") {
  std::mt19937 random(11); // its sequence is fixed by the standard
  const auto coordinate = [&] { return double(random() % 4096) / 4096 - 0.5; };
  std::size_t found = 0;
  for (int run = 0; run < 40; ++run) {
    Quad_mesh mesh = tiny::quad_torus(12, 8);
    const double size = 0.15 * (1 + run % 10);
    for (Point& p : mesh.points) p += size * Point(coordinate(), coordinate(), coordinate());
    // On a coarse lattice many predicates are degenerate.
    if (run % 2 == 1)
      for (Point& p : mesh.points) p = (16 * p).array().round() / 16;
    CAPTURE(run);
    const Pairs pairs = pairs_by_cgal(mesh);
    // CGAL counts a triangle without area as intersecting itself or its neighbours; the certificate leaves it
    // out.
    const Certificate c = certify({mesh});
    if (run % 2 == 0) CHECK(c.intersecting_quads == pairs);
    const Pairs& mine = c.intersecting_quads;
    CHECK(std::includes(pairs.begin(), pairs.end(), mine.begin(), mine.end()));
    for (const auto& pair : pairs)
      if (!std::binary_search(mine.begin(), mine.end(), pair)) {
        const auto& inverted = c.inverted_quads;
        const bool at_inverted = std::binary_search(inverted.begin(), inverted.end(), pair.first) ||
                                 std::binary_search(inverted.begin(), inverted.end(), pair.second);
        CHECK(at_inverted);
      }
    found += pairs.size();
  }
  CHECK(found > 1000);
}

TEST_CASE("Real meshes have the genus, the loops and the components that are known of them", "[models]") {
  for (const Known_model& model : known_models()) {
    if (model.triangles > 30000) continue;
    CAPTURE(model.file);
    const std::optional<std::string> path = model_file(model.file);
    REQUIRE(path);
    const Result<Polygon_soup> soup = read_polygon_soup(*path);
    REQUIRE(bool(soup));
    Triangle_surface input;
    input.points = soup->points;
    for (int p = 0; p < soup->number_of_polygons(); ++p) {
      if (soup->size_of_polygon(p) != 3) FAIL("polygon " << p << " is no triangle");
      const int* corner = soup->corner.data() + soup->begin[p];
      input.triangles.push_back({corner[0], corner[1], corner[2]});
    }
    const Quad_mesh quads = in_threes(input.points, input.triangles);
    Certificate_options options;
    options.measure_shape = options.find_self_intersections = false;
    const Certificate c = certify({quads, &input}, options);
    CHECK(int(c.components.size()) == model.components);
    CHECK(c.check("watertight").measured == model.boundaries);
    CHECK(c.check("euler_characteristic").measured ==
          2 * model.components - 2 * model.genus - model.boundaries);
    CHECK(c.check("outward").measured > 0.99);
    for (const Certificate_check& check : c.checks)
      if (check.name != "no_unreferenced_vertices" && check.name != "no_inverted_quads") {
        CAPTURE(check.name, check.message);
        CHECK(check.status != Check_status::failed);
      }
    if (model.triangles > 6000) continue;
    options.find_self_intersections = true;
    CHECK(certify({quads}, options).intersecting_quads == pairs_by_cgal(quads));
  }
}
