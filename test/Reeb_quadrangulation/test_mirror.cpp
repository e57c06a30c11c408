// SPDX-License-Identifier: GPL-3.0-or-later
// Exact mirrors: planes, halves, doubled quads, and the check of them.
#include "random_edits.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mirror_check.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <random>

using namespace CGAL::Reeb_quadrangulation;

namespace {

const Certificate_options only_topology = [] {
  Certificate_options options;
  options.measure_shape = options.find_self_intersections = false;
  return options;
}();

const Mirror_plane across_x{Point(0, 0, 0), Eigen::Vector3d(1, 0, 0)};

Triangle_surface moved(Triangle_surface s, const Eigen::Matrix3d& turn, const Point& by) {
  for (Point& p : s.points) p = turn * p + by;
  return s;
}

Triangle_surface moved(Triangle_surface s, const Point& by) {
  return moved(std::move(s), Eigen::Matrix3d::Identity(), by);
}

Quadrangulation mirrored(const Triangle_surface& s, const Mirror_request& request, int quads = 200) {
  Quadrangulation_options options;
  options.quads = quads;
  options.mirror = request;
  Result<Quadrangulation> result = quadrangulate(s, options);
  INFO((result ? std::string() : result.error().message));
  REQUIRE(bool(result));
  return std::move(*result);
}

Mirror_check check_of(const Quadrangulation& result) {
  return check_mirror(result.mesh, result.mirror->mirror.plane, result.mirror->image);
}

// A box of a, b and c unit cubes, from the origin.
Triangle_surface box(int a, int b, int c) {
  tiny::Lattice_draft draft;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const std::array<int, 3> size{a, b, c};
    for (int u = 0; u < size[std::size_t(j)]; ++u)
      for (int v = 0; v < size[std::size_t(k)]; ++v) {
        const auto at = [&](int side, int du, int dv) {
          std::array<int, 3> p{};
          p[std::size_t(i)] = side;
          p[std::size_t(j)] = u + du;
          p[std::size_t(k)] = v + dv;
          return p;
        };
        const int top = size[std::size_t(i)];
        draft.square(at(top, 0, 0), at(top, 1, 0), at(top, 1, 1), at(top, 0, 1));
        draft.square(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
      }
  }
  return tiny::connected(std::move(draft.surface));
}

} // namespace

TEST_CASE("a reflection on a mirror grid is undone by itself, to the bit") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-3, 5);
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i)
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  for (const double c : {0.0, 0.1, 1.0 / 3, -2.7, 1e-12, 4.9999}) {
    const Mirror_grid grid({Point(0, c, 0), Eigen::Vector3d(0, -2, 0)}, points);
    const Mirror_plane& plane = grid.plane();
    CHECK(plane.axis() == 1);
    CHECK(plane.normal == Eigen::Vector3d(0, -1, 0));
    CHECK(std::abs(plane.point.y() - c) <= 1e-15 * 10);
    CHECK(Mirror_grid(plane, points).plane().point == plane.point);
    for (const Point& p : points) {
      const Point q = grid.rounded(p), image = plane.reflected(q);
      CHECK((q - p).norm() <= 1e-14);
      CHECK(plane.reflected(image) == q);
      CHECK(are_exact_images(plane, q, image));
      CHECK(!are_exact_images(plane, q, image + Point(0, 1e-12, 0)));
    }
  }
  CHECK(!are_exact_images({Point(0, 0, 0), Eigen::Vector3d(0.6, 0.8, 0)}, Point(0, 0, 0), Point(0, 0, 0)));
}

TEST_CASE("the three planes of a box are found wherever it lies, and none where it was spoilt") {
  const Triangle_surface block = box(4, 3, 2);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  for (const bool turned : {false, true}) {
    const Triangle_surface s = turned ? moved(block, turn, Point(10, -3, 2)) : moved(block, Point(10, -3, 2));
    const std::vector<Found_mirror> found = find_mirror_planes(Surface_projector(s));
    REQUIRE(found.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(found[i].deviation.largest < 1e-9);
      CHECK((found[i].plane.axis() >= 0) == !turned);
      // The shortest curve is the one across the longest edge.
      const Eigen::Vector3d edge = Eigen::Vector3d::Unit(int(i));
      CHECK(std::abs(found[i].plane.normal.dot(turned ? Eigen::Vector3d(turn * edge) : edge)) > 1 - 1e-9);
    }
  }
  Triangle_surface spoilt = block;
  for (Point& p : spoilt.points) p += Point(0.3 * p.y() * p.z(), 0.2 * p.x() * p.z(), 0.5 * p.x() * p.y());
  CHECK(find_mirror_planes(Surface_projector(spoilt)).empty());
}

