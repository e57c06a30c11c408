// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate passes on sound meshes, and each check fails on the mutation that it is there for.
#include "tiny_quads.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/surface_intersections.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <limits>
#include <random>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using Names = std::set<std::string>;

namespace {

Names with_status(const Certificate& certificate, Check_status status) {
  Names names;
  for (const Certificate_check& check : certificate.checks)
    if (check.status == status) names.insert(check.name);
  return names;
}

Names names_of(const std::vector<Shape_warning>& warnings) {
  Names names;
  for (const Shape_warning& w : warnings) names.insert(w.name);
  return names;
}

Names failed(const Certificate& certificate) {
  return with_status(certificate, Check_status::failed);
}

// The checks that fail when the sound mesh stands for the input and its valences for the prediction.
Certificate certify_against(const Quad_mesh& sound, const Quad_mesh& mutant) {
  const Triangle_surface input = tiny::triangulated(sound);
  const auto predicted = certify({sound, &input}).interior_valences;
  return certify({mutant, &input, predicted});
}

void require_sound(const Quad_mesh& mesh) {
  const Certificate certificate = certify_against(mesh, mesh);
  CAPTURE(to_text(certificate));
  CHECK(failed(certificate).empty());
  CHECK(with_status(certificate, Check_status::not_checked) == Names{"distance"}); // no limit was given
  CHECK(certificate.passed);
  CHECK(certificate.strictly_valid);
  for (const Certificate_check& check : certificate.checks)
    if (check.status == Check_status::passed) CHECK(check.message.empty());
}

} // namespace

TEST_CASE("Sound meshes pass every check") {
  require_sound(tiny::quad_cube());
  require_sound(tiny::quad_torus(8, 6));
  require_sound(tiny::quad_cylinder(7, 3));
  require_sound(tiny::two_cubes());
  require_sound(tiny::subdivided(tiny::subdivided(tiny::quad_cube())));
}

TEST_CASE("The certificate counts what it certifies") {
  const Quad_mesh cylinder = tiny::quad_cylinder(7, 3);
  const Triangle_surface input = tiny::triangulated(cylinder);
  const Certificate c = certify({cylinder, &input});
  CHECK(c.vertices == 28);
  CHECK(c.edges == 7 * 4 + 7 * 3);
  CHECK(c.quads == 21);
  REQUIRE(c.components.size() == 1);
  CHECK(c.components[0].boundary_loops == 2);
  CHECK(c.components[0].euler_characteristic() == 0);
  CHECK(c.interior_valences == std::map<int, int>{{4, 14}});
  CHECK(c.boundary_valences == std::map<int, int>{{3, 14}});
  REQUIRE(c.input_components.size() == 1);
  CHECK(c.input_components[0].boundary_loops == 2);
  CHECK(c.input_components[0].faces == 42);
}

TEST_CASE("A dropped quad opens the surface") {
  Quad_mesh mesh = tiny::quad_torus(6, 5);
  mesh.quads.erase(mesh.quads.begin() + 7);
  const Certificate c = certify_against(tiny::quad_torus(6, 5), mesh);
  CHECK(failed(c) == Names{"watertight", "euler_characteristic", "valences"});
  CHECK_FALSE(c.passed);
  CHECK(c.check("watertight").measured == 1);
  CHECK(c.check("watertight").expected == 0);
  CHECK(c.check("watertight").element == Element_kind::vertex);
}

TEST_CASE("Without an input, a surface with boundary is not watertight") {
  CHECK(failed(certify({tiny::quad_cylinder(5, 2)})) == Names{"watertight"});
  CHECK(failed(certify({tiny::quad_cube()})).empty());
  CHECK(with_status(certify({tiny::quad_cube()}), Check_status::not_checked) ==
        Names{"components", "euler_characteristic", "valences", "outward", "distance"});
}

TEST_CASE("A flipped quad breaks the orientation alone") {
  Quad_mesh mesh = tiny::subdivided(tiny::quad_cube());
  std::swap(mesh.quads[5][1], mesh.quads[5][3]);
  const Certificate c = certify_against(tiny::subdivided(tiny::quad_cube()), mesh);
  CHECK(failed(c) == Names{"oriented"});
  CHECK(c.check("oriented").measured == 4);
}

TEST_CASE("A duplicate quad is no quad, in whatever order its vertices come") {
  Quad_mesh mesh = tiny::quad_cube();
  mesh.quads.push_back({1, 0, 2, 3});
  const Certificate c = certify_against(tiny::quad_cube(), mesh);
  CHECK(failed(c) == Names{"all_quads"});
  CHECK(c.check("all_quads").index == 6);
}

