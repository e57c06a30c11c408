// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_files.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/plane_contour.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cstdint>
#include <limits>
#include <map>

using namespace CGAL::Reeb_quadrangulation;
using Eigen::Vector3d;

namespace {

// The surface of an n x n x n lattice cube with vertices at integers.
Triangle_surface lattice_cube(int n) {
  Triangle_surface s;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](int axis, int i, int j, int k) {
    std::array<int, 3> p{};
    p[axis] = k;
    p[(axis + 1) % 3] = i;
    p[(axis + 2) % 3] = j;
    const auto [found, is_new] = index.insert({p, int(s.points.size())});
    if (is_new) s.points.emplace_back(p[0], p[1], p[2]);
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const int k : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          std::array<int, 4> q = {vertex(axis, i, j, k), vertex(axis, i + 1, j, k),
                                  vertex(axis, i + 1, j + 1, k), vertex(axis, i, j + 1, k)};
          if (k == 0) std::swap(q[1], q[3]);
          s.triangles.push_back({q[0], q[1], q[2]});
          s.triangles.push_back({q[0], q[2], q[3]});
        }
  return tiny::connected(std::move(s));
}

Triangle_surface mapped(Triangle_surface s, const Eigen::Matrix3d& map) {
  for (Point& p : s.points) p = map * p;
  return s;
}

// Integral multiples of rotations: they keep lattice points on lattice planes.
std::vector<Eigen::Matrix3d> exact_maps() {
  Eigen::Matrix3d about_z, about_x;
  about_z << 3, -4, 0, 4, 3, 0, 0, 0, 5;
  about_x << 13, 0, 0, 0, 5, -12, 0, 12, 5;
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  return {identity,
          about_z,
          about_x,
          about_z * about_x,
          std::ldexp(1.0, 300) * about_z * about_x,
          std::ldexp(1.0, -300) * about_x * about_z};
}

// The plane whose normal is the image of `normal`: for multiples of rotations, the mapped plane.
Cutting_plane mapped_plane(const Eigen::Matrix3d& map, const Point& point, const Vector3d& normal) {
  return Cutting_plane::at(map * point, map * normal);
}

// What holds for every plane and surface.
Plane_curves checked_curves(const Triangle_surface& s, const Cutting_plane& plane) {
  Result<Plane_curves> result = plane_curves(s, plane);
  REQUIRE(bool(result));
  REQUIRE(int(result->is_above.size()) == s.number_of_vertices());
  const auto runs_down = [&](int h) {
    return result->is_above[s.source(h)] && !result->is_above[s.target(h)];
  };
  std::vector<int> crossed(s.number_of_halfedges(), 0);
  bool right = true; // one assertion in the end: there are millions of crossings
  const bool is_closed_surface = boundary_loops(s).empty();
  int last_first_face = -1;
  for (const Plane_curve& curve : result->curves) {
    const std::size_t n = curve.crossings.size();
    right &= curve.faces.size() == (curve.is_closed ? n : n - 1);
    right &= curve.is_closed || !is_closed_surface;
    right &= last_first_face < curve.faces.at(0);
    last_first_face = curve.faces.at(0);
    for (const Edge_crossing& c : curve.crossings) {
      right &= s.edge(c.halfedge) == c.halfedge && 0 < c.t && c.t < 1;
      ++crossed[c.halfedge];
    }
    for (std::size_t i = 0; i < curve.faces.size(); ++i) {
      // In its face the curve comes in over the edge that runs down, so that the upper side is on its left.
      int in = curve.crossings[i].halfedge, out = curve.crossings[(i + 1) % n].halfedge;
      if (in / 3 != curve.faces[i]) in = s.opposite[in];
      if (out / 3 != curve.faces[i]) out = s.opposite[out];
      right &= in >= 0 && out >= 0 && in / 3 == curve.faces[i] && out / 3 == curve.faces[i];
      right &= runs_down(in) && !runs_down(out);
    }
    if (!curve.is_closed)
      right &=
          s.is_boundary(curve.crossings.front().halfedge) && s.is_boundary(curve.crossings.back().halfedge);
  }
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    if (s.edge(h) == h)
      right &= crossed[h] == (result->is_above[s.source(h)] != result->is_above[s.target(h)] ? 1 : 0);
  CHECK(right);
  return std::move(*result);
}

int number_of_curves(const Triangle_surface& s, const Cutting_plane& plane) {
  return int(checked_curves(s, plane).curves.size());
}

bool same_combinatorics(const Plane_curves& a, const Plane_curves& b) {
  if (a.is_above != b.is_above || a.curves.size() != b.curves.size()) return false;
  for (std::size_t i = 0; i < a.curves.size(); ++i)
    if (a.curves[i].faces != b.curves[i].faces || a.curves[i].is_closed != b.curves[i].is_closed)
      return false;
  return true;
}

