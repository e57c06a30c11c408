// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/decimate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>
#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

const double pi = std::acos(-1.0);

Triangle_surface shape(const std::string& name, int triangles = 2000) {
  auto result = make_shape(name, triangles);
  REQUIRE(bool(result));
  return *result;
}

double volume(const Triangle_surface& s) {
  double sum = 0;
  for (const Triangle& t : s.triangles) sum += s.points[t[0]].dot(s.points[t[1]].cross(s.points[t[2]])) / 6;
  return sum;
}

void check_on_surface(const Triangle_surface& s, const std::function<double(const Point&)>& distance) {
  double largest = 0;
  for (const Point& p : s.points) largest = std::max(largest, std::abs(distance(p)));
  CHECK(largest < 1e-13);
}

// The number of vertices of each valence is not that of a lattice: irregular ones are spread over the
// surface.
double irregular_fraction(const Triangle_surface& s) {
  std::vector<int> valence(s.number_of_vertices(), 0);
  for (const Triangle& t : s.triangles)
    for (int v : t) ++valence[v];
  return double(std::count_if(valence.begin(), valence.end(), [](int n) { return n != 6; })) /
         double(valence.size());
}

double least_angle(const Triangle_surface& s) {
  double least = pi;
  for (const Triangle& t : s.triangles)
    for (int i = 0; i < 3; ++i) {
      const Point u = s.points[t[(i + 1) % 3]] - s.points[t[i]],
                  v = s.points[t[(i + 2) % 3]] - s.points[t[i]];
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  return least * 180 / pi;
}

// The sharp edges' total length: edges whose faces turn by more than 60 degrees.
double crease_length(const Triangle_surface& s) {
  const auto normal = [&](int h) -> Point {
    const Triangle& t = s.triangles[h / 3];
    return (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]).normalized();
  };
  double sum = 0;
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    if (h < s.opposite[h] && normal(h).dot(normal(s.opposite[h])) < 0.5)
      sum += (s.points[s.source(h)] - s.points[s.target(h)]).norm();
  return sum;
}

} // namespace

TEST_CASE(
    "every shape is one oriented manifold of its genus and boundaries, near the asked size, and irregular") {
  std::vector<std::string> names{"genus-1", "genus-3", "genus-7", "genus-12"};
  for (const Shape_info& info : shape_names())
    if (info.name != "genus-N") names.push_back(info.name);
  for (const std::string& name : names) {
    INFO(name);
    const Shape_info info = *shape_info(name);
    CHECK(info.name == name);
    const Triangle_surface s = shape(name, 3000);
    CHECK(connected_components(s).second == 1);
    CHECK(euler_characteristic(s) == 2 - 2 * info.genus - info.boundaries);
    CHECK(int(boundary_loops(s).size()) == info.boundaries);
    CHECK(std::count(s.outgoing.begin(), s.outgoing.end(), -1) == 0);
    if (info.boundaries == 0) CHECK(volume(s) > 0);
    if (name == "tetrahedron" || name == "octahedron") continue;
    CHECK(s.number_of_faces() == Approx(3000).epsilon(0.15));
    CHECK(irregular_fraction(s) > 0.2);
    CHECK(least_angle(s) > 10);
  }
}

TEST_CASE("the same call gives the same bytes") {
  for (const char* name : {"hand", "twisted-bar", "cylinder"}) {
    const Triangle_surface a = shape(name, 1500), b = shape(name, 1500);
    REQUIRE(a.points.size() == b.points.size());
    CHECK(a.triangles == b.triangles);
    CHECK(std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)) == 0);
  }
}

TEST_CASE("large shapes are refined from small ones, still on the exact surface and near the asked size") {
  const Triangle_surface s = shape("sphere", 120000);
  CHECK(s.number_of_faces() == Approx(120000).epsilon(0.15));
  CHECK(euler_characteristic(s) == 2);
  check_on_surface(s, [](const Point& p) { return p.norm() - 1; });
}

TEST_CASE("vertices lie on the exact surfaces") {
  check_on_surface(shape("sphere"), [](const Point& p) { return p.norm() - 1; });
  check_on_surface(shape("ellipsoid"),
                   [](const Point& p) { return p.cwiseQuotient(Point(1, 0.7, 2)).norm() - 1; });
  check_on_surface(shape("torus"),
                   [](const Point& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4; });
  check_on_surface(shape("cylinder"), [](const Point& p) { return std::hypot(p.x(), p.y()) - 1; });
}

TEST_CASE("the cylinder's loops lie exactly at its two ends") {
  const Triangle_surface s = shape("cylinder");
  std::set<double> heights;
  for (const auto& loop : boundary_loops(s))
    for (int h : loop) heights.insert(s.points[s.source(h)].z());
  CHECK(heights == std::set<double>{0, 3});
}

TEST_CASE("shapes with sharp edges keep all of them, and exact volume and area") {
  const Triangle_surface cube = shape("cube");
  CHECK(volume(cube) == Approx(1).epsilon(1e-12));
  CHECK(area(cube) == Approx(6).epsilon(1e-12));
  CHECK(crease_length(cube) == Approx(12).epsilon(1e-12));
  const Triangle_surface l = shape("l-shape");
  CHECK(volume(l) == Approx(3).epsilon(1e-12));
  CHECK(area(l) == Approx(14).epsilon(1e-12));
  CHECK(crease_length(l) == Approx(22).epsilon(1e-12)); // two hexagons of length 8 and six edges of length 1
}

TEST_CASE("the twisted bar is a bar when turned back") {
  Triangle_surface s = shape("twisted-bar");
  for (Point& p : s.points) p = Eigen::AngleAxisd(-pi * p.z() / 4, Point::UnitZ()) * p;
  check_on_surface(s, [](const Point& p) {
    const double sides = 0.5 - std::max(std::abs(p.x()), std::abs(p.y())), ends = std::min(p.z(), 4 - p.z());
    return std::min(sides, ends);
  });
  CHECK(crease_length(s) == Approx(24).epsilon(1e-12));
}

TEST_CASE("the hand has four fingers above its palm, and a thumb at the side") {
  const Triangle_surface s = shape("hand", 6000);
  const auto is_above = [&](int v) { return s.points[v].z() > 0.7; };
  std::vector<int> root(s.points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v];
    return v;
  };
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    if (is_above(s.source(h)) && is_above(s.target(h))) root[find(s.source(h))] = find(s.target(h));
  int pieces = 0;
  for (int v = 0; v < s.number_of_vertices(); ++v) pieces += is_above(v) && root[v] == v;
  CHECK(pieces == 4);
  CHECK(std::any_of(s.points.begin(), s.points.end(),
                    [](const Point& p) { return p.x() > 1.1 && p.z() < 0.7; }));
}

TEST_CASE("unknown shapes and sizes are refused with the names that exist") {
  for (const char* name : {"", "genus-0", "genus-13", "genus-N", "genus-2x", "Sphere", "teapot"}) {
    const auto refused = make_shape(name, 1000);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == Error_code::impossible_request);
    CHECK(refused.error().message.find("twisted-bar") != std::string::npos);
  }
  for (int n : {-1, 0, 399, 4000001}) CHECK_FALSE(make_shape("sphere", n));
  CHECK_FALSE(make_shape("genus-12", 1100));
}