TEST_CASE("Faces that are no quads are found and left out") {
  SECTION("a repeated vertex") {
    Quad_mesh mesh = tiny::quad_cube();
    mesh.quads[2] = {0, 1, 5, 1};
    const Certificate c = certify_against(tiny::quad_cube(), mesh);
    CHECK(failed(c) == Names{"all_quads", "watertight", "euler_characteristic", "valences"});
    CHECK(c.check("all_quads").index == 2);
  }
  SECTION("an index out of range") {
    for (int bad : {-1, 8, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
      Quad_mesh mesh = tiny::quad_cube();
      mesh.quads[3][1] = bad;
      const Certificate c = certify_against(tiny::quad_cube(), mesh);
      CHECK(failed(c).count("all_quads") == 1);
      CHECK(c.check("all_quads").index == 3);
    }
  }
  SECTION("nothing at all") {
    CHECK(failed(certify({Quad_mesh{}})) == Names{"all_quads"});
    CHECK(failed(certify_against(tiny::quad_cube(), Quad_mesh{})) ==
          Names{"all_quads", "components", "euler_characteristic", "valences"});
  }
}

TEST_CASE("A swapped index is found") {
  Quad_mesh mesh = tiny::quad_torus(6, 5);
  std::swap(mesh.quads[8][0], mesh.quads[20][2]);
  CHECK_FALSE(certify_against(tiny::quad_torus(6, 5), mesh).passed);
}

TEST_CASE("A third quad at an edge is found") {
  Quad_mesh mesh = tiny::quad_cube();
  mesh.points.emplace_back(-1, -1, 0);
  mesh.points.emplace_back(-1, -1, 1);
  mesh.quads.push_back({0, 4, 9, 8});
  const Certificate c = certify_against(tiny::quad_cube(), mesh);
  CHECK(failed(c).count("manifold_edges") == 1);
  CHECK(c.check("manifold_edges").measured == 1);
  CHECK(c.check("manifold_edges").index == 0);
  CHECK(failed(c).count("manifold_vertices") == 0);
}

TEST_CASE("A pinched vertex is found") {
  // Two vertices far apart on a torus become one.
  Quad_mesh mesh = tiny::quad_torus(8, 6);
  const int kept = 3, gone = 4 * 6 + 3;
  for (Quad& q : mesh.quads)
    for (int& v : q)
      if (v == gone) v = kept;
  const Certificate c = certify_against(tiny::quad_torus(8, 6), mesh);
  CHECK(failed(c).count("manifold_vertices") == 1);
  CHECK(c.check("manifold_vertices").index == kept);
  CHECK(c.check("no_unreferenced_vertices").measured == 1);
  CHECK(c.check("euler_characteristic").measured == -1);
  CHECK_FALSE(c.passed);
}

TEST_CASE("A pinch on the boundary breaks the sum of valences, and keeps its loops apart") {
  Quad_mesh mesh = tiny::quad_cylinder(8, 2);
  for (Quad& q : mesh.quads)
    for (int& v : q)
      if (v == 4) v = 0; // both on the lower loop
  const Certificate c = certify({mesh});
  CHECK(failed(c).count("valence_sum") == 1);
  CHECK(failed(c).count("manifold_vertices") == 1);
  CHECK(c.check("watertight").measured == 2);
}

TEST_CASE("Two components glued at a vertex are one component that is not manifold") {
  Quad_mesh mesh = tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(1, 1, 1)));
  for (Quad& q : mesh.quads)
    for (int& v : q)
      if (v == 8) v = 7;
  mesh.points.erase(mesh.points.begin() + 8);
  for (Quad& q : mesh.quads)
    for (int& v : q)
      if (v > 8) --v;
  const Certificate c =
      certify_against(tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(1, 1, 1))), mesh);
  CHECK(failed(c) == Names{"manifold_vertices", "components", "euler_characteristic", "valences"});
  CHECK(c.check("components").measured == 1);
}

TEST_CASE("A lost component is found") {
  const Certificate c = certify_against(tiny::two_cubes(), tiny::quad_cube());
  CHECK(failed(c) == Names{"components", "euler_characteristic", "valences"});
}

