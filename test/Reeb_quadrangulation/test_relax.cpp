// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// A generator with a fixed algorithm (Knuth's MMIX constants), uniform in [-1, 1).
class Noise {
public:
  double operator()() {
    m_state = m_state * 6364136223846793005u + 1442695040888963407u;
    return double(m_state >> 33) / double(1u << 30) - 1;
  }
  Point vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return Point(x, y, z);
  }

private:
  std::uint64_t m_state = 1;
};

// The quads of tiny::torus() and tiny::open_cylinder(): their triangles come in pairs {a, b, c}, {a, c, d}.
Quad_mesh quads_of(const Triangle_surface& s) {
  Quad_mesh mesh{s.points, {}};
  for (std::size_t f = 0; f < s.triangles.size(); f += 2)
    mesh.quads.push_back({s.triangles[f][0], s.triangles[f][1], s.triangles[f][2], s.triangles[f + 1][2]});
  return mesh;
}

void shake(Quad_mesh& mesh, const Surface_projector& projector, double amount) {
  Noise noise;
  for (Point& p : mesh.points) p = projector.closest(p + amount * noise.vector()).point;
}

double quality(const Quad_mesh& mesh, const Quad& q) {
  return scaled_jacobian(mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]);
}

double brute_force_distance(const Triangle_surface& s, const Point& p) {
  // The distance to a triangle by minimising over its three edges and its plane, independently of the
  // projector.
  double best = std::numeric_limits<double>::infinity();
  for (const Triangle& t : s.triangles) {
    const Point a = s.points[t[0]], b = s.points[t[1]], c = s.points[t[2]];
    for (const auto& [x, y] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const double u = std::min(1.0, std::max(0.0, (p - x).dot(y - x) / (y - x).squaredNorm()));
      best = std::min(best, (x + u * (y - x) - p).norm());
    }
    const Point n = (b - a).cross(c - a).normalized();
    const Point foot = p - n.dot(p - a) * n;
    const bool within = n.dot((b - a).cross(foot - a)) >= 0 && n.dot((c - b).cross(foot - b)) >= 0 &&
                        n.dot((a - c).cross(foot - c)) >= 0;
    if (within) best = std::min(best, std::abs(n.dot(p - a)));
  }
  return best;
}

// Two parallel squares facing away from each other, `gap` apart: a thin sheet without its rim.
Triangle_surface thin_sheet(double gap) {
  return tiny::connected({{Point(0, 0, gap), Point(1, 0, gap), Point(1, 1, gap), Point(0, 1, gap),
                           Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)},
                          {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}},
                          {},
                          {}});
}

// The unit cube: each side two triangles.
Triangle_surface cube() {
  Triangle_surface s;
  for (int i = 0; i < 8; ++i) s.points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  for (const Quad& q : {Quad{0, 2, 3, 1}, Quad{4, 5, 7, 6}, Quad{0, 1, 5, 4}, Quad{2, 6, 7, 3},
                        Quad{0, 4, 6, 2}, Quad{1, 3, 7, 5}}) {
    s.triangles.push_back({q[0], q[1], q[2]});
    s.triangles.push_back({q[0], q[2], q[3]});
  }
  return tiny::connected(std::move(s));
}

} // namespace

TEST_CASE("the scaled Jacobian is 1 for rectangles, the sine for rhombi, and not positive beyond") {
  const Point o(0, 0, 0);
  CHECK(scaled_jacobian(o, Point(3, 0, 0), Point(3, 1, 0), Point(0, 1, 0)) == Approx(1));
  const Point u(1, 0, 0), v(0.5, std::sqrt(0.75), 0);
  CHECK(scaled_jacobian(o, u, u + v, v) == Approx(std::sqrt(0.75)));
  CHECK(scaled_jacobian(o, u, Point(0.2, 0.2, 0), Point(0, 1, 0)) < 0);           // a dart
  CHECK(scaled_jacobian(o, Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)) <= 0); // a bow tie
  CHECK(scaled_jacobian(o, u, 2 * u, v) == Approx(0).margin(1e-15));              // a straight corner
  CHECK(scaled_jacobian(o, o, u, v) == 0);                                        // a collapsed edge
}

