// SPDX-License-Identifier: GPL-3.0-or-later
// What the check finds on tiny soups, what mending makes of them, and both on real meshes.
#include "mesh_samples.h"
#include "model_files.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

using namespace CGAL::Reeb_quadrangulation;
using samples::soup;

namespace {

int genus(const Triangle_surface& s) {
  return (2 - int(boundary_loops(s).size()) - euler_characteristic(s)) / 2;
}

double volume(const Triangle_surface& s) {
  double sum = 0;
  for (const Triangle& t : s.triangles) sum += s.points[t[0]].dot(s.points[t[1]].cross(s.points[t[2]])) / 6;
  return sum;
}

/// The theorem that every mended component satisfies, whatever the soup was.
void require_sound(const Mended_component& c, const Polygon_soup& from) {
  Triangle_surface again = c.surface;
  REQUIRE(again.connect());
  REQUIRE(again.opposite == c.surface.opposite);
  REQUIRE(connected_components(c.surface).second == 1);
  REQUIRE(c.point_of_vertex.size() == c.surface.points.size());
  REQUIRE(c.face_of_triangle.size() == c.surface.triangles.size());
  for (int v = 0; v < c.surface.number_of_vertices(); ++v) {
    REQUIRE(c.surface.outgoing[v] >= 0);
    REQUIRE(c.surface.points[v].allFinite());
    if (c.point_of_vertex[v] >= 0) REQUIRE(c.surface.points[v] == from.points[c.point_of_vertex[v]]);
  }
  for (int f : c.face_of_triangle) REQUIRE((f >= -1 && f < from.number_of_polygons()));
}

Mended_surface mended(const Polygon_soup& s, const Mend_options& options = {}) {
  Result<Mended_surface> result = mend_surface(s, options);
  if (!result) FAIL(result.error().message);
  for (const Mended_component& c : result->components) require_sound(c, s);
  return *result;
}

/// The count of the mend whose sentence contains `words`, or 0.
std::int64_t count_of(const Mended_surface& m, const std::string& words) {
  for (const Mend& mend : m.mends)
    if (mend.text.find(words) != std::string::npos) return mend.count;
  return 0;
}

std::string refusal(const Polygon_soup& s, const Mend_options& options = {}) {
  const Result<Mended_surface> result = mend_surface(s, options);
  REQUIRE_FALSE(result);
  CHECK(result.error().code == Error_code::not_a_surface);
  return result.error().message;
}

std::int64_t count(const Polygon_soup& s, Defect_kind kind) {
  return check_surface(s).count(kind);
}

Polygon_soup octahedron() {
  return polygon_soup(tiny::octahedron());
}

void add(Polygon_soup& s, const std::vector<int>& polygon) {
  s.corner.insert(s.corner.end(), polygon.begin(), polygon.end());
  s.close_polygon();
}

/// Every face with points of its own.
Polygon_soup apart(const Polygon_soup& s) {
  Polygon_soup result;
  result.begin = s.begin;
  for (int v : s.corner) {
    result.corner.push_back(result.number_of_points());
    result.points.push_back(s.points[v]);
  }
  return result;
}

Polygon_soup both(const Polygon_soup& s, const Polygon_soup& t) {
  Polygon_soup result = s;
  result.points.insert(result.points.end(), t.points.begin(), t.points.end());
  for (int p = 0; p < t.number_of_polygons(); ++p) {
    for (int c = t.begin[p]; c < t.begin[p + 1]; ++c)
      result.corner.push_back(t.corner[c] + s.number_of_points());
    result.close_polygon();
  }
  return result;
}

/// The faces between cells that are there and cells that are not, as quads that look out of the solid.
Polygon_soup voxels(const std::vector<std::array<int, 3>>& cells) {
  Polygon_soup s;
  std::map<std::array<int, 3>, int> number;
  const auto point = [&](std::array<int, 3> p) {
    const auto [at, is_new] = number.emplace(p, s.number_of_points());
    if (is_new) s.points.emplace_back(p[0], p[1], p[2]);
    return at->second;
  };
  for (const std::array<int, 3>& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        std::array<int, 3> neighbour = cell;
        neighbour[axis] += 2 * side - 1;
        if (std::find(cells.begin(), cells.end(), neighbour) != cells.end()) continue;
        std::vector<int> quad;
        for (const auto& [u, v] : {std::pair<int, int>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          std::array<int, 3> p = cell;
          p[axis] += side;
          p[(axis + 1) % 3] += u;
          p[(axis + 2) % 3] += v;
          quad.push_back(point(p));
        }
        if (side == 0) std::reverse(quad.begin(), quad.end());
        add(s, quad);
      }
  return s;
}

/// A strip of m quads, divided into triangles, whose ends are glued with a half turn.
Polygon_soup moebius(int m = 7) {
  Polygon_soup s;
  for (int i = 0; i < m; ++i)
    for (double side : {-0.3, 0.3}) {
      const double a = 2 * std::acos(-1.0) * i / m, r = 1 + side * std::cos(a / 2);
      s.points.emplace_back(r * std::cos(a), r * std::sin(a), side * std::sin(a / 2));
    }
  for (int i = 0; i < m; ++i) {
    const int a = 2 * i, b = 2 * i + 1, c = i + 1 < m ? a + 2 : 1, d = i + 1 < m ? a + 3 : 0;
    add(s, {a, c, d});
    add(s, {a, d, b});
  }
  return s;
}

/// A torus grid glued with a reflection: one side, no boundary.
Polygon_soup klein(int m = 6, int n = 5) {
  Polygon_soup s = polygon_soup(tiny::torus(m, n));
  for (int p = 0; p < s.number_of_polygons(); ++p) {
    const bool last = p / (2 * n) == m - 1;
    for (int c = s.begin[p]; last && c < s.begin[p + 1]; ++c)
      if (s.corner[c] < n) s.corner[c] = (n - s.corner[c]) % n;
  }
  return s;
}

} // namespace

// ----------------------------------------------------------------------------------------------------------
// check

TEST_CASE("a closed surface is clean, and its genus is known") {
  for (const auto& [surface, expected] : {std::pair(tiny::tetrahedron(), 0), std::pair(tiny::octahedron(), 0),
                                          std::pair(tiny::torus(3, 3), 1)}) {
    const Surface_check check = check_surface(polygon_soup(surface));
    CHECK(check.is_clean());
    CHECK(check.defects.empty());
    REQUIRE(check.components.size() == 1);
    CHECK(check.components[0].closed());
    CHECK(check.components[0].genus() == expected);
    CHECK(check.components[0].euler_characteristic == euler_characteristic(surface));
  }
}

TEST_CASE("the two rims of a cylinder are listed with their points and lengths") {
  const Surface_check check = check_surface(polygon_soup(tiny::open_cylinder(6, 3)));
  CHECK(check.is_clean());
  REQUIRE(check.components.size() == 1);
  CHECK(check.components[0].boundary_loops == 2);
  CHECK(check.components[0].genus() == 0);
  REQUIRE(check.defects.size() == 2);
  for (const Defect& d : check.defects) {
    CHECK(d.kind == Defect_kind::boundary_loop);
    CHECK(d.points.size() == 6);
    CHECK(d.length == Approx(6)); // a hexagon of radius 1
  }
  CHECK(std::set<int>(check.defects[0].points.begin(), check.defects[0].points.end()) ==
        std::set<int>{0, 1, 2, 3, 4, 5});
}

TEST_CASE("quads are no defect, but not clean either: they are to be triangulated") {
  const Surface_check check = check_surface(samples::cube());
  CHECK(check.defects.empty());
  CHECK_FALSE(check.is_clean());
  CHECK(check.components[0].genus() == 0);
}

TEST_CASE("an edge with three faces is named") {
  const Polygon_soup fin =
      soup({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), Point(0, -1, 0)},
           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Surface_check check = check_surface(fin);
  REQUIRE(check.count(Defect_kind::non_manifold_edge) == 1);
  const Defect& d = check.defects[0];
  CHECK(d.points == std::vector<int>{0, 1});
  CHECK(d.faces == std::vector<int>{0, 1, 2});
  CHECK(d.where == Point(0.5, 0, 0));
  CHECK(check.components[0].genus() == -1);
}

TEST_CASE("a point where two fans meet is named") {
  const Polygon_soup bow_tie =
      soup({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(-1, 0, 0), Point(-1, -1, 0)},
           {{0, 1, 2}, {0, 3, 4}});
  const Surface_check check = check_surface(bow_tie);
  REQUIRE(check.count(Defect_kind::non_manifold_vertex) == 1);
  CHECK(check.defects[0].points == std::vector<int>{0});
  CHECK(check.components.size() == 2);
}

TEST_CASE("a face that is turned round makes its three edges inconsistent") {
  Polygon_soup s = octahedron();
  std::swap(s.corner[1], s.corner[2]);
  CHECK(count(s, Defect_kind::inconsistent_orientation) == 3);
  CHECK(count(s, Defect_kind::non_orientable) == 0);
}

TEST_CASE("a Moebius band and a Klein bottle have one side") {
  for (const auto& [s, loops] : {std::pair(moebius(), 1), std::pair(klein(), 0)}) {
    const Surface_check check = check_surface(s);
    CHECK(check.count(Defect_kind::non_orientable) == 1);
    CHECK(check.count(Defect_kind::non_manifold_edge) == 0);
    CHECK(check.count(Defect_kind::non_manifold_vertex) == 0);
    REQUIRE(check.components.size() == 1);
    CHECK_FALSE(check.components[0].orientable);
    CHECK(check.components[0].boundary_loops == loops);
    CHECK(check.components[0].euler_characteristic == 0);
    CHECK(check.components[0].genus() == -1);
  }
}

TEST_CASE("degenerate and duplicate faces are told apart from needles") {
  const Polygon_soup s = soup({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(0.5, 1e-300, 0)},
                              {{0, 1, 1}, {0, 1, 2}, {0, 1}, {0, 1, 3}, {3, 1, 0}});
  const Surface_check check = check_surface(s);
  CHECK(check.count(Defect_kind::degenerate_face) == 3);
  REQUIRE(check.count(Defect_kind::duplicate_face) == 1);
  const auto duplicate = std::find_if(check.defects.begin(), check.defects.end(),
                                      [](const Defect& d) { return d.kind == Defect_kind::duplicate_face; });
  CHECK(duplicate->faces == std::vector<int>{3, 4});
}

TEST_CASE("points that are not finite, equal or unused are listed") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Polygon_soup s = soup(
      {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(-0.0, 0, 0), Point(nan, 0, 0), Point(nan, 0, 0)},
      {{0, 1, 2}});
  const Surface_check check = check_surface(s);
  CHECK(check.count(Defect_kind::non_finite_point) == 2);
  CHECK(check.count(Defect_kind::duplicate_point) == 1);
  CHECK(check.count(Defect_kind::unreferenced_point) == 3);
  CHECK(check.highest == Point(1, 1, 0));
}