TEST_CASE("a half is one component, lies on one side, and its boundary is on the plane exactly") {
  const double c = 0.137;
  const Triangle_surface sphere = moved(tiny::bipyramid(9), Point(c, 0, 0));
  const Triangle_surface torus = moved(tiny::torus(12, 8), Point(c, 0, 0));
  for (const auto& [whole, curves] : {std::pair(sphere, 1), std::pair(torus, 2)}) {
    const auto half = halve_surface(whole, {Point(c, 0, 0), Eigen::Vector3d(1, 0, 0)});
    REQUIRE(bool(half));
    CHECK(half->curves == curves);
    CHECK(half->arcs == 0);
    CHECK(connected_components(half->surface).second == 1);
    CHECK(2 * euler_characteristic(half->surface) == euler_characteristic(whole));
    CHECK(area(half->surface) == Approx(area(whole) / 2).epsilon(0.05));
    for (int h = 0; h < half->surface.number_of_halfedges(); ++h) {
      const Point& p = half->surface.points[std::size_t(half->surface.source(h))];
      CHECK(p.x() >= half->plane.point.x());
      CHECK(bool(half->on_plane[std::size_t(h)]) == half->surface.is_boundary(h));
      if (half->surface.is_boundary(h)) CHECK(p.x() == half->plane.point.x());
    }
  }
}

TEST_CASE("the surface's own boundary is no part of the cut, also where the cut ends on it") {
  const Triangle_surface tube = tiny::open_cylinder(12, 4);
  const auto across = halve_surface(tube, {Point(0, 0, 1), Eigen::Vector3d(0, 0, 1)});
  REQUIRE(bool(across));
  CHECK(across->curves == 1);
  CHECK(across->arcs == 0);
  CHECK(boundary_loops(across->surface).size() == 2);
  const auto along = halve_surface(tube, across_x);
  REQUIRE(bool(along));
  CHECK(along->curves == 0);
  CHECK(along->arcs == 2);
  CHECK(boundary_loops(along->surface).size() == 1);
}

TEST_CASE("planes that do not halve the surface are refused with the reason") {
  const Triangle_surface block = box(2, 2, 2);
  const auto refusal = [&](const Triangle_surface& s, const Mirror_plane& plane) {
    const auto half = halve_surface(s, plane);
    REQUIRE(!half);
    CHECK(half.error().code == Error_code::impossible_request);
    return half.error().message;
  };
  CHECK(refusal(block, {Point(9, 0, 0), Eigen::Vector3d(1, 0, 0)}).find("does not cut") != std::string::npos);
  CHECK(refusal(block, {Point(2, 0, 0), Eigen::Vector3d(1, 0, 0)}).find("touches") != std::string::npos);
  CHECK(refusal(tiny::octahedron(), {Point(1, 0, 0), Eigen::Vector3d(1, 0, 0)}).find("cut") !=
        std::string::npos);
  // Across the tube of a torus, off its middle: one side keeps the hole, the other does not.
  CHECK(refusal(tiny::torus(24, 12), {Point(0.8, 0, 0), Eigen::Vector3d(1, 0, 0)}).find("not alike") !=
        std::string::npos);
  Mirror_request request;
  request.choice = Mirror_choice::given;
  request.plane = {Point(0.3, 0, 0), Eigen::Vector3d(1, 0, 0)};
  const auto chosen = choose_mirror(Surface_projector(block), request);
  REQUIRE(!chosen);
  CHECK(chosen.error().message.find("not symmetric") != std::string::npos);
}

TEST_CASE("mirrored quads equal their mirror image to the bit and pass the certificate") {
  const Point by(0.1, 1.0 / 3, -7.3);
  const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
  for (const Triangle_surface& s :
       {moved(tiny::torus(24, 12), none, by), moved(box(3, 2, 2), none, by), tiny::torus(24, 12)}) {
    const Quadrangulation result = mirrored(s, {});
    const Mirror_check check = check_of(result);
    INFO(to_text(check, result.mirror->mirror.plane));
    CHECK(check.is_exact);
    CHECK(check.deviation == 0);
    CHECK(check.on_plane >= 4);
    const Certificate certificate = certify({result.mesh, &s, result.valences});
    INFO(to_text(certificate));
    CHECK(certificate.passed);
  }
}

TEST_CASE("a plane in general position gives symmetric connectivity, and positions up to rounding") {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Triangle_surface s = moved(tiny::torus(24, 12), turn, Point(1, 2, 3));
  const Quadrangulation result = mirrored(s, {});
  const Mirror_check check = check_of(result);
  CHECK(check.is_symmetric);
  CHECK(!check.is_exact);
  CHECK(check.deviation < 1e-14);
  CHECK(certify({result.mesh, &s, result.valences}).passed);
}