// A fixed sequence of integers in [-bound, bound] (Marsaglia's xorshift).
class Integers {
public:
  std::int64_t operator()(std::int64_t bound) {
    m_state ^= m_state << 13;
    m_state ^= m_state >> 7;
    m_state ^= m_state << 17;
    return std::int64_t(m_state % std::uint64_t(2 * bound + 1)) - bound;
  }

private:
  std::uint64_t m_state = 88172645463325252ull;
};

__extension__ typedef __int128 Wide;

} // namespace

TEST_CASE("a plane through four vertices and along four edges of the octahedron cuts below them") {
  for (const Eigen::Matrix3d& map : exact_maps()) {
    const Triangle_surface s = mapped(tiny::octahedron(), map);
    for (const Vector3d& normal : {Vector3d(0, 0, 1), Vector3d(0, 0, -1)}) {
      const Plane_curves cut = checked_curves(s, mapped_plane(map, Point(0, 0, 0), normal));
      REQUIRE(cut.curves.size() == 1);
      CHECK(cut.curves[0].is_closed);
      CHECK(cut.curves[0].crossings.size() == 4);
      const int apex = normal.z() > 0 ? 5 : 4; // the only vertex that is not above
      for (int v = 0; v < 6; ++v) CHECK(bool(cut.is_above[v]) == (v != apex));
    }
  }
}

TEST_CASE("a plane that contains a face of a lattice cube cuts just inside it or not at all") {
  for (const Eigen::Matrix3d& map : exact_maps()) {
    const Triangle_surface s = mapped(lattice_cube(3), map);
    CHECK(number_of_curves(s, mapped_plane(map, Point(0, 1, 2), Vector3d(1, 0, 0))) == 0);
    const Plane_curves inside = checked_curves(s, mapped_plane(map, Point(0, 1, 2), Vector3d(-1, 0, 0)));
    REQUIRE(inside.curves.size() == 1);
    // 12 edges along x and 12 diagonals leave the rim of the face.
    CHECK(inside.curves[0].crossings.size() == 24);
  }
}

TEST_CASE("planes along edges and diagonals of a lattice cube give one closed curve") {
  const std::vector<std::pair<Point, Vector3d>> planes = {
      {Point(1, 0, 0), Vector3d(1, 0, 0)},  {Point(2, 2, 2), Vector3d(0, 1, 0)},
      {Point(0, 0, 0), Vector3d(1, -1, 0)}, {Point(1, 1, 1), Vector3d(1, 1, 1)},
      {Point(3, 0, 0), Vector3d(1, 1, 0)},  {Point(2, 1, 1), Vector3d(-3, 2, 1)}};
  for (const auto& [point, normal] : planes) {
    const Plane_curves first = checked_curves(lattice_cube(3), Cutting_plane::at(point, normal));
    CHECK(first.curves.size() == 1);
    for (const Eigen::Matrix3d& map : exact_maps())
      CHECK(same_combinatorics(
          first, checked_curves(mapped(lattice_cube(3), map), mapped_plane(map, point, normal))));
  }
}

TEST_CASE("three points and a normal decide alike, also on the plane") {
  const Triangle_surface cube = lattice_cube(4);
  Integers random;
  for (int i = 0; i < 200; ++i) {
    const auto point = [&] { return Point(double(random(4)), double(random(4)), double(random(4))); };
    const Point p = point(), q = point(), r = point();
    const Vector3d normal = (q - p).cross(r - p); // exact: small integers
    const Cutting_plane three = Cutting_plane::through(p, q, r);
    if (normal.isZero(0)) {
      const auto refused = plane_curves(cube, three);
      REQUIRE(!refused);
      CHECK(refused.error().code == Error_code::impossible_request);
      continue;
    }
    CHECK(
        same_combinatorics(checked_curves(cube, three), checked_curves(cube, Cutting_plane::at(p, normal))));
    CHECK(three.unit_normal().isApprox(normal.normalized(), 1e-14));
  }
}