TEST_CASE("defects beyond the limit are counted and not listed") {
  const Polygon_soup s = apart(octahedron());
  Check_options options;
  options.listed_per_kind = 5;
  const Surface_check check = check_surface(s, options);
  CHECK(check.count(Defect_kind::duplicate_point) == 18);
  CHECK(std::count_if(check.defects.begin(), check.defects.end(),
                      [](const Defect& d) { return d.kind == Defect_kind::duplicate_point; }) == 5);
  options.listed_per_kind = -1;
  CHECK(check_surface(s, options).defects.size() == 18 + 8); // and eight triangles with a boundary each
}

TEST_CASE("the JSON text says what the check says") {
  Polygon_soup s = samples::cube();
  s.points.emplace_back(std::numeric_limits<double>::infinity(), 0, 0);
  const auto json = nlohmann::json::parse(to_json(check_surface(s)));
  CHECK(json["points"] == 9);
  CHECK(json["clean"] == false);
  CHECK(json["counts"]["non_finite_point"] == 1);
  CHECK(json["counts"]["unreferenced_point"] == 1);
  CHECK(json["counts"].size() == std::size_t(number_of_defect_kinds));
  CHECK(json["defects"].size() == 2);
  CHECK(json["defects"][0]["kind"] == "non_finite_point");
  CHECK(json["defects"][0]["where"][0].is_null());
  CHECK(json["defects"][0]["points"] == std::vector<int>{8});
  CHECK(json["components"][0]["genus"] == 0);
  CHECK(json["bounding_box"][1] == std::vector<double>{1, 1, 1});
}