TEST_CASE("Components are compared one by one, not by their sum") {
  // Sphere and double torus against two tori: the same number of components and the same sum.
  const Quad_mesh tori = tiny::together(tiny::quad_torus(8, 6), tiny::quad_torus(8, 6, 0.2));
  Quad_mesh two = tiny::together(tiny::quad_torus(8, 6), tiny::quad_torus(8, 6));
  // Joins the tori by a tube of four quads between a quad of each.
  const Quad a = two.quads[10], b = two.quads[58];
  two.quads.erase(two.quads.begin() + 58);
  two.quads.erase(two.quads.begin() + 10);
  for (int i = 0; i < 4; ++i) two.quads.push_back({a[i], a[(i + 1) % 4], b[(7 - i) % 4], b[(8 - i) % 4]});
  const Quad_mesh mesh = tiny::together(two, tiny::quad_cube(Point(5, 0, 0)));
  const Certificate c = certify_against(tori, mesh);
  CAPTURE(to_text(c));
  CHECK(failed(c).count("components") == 0);
  CHECK(failed(c).count("manifold_edges") == 0);
  CHECK(failed(c).count("oriented") == 0);
  CHECK(c.check("euler_characteristic").measured == c.check("euler_characteristic").expected);
  CHECK(failed(c).count("euler_characteristic") == 1);
}

TEST_CASE("A Moebius band cannot be oriented") {
  for (int n : {5, 6, 9}) {
    const Certificate c = certify({tiny::quad_moebius(n)});
    CHECK(failed(c).count("oriented") == 1);
    CHECK(c.check("oriented").measured == 1);
    CHECK(failed(c).count("manifold_edges") == 0);
    CHECK(failed(c).count("manifold_vertices") == 0);
    CHECK(c.check("watertight").measured == 1); // its boundary is one loop
  }
}

TEST_CASE("A mesh turned inside out is found, also when it is one of two components") {
  Quad_mesh mesh = tiny::two_cubes();
  for (int q = 6; q < 12; ++q) std::swap(mesh.quads[q][1], mesh.quads[q][3]);
  const Certificate c = certify_against(tiny::two_cubes(), mesh);
  CHECK(failed(c) == Names{"outward"});
  CHECK(c.check("outward").index == 1);
  CHECK(c.check("outward").measured == Approx(0.5));
}

TEST_CASE("Front and back nearer than rounding: the volume's sign decides, or nothing does") {
  // A panel 440 x 4 of thickness 4e-6: the nearest quad of a point may be one of the other side.
  const auto panel = [](double thickness) {
    Quad_mesh mesh = tiny::subdivided(tiny::subdivided(tiny::quad_cube()));
    for (Point& p : mesh.points) p = Point(440 * p.x(), 4 * p.y(), thickness * p.z());
    return mesh;
  };
  const Quad_mesh sound = panel(4e-6);
  const Triangle_surface input = tiny::triangulated(sound);
  Quad_mesh turned = sound;
  for (Quad& q : turned.quads) std::swap(q[1], q[3]);
  CHECK(certify({sound, &input}).check("outward").status == Check_status::passed);
  const Certificate c = certify({turned, &input});
  CHECK(c.check("outward").status == Check_status::failed);
  CHECK(c.check("outward").index == 0);
  const Quad_mesh flat = panel(0);
  const Triangle_surface flat_input = tiny::triangulated(flat);
  CHECK(certify({flat, &flat_input}).check("outward").status == Check_status::not_checked);
}

TEST_CASE("A spike that the quads leave out says nothing of how they face") {
  const Quad_mesh quads = tiny::subdivided(tiny::subdivided(tiny::quad_cube()));
  Triangle_surface input = tiny::triangulated(quads);
  input.points[0] = Point(-1e5, -2e5, -1e5); // a corner far away: nearly all of the area hangs on it
  const Certificate c = certify({quads, &input});
  CHECK(c.check("outward").status == Check_status::passed);
  CHECK(names_of(c.warnings).count("lost_area") == 1);
  Quad_mesh turned = quads;
  for (Quad& q : turned.quads) std::swap(q[1], q[3]);
  CHECK(failed(certify({turned, &input})) == Names{"outward"});
}

TEST_CASE("Intersections of the input are told apart from those of the quads") {
  const Quad_mesh crossing =
      tiny::subdivided(tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(0.5, 0.3, 0.3))));
  const Triangle_surface input = tiny::triangulated(crossing);
  Certificate c = certify({crossing, &input});
  CHECK(c.passed);
  CHECK_FALSE(c.strictly_valid);
  CHECK(c.valid_as_input);
  CHECK(c.check("no_self_intersections").status == Check_status::passed);
  CHECK(c.input_intersections == int(c.intersecting_quads.size()));
  CHECK(c.input_intersections > 0);
  CHECK(names_of(c.warnings) == Names{"input_intersections"});

  SECTION("against an input that does not intersect itself they are the quads' own") {
    const Triangle_surface apart = tiny::triangulated(tiny::subdivided(tiny::two_cubes()));
    const Certificate own = certify({crossing, &apart});
    CHECK(own.input_intersections == 0);
    CHECK_FALSE(own.valid_as_input);
    CHECK(own.check("no_self_intersections").measured == double(c.intersecting_quads.size()));
  }
  SECTION("a vertex pulled through its own component is not excused by another crossing") {
    Quad_mesh pulled = crossing;
    pulled.points[0] = Point(-0.1, 1.2, 1.3); // the corner (0, 0, 0), far from the other cube
    c = certify({pulled, &input});
    CHECK_FALSE(c.valid_as_input);
    CHECK(c.check("no_self_intersections").status == Check_status::failed);
    CHECK(c.check("no_self_intersections").measured > 0);
  }
}