TEST_CASE("sides are exact where doubles are not") {
  Integers random;
  int on_plane = 0, misjudged = 0;
  Triangle_surface one; // classified, never traced
  one.points.resize(1);
  for (int i = 0; i < 20000; ++i) {
    // n . x = 0 by construction, or off by one in the last coordinate.
    const std::int64_t a = random(1 << 20), b = random(1 << 20), c = 1 + std::abs(random(1 << 10));
    const std::int64_t x = c * random(1 << 20), y = c * random(1 << 20), off = random(1);
    const std::int64_t z = -(a * (x / c) + b * (y / c)) + off;
    const Point normal = Vector3d(double(a), double(b), double(c)),
                p = Vector3d(double(x), double(y), double(z));
    one.points[0] = p * 0.125;
    const auto above = classify_vertices(one, Cutting_plane::at(Point(0, 0, 0), normal));
    REQUIRE(bool(above));
    const Wide exact = Wide(a) * x + Wide(b) * y + Wide(c) * z;
    CHECK(bool((*above)[0]) == (exact >= 0));
    on_plane += exact == 0;
    misjudged +=
        (normal.x() / 3 * p.x() + normal.y() / 3 * p.y() + normal.z() / 3 * p.z() >= 0) != (exact >= 0);
  }
  CHECK(on_plane > 5000);
  CHECK(misjudged > 100); // so the test is one that rounding fails
}

TEST_CASE("an offset of any size decides") {
  const Triangle_surface s = tiny::octahedron();
  for (const double offset : {1e-300, 4.9406564584124654e-324, 1e-16}) {
    const Plane_curves above = checked_curves(s, Cutting_plane::at(Point(0, 0, -offset), Vector3d(0, 0, 1)));
    const Plane_curves below = checked_curves(s, Cutting_plane::at(Point(0, 0, offset), Vector3d(0, 0, 1)));
    CHECK(above.is_above == std::vector<char>{1, 1, 1, 1, 1, 0});
    CHECK(below.is_above == std::vector<char>{0, 0, 0, 0, 1, 0});
    CHECK(above.curves.size() == 1);
    CHECK(below.curves.size() == 1);
    const Cutting_plane tilted =
        Cutting_plane::through(Point(1, 0, offset), Point(0, 1, 0), Point(-1, 0, -offset));
    CHECK(checked_curves(s, tilted).is_above == std::vector<char>{0, 1, 1, 1, 1, 0});
  }
}

TEST_CASE("curves of planes across a torus") {
  for (const Triangle_surface& s : {tiny::torus(3, 3), tiny::torus(24, 12), tiny::torus(23, 11)}) {
    CHECK(number_of_curves(s, Cutting_plane::at(Point(0.1, 0, 0), Vector3d(1, 0, 0))) == 2);
    CHECK(number_of_curves(s, Cutting_plane::at(Point(0, 0, 0.01), Vector3d(0, 0, 1))) == 2);
    CHECK(number_of_curves(s, Cutting_plane::at(Point(1.1, 0, 0), Vector3d(1, 0, 0))) == 1);
    CHECK(number_of_curves(s, Cutting_plane::at(Point(2, 0, 0), Vector3d(1, 0, 0))) == 0);
  }
}

TEST_CASE("curves of planes across a double torus") {
  const Result<Triangle_surface> s = make_shape("bitorus", 2000);
  REQUIRE(bool(s));
  CHECK(number_of_curves(*s, Cutting_plane::at(Point(0, 0, 0), Vector3d(0, 0, 1))) ==
        3); // the rim and two holes
  CHECK(number_of_curves(*s, Cutting_plane::at(Point(0, 0, 0), Vector3d(0, 1, 0))) == 3); // three tubes
  CHECK(number_of_curves(*s, Cutting_plane::at(Point(1, 0, 0), Vector3d(1, 0, 0))) == 1); // between the tori
}

TEST_CASE("curves end on boundaries and nowhere else") {
  const Triangle_surface s = tiny::open_cylinder(12, 5);
  const Plane_curves along = checked_curves(s, Cutting_plane::at(Point(0.1, 0, 0), Vector3d(1, 0, 0)));
  REQUIRE(along.curves.size() == 2);
  for (const Plane_curve& curve : along.curves) CHECK(!curve.is_closed);
  const Plane_curves across = checked_curves(s, Cutting_plane::at(Point(0, 0, 0.4), Vector3d(0, 0, 1)));
  REQUIRE(across.curves.size() == 1);
  CHECK(across.curves[0].is_closed);
  // A slope that leaves through one end only.
  const Plane_curves slope = checked_curves(s, Cutting_plane::at(Point(0, 0, 0.3), Vector3d(1, 0, 1)));
  REQUIRE(slope.curves.size() == 1);
  CHECK(!slope.curves[0].is_closed);
}