// -----------------------------------------------------------------------------------------------------------
// mend

TEST_CASE("a clean surface comes back as it was") {
  for (const Triangle_surface& s :
       {tiny::tetrahedron(), tiny::octahedron(), tiny::torus(4, 5), tiny::open_cylinder(5, 2)}) {
    const Mended_surface m = mended(polygon_soup(s));
    CHECK(m.mends.empty());
    CHECK(m.refused.empty());
    REQUIRE(m.components.size() == 1);
    CHECK(m.components[0].surface.points == s.points);
    CHECK(m.components[0].surface.triangles == s.triangles);
  }
}

TEST_CASE("faces with points of their own are glued") {
  const Mended_surface m = mended(apart(octahedron()));
  REQUIRE(m.components.size() == 1);
  CHECK(m.components[0].surface.number_of_vertices() == 6);
  CHECK(genus(m.components[0].surface) == 0);
  CHECK(count_of(m, "merged") == 18);
  CHECK(m.mends.size() == 1);
}

TEST_CASE("surfaces that touch in a point or along an edge stay apart when they were") {
  Polygon_soup moved = octahedron();
  for (Point& p : moved.points) p += Point(2, 0, 0); // shares one point
  const Mended_surface in_point = mended(both(octahedron(), moved));
  CHECK(in_point.components.size() == 2);
  Polygon_soup cube = samples::cube();
  for (Point& p : cube.points) p += Point(1, 1, 0); // shares one edge
  const Mended_surface along_edge = mended(both(samples::cube(), cube));
  CHECK(along_edge.components.size() == 2);
  CHECK(count_of(along_edge, "merged") == 0);
}

TEST_CASE("four sheets that touch along an edge are glued in pairs that do not cross") {
  // Two pairs of triangles; each pair is cut along its inner edge, and all four touch there.
  const auto pair = [](double y) {
    return soup(
        {Point(0, 0, 0), Point(1, 0, 0), Point(0.5, y, 1), Point(0, 0, 0), Point(1, 0, 0), Point(0.5, y, -1)},
        {{0, 1, 2}, {4, 3, 5}});
  };
  const Mended_surface one = mended(pair(1));
  REQUIRE(one.components.size() == 1);
  CHECK(count_of(one, "merged") == 2);
  const Mended_surface two = mended(both(pair(1), pair(-1)));
  CHECK(count_of(two, "merged") == 6);
  CHECK(count_of(two, "solids touch") == 1);
  REQUIRE(two.components.size() == 2);
  for (const Mended_component& c : two.components) CHECK(c.surface.number_of_faces() == 2);
}

TEST_CASE("a point where several fans meet becomes several vertices") {
  Polygon_soup s = polygon_soup(tiny::open_cylinder(6, 2));
  for (int& v : s.corner)
    if (v == 3) v = 0; // pinches the lower rim
  const Mended_surface m = mended(s);
  REQUIRE(m.components.size() == 1);
  CHECK(count_of(m, "fans") == 1);
  CHECK(m.components[0].surface.number_of_vertices() == 18);
  CHECK(boundary_loops(m.components[0].surface).size() == 2);
  CHECK(std::count(m.components[0].point_of_vertex.begin(), m.components[0].point_of_vertex.end(), 0) == 2);
  CHECK(count_of(m, "without faces") == 1);
}

TEST_CASE("two tetrahedra that share a point are two components") {
  Polygon_soup s = both(samples::tetrahedron(), samples::tetrahedron());
  for (int v = 5; v < 8; ++v) s.points[v] = Point(2, 2, 2) - s.points[v];
  for (int& v : s.corner)
    if (v == 4) v = 0;
  const Mended_surface m = mended(s);
  REQUIRE(m.components.size() == 2);
  CHECK(count_of(m, "fans") == 1);
  for (const Mended_component& c : m.components) CHECK(volume(c.surface) > 0);
}

TEST_CASE("faces are turned to agree, and closed surfaces outward") {
  const Triangle_surface torus = tiny::torus(6, 5);
  const double expected = std::abs(volume(torus));
  for (int pattern = 1; pattern <= 5; ++pattern) {
    Polygon_soup s = polygon_soup(torus);
    for (int f = 0; f < s.number_of_polygons(); ++f)
      if ((f * f + f) % 7 < pattern) std::swap(s.corner[3 * f], s.corner[3 * f + 1]);
    const Mended_surface m = mended(s);
    REQUIRE(m.components.size() == 1);
    CHECK(volume(m.components[0].surface) == Approx(expected));
    CHECK(genus(m.components[0].surface) == 1);
    CHECK(count_of(m, "agree") > 0);
    CHECK(2 * count_of(m, "agree") <= s.number_of_polygons());
  }
}

TEST_CASE("an inside-out surface is turned outward, unless that is not wanted") {
  Polygon_soup s = octahedron();
  for (int f = 0; f < 8; ++f) std::swap(s.corner[3 * f], s.corner[3 * f + 1]);
  const Mended_surface m = mended(s);
  CHECK(count_of(m, "outward") == 1);
  CHECK(volume(m.components[0].surface) > 0);
  Mend_options options;
  options.orient_outward = false;
  CHECK(volume(mended(s, options).components[0].surface) < 0);
}

TEST_CASE("what has one side only is refused with a sentence") {
  CHECK(refusal(moebius()).find("one side") != std::string::npos);
  CHECK(refusal(klein()).find("one side") != std::string::npos);
  CHECK(refusal(apart(moebius())).find("one side") != std::string::npos);
}