TEST_CASE("Intersections of a surface are counted within and between its components") {
  const auto counted = [](const Quad_mesh& mesh) { return surface_intersections(tiny::triangulated(mesh)); };
  CHECK(counted(tiny::two_cubes()).pairs.empty());
  const Surface_intersections between =
      counted(tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(0.5, 0.3, 0.3))));
  CHECK(between.within == 0);
  CHECK(between.between == std::int64_t(between.pairs.size()));
  CHECK(between.between > 0);
  Quad_mesh pulled = tiny::subdivided(tiny::subdivided(tiny::quad_cube()));
  pulled.points[0] = Point(1.2, 1.1, 1.3);
  const Surface_intersections within = counted(pulled);
  CHECK(within.within > 0);
  CHECK(within.between == 0);
  const Surface_intersections some = surface_intersections(tiny::triangulated(pulled), 1);
  CHECK(some.pairs.size() == 1);
  CHECK_FALSE(some.is_complete);
}

TEST_CASE("A point that is not finite is found") {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Quad_mesh mesh = tiny::subdivided(tiny::quad_cube());
    mesh.points[9].y() = bad;
    const Certificate c = certify_against(tiny::subdivided(tiny::quad_cube()), mesh);
    CHECK(failed(c) == Names{"finite_points", "no_inverted_quads"});
    CHECK(c.check("finite_points").index == 9);
    CHECK_FALSE(c.passed);
  }
}

TEST_CASE("An unreferenced vertex is found") {
  Quad_mesh mesh = tiny::quad_cube();
  mesh.points.emplace_back(0.5, 0.5, 0.5);
  CHECK(failed(certify_against(tiny::quad_cube(), mesh)) == Names{"no_unreferenced_vertices"});
}

TEST_CASE("Valences are compared with the prediction; valence 4 only when it is named") {
  const Quad_mesh mesh = tiny::subdivided(tiny::quad_cube()); // 8 corners of valence 3, 18 of valence 4
  using Prediction = std::map<int, int>;
  CHECK(failed(certify({mesh, nullptr, Prediction{{3, 8}}})).empty());
  CHECK(failed(certify({mesh, nullptr, Prediction{{3, 8}, {4, 18}}})).empty());
  CHECK(failed(certify({mesh, nullptr, Prediction{{3, 8}, {4, 17}}})) == Names{"valences"});
  CHECK(failed(certify({mesh, nullptr, Prediction{{3, 9}}})) == Names{"valences"});
  CHECK(failed(certify({mesh, nullptr, Prediction{{3, 8}, {5, 1}}})) == Names{"valences"});
  const Certificate c = certify({mesh, nullptr, Prediction{}});
  CHECK(failed(c) == Names{"valences"});
  CHECK(c.check("valences").measured == 8);
  CHECK(c.check("valences").index == 0);
}

TEST_CASE("A vertex moved through its neighbours inverts quads in the plane") {
  // A flat 4 x 4 patch; its vertex 12 is the middle one, 13 and 14 lie to its right.
  Quad_mesh mesh;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) mesh.points.emplace_back(x, y, 0);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      mesh.quads.push_back({5 * y + x, 5 * y + x + 1, 5 * y + x + 6, 5 * y + x + 5});
  CHECK(failed(certify_against(mesh, mesh)).empty());
  Quad_mesh moved = mesh;
  moved.points[12] = Point(3.5, 2, 0);
  const Certificate c = certify_against(mesh, moved);
  CHECK(failed(c) == Names{"no_inverted_quads", "no_self_intersections"});
  CHECK(c.passed);
  CHECK_FALSE(c.strictly_valid);
  CHECK(c.inverted_quads == std::vector<int>{6, 10}); // the two quads to the right of the vertex
}