TEST_CASE("on closed surfaces the curves are those between two ranks of an order") {
  for (const Triangle_surface& s : {tiny::torus(24, 12), lattice_cube(4)}) {
    const Plane_curves cut = checked_curves(s, Cutting_plane::at(Point(0.5, 0.25, 0), Vector3d(1, 2, 0.5)));
    std::vector<double> two_values(cut.is_above.begin(), cut.is_above.end());
    const Vertex_order order = order_vertices(two_values);
    int threshold = -1;
    for (char above : cut.is_above) threshold += !above;
    for (const Plane_curve& curve : cut.curves) {
      int first = curve.crossings.back().halfedge; // the exit from the last face is the entry to the first
      if (order.rank[s.source(first)] > threshold) first = s.opposite[first];
      const Traced_contour traced = trace_threshold(s, order, Rank(threshold), Halfedge_index(first));
      std::vector<int> edges, expected;
      for (int h : traced.halfedges) edges.push_back(s.edge(h));
      expected.push_back(curve.crossings.back().halfedge);
      for (std::size_t i = 0; i + 1 < curve.crossings.size(); ++i)
        expected.push_back(curve.crossings[i].halfedge);
      CHECK(edges == expected);
    }
  }
}

TEST_CASE("points are on the plane, but never at a vertex") {
  const Triangle_surface s = tiny::torus(24, 12);
  const Vector3d normal = Vector3d(1, 2, 3).normalized();
  const Cutting_plane plane = Cutting_plane::at(Point(0.3, 0.1, 0), normal);
  for (const Plane_curve& curve : checked_curves(s, plane).curves) {
    const std::vector<Point> points = curve_points(s, curve);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const double t = curve.crossings[i].t; 1e-3 < t && t < 1 - 1e-3)
        CHECK(std::abs(normal.dot(points[i] - plane.point())) < 1e-14);
  }
  Plane_curves cut = checked_curves(tiny::octahedron(), Cutting_plane::at(Point(0, 0, 0), Vector3d(0, 0, 1)));
  place_crossings(tiny::octahedron(), Cutting_plane::at(Point(0, 0, 0), Vector3d(0, 0, 1)), 0.25, cut.curves);
  for (const Point& p : curve_points(tiny::octahedron(), cut.curves[0])) CHECK(p.z() == -0.25);
}

TEST_CASE("the nearest of two curves") {
  const Triangle_surface s = tiny::torus(24, 12);
  const Plane_curves cut = checked_curves(s, Cutting_plane::at(Point(0.1, 0, 0), Vector3d(1, 0, 0)));
  REQUIRE(cut.curves.size() == 2);
  for (const double y : {-1.0, 1.0}) {
    const int nearest = nearest_curve(s, cut.curves, Point(0, y, 0));
    REQUIRE(nearest >= 0);
    for (const Point& p : curve_points(s, cut.curves[nearest])) CHECK(p.y() * y > 0);
  }
  CHECK(nearest_curve(s, {}, Point(0, 0, 0)) == -1);
}

TEST_CASE("what is no plane is refused") {
  const Triangle_surface s = tiny::tetrahedron();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Cutting_plane& plane :
       {Cutting_plane::at(Point(0, 0, 0), Vector3d(0, 0, 0)),
        Cutting_plane::at(Point(0, nan, 0), Vector3d(1, 0, 0)),
        Cutting_plane::at(Point(0, 0, 0), Vector3d(1, INFINITY, 0)),
        Cutting_plane::through(Point(0, 0, 0), Point(1, 1, 1), Point(3, 3, 3)),
        Cutting_plane::through(Point(1, 0, 0), Point(1, 0, 0), Point(0, 3, 3))}) {
    const auto result = plane_curves(s, plane);
    REQUIRE(!result);
    CHECK(result.error().code == Error_code::impossible_request);
  }
  Triangle_surface bad = s;
  bad.points[2].y() = nan;
  const auto result = plane_curves(bad, Cutting_plane::at(Point(0, 0, 0), Vector3d(1, 0, 0)));
  REQUIRE(!result);
  CHECK(result.error().code == Error_code::not_a_surface);
  CHECK(result.error().index == 2);
}

TEST_CASE("real meshes, cut through vertices and along triangles", "[models]") {
  for (const char* name : {"bunny_low.off", "double_torus.obj", "coupling_g9.off", "aqua_center_open.off"}) {
    const std::optional<Triangle_surface> found = model(name);
    if (!found) continue;
    const Triangle_surface& s = *found;
    for (int i = 1; i <= 3; ++i) {
      const Triangle& t = s.triangles[s.number_of_faces() / 4 * i];
      for (int axis = 0; axis < 3; ++axis)
        checked_curves(s, Cutting_plane::at(s.points[t[0]], Vector3d::Unit(axis)));
      const Plane_curves cut =
          checked_curves(s, Cutting_plane::through(s.points[t[0]], s.points[t[1]], s.points[t[2]]));
      for (int v : t) CHECK(cut.is_above[v] == 1);
    }
  }
}