TEST_CASE("a fin comes off the sheet that it stands on, or its edge refuses the component if asked") {
  const Polygon_soup fin =
      soup({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), Point(0, -1, 0)},
           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Mended_surface m = mended(fin);
  REQUIRE(m.components.size() == 2);
  CHECK(count_of(m, "sheets or more meet") == 1);
  CHECK(m.components[0].surface.number_of_faces() == 2); // the flat pair, turned alike
  CHECK(m.components[1].face_of_triangle == std::vector<int>{1});
  Mend_options options;
  options.cut_non_manifold_edges = false;
  const std::string text = refusal(fin, options);
  CHECK(text.find("from point 0 at (0, 0, 0) to point 1 at (1, 0, 0) has 3 faces; ") != std::string::npos);
}

TEST_CASE("a fin comes off a solid, which stays closed, wherever it points") {
  for (const Point& tip : {Point(0.5, -1, -1), Point(0.5, -1, 0), Point(0.5, 0, -3), Point(0.5, 0.3, 0.3)}) {
    Polygon_soup s = samples::cube();
    s.points.push_back(tip);
    add(s, {0, 1, 8});
    const Mended_surface m = mended(s);
    REQUIRE(m.components.size() == 2);
    CHECK(volume(m.components[0].surface) == Approx(1));
    CHECK(boundary_loops(m.components[0].surface).empty());
    CHECK(m.components[1].surface.number_of_faces() == 1);
  }
}

TEST_CASE("solids that touch along edges come apart, whatever their cells are") {
  using Cells = std::vector<std::array<int, 3>>;
  const auto full = [](int nx, int ny, int nz, const Cells& without) {
    Cells cells;
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y)
        for (int z = 0; z < nz; ++z)
          if (const std::array<int, 3> cell{x, y, z};
              std::find(without.begin(), without.end(), cell) == without.end())
            cells.push_back(cell);
    return cells;
  };
  struct Case {
    Cells cells;
    std::size_t components;
    int edges;
  };
  const std::vector<Case> cases = {
      {{{0, 0, 0}, {1, 1, 0}}, 2, 1},
      {{{0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 1, 1}}, 2, 2},
      {full(3, 3, 2, {{1, 1, 0}, {1, 1, 1}, {0, 0, 0}, {0, 0, 1}}), 1, 2}, // two shafts that touch
      {full(2, 2, 3, {{0, 0, 1}, {1, 1, 1}}), 1, 1}, // the edge ends inside: both its ends are one fan each
  };
  for (const Case& c : cases) {
    const Polygon_soup s = voxels(c.cells);
    CHECK(count(s, Defect_kind::non_manifold_edge) == c.edges);
    const Mended_surface m = mended(s);
    CHECK(m.refused.empty());
    CHECK(m.components.size() == c.components);
    CHECK(count_of(m, "solids touch") == c.edges);
    double total = 0;
    for (const Mended_component& component : m.components) {
      CHECK(boundary_loops(component.surface).empty());
      total += volume(component.surface);
    }
    CHECK(total == Approx(double(c.cells.size())));
    // The same from faces with points of their own.
    CHECK(mended(apart(s)).components.size() == c.components);
  }
}

TEST_CASE("points a hair apart are welded where that closes edges, and the check names them") {
  std::uint64_t state = 7;
  const auto noise = [&state](double size) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double(state >> 11) / 9007199254740992.0 - 0.5) * size;
  };
  for (const Polygon_soup& good : {octahedron(), polygon_soup(tiny::torus(8, 6))}) {
    Polygon_soup s = apart(good);
    for (Point& p : s.points) p += Point(noise(1e-9), noise(1e-9), noise(1e-9));
    CHECK(count(s, Defect_kind::near_point) == s.number_of_points() - good.number_of_points());
    const Mended_surface m = mended(s);
    REQUIRE(m.components.size() == 1);
    CHECK(m.components[0].surface.number_of_vertices() == good.number_of_points());
    CHECK(boundary_loops(m.components[0].surface).empty());
    CHECK(count_of(m, "welded with others that lay at most") ==
          s.number_of_points() - good.number_of_points());
    Mend_options off;
    off.weld = 0;
    CHECK(int(mended(s, off).components.size()) == good.number_of_polygons());
  }
  // Farther apart only if asked.
  Polygon_soup s = apart(octahedron());
  for (Point& p : s.points) p += Point(noise(1e-3), noise(1e-3), noise(1e-3));
  CHECK(mended(s).components.size() == 8);
  Mend_options far;
  far.weld = 0.01;
  CHECK(mended(s, far).components.size() == 1);
}