TEST_CASE("Inverted is where the scaled Jacobian is not positive") {
  const auto inverted = [](std::vector<Point> points) {
    return certify({Quad_mesh{std::move(points), {{0, 1, 2, 3}}}}).inverted_quads.size() == 1;
  };
  CHECK_FALSE(inverted({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}));
  CHECK_FALSE(inverted({Point(0, 0, 0), Point(1, 0, 0), Point(0.51, 0.51, 0), Point(0, 1, 0)}));
  CHECK(
      inverted({Point(0, 0, 0), Point(1, 0, 0), Point(0.5, 0.5, 0), Point(0, 1, 0)})); // straight at a corner
  CHECK(inverted({Point(0, 0, 0), Point(1, 0, 0), Point(0.2, 0.2, 0), Point(0, 1, 0)})); // an arrow
  CHECK(inverted({Point(0, 0, 0), Point(1, 1, 0), Point(1, 0, 0), Point(0, 1, 0)}));     // a bow tie
  CHECK(inverted({Point(0, 0, 0), Point(0, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})); // an edge of length 0
  CHECK(inverted({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(3, 0, 0)})); // no area
}

TEST_CASE("Two components that cross intersect") {
  const Quad_mesh apart = tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(1.5, 0.25, 0.25)));
  const Quad_mesh crossing = tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(0.5, 0.25, 0.25)));
  CHECK(certify({apart}).strictly_valid);
  const Certificate c = certify({crossing});
  CHECK(failed(c) == Names{"no_self_intersections"});
  // The face x = 1 of the first cube is cut by four faces of the second, whose face x = 0.5 is inside; the
  // faces y = 1 and z = 1 of the first are cut by the parts above 1 of the second.
  for (const auto& [i, j] : c.intersecting_quads) {
    CHECK(i < 6);
    CHECK(j >= 6);
  }
  CHECK(c.intersecting_quads.size() == c.check("no_self_intersections").measured);
}

TEST_CASE("Touching is intersecting, a hair apart is not") {
  const double hair = std::nextafter(1.0, 2.0);
  CHECK(
      certify({tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(hair, 0.25, 0.25)))}).strictly_valid);
  CHECK_FALSE(
      certify({tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(1, 0.25, 0.25)))}).strictly_valid);
}

TEST_CASE("Neighbours that fold onto each other intersect, at an edge and at a vertex") {
  // Two quads of one edge, the second laid on the first.
  const auto folded = [](double height) {
    Quad_mesh mesh;
    mesh.points = {Point(0, 0, 0), Point(1, 0, 0),        Point(1, 1, 0),
                   Point(0, 1, 0), Point(0, 0.8, height), Point(1, 0.8, height)};
    mesh.quads = {{0, 1, 2, 3}, {1, 0, 4, 5}};
    return certify({mesh}).check("no_self_intersections").measured;
  };
  CHECK(folded(0) == 1);
  CHECK(folded(1e-300) == 0);
  CHECK(folded(0.1) == 0);
  // Two quads of one vertex; the far corner of the second is below or above the first.
  const auto pierced = [](double z) {
    Quad_mesh mesh;
    mesh.points = {Point(0, 0, 0),       Point(1, 0, 0),     Point(1, 1, 0),      Point(0, 1, 0),
                   Point(0.5, 0.1, 0.3), Point(0.7, 0.4, z), Point(0.1, 0.5, 0.3)};
    mesh.quads = {{0, 1, 2, 3}, {0, 4, 5, 6}};
    return certify({mesh}).check("no_self_intersections").measured;
  };
  CHECK(pierced(-0.2) == 1);
  CHECK(pierced(0) == 1);
  CHECK(pierced(0.2) == 0);
}

TEST_CASE("Intersections do not depend on place, scale or rotation") {
  const Quad_mesh cube = tiny::subdivided(tiny::subdivided(tiny::quad_cube()));
  const Eigen::AngleAxisd turn(0.7, Point(1, 2, 3).normalized());
  for (double scale : {1e-60, 1e-20, 1e-3, 1.0, 1e9, 1e60}) {
    Quad_mesh mesh = cube;
    for (Point& p : mesh.points) p = scale * (turn * (p + Point(1000, -500, 250)));
    const Certificate c = certify({mesh});
    CAPTURE(scale, to_text(c));
    CHECK(c.strictly_valid);
    // Pulls one corner of the cube through the opposite side.
    mesh.points[0] = scale * (turn * Point(1001.55, -498.45, 251.5));
    CHECK_FALSE(certify({mesh}).strictly_valid);
  }
}