TEST_CASE("the closest point is as close as brute force finds, with and without a hint") {
  const Triangle_surface torus = tiny::torus(31, 17);
  const Surface_projector projector(torus);
  Noise noise;
  for (int i = 0; i < 300; ++i) {
    const Point p = 2 * noise.vector();
    const Closest_point c = projector.closest(p);
    CHECK((c.point - p).norm() == Approx(brute_force_distance(torus, p)).epsilon(1e-12));
    CHECK(c.squared_distance == (c.point - p).squaredNorm());
    CHECK(projector.closest(p, i).squared_distance == Approx(c.squared_distance));
    CHECK(brute_force_distance(torus, c.point) < 1e-12);
    const Closest_point near = projector.closest_nearby(p, c.face);
    CHECK(near.squared_distance == Approx(c.squared_distance));
  }
}

TEST_CASE("surfaces of one to twenty faces are searched as well") {
  for (int n = 1; n <= 20; ++n) {
    Triangle_surface strip;
    for (int i = 0; i < n + 2; ++i) strip.points.emplace_back(i, i % 2, 0);
    for (int i = 0; i < n; ++i) strip.triangles.push_back({i + i % 2, i + 1 - i % 2, i + 2});
    const auto connected = strip.connect();
    const Surface_projector projector(strip);
    const Point p(n - 0.5, 0.3, 2);
    CHECK(std::sqrt(projector.closest(p).squared_distance) == Approx(brute_force_distance(strip, p)));
  }
}

TEST_CASE("a compatible query does not cross a thin sheet") {
  const Triangle_surface sheet = thin_sheet(0.01);
  const Surface_projector projector(sheet);
  const Point up(0, 0, 1), below(0.3, 0.4, -0.02);
  CHECK(projector.closest(below).point.z() == 0);
  CHECK((projector.closest_compatible(below, up, 0).point - Point(0.3, 0.4, 0.01)).norm() < 1e-15);
  CHECK(projector.closest_compatible(below, Point(1, 0, 0), 0.5).face == -1);
  CHECK(projector.closest_compatible(below, up, 0, -1, 0.02).face == -1);
  CHECK(projector.closest_compatible(below, up, 0, -1, 0.04).face >= 0);
  CHECK(projector.closest_nearby(below, 0).point.z() == Approx(0.01));
}

TEST_CASE("a cube has twelve sharp edges and eight corners; a wide angle leaves none") {
  const Feature_edges features = feature_edges(cube(), 60);
  CHECK(features.chains.size() == 12);
  CHECK(features.corners.size() == 8);
  for (const Feature_chain& chain : features.chains) CHECK(chain.halfedges.size() == 1);
  CHECK(feature_edges(cube(), 100).chains.empty());
  CHECK(feature_edges(cube(), 0).chains.empty());
}

TEST_CASE("the rims of a cylinder are two closed chains") {
  const Feature_edges features = feature_edges(tiny::open_cylinder(24, 3), 0);
  REQUIRE(features.chains.size() == 2);
  CHECK(features.corners.empty());
  for (const Feature_chain& chain : features.chains) {
    CHECK(chain.closed);
    CHECK(chain.boundary);
    CHECK(chain.halfedges.size() == 24);
  }
}

TEST_CASE("a shaken torus comes back to good quads that lie on the surface") {
  const Triangle_surface input = tiny::torus(120, 60);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(tiny::torus(30, 15));
  shake(mesh, projector, 0.09);
  const auto report = relax_quads(mesh, projector);
  REQUIRE(report);
  CHECK(report->worst_before < 0.2);
  CHECK(report->worst_after > 0.7);
  CHECK(report->mean_after > 0.95);
  CHECK(report->inverted_after == 0);
  for (const Point& p : mesh.points) CHECK(projector.closest(p).squared_distance < 1e-28);
}

TEST_CASE("a torus shaken until a third of its quads are inverted is untangled") {
  const Triangle_surface input = tiny::torus(120, 60);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(tiny::torus(30, 15));
  shake(mesh, projector, 0.2);
  const auto report = relax_quads(mesh, projector);
  REQUIRE(report);
  CHECK(report->inverted_before > 100);
  CHECK(report->inverted_after == 0);
  for (const Quad& q : mesh.quads) CHECK(quality(mesh, q) > 0);
}

TEST_CASE("boundary vertices stay on the boundary, in order") {
  const Triangle_surface input = tiny::open_cylinder(90, 40);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(tiny::open_cylinder(18, 8));
  shake(mesh, projector, 0.1);
  const auto report = relax_quads(mesh, projector);
  REQUIRE(report);
  CHECK(report->boundary_vertices == 36);
  CHECK(report->inverted_after == 0);
  double turn = 0;
  for (int i = 0; i < 18; ++i) {
    const Point &a = mesh.points[i], &b = mesh.points[(i + 1) % 18];
    CHECK(a.z() == 0);
    CHECK(mesh.points[8 * 18 + i].z() == 2);
    const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
    CHECK(angle > 0);
    turn += angle;
  }
  CHECK(turn == Approx(2 * std::acos(-1.0)));
}