TEST_CASE("rims a hair apart that close nothing stay apart, and so does what would become non-manifold") {
  Polygon_soup s = both(octahedron(), octahedron());
  for (int v = 6; v < 12; ++v) s.points[v] += Point(2 + 1e-9, 0, 0); // closed surfaces have no rims
  CHECK(mended(s).components.size() == 2);
  CHECK(count(s, Defect_kind::near_point) == 0);
  // Three wings at one axis, a hair apart: no pair of them is better than another.
  Polygon_soup wings;
  for (int i = 0; i < 3; ++i) {
    const double a = 2 * std::acos(-1.0) * i / 3;
    for (const Point& p : {Point(0, 0, 0), Point(0, 0, 1), Point(std::cos(a), std::sin(a), 0)})
      wings.points.push_back(p + Point(i * 1e-9, 0, 0));
    add(wings, {3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Mended_surface m = mended(wings);
  CHECK(m.components.size() == 3);
  CHECK(count_of(m, "welded") == 0);
}

TEST_CASE("T-junctions are named and mended") {
  Polygon_soup s = octahedron();
  const int m = s.number_of_points();
  s.points.push_back((s.points[0] + s.points[2]) / 2);
  s.corner[0] = 0, s.corner[1] = m, s.corner[2] = 4;
  add(s, {m, 2, 4});
  CHECK(count(s, Defect_kind::t_junction) == 1);
  CHECK_FALSE(check_surface(s).is_clean());
  const Mended_surface one = mended(s);
  CHECK(count_of(one, "T-junction") == 1);
  REQUIRE(one.components.size() == 1);
  CHECK(boundary_loops(one.components[0].surface).empty());
  CHECK(one.components[0].surface.number_of_faces() == 10);
  CHECK(area(one.components[0].surface) == Approx(area(tiny::octahedron())));

  // Rows of bricks: each joint lies on an edge of the other row.
  Polygon_soup bricks;
  for (double x : {0, 2, 4}) bricks.points.emplace_back(x, 1, 0);     // 0 1 2
  for (double x : {0, 1, 3, 4}) bricks.points.emplace_back(x, 0, 0);  // 3 4 5 6
  for (double x : {0, 2, 4}) bricks.points.emplace_back(x, 0, 0);     // 7 8 9, of the upper row
  for (double x : {0, 1, 3, 4}) bricks.points.emplace_back(x, -1, 0); // 10 11 12 13
  for (const auto& quad :
       {std::vector<int>{7, 8, 1, 0}, {8, 9, 2, 1}, {10, 11, 4, 3}, {11, 12, 5, 4}, {12, 13, 6, 5}})
    add(bricks, quad);
  const Mended_surface wall = mended(bricks);
  CHECK(count_of(wall, "T-junction") == 3);
  REQUIRE(wall.components.size() == 1);
  CHECK(boundary_loops(wall.components[0].surface).size() == 1);
  CHECK(area(wall.components[0].surface) == Approx(8));

  // A point on a rim where nothing is to be closed is none.
  const Polygon_soup rim =
      soup({Point(0, 0, 0), Point(2, 0, 0), Point(0, 2, 0), Point(1, 0, 0), Point(1, -1, 1), Point(2, -1, 1)},
           {{0, 1, 2}, {3, 4, 5}});
  CHECK(count_of(mended(rim), "T-junction") == 0);
  CHECK(mended(rim).components.size() == 2);
}

TEST_CASE("a panel with a front and a back of their own points is one sheet") {
  Polygon_soup front;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j) front.points.emplace_back(i, j, 0);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) {
      add(front, {4 * i + j, 4 * i + 4 + j, 4 * i + 5 + j});
      add(front, {4 * i + j, 4 * i + 5 + j, 4 * i + 1 + j});
    }
  Polygon_soup back = front;
  for (int p = 0; p < back.number_of_polygons(); ++p)
    std::reverse(back.corner.begin() + back.begin[p], back.corner.begin() + back.begin[p + 1]);
  for (const double apart_by : {0.0, 1e-9}) {
    for (Point& p : back.points) p[2] = apart_by;
    const Mended_surface m = mended(both(front, back));
    REQUIRE(m.components.size() == 1);
    CHECK(m.components[0].surface.number_of_faces() == 24);
    CHECK(boundary_loops(m.components[0].surface).size() == 1);
    CHECK(count_of(m, "duplicate") == 24);
  }
  // With a thickness it is a solid, however thin.
  for (Point& p : back.points) p[2] = -1e-3;
  Polygon_soup box = both(front, back);
  const auto side = [&](int a, int b) { add(box, {b, a, a + 20, b + 20}); };
  for (int i = 0; i < 4; ++i) side(4 * i, 4 * i + 4), side(4 * i + 7, 4 * i + 3);
  for (int j = 0; j < 3; ++j) side(j + 1, j), side(16 + j, 17 + j);
  const Mended_surface solid = mended(box);
  REQUIRE(solid.components.size() == 1);
  CHECK(std::abs(volume(solid.components[0].surface)) == Approx(12e-3));
}

TEST_CASE("of a model whose faces are all doubled one copy is kept, also where sheets meet") {
  Polygon_soup s = samples::cube();
  s.points.emplace_back(0.5, -1, -1);
  add(s, {0, 1, 8});
  const int n = s.number_of_polygons();
  for (int p = 0; p < n; ++p) {
    std::vector<int> turned(s.corner.begin() + s.begin[p], s.corner.begin() + s.begin[p + 1]);
    std::reverse(turned.begin(), turned.end());
    add(s, turned);
  }
  const Mended_surface m = mended(s);
  REQUIRE(m.components.size() == 2);
  CHECK(volume(m.components[0].surface) == Approx(1));
  CHECK(m.components[1].surface.number_of_faces() == 1);
  CHECK(count_of(m, "duplicate") == 13);
  CHECK(count_of(m, "double sheet") == 0);
  // A two-sided fin that ends freely is no wall inside.
  Polygon_soup fin = samples::cube();
  fin.points.emplace_back(0.5, -1, -1);
  add(fin, {0, 1, 8});
  add(fin, {1, 0, 8});
  CHECK(mended(fin).components.size() == 2);
}

TEST_CASE("a face without area that hangs on others is dropped") {
  Polygon_soup s = octahedron();
  const int m = s.number_of_points();
  s.points.push_back((s.points[0] + s.points[2]) / 2);
  for (int copies = 1; copies <= 3; ++copies) {
    add(s, {0, 2, m});
    const Mended_surface mended_once = mended(s);
    CHECK(count_of(mended_once, "hung on others") == 1);
    CHECK(count_of(mended_once, "duplicate") == copies - 1);
    REQUIRE(mended_once.components.size() == 1);
    CHECK(mended_once.components[0].surface.triangles == tiny::octahedron().triangles);
  }
}

TEST_CASE("closed components face outward, and inward where they lie inside another") {
  Polygon_soup s;
  for (const double size : {3.0, 2.0, 1.0}) {
    Polygon_soup part = octahedron();
    for (Point& p : part.points) p *= size;
    s = both(s, part);
  }
  const Mended_surface m = mended(s);
  REQUIRE(m.components.size() == 3);
  CHECK(count_of(m, "inside another was turned inward") == 1);
  CHECK(volume(m.components[0].surface) > 0);
  CHECK(volume(m.components[1].surface) < 0);
  CHECK(volume(m.components[2].surface) > 0);
  // What is right already stays: a hollow solid.
  Polygon_soup hollow = both(octahedron(), octahedron());
  for (int v = 6; v < 12; ++v) hollow.points[v] *= 0.5;
  for (int f = 8; f < 16; ++f) std::swap(hollow.corner[3 * f], hollow.corner[3 * f + 1]);
  CHECK(mended(hollow).mends.empty());
  // Beside each other, or crossing, they are not inside.
  Polygon_soup crossing = both(octahedron(), octahedron());
  for (int v = 6; v < 12; ++v) crossing.points[v] = crossing.points[v] * 0.5 + Point(0.6, 0, 0);
  CHECK(mended(crossing).mends.empty());
}

TEST_CASE("components below a size are dropped if asked") {
  Polygon_soup speck = octahedron();
  for (Point& p : speck.points) p = p * 0.01 + Point(3, 0, 0);
  const Polygon_soup s = both(polygon_soup(tiny::torus(8, 6)), speck);
  CHECK(mended(s).components.size() == 2);
  Mend_options options;
  options.smallest_part = 0.02;
  CHECK(mended(s, options).components.size() == 1);
  CHECK(count_of(mended(s, options), "small component was dropped (8 faces)") == 1);
  options = {};
  options.smallest_diagonal = 0.05;
  CHECK(mended(s, options).components.size() == 1);
  options = {};
  options.fewest_triangles = 9;
  CHECK(mended(s, options).components.size() == 1);
  options.fewest_triangles = 1000;
  CHECK(refusal(s, options).find("keep smaller ones") != std::string::npos);
}

TEST_CASE("a mesh that is too small to compute with is refused, and not called clean") {
  for (const double scale : {1e-160, 1e-320, 1e-71}) {
    Polygon_soup s = octahedron();
    for (Point& p : s.points) p *= scale;
    CHECK(refusal(s).find("scale the mesh up") != std::string::npos);
    CHECK_FALSE(check_surface(s).is_clean());
    CHECK(count(s, Defect_kind::extreme_coordinate) == 1);
  }
  Polygon_soup s = octahedron();
  for (Point& p : s.points) p *= 1e-60;
  CHECK(mended(s).mends.empty());
  CHECK(check_surface(s).is_clean());
}

TEST_CASE("a component that is refused does not refuse the others") {
  const Mended_surface m = mended(both(moebius(), both(octahedron(), klein())));
  CHECK(m.components.size() == 1);
  CHECK(m.refused.size() == 2);
  CHECK(m.components[0].point_of_vertex[0] == 14);
  CHECK(m.components[0].face_of_triangle[0] == 14);
}

TEST_CASE("two triangles with the same corners are one, and a single triangle is a surface with a rim") {
  const std::vector<Point> points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  for (const std::vector<std::vector<int>>& faces :
       {std::vector<std::vector<int>>{{0, 1, 2}}, {{0, 1, 2}, {0, 2, 1}}, {{0, 1, 2}, {1, 2, 0}}}) {
    const Mended_surface m = mended(soup(points, faces));
    REQUIRE(m.components.size() == 1);
    CHECK(m.components[0].surface.number_of_faces() == 1);
    CHECK(boundary_loops(m.components[0].surface).size() == 1);
    CHECK(count_of(m, "duplicate") == std::int64_t(faces.size()) - 1);
  }
  Mend_options fill;
  fill.fill_holes = 10;
  CHECK(mended(soup(points, {{0, 1, 2}}), fill).components[0].surface.number_of_faces() == 1);
}

TEST_CASE("duplicate faces vanish, and so do double sheets inside a surface") {
  Polygon_soup twice = octahedron();
  add(twice, {0, 2, 4});
  add(twice, {4, 2, 0});
  const Mended_surface m = mended(twice);
  CHECK(count_of(m, "duplicate") == 2);
  CHECK(genus(m.components[0].surface) == 0);
  Polygon_soup wall = octahedron(); // the equator 0 2 1 3, both sides
  for (const auto& t : {std::vector<int>{0, 2, 1}, {0, 1, 3}, {2, 0, 1}, {1, 0, 3}}) add(wall, t);
  const Mended_surface without = mended(wall);
  CHECK(count_of(without, "double sheet") == 4);
  CHECK(without.components[0].surface.number_of_faces() == 8);
}

TEST_CASE("a sheet given once for each side is one sheet") {
  Polygon_soup s = polygon_soup(tiny::open_cylinder(6, 3));
  const int n = s.number_of_polygons();
  for (int f = 0; f < n; ++f) add(s, {s.corner[3 * f], s.corner[3 * f + 2], s.corner[3 * f + 1]});
  const Mended_surface m = mended(s);
  REQUIRE(m.components.size() == 1);
  CHECK(m.components[0].surface.number_of_faces() == n);
  CHECK(boundary_loops(m.components[0].surface).size() == 2);
}

TEST_CASE("a cap without area is flipped away and opens no hole") {
  Polygon_soup s = octahedron();
  const int m = s.number_of_points();
  s.points.push_back((s.points[0] + s.points[2]) / 2);
  s.corner[0] = 0, s.corner[1] = m, s.corner[2] = 4; // (0, 2, 4) becomes two, and a cap closes the rest
  add(s, {m, 2, 4});
  add(s, {0, 2, m});
  REQUIRE(count(s, Defect_kind::degenerate_face) == 1);
  const Mended_surface result = mended(s);
  CHECK(count_of(result, "flipped") == 1);
  const Triangle_surface& surface = result.components[0].surface;
  CHECK(count(polygon_soup(surface), Defect_kind::degenerate_face) == 0);
  CHECK(surface.number_of_faces() == 10);
  CHECK(surface.number_of_vertices() == 7);
  CHECK(genus(surface) == 0);
  CHECK(boundary_loops(surface).empty());
  CHECK(area(surface) == Approx(area(tiny::octahedron())));
}

TEST_CASE("an edge without length is collapsed") {
  // A bipyramid over a hexagon whose first two points coincide.
  Polygon_soup s;
  for (int i : {0, 0, 1, 2, 3, 4}) s.points.emplace_back(std::cos(i * 1.2), std::sin(i * 1.2), 0);
  s.points.emplace_back(0, 0, 1);
  s.points.emplace_back(0, 0, -1);
  for (int i = 0; i < 6; ++i) {
    add(s, {i, (i + 1) % 6, 6});
    add(s, {(i + 1) % 6, i, 7});
  }
  const Mended_surface m = mended(s);
  CHECK(count_of(m, "collapsed") == 1);
  const Triangle_surface& surface = m.components[0].surface;
  CHECK(surface.number_of_vertices() == 7);
  CHECK(surface.number_of_faces() == 10);
  CHECK(genus(surface) == 0);
  CHECK(count(polygon_soup(surface), Defect_kind::degenerate_face) == 0);
}

TEST_CASE("needles with area are kept") {
  Polygon_soup s = octahedron();
  s.points[4] = s.points[0] + Point(0, 0, 1e-14);
  const Mended_surface m = mended(s);
  CHECK(m.components[0].surface.number_of_faces() == 8);
  CHECK(m.mends.empty());
}

TEST_CASE("a flat ear at a rim is removed, and nothing without any area is taken") {
  const std::vector<Point> points = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(0, 1, 0)};
  const Mended_surface m = mended(soup(points, {{0, 2, 3}, {2, 0, 1}}));
  CHECK(count_of(m, "boundary") + count_of(m, "flipped") == 1);
  CHECK(count_of(m, "kept") == 0);
  CHECK(refusal(soup(points, {{0, 1, 2}})).find("no area") != std::string::npos);
}