TEST_CASE("Pairs that intersect are the same as by brute force") {
  std::mt19937 random(7); // its sequence is fixed by the standard
  const auto coordinate = [&] { return double(random() % 1000) / 1000; };
  for (int run = 0; run < 20; ++run) {
    Quad_mesh mesh = tiny::quad_torus(6, 5);
    for (Point& p : mesh.points) p += 0.4 * Point(coordinate(), coordinate(), coordinate());
    const auto all = certify({mesh}).intersecting_quads;
    // A pair intersects also in the mesh of these two quads alone.
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < int(mesh.quads.size()); ++i)
      for (int j = i + 1; j < int(mesh.quads.size()); ++j)
        if (!certify({Quad_mesh{mesh.points, {mesh.quads[i], mesh.quads[j]}}}).intersecting_quads.empty())
          pairs.emplace_back(i, j);
    CHECK(all == pairs);
  }
}

TEST_CASE("The list of intersecting pairs is bounded and says so") {
  const Quad_mesh mesh = tiny::together(tiny::quad_cube(), tiny::quad_cube(Point(0.5, 0.25, 0.25)));
  Certificate_options options;
  options.maximum_intersections = 2;
  const Certificate c = certify({mesh}, options);
  CHECK(c.intersecting_quads.size() == 2);
  CHECK(c.check("no_self_intersections").message.find("at least 2") != std::string::npos);
}

TEST_CASE("Distances are fractions of the diagonal, to and from the input") {
  const Quad_mesh cube = tiny::quad_cube();
  const Triangle_surface input = tiny::triangulated(cube);
  Certificate c = certify({cube, &input});
  REQUIRE(c.shape);
  CHECK(c.shape->diagonal == Approx(std::sqrt(3.0)));
  CHECK(c.shape->distance() < 1e-15);
  CHECK(c.shape->bound() < 1.01e-4);
  Quad_mesh moved = cube;
  for (Point& p : moved.points) p.x() += 0.1;
  c = certify({moved, &input});
  const double shift = 0.1 / std::sqrt(3.0);
  for (const Area_distance& side : {c.shape->from_quads, c.shape->from_input}) {
    CHECK(side.maximum == Approx(shift));
    CHECK(side.bound >= side.maximum);
    CHECK(side.bound <= 1.0101 * side.maximum);
  }
  CHECK(c.shape->from_quads.at.x() == Approx(1.1)); // on the one face of the quads that lies outside
  CHECK(c.shape->box_shift == Approx(shift));
  CHECK(c.check("distance").status == Check_status::not_checked);
  CHECK(c.check("distance").measured == Approx(shift).epsilon(0.011));
  Certificate_options options;
  options.maximum_distance = 0.05;
  CHECK(failed(certify({moved, &input}, options)) == Names{"distance"});
  options.maximum_distance = 0.06;
  CHECK(certify({moved, &input}, options).check("distance").status == Check_status::passed);
}

TEST_CASE("A missing limb shows in the distance from the input only") {
  const Triangle_surface input = tiny::triangulated(tiny::two_cubes());
  const Quad_mesh one = tiny::quad_cube();
  const Certificate c = certify({one, &input});
  CHECK(c.shape->from_quads.maximum < 1e-15);
  CHECK(c.shape->from_input.maximum == Approx(3 / std::sqrt(18.0)));
  CHECK(c.shape->components == 2);
  CHECK(c.shape->lost_components == 1);
  CHECK(c.shape->lost_area == Approx(0.5).margin(0.001));
}

namespace {

// A plate 12 x 8 of thickness 1 in long triangles, whose upper long edge sags by `sag` in the quads, between
// its ends.
struct Sagging_plate {
  Quad_mesh quads;
  Triangle_surface input;
};

Sagging_plate sagging_plate(double sag) {
  Sagging_plate plate;
  plate.quads = tiny::quad_cube();
  for (int i = 0; i < 3; ++i) plate.quads = tiny::subdivided(plate.quads);
  plate.input = tiny::triangulated(tiny::quad_cube());
  for (Point& p : plate.input.points) p = Point(12 * p.x(), 8 * p.y(), p.z());
  for (Point& p : plate.quads.points) {
    const bool edge = p.y() == 1 && p.z() == 1;
    p = Point(12 * p.x(), 8 * p.y(), p.z());
    if (edge && p.x() > 2 && p.x() < 10) p.z() -= sag;
  }
  return plate;
}

} // namespace