TEST_CASE("of a nearly symmetric surface, projected positions lie on it and the connectivity is symmetric") {
  Triangle_surface s = tiny::torus(32, 16);
  for (Point& p : s.points)
    if (p.x() < 0) p.y() *= 1 + 0.02 * p.x();
  Mirror_request request;
  request.choice = Mirror_choice::across_x;
  request.positions = Mirror_positions::projected;
  const Quadrangulation result = mirrored(s, request, 300);
  const Mirror_check check = check_of(result);
  CHECK(check.is_symmetric);
  CHECK(!check.is_exact);
  CHECK(result.mirror->largest_shift > 1e-3);
  CHECK(result.mirror->largest_shift < 0.01);
  const Surface_projector projector(s);
  for (const Point& p : result.mesh.points) CHECK(projector.closest(p).squared_distance < 1e-18);
  request.tolerance = 1e-4;
  Quadrangulation_options options;
  options.mirror = request;
  CHECK(!quadrangulate(s, options));
}

TEST_CASE("where the cut ends on the surface's boundary, both sides share the vertex there") {
  const Triangle_surface tube = tiny::open_cylinder(24, 8);
  Mirror_request request;
  request.choice = Mirror_choice::across_x;
  const Quadrangulation result = mirrored(tube, request);
  CHECK(check_of(result).is_exact);
  const Certificate certificate = certify({result.mesh, &tube, result.valences});
  INFO(to_text(certificate));
  CHECK(certificate.passed);
}

TEST_CASE("the check of mirrors fails where one coordinate, one quad or one pair is wrong") {
  const Quadrangulation result = mirrored(tiny::torus(24, 12), {});
  const Mirror_plane& plane = result.mirror->mirror.plane;
  const std::vector<int>& image = result.mirror->image;
  REQUIRE(check_mirror(result.mesh, plane, image).is_exact);
  Quad_mesh nudged = result.mesh;
  std::size_t off = 0;
  while (image[off] == int(off)) ++off;
  nudged.points[off].z() = std::nextafter(nudged.points[off].z(), 10.0);
  CHECK(check_mirror(nudged, plane, image).is_symmetric);
  CHECK(!check_mirror(nudged, plane, image).is_exact);
  Quad_mesh less = result.mesh;
  less.quads.pop_back();
  CHECK(!check_mirror(less, plane, image).is_symmetric);
  std::vector<int> swapped = image;
  std::swap(swapped[0], swapped[1]);
  CHECK(!check_mirror(result.mesh, plane, swapped).is_symmetric);
  CHECK(!check_mirror(result.mesh, plane, {}).is_symmetric);
  std::vector<int> itself(result.mesh.points.size());
  for (std::size_t v = 0; v < itself.size(); ++v) itself[v] = int(v);
  CHECK(!check_mirror(result.mesh, plane, itself).is_symmetric);
}

TEST_CASE("an edge inside the half between two vertices on the plane gets a ring of quads beside it") {
  // A tube that is one quad high between two curves on the plane: half a torus, cut across its tube.
  const Triangle_surface torus = tiny::torus(16, 8);
  const auto half = halve_surface(torus, across_x);
  REQUIRE(bool(half));
  const std::vector<std::vector<int>> loops = boundary_loops(half->surface);
  REQUIRE(loops.size() == 2);
  REQUIRE(loops[0].size() == loops[1].size());
  Finished_design design;
  const int n = int(loops[0].size());
  for (const std::vector<int>& loop : loops)
    for (const int h : loop)
      design.quads.mesh.points.push_back(half->surface.points[std::size_t(half->surface.source(h))]);
  // Across the half from y > 0 to y < 0: partners have the same distance from the axis and the same z.
  const std::vector<Point>& p = design.quads.mesh.points;
  const auto partner = [&](int i) {
    int best = n;
    for (int j = n; j < 2 * n; ++j) {
      const Point wanted(p[std::size_t(i)].x(), -p[std::size_t(i)].y(), p[std::size_t(i)].z());
      if ((p[std::size_t(j)] - wanted).norm() < (p[std::size_t(best)] - wanted).norm()) best = j;
    }
    return best;
  };
  for (int i = 0; i < n; ++i)
    design.quads.mesh.quads.push_back({i, (i + 1) % n, partner((i + 1) % n), partner(i)});
  design.quads.chart_of_quad.assign(std::size_t(n), 0);
  const auto whole = mirror_design(design, *half, Surface_projector(torus));
  REQUIRE(bool(whole));
  CHECK(whole->ring_quads == 2 * n);
  const Quad_mesh& mesh = whole->whole.quads.mesh;
  CHECK(int(mesh.quads.size()) == 6 * n);
  CHECK(check_mirror(mesh, half->plane, whole->image).is_exact);
  const Certificate certificate = certify({mesh, &torus});
  CHECK(certificate.check("manifold_edges").status == Check_status::passed);
  CHECK(certificate.check("all_quads").status == Check_status::passed);
  CHECK(certificate.check("euler_characteristic").status == Check_status::passed);
  CHECK(certificate.interior_valences.size() == 1);
}