TEST_CASE("points that are not finite refuse their component, or vanish if unused") {
  Polygon_soup s = octahedron();
  s.points[2][1] = std::numeric_limits<double>::infinity();
  CHECK(refusal(s).find("point 2 at (0, inf, 0) is not finite") != std::string::npos);
  s = octahedron();
  s.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  CHECK(count_of(mended(s), "without faces") == 1);
  s = octahedron();
  s.points[2][1] = 1e200;
  CHECK(refusal(s).find("too far away") != std::string::npos);
}

TEST_CASE("no faces, or none that is one, is no surface") {
  CHECK(refusal(Polygon_soup()).find("no faces") != std::string::npos);
  CHECK(refusal(soup({Point(0, 0, 0), Point(1, 0, 0)}, {{0, 1, 0}, {0, 1}})).find("no faces") !=
        std::string::npos);
}

TEST_CASE("polygons are triangulated inside themselves") {
  const Mended_surface cube = mended(samples::cube());
  CHECK(cube.components[0].surface.number_of_faces() == 12);
  CHECK(volume(cube.components[0].surface) == Approx(1));
  CHECK(count_of(cube, "triangulated") == 6);
  // A U: the fan from its first corner would leave it.
  const Polygon_soup u = soup({Point(0, 0, 0), Point(3, 0, 0), Point(3, 3, 0), Point(2, 3, 0), Point(2, 1, 0),
                               Point(1, 1, 0), Point(1, 3, 0), Point(0, 3, 0)},
                              {{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(area(mended(u).components[0].surface) == Approx(7));
}

TEST_CASE("two polygons with the same corners are divided alike, and are one") {
  const Polygon_soup s =
      soup({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, {{0, 1, 2, 3}, {3, 2, 1, 0}});
  for (const Polygon_soup& t : {s, apart(s)}) {
    const Mended_surface m = mended(t);
    REQUIRE(m.components.size() == 1);
    CHECK(m.components[0].surface.number_of_faces() == 2);
    CHECK(boundary_loops(m.components[0].surface).size() == 1);
  }
}

TEST_CASE("the diagonals of quads do not depend on scale and place") {
  Polygon_soup s;
  for (int i = 0; i <= 12; ++i)
    for (int j = 0; j <= 9; ++j) s.points.emplace_back(i, j, 0.1 * ((i * 7 + j * 5) % 4));
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 9; ++j) add(s, {10 * i + j, 10 * i + 10 + j, 10 * i + 11 + j, 10 * i + j + 1});
  const auto expected = mended(s).components[0].surface.triangles;
  for (const double scale : {100.0, 1e-3, 3.7}) {
    Polygon_soup t = s;
    for (Point& p : t.points) p = p * scale + Point(1000, -1000, 1000) * scale * 15;
    CHECK(mended(t).components[0].surface.triangles == expected);
  }
}

TEST_CASE("a polygon with very many corners takes no time and has its area") {
  Polygon_soup s;
  std::vector<int> all;
  const int n = 100'000;
  for (int i = 0; i < n; ++i) {
    s.points.emplace_back(std::cos(2 * std::acos(-1.0) * i / n), std::sin(2 * std::acos(-1.0) * i / n), 0);
    all.push_back(i);
  }
  add(s, all);
  CHECK(area(mended(s).components[0].surface) == Approx(std::acos(-1.0)).epsilon(1e-6));
}

TEST_CASE("a hub with very many faces without area takes no time") {
  // A double cone whose rim points coincide in pairs, and one whose rim points all lie on a line with a hub.
  const int n = 50'000;
  for (const bool on_a_line : {false, true}) {
    Polygon_soup s;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::acos(-1.0) * (i / 2) / (n / 2);
      s.points.push_back(on_a_line && i > 5 ? Point(i, 0, 0) : Point(std::cos(a), std::sin(a), 0));
    }
    s.points.emplace_back(0, 0, on_a_line ? 0 : 1);
    s.points.emplace_back(0, 0, -1);
    for (int i = 0; i < n; ++i) {
      add(s, {i, (i + 1) % n, n});
      add(s, {(i + 1) % n, i, n + 1});
    }
    const std::clock_t start = std::clock();
    const Result<Mended_surface> m = mend_surface(s);
    CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 20); // measured: below 1
    REQUIRE(m);
    CHECK(count_of(*m, "without area") + count_of(*m, "without length") > 0);
    CHECK(genus(m->components[0].surface) == 0);
  }
}

TEST_CASE("holes up to the given size are filled") {
  const Polygon_soup s = polygon_soup(tiny::open_cylinder(6, 3));
  Mend_options options;
  options.fill_holes = 5;
  CHECK(boundary_loops(mended(s, options).components[0].surface).size() == 2);
  options.fill_holes = 6;
  const Mended_surface m = mended(s, options);
  const Triangle_surface& surface = m.components[0].surface;
  CHECK(count_of(m, "filled") == 2);
  CHECK(boundary_loops(surface).empty());
  CHECK(genus(surface) == 0);
  CHECK(surface.number_of_faces() == s.number_of_polygons() + 8);
  CHECK(std::count(m.components[0].face_of_triangle.begin(), m.components[0].face_of_triangle.end(), -1) ==
        8);
  CHECK(volume(surface) == Approx(2 * 1.5 * std::sqrt(3.0)));
}

TEST_CASE("large holes are filled with a point in their middle") {
  Mend_options options;
  options.fill_holes = 1000;
  const Mended_surface m = mended(polygon_soup(tiny::open_cylinder(500, 1)), options);
  CHECK(boundary_loops(m.components[0].surface).empty());
  CHECK(genus(m.components[0].surface) == 0);
  CHECK(std::count(m.components[0].point_of_vertex.begin(), m.components[0].point_of_vertex.end(), -1) == 2);
}

TEST_CASE("whatever the soup, what comes out of mending is a surface") {
  std::uint64_t state = 88172645463325252u; // xorshift, after Marsaglia, "Xorshift RNGs", 2003
  const auto random = [&state](int below) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return int(state % std::uint64_t(below));
  };
  int taken = 0, taken_again = 0;
  for (int run = 0; run < 3000; ++run) {
    // A few points on a tiny grid, so that equal and collinear ones are frequent, and on a part of a good
    // surface.
    Polygon_soup s = run % 3 == 0   ? polygon_soup(tiny::torus(4, 4))
                     : run % 3 == 1 ? samples::cube()
                                    : Polygon_soup();
    const int points = 3 + random(8), faces = random(run % 3 == 2 ? 14 : 4);
    for (int i = 0; i < points; ++i) s.points.emplace_back(random(3), random(3), random(2));
    for (int f = 0; f < faces; ++f) {
      std::vector<int> polygon;
      for (int k = 2 + random(4); k > 0; --k) polygon.push_back(random(s.number_of_points()));
      add(s, polygon);
    }
    if (s.corner.size() > 4)
      for (int k = random(4); k > 0; --k)
        s.corner[random(int(s.corner.size()))] = random(s.number_of_points());
    Mend_options options;
    options.cut_non_manifold_edges = random(2);
    options.fill_holes = random(2) * 8;
    check_surface(s);
    const Result<Mended_surface> result = mend_surface(s, options);
    if (!result) {
      REQUIRE(result.error().code == Error_code::not_a_surface);
      continue;
    }
    for (const Mended_component& c : result->components) require_sound(c, s);
    taken += int(result->components.size());
    // Mending is finished: what came out is taken again as it is, unless rims that were left apart now look
    // like one.
    const Triangle_surface& first = result->components[0].surface;
    const Result<Mended_surface> again = mend_surface(polygon_soup(first));
    if (!again || count_of(*again, "merged") + count_of(*again, "T-junction") > 0) continue;
    ++taken_again;
    REQUIRE(count_of(*again, "fans") + count_of(*again, "agree") + count_of(*again, "outward") == 0);
  }
  CHECK(taken > 2000);
  CHECK(taken_again > 1000);
}