TEST_CASE("What sags between the vertices of a coarse input is measured") {
  const Sagging_plate plate = sagging_plate(0.1);
  const Certificate c = certify({plate.quads, &plate.input});
  // The input has vertices at the corners only, where nothing sags: 0 is what its vertices tell. The point
  // that is farthest lies on the edge; the nearest quad is the slope from (y = 7, z = 1) down to (y = 8, z =
  // 0.9).
  const double farthest = 0.1 / std::sqrt(1 + 0.01), diagonal = std::sqrt(144 + 64 + 1.0);
  CHECK(c.shape->from_input.maximum * diagonal <= farthest * (1 + 1e-12));
  CHECK(c.shape->from_input.bound * diagonal >= farthest * (1 - 1e-12));
  CHECK(c.shape->from_input.bound <= 1.0101 * c.shape->from_input.maximum);
  CHECK(c.shape->missed_corners == 0);
  CHECK(c.shape->corners == 8);
  CHECK(*c.shape->covered_sharp_lines < 0.95);
}

TEST_CASE("The bound of the distance holds, and a dense sampling comes near to it") {
  std::mt19937 random(3); // its sequence is fixed by the standard
  const auto coordinate = [&] { return double(random() % 4096) / 4096 - 0.5; };
  for (int run = 0; run < 4; ++run) {
    Quad_mesh mesh = tiny::quad_torus(9 + run, 7);
    for (Point& p : mesh.points) p += 0.02 * (run % 4) * Point(coordinate(), coordinate(), coordinate());
    const Triangle_surface input = run % 2 ? tiny::torus(12, 8) : tiny::torus(6, 5);
    Certificate_options options;
    options.find_self_intersections = false;
    const Shape_kept shape = *certify({mesh, &input}, options).shape;
    // The distance of a dense grid of points of the input.
    const int n = run % 2 ? 5 : 10;
    double greatest = 0;
    for (const Triangle& t : input.triangles)
      for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j) {
          const Point p =
              (i * input.points[t[0]] + j * input.points[t[1]] + (n - i - j) * input.points[t[2]]) / n;
          greatest = std::max(greatest, tiny::distance_to_quads(p, mesh));
        }
    CAPTURE(run);
    CHECK(greatest <= shape.from_input.bound * shape.diagonal * (1 + 1e-12));
    CHECK(greatest >= 0.85 * shape.from_input.bound * shape.diagonal); // the grid misses the farthest point
    CHECK(shape.from_input.bound <= 1.0101 * shape.from_input.maximum + 1e-4);
    CHECK(shape.from_quads.bound <= 1.0101 * shape.from_quads.maximum + 1e-4);
  }
}

TEST_CASE("The shape is compared with the surface as it was read, points of its own in every triangle") {
  const Quad_mesh both = tiny::two_cubes();
  const Triangle_surface input = tiny::triangulated(tiny::quad_cube());
  Triangle_surface as_read, all = tiny::triangulated(both);
  for (const Triangle& t : all.triangles) {
    const int n = as_read.number_of_vertices();
    for (int v : t) as_read.points.push_back(all.points[v]);
    as_read.triangles.push_back({n, n + 1, n + 2});
  }
  const Quad_mesh one = tiny::subdivided(tiny::quad_cube());
  Certificate_input certified{one, &input};
  CHECK(certify(certified).warnings.empty());
  certified.as_read = &as_read;
  const Certificate c = certify(certified);
  CHECK(c.passed); // the topology is that of the mended input
  CHECK(c.shape->components == 2);
  CHECK(c.shape->corners == 16);
  CHECK(c.shape->missed_corners == 8);
  CHECK(names_of(c.warnings) == Names{"distance", "lost_area", "box_shift", "missed_corners",
                                      "missed_sharp_edges", "lost_components"});
  CHECK(to_text(c).find("warning: 8 of 16 corners") != std::string::npos);
}

TEST_CASE("A count that is missed is a warning") {
  const Quad_mesh cube = tiny::quad_cube();
  const Triangle_surface input = tiny::triangulated(cube);
  Certificate_input certified{cube, &input};
  for (const auto& [asked, warned] : {std::pair{0, false}, {6, false}, {5, true}, {7, true}}) {
    certified.quads_asked = asked;
    CAPTURE(asked);
    CHECK(names_of(certify(certified).warnings).count("missed_count") == std::size_t(warned));
  }
}

TEST_CASE("A sentence says how much of the shape is kept") {
  Shape_kept shape;
  shape.from_quads.bound = 0.012;
  shape.corners = 32;
  shape.missed_corners = 1;
  shape.covered_sharp_lines = 0.94;
  CHECK(shape_summary(shape) ==
        "distance at most 1.2 % of the diagonal, 31 of 32 corners, 94 % of sharp edges");
  CHECK(names_of(shape_warnings(shape)) == Names{"missed_corners"});
  Shape_limits limits;
  limits.missed_corners = 1;
  CHECK(shape_warnings(shape, limits).empty());
  limits.distance = 0.011;
  CHECK(names_of(shape_warnings(shape, limits)) == Names{"distance"});
}