TEST_CASE("a quad with two neighbouring edges on the plane does not become a vertex of valence two") {
  const Triangle_surface block = box(4, 4, 4);
  const auto half = halve_surface(block, {Point(2, 0, 0), Eigen::Vector3d(1, 0, 0)});
  REQUIRE(bool(half));
  // The half's five faces as one grid would have four corners on the plane: here each quad of a cross has.
  Finished_design design;
  std::vector<Point>& p = design.quads.mesh.points;
  for (const double x : {2.0, 4.0})
    for (const auto& [y, z] : {std::pair(0, 0), std::pair(4, 0), std::pair(4, 4), std::pair(0, 4)})
      p.emplace_back(x, y, z);
  design.quads.mesh.quads = {{4, 5, 6, 7}};
  for (int i = 0; i < 4; ++i) design.quads.mesh.quads.push_back({i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i});
  design.quads.chart_of_quad.assign(5, 0);
  const auto regular = mirror_design(design, *half, Surface_projector(block));
  REQUIRE(bool(regular));
  CHECK(regular->ring_quads == 0);
  CHECK(certify({regular->whole.quads.mesh, &block}).interior_valences == std::map<int, int>{{3, 8}, {4, 4}});

  Finished_design corners;
  corners.quads.mesh.points.assign(p.begin(), p.begin() + 4);
  corners.quads.mesh.quads = {{0, 1, 2, 3}};
  corners.quads.chart_of_quad = {0};
  const auto ringed = mirror_design(corners, *half, Surface_projector(block));
  REQUIRE(bool(ringed));
  CHECK(ringed->ring_quads == 4);
  const Certificate certificate = certify({ringed->whole.quads.mesh, &block});
  CHECK(certificate.check("all_quads").status == Check_status::passed);
  CHECK(certificate.interior_valences == std::map<int, int>{{3, 8}, {4, 4}});
}

TEST_CASE("after every edit of a half, the quads of both sides equal their mirror image and are a surface") {
  const Triangle_surface torus = tiny::torus(24, 14);
  const auto half = halve_surface(torus, across_x);
  REQUIRE(bool(half));
  const Surface_projector whole(torus);
  tiny::Random random(5);
  Editor_options options;
  options.quads = 120;
  options.prepare = false;
  Result<Editor> editor = Editor::create(half->surface, options);
  REQUIRE(bool(editor));
  REQUIRE(bool(editor->apply(Suggest{0.05, {0, 0, 1}})));
  int applied = 0;
  Finish_options finish;
  finish.relaxation.iterations = 2;
  finish.relaxation.untangle = false;
  for (int i = 0; i < 120; ++i) {
    const Edit edit = random_edits::Generator(*editor, random).next();
    if (!editor->apply(edit)) continue;
    ++applied;
    INFO("edit " << i << ": " << to_json(edit));
    Result<Finished_design> quads = editor->finished_quads(finish);
    REQUIRE(bool(quads));
    if (!pole_fans(editor->design(), quads->quads).empty()) continue; // not all-quad, and told apart
    const auto both = mirror_design(std::move(*quads), *half, whole, Mirror_positions::exact, finish);
    INFO((both ? std::string() : both.error().message));
    REQUIRE(bool(both));
    const Stitched_mesh& all = both->whole.quads;
    CHECK(check_mirror(all.mesh, half->plane, both->image).is_exact);
    const Certificate certificate = certify({all.mesh, &torus, all.valences, all.components}, only_topology);
    INFO(to_text(certificate));
    CHECK(certificate.passed);
  }
  CHECK(applied > 30);
}

TEST_CASE("a recipe keeps its mirror, and refuses one without a normal") {
  Recipe recipe;
  recipe.mirror = Mirror{{Point(0.1, 0, 1e-9), Eigen::Vector3d(0.6, 0.8, 0)}, Mirror_positions::projected};
  const auto read = recipe_from_json(to_json(recipe));
  REQUIRE(bool(read));
  REQUIRE(read->mirror.has_value());
  CHECK(read->mirror->plane.point == recipe.mirror->plane.point);
  CHECK(read->mirror->plane.normal == recipe.mirror->plane.normal);
  CHECK(read->mirror->positions == Mirror_positions::projected);
  CHECK(!recipe_from_json(to_json(Recipe{}))->mirror);
  const std::string begin = R"({"format": "reebquad recipe", "version": 1, "edits": [], "mirror": )";
  CHECK(!recipe_from_json(begin + R"({"point": [0,0,0], "normal": [0,0,0]}})"));
  CHECK(!recipe_from_json(begin + R"({"point": [0,0,0]}})"));
  CHECK(recipe_from_json(begin + R"({"point": [0,0,0], "normal": [0,0,1]}})")->mirror->positions ==
        Mirror_positions::exact);
}