// ------------------------------------------------------------------------------------------------- files

// EXPECTED.tsv: the file; 3 if it must be unreadable, 4 if it is no surface, 0 if it is one; words of the
// sentence.
TEST_CASE("every file of the corpus ends as its table says") {
  std::ifstream table(std::string(REEBQUAD_TEST_DIR) + "/corpus/EXPECTED.tsv");
  std::string line;
  REQUIRE(std::getline(table, line));
  int files = 0;
  for (; std::getline(table, line); ++files) {
    std::istringstream in(line);
    std::string file, code, says, message;
    std::getline(in, file, '\t');
    std::getline(in, code, '\t');
    std::getline(in, says, '\t');
    const Result<Polygon_soup> read = read_polygon_soup(std::string(REEBQUAD_TEST_DIR) + "/corpus/" + file);
    std::string got = "3";
    if (read) {
      const Result<Mended_surface> result = mend_surface(*read);
      got = result ? "0" : "4";
      if (!result) message = result.error().message;
    } else {
      message = read.error().message;
    }
    INFO(file << ": " << message);
    CHECK(got == code);
    CHECK(message.find(says) != std::string::npos);
  }
  CHECK(files >= 19);
}

TEST_CASE("the real meshes have the genus, the boundaries and the components of their table", "[models]") {
  const std::optional<std::string> list = model_file("TABLE.tsv");
  if (!list) return;
  std::ifstream table(*list);
  std::string line;
  std::getline(table, line);
  int meshes = 0;
  while (std::getline(table, line)) {
    std::istringstream in(line);
    std::string name, file, manifold;
    int points, faces, expected_genus, boundaries, components;
    in >> name >> file >> points >> faces >> expected_genus >> boundaries >> components >> manifold;
    if (manifold != "yes") continue;
    INFO(name);
    const std::optional<std::string> path = model_file(file);
    REQUIRE(path);
    const Result<Polygon_soup> read = read_polygon_soup(*path);
    if (!read) FAIL(read.error().message);
    CHECK(read->number_of_points() == points);
    CHECK(read->number_of_polygons() == faces);
    const Surface_check check = check_surface(*read);
    CHECK(int(check.components.size()) == components);
    const Result<Mended_surface> result = mend_surface(*read);
    if (!result) FAIL(result.error().message);
    CHECK(result->refused.empty());
    CHECK(int(result->components.size()) == components);
    int total_genus = 0, loops = 0, vertices = 0, triangles = 0;
    for (const Mended_component& c : result->components) {
      total_genus += genus(c.surface);
      loops += int(boundary_loops(c.surface).size());
      vertices += c.surface.number_of_vertices();
      triangles += c.surface.number_of_faces();
    }
    CHECK(total_genus == expected_genus);
    CHECK(loops == boundaries);
    CHECK(vertices == points);
    CHECK(triangles == faces);
    ++meshes;
  }
  CHECK(meshes == 60);
}