TEST_CASE("What is not asked for or cancelled is not checked, and then nothing is strictly valid") {
  const Quad_mesh cube = tiny::quad_cube();
  const Triangle_surface input = tiny::triangulated(cube);
  Certificate_options options;
  options.find_self_intersections = options.measure_shape = false;
  Certificate c = certify({cube, &input}, options);
  CHECK(c.passed);
  CHECK_FALSE(c.strictly_valid);
  CHECK_FALSE(c.shape);
  CHECK(with_status(c, Check_status::not_checked) == Names{"valences", "no_self_intersections", "distance"});

  struct Impatient : Observer {
    bool cancelled() const override { return true; }
  } impatient;
  options = {};
  options.observer = &impatient;
  c = certify({cube, &input}, options);
  CHECK(c.check("no_self_intersections").message == "cancelled");
  CHECK(c.check("distance").message == "cancelled");
  CHECK_FALSE(c.strictly_valid);
}

TEST_CASE("The sum of 4 - valence is 4 chi on random valid meshes") {
  std::mt19937 random(1);
  for (int run = 0; run < 100; ++run) {
    Quad_mesh mesh;
    int chi = 0;
    for (unsigned i = 0, n = 1 + random() % 3; i < n; ++i) {
      const int a = 3 + int(random() % 5), b = 3 + int(random() % 5);
      const unsigned kind = random() % 3;
      mesh = tiny::together(mesh, kind == 0   ? tiny::quad_cube()
                                  : kind == 1 ? tiny::quad_torus(a, b)
                                              : tiny::quad_cylinder(a, b));
      chi += kind == 0 ? 2 : 0;
    }
    for (unsigned i = 0, n = random() % 3; i < n; ++i) mesh = tiny::subdivided(mesh);
    // Digs handles and holes: quads that share no vertex with each other or with the boundary are taken out.
    std::map<std::pair<int, int>, int> uses;
    for (const Quad& q : mesh.quads)
      for (int i = 0; i < 4; ++i) ++uses[std::minmax({q[i], q[(i + 1) % 4]})];
    std::set<int> taken;
    for (const auto& [edge, n] : uses)
      if (n == 1) taken.insert({edge.first, edge.second});
    std::vector<Quad> kept;
    const Quad_mesh whole = mesh;
    for (const Quad& q : whole.quads) {
      bool apart = random() % 4 == 0;
      for (int v : q) apart = apart && taken.count(v) == 0;
      if (!apart) {
        kept.push_back(q);
        continue;
      }
      taken.insert(q.begin(), q.end());
      --chi;
    }
    mesh.quads = kept;
    Certificate_options options;
    options.find_self_intersections = false;
    const Certificate c = certify({mesh}, options);
    CAPTURE(run, to_text(c));
    CHECK(c.check("manifold_vertices").status == Check_status::passed);
    CHECK(c.check("valence_sum").status == Check_status::passed);
    CHECK(c.check("valence_sum").expected == 4 * chi);
  }
}

TEST_CASE("The JSON of a certificate can be read back; what is not finite is null") {
  Quad_mesh mesh = tiny::quad_cube();
  mesh.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(to_json(certify({mesh})));
  CHECK(json.at("passed") == false);
  CHECK(json.at("checks").size() == 15);
  const auto& check = json.at("checks").at(1);
  CHECK(check.at("name") == "finite_points");
  CHECK(check.at("status") == "failed");
  CHECK(check.at("measured") == 1);
  CHECK(check.at("expected") == 0);
  CHECK(check.at("element") == "vertex");
  CHECK(check.at("index") == 0);
  CHECK(json.at("checks").at(9).at("measured").is_null());
  CHECK(json.at("interior_valences") == nlohmann::json{{"3", 8}});
  CHECK(json.at("shape").is_null());
  CHECK(json.at("components").at(0).at("euler_characteristic") == 2);
}

TEST_CASE("The table has one line a check, and its last line is the verdict") {
  const Certificate c = certify({tiny::quad_cube()});
  const std::string text = to_text(c);
  CHECK(std::count(text.begin(), text.end(), '\n') == std::ptrdiff_t(c.checks.size()) + 2);
  CHECK(text.find("\npassed, strictly valid\n") != std::string::npos);
  CHECK(to_text(certify({tiny::quad_cylinder(4, 2)})).find("\nFAILED\n") != std::string::npos);
}