TEST_CASE("the two sides of a thin body do not pass through each other") {
  Triangle_surface input = tiny::torus(160, 80);
  Triangle_surface coarse = tiny::torus(30, 16);
  for (Point& p : input.points) p.z() *= 0.12;
  for (Point& p : coarse.points) p.z() *= 0.12;
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(coarse);
  Noise noise; // within the sheets: no vertex changes sides
  for (Point& p : mesh.points)
    p = projector.closest(p + 0.1 * noise.vector().cwiseProduct(Point(1, 1, 0))).point;
  const double meetings_before = certify({mesh}).check("no_self_intersections").measured;
  const auto report = relax_quads(mesh, projector);
  REQUIRE(report);
  CHECK(meetings_before > 10);
  CHECK(report->inverted_after == 0);
  CHECK(report->intersections_after == 0);
  CHECK(certify({mesh}).check("no_self_intersections").status == Check_status::passed);
  CHECK(certify({mesh}).check("no_inverted_quads").status == Check_status::passed);
}

TEST_CASE(
    "the report counts the intersections that the certificate finds, and the vertices off the surface") {
  // Two crossing quads that are held where they are.
  const Triangle_surface input = thin_sheet(0.5);
  const Surface_projector projector(input);
  Quad_mesh mesh{{Point(0, 0, 0.2), Point(1, 0, 0.2), Point(1, 1, 0.2), Point(0, 1, 0.2), Point(0.5, 0.2, 0),
                  Point(0.5, 0.8, 0), Point(0.5, 0.8, 1), Point(0.5, 0.2, 1)},
                 {{0, 1, 2, 3}, {4, 5, 6, 7}}};
  const auto report = relax_quads(mesh, projector, std::vector<char>(8, 1));
  REQUIRE(report);
  CHECK(report->intersections_after == 1);
  CHECK(report->off_surface.empty()); // fixed vertices are not counted
  CHECK(report->moved_vertices == 0);
}

TEST_CASE("fixed vertices do not move by a bit") {
  const Triangle_surface input = tiny::torus(60, 30);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(tiny::torus(20, 10));
  shake(mesh, projector, 0.05);
  mesh.points[7] += Point(0, 0, 1e-3); // off the surface, and to stay there
  const Quad_mesh before = mesh;
  std::vector<char> fixed(mesh.points.size(), 0);
  for (std::size_t v = 0; v < fixed.size(); v += 7) fixed[v] = 1;
  REQUIRE(relax_quads(mesh, projector, fixed));
  for (std::size_t v = 0; v < fixed.size(); v += 7) CHECK(mesh.points[v] == before.points[v]);
  CHECK(mesh.points[1] != before.points[1]);
}

TEST_CASE("one thread and several give the same bytes") {
  const Triangle_surface input = tiny::torus(200, 100);
  const Surface_projector projector(input);
  Quad_mesh one = quads_of(tiny::torus(100, 50));
  shake(one, projector, 0.03);
  Quad_mesh three = one;
  Relax_options options;
  REQUIRE(relax_quads(one, projector, {}, options));
  options.threads = 3;
  REQUIRE(relax_quads(three, projector, {}, options));
  CHECK(one.points == three.points);
}

TEST_CASE("the usual sweeps take a shear out of a whole surface") {
  const Triangle_surface input = tiny::open_cylinder(48, 48, 4);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(tiny::open_cylinder(24, 24, 4));
  for (Point& p : mesh.points) p = Eigen::AngleAxisd(0.3 * p.z(), Point::UnitZ()) * p;
  Quad_mesh soon = mesh;
  Relax_options options;
  options.more_iterations = 0;
  const auto usual = relax_quads(mesh, projector, {}, options);
  options.iterations /= 3;
  const auto third = relax_quads(soon, projector, {}, options);
  REQUIRE((bool(usual) && bool(third)));
  CHECK(1 - usual->mean_after < 0.9 * (1 - third->mean_after));
  CHECK(1 - usual->mean_after < 0.7 * (1 - usual->mean_before));
}

TEST_CASE("quads that are nearly good are relaxed further, and bad or good ones are not") {
  const Triangle_surface input = tiny::open_cylinder(48, 48, 4);
  const Surface_projector projector(input);
  for (const double twist : {0.1, 0.55, 2.0}) {
    INFO(twist);
    Quad_mesh usual = quads_of(tiny::open_cylinder(24, 24, 4));
    for (Point& p : usual.points) p = Eigen::AngleAxisd(twist * p.z(), Point::UnitZ()) * p;
    Quad_mesh further = usual;
    Relax_options options;
    options.iterations = 10;
    const auto more = relax_quads(further, projector, {}, options);
    options.more_iterations = 0;
    const auto less = relax_quads(usual, projector, {}, options);
    REQUIRE((bool(more) && bool(less)));
    if (twist == 0.55) {
      CHECK(less->mean_after < 0.92);
      CHECK(more->mean_after > less->mean_after + 0.005);
    } else {
      CHECK(further.points == usual.points);
    }
  }
}

TEST_CASE("vertices that have come together part again, though their quads have good angles") {
  const Triangle_surface input = tiny::torus(60, 30);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(input);
  const Quad first = mesh.quads[0];
  mesh.points[first[1]] = mesh.points[first[0]] + 1e-9 * (mesh.points[first[1]] - mesh.points[first[0]]);
  REQUIRE(quality(mesh, first) > 0.4);
  Relax_options options;
  options.iterations = 0;
  REQUIRE(relax_quads(mesh, projector, {}, options));
  std::array<double, 4> length;
  for (int i = 0; i < 4; ++i) length[i] = (mesh.points[first[(i + 1) % 4]] - mesh.points[first[i]]).norm();
  const auto [least, most] = std::minmax_element(length.begin(), length.end());
  CHECK(*least > *most / 250);
}

TEST_CASE(
    "quads below the wanted quality are raised last, without new defects, and good ones are left alone") {
  const Triangle_surface input = tiny::torus(60, 30);
  const Surface_projector projector(input);
  Relax_options unpolished;
  unpolished.iterations = 0;
  unpolished.wanted = 0;
  Relax_options polished = unpolished;
  polished.wanted = 0.7;
  Quad_mesh mesh = quads_of(tiny::torus(24, 12));
  const Quad_mesh good = mesh;
  const int v = mesh.quads[30][2];
  mesh.points[v] += 0.4 * (mesh.points[mesh.quads[30][0]] - mesh.points[v]); // into the corner across
  Quad_mesh raised = mesh;
  const auto less = relax_quads(mesh, projector, {}, unpolished);
  const auto more = relax_quads(raised, projector, {}, polished);
  REQUIRE((bool(less) && bool(more)));
  CHECK(less->worst_after < 0.5);
  CHECK(more->worst_after > 0.7);
  CHECK(more->intersections_after == 0);
  Quad_mesh untouched = good, same = good;
  REQUIRE(relax_quads(untouched, projector, {}, unpolished));
  REQUIRE(relax_quads(same, projector, {}, polished));
  CHECK(same.points == untouched.points);
}

TEST_CASE("a mesh that is good already keeps its quality") {
  const Triangle_surface input = tiny::torus(60, 30);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(input);
  const auto report = relax_quads(mesh, projector);
  REQUIRE(report);
  CHECK(report->worst_after >= report->worst_before - 0.01);
}

TEST_CASE("what cannot be relaxed is refused with a reason, and the mesh is untouched") {
  const Triangle_surface input = tiny::torus(9, 9);
  const Surface_projector projector(input);
  Quad_mesh mesh = quads_of(input);
  const std::vector<Point> points = mesh.points;
  CHECK(relax_quads(mesh, projector, std::vector<char>{1, 0}).error().code == Error_code::impossible_request);
  Vertex_constraints places;
  places.places = {{0, 0, 0.0}}; // there is no curve
  CHECK(relax_quads(mesh, projector, places).error().code == Error_code::impossible_request);
  places.curves = {make_surface_curve({input.points[0], input.points[1]}, false)};
  places.places = {{0, 0, 0.0}, {0, 0, 0.1}}; // twice
  CHECK(relax_quads(mesh, projector, places).error().index == 0);
  Relax_options options;
  options.attempts = -1;
  CHECK(relax_quads(mesh, projector, {}, options).error().code == Error_code::impossible_request);
  options = {};
  options.wanted = 1.5;
  CHECK(relax_quads(mesh, projector, {}, options).error().code == Error_code::impossible_request);
  options = {};
  options.threads = 0;
  CHECK(relax_quads(mesh, projector, {}, options).error().code == Error_code::impossible_request);
  struct Stop : Observer {
    bool cancelled() const override { return true; }
  } stop;
  CHECK(relax_quads(mesh, projector, {}, {}, &stop).error().code == Error_code::cancelled);
  CHECK(mesh.points == points);
  mesh.quads[5][2] = 81;
  const auto refused = relax_quads(mesh, projector);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().index == 5);
}
