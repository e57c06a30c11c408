// SPDX-License-Identifier: GPL-3.0-or-later
// Guides: strokes that quads follow.
#include "editor_sessions.h"
#include "tiny_surfaces.h"

#include "base/quad_connectivity.h"
#include "base/segments.h"

#include <CGAL/Reeb_quadrangulation/followed_guide.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;
using namespace sessions;

namespace {

constexpr double half_turn = 3.14159265358979323846;

// A point of the torus of the sessions: a around the axis, b around the tube.
Point on_torus(double a, double b) {
  return {(1 + 0.4 * std::cos(b)) * std::cos(a), (1 + 0.4 * std::cos(b)) * std::sin(a), 0.4 * std::sin(b)};
}

Guide drawn(int n, bool closed, const std::function<Point(double)>& at) {
  Guide guide;
  guide.closed = closed;
  for (int i = 0; i < n; ++i) guide.points.push_back(at(i / double(closed ? n : n - 1)));
  return guide;
}

// Along the tube, that is along the flow, and from its outside a little upwards.
Guide along_the_tube(double strength = 1) {
  Guide guide =
      drawn(20, false, [](double t) { return on_torus(half_turn * (0.25 + 0.5 * t), 0.2 + 0.5 * t); });
  guide.strength = strength;
  return guide;
}

// Around the tube, on a wave.
Guide around_the_tube(double phase = 0) {
  return drawn(40, true, [=](double t) {
    return on_torus(half_turn / 2 + phase + 0.12 * std::sin(2 * half_turn * t), -2 * half_turn * t);
  });
}

Editor fine_torus(int quads) {
  return session(shape("torus", 1500), extrema({-1.4, 0, 0}, {{1.4, 0, 0}}), quads);
}

Finished_design finished(const Editor& editor) {
  Result<Finished_design> done = editor.finished_quads();
  INFO((done ? "" : done.error().message));
  REQUIRE(bool(done));
  return std::move(*done);
}

double distance(const Surface_curve& curve, const Point& p) {
  return (curve.at(curve.nearest(p, 0, curve.length())) - p).norm();
}

int vertices_on(const Quad_mesh& mesh, const Surface_curve& curve) {
  return int(std::count_if(mesh.points.begin(), mesh.points.end(),
                           [&](const Point& p) { return distance(curve, p) < 1e-9; }));
}

double worst_jacobian(const Quad_mesh& mesh) {
  double worst = 1;
  for (const Quad& q : mesh.quads)
    worst = std::min(worst, scaled_jacobian(mesh.points[std::size_t(q[0])], mesh.points[std::size_t(q[1])],
                                            mesh.points[std::size_t(q[2])], mesh.points[std::size_t(q[3])]));
  return worst;
}

Stroke traced(const Triangle_surface& surface, const Guide& guide) {
  const Surface_projector projector(surface);
  Result<Stroke> stroke = trace_stroke(projector, guide);
  INFO((stroke ? "" : stroke.error().message));
  REQUIRE(bool(stroke));
  return std::move(*stroke);
}

} // namespace

TEST_CASE("a stroke on a surface has each of its segments in one face and crosses edges between them") {
  const Triangle_surface torus = shape("torus", 1500);
  const Surface_projector projector(torus);
  for (const Guide& guide : {along_the_tube(), around_the_tube()}) {
    const Stroke stroke = traced(torus, guide);
    REQUIRE(stroke.faces.size() + 1 == stroke.curve.points.size());
    CHECK((stroke.curve.points.front() == stroke.curve.points.back()) == guide.closed);
    for (std::size_t i = 0; i < stroke.faces.size(); ++i)
      for (const Point& p : {stroke.curve.points[i], stroke.curve.points[i + 1]}) {
        const Point& corner = torus.points[std::size_t(torus.triangles[std::size_t(stroke.faces[i])][0])];
        CHECK(std::abs((p - corner).dot(projector.normal(stroke.faces[i]))) < 1e-9);
      }
    std::size_t changes = 0;
    for (std::size_t i = 0; i + 1 < stroke.faces.size(); ++i)
      changes += stroke.faces[i] != stroke.faces[i + 1];
    CHECK(changes == stroke.crossings.size());
  }
}

TEST_CASE("the way between two far points of a stroke goes over the surface") {
  const Triangle_surface sphere = shape("sphere", 1200);
  Guide guide;
  guide.points = {Point(1, 0, 0), Point(-0.6, 0.8, 0)};
  const Stroke stroke = traced(sphere, guide);
  CHECK(stroke.curve.length() == Approx(std::acos(-0.6)).epsilon(0.02));
  guide.points.back() = Point(-1, 0, 0); // every way around is as short
  CHECK(traced(sphere, guide).curve.length() == Approx(half_turn).epsilon(0.02));
}

TEST_CASE("strokes that are none are refused with the point that is wrong") {
  const Triangle_surface torus = shape("torus", 1500);
  const Surface_projector projector(torus);
  const auto message = [&](const Guide& guide) {
    const Result<Stroke> stroke = trace_stroke(projector, guide);
    REQUIRE(!stroke);
    CHECK(stroke.error().code == Error_code::impossible_request);
    return stroke.error().message;
  };
  Guide guide = along_the_tube();
  guide.points[3].y() += 0.2;
  CHECK(message(guide).find("point 3 of the guide lies off the surface by ") == 0);
  guide.points[3].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(message(guide) == "point 3 of the guide is not finite");
  guide.points.assign(5, on_torus(0, 0));
  CHECK(message(guide) == "a guide has two points at least");
  guide.closed = true;
  CHECK(message(guide) == "a closed guide has three points at least");
  CHECK(message(along_the_tube(0)) == "the strength of a guide lies between 0 and 1, and is not 0");
  CHECK(message(along_the_tube(1.5)) == "the strength of a guide lies between 0 and 1, and is not 0");
}

TEST_CASE("columns come onto a stroke along the flow, and quads stay good") {
  Editor editor = torus_session();
  const Finished_design plain = finished(editor);
  const Edit_report report = applied(editor, Add_guide{along_the_tube()});
  CHECK(report.new_charts.empty());
  CHECK(report.remeshed_charts.empty());
  CHECK(report.remark == "Columns of quads come onto the stroke when the quads are finished.");
  const Finished_design guided = finished(editor);
  REQUIRE(guided.guides.size() == 1);
  const Guide_outcome& outcome = guided.guides[0];
  INFO(outcome.reason);
  REQUIRE(outcome.kept);
  CHECK(outcome.before.angle > 5);
  CHECK(outcome.after.angle < 5);
  CHECK(outcome.after.on > 0.9);
  CHECK(outcome.jacobian_after > 0.98 * outcome.jacobian_before);
  const Stroke stroke = traced(editor.input(), along_the_tube());
  CHECK(vertices_on(guided.quads.mesh, stroke.curve) == outcome.vertices);
  CHECK(followed_guide(guided.quads.mesh, stroke.curve).angle == outcome.after.angle);
  CHECK(worst_jacobian(guided.quads.mesh) > 0.2);
  CHECK(guided.relaxation.inverted_after == 0);
  CHECK(guided.quads.mesh.quads == plain.quads.mesh.quads);
}

TEST_CASE("a guide of less than full strength takes every vertex that part of its way") {
  Editor editor = torus_session();
  const Surface_projector projector(editor.input());
  const std::vector<Point> plain = finished(editor).quads.mesh.points;
  applied(editor, Add_guide{along_the_tube()});
  const std::vector<Point> exact = finished(editor).quads.mesh.points;
  for (const double strength : {0.3, 0.7}) {
    Move_guide weaker;
    weaker.at = {along_the_tube().points[5], -1};
    weaker.strength = strength;
    applied(editor, weaker);
    const Finished_design guided = finished(editor);
    REQUIRE(guided.guides[0].kept);
    for (std::size_t v = 0; v < plain.size(); ++v) {
      const Point there = projector.closest(plain[v] + strength * (exact[v] - plain[v])).point;
      CHECK((guided.quads.mesh.points[v] - there).norm() < 1e-6);
    }
  }
}

TEST_CASE("a closed stroke around a chart becomes a contour, which moves with it and goes with it") {
  Editor editor = fine_torus(2500);
  const std::vector<int> before = contours_of(editor);
  const Edit_report added = applied(editor, Add_guide{around_the_tube()});
  CHECK(added.remark == "The stroke becomes a contour.");
  REQUIRE(added.new_contours.size() == 1);
  const int contour = editor.design().guides.at(0).contour;
  CHECK(contour == added.new_contours[0]);
  const Stroke stroke = traced(editor.working_surface(), around_the_tube());
  for (const Point& p : points_of(editor, contour)) CHECK(distance(stroke.curve, p) < 0.02);
  const Finished_design guided = finished(editor);
  INFO(guided.guides[0].reason);
  CHECK(guided.guides[0].after.angle < 5);
  CHECK(guided.guides[0].after.on > 0.9);
  CHECK(guided.relaxation.inverted_after == 0);

  applied(editor, Move_guide{{around_the_tube().points[0], -1}, around_the_tube(0.3).points, 0});
  const int moved = editor.design().guides.at(0).contour;
  REQUIRE(moved >= 0);
  const Stroke there = traced(editor.working_surface(), around_the_tube(0.3));
  for (const Point& p : points_of(editor, moved)) CHECK(distance(there.curve, p) < 0.02);
  applied(editor, Remove_guide{{around_the_tube(0.3).points[0], -1}});
  CHECK(editor.design().guides.empty());
  CHECK(contours_of(editor).size() == before.size());
  refused(editor, Remove_guide{{Point(0, 0, 0), -1}}, "there is no guide");
}

TEST_CASE("a stroke near a contour without saddles takes its place") {
  Editor editor = sphere_session();
  const auto circle = [](double z) {
    return drawn(40, true, [=](double t) {
      const double r = std::sqrt(1 - z * z);
      return Point(r * std::cos(2 * half_turn * t), r * std::sin(2 * half_turn * t), z);
    });
  };
  applied(editor, Subdivide_chart{{Point(1, 0, 0), -1}});
  const std::size_t number = contours_of(editor).size();
  applied(editor, Add_guide{circle(0.03)});
  CHECK(contours_of(editor).size() == number);
  for (const Point& p : points_of(editor, editor.design().guides.at(0).contour))
    CHECK(p.z() == Approx(0.03).margin(0.01));
  // A second guide there does not take the contour of the first one away.
  const Edit_report second = applied(editor, Add_guide{circle(0.06)});
  CHECK(second.remark.find("No contour can follow the stroke") == 0);
  CHECK(editor.design().guides.at(0).contour >= 0);
}

TEST_CASE("rows or columns follow a stroke as the user says") {
  Editor editor = sphere_session();
  // Between the two families, nearer to the level lines.
  Guide guide = drawn(20, false, [](double t) {
    const double a = 1.2 * t, z = -0.4 + 0.8 * t;
    return Point(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
  });
  std::vector<double> upwards; // the part of the edges on the stroke that rises
  for (const Guide_way way : {Guide_way::level, Guide_way::flow}) {
    guide.way = way;
    applied(editor, Add_guide{guide});
    const Finished_design guided = finished(editor);
    INFO(guided.guides[0].reason);
    REQUIRE(guided.guides[0].kept);
    CHECK(guided.guides[0].after.on > guided.guides[0].before.on);
    // The lines of the other family cross the stroke: the edges on it are of the one that was asked for.
    const Stroke stroke = traced(editor.input(), guide);
    const Quad_mesh plain = editor.quads().mesh;
    double up = 0, number = 0;
    for (const Quad& q : guided.quads.mesh.quads)
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t a = std::size_t(q[i]), b = std::size_t(q[(i + 1) % 4]);
        if (distance(stroke.curve, guided.quads.mesh.points[a]) > 1e-9 ||
            distance(stroke.curve, guided.quads.mesh.points[b]) > 1e-9)
          continue;
        const Point way_before = (plain.points[b] - plain.points[a]).normalized();
        up += std::abs(way_before.z());
        ++number;
      }
    REQUIRE(number > 2);
    upwards.push_back(up / number);
    editor.undo();
  }
  CHECK(upwards[0] < upwards[1]);
}

TEST_CASE("a radial stroke on a flat disc is followed") {
  Set_extrema first;
  first.extrema.push_back({{Point(0, 0, 0), -1}, false, -1});
  Editor editor = session(tiny::disc(48, 16), first, 300);
  const Guide guide = drawn(12, false, [](double t) {
    const double a = 0.3 + 0.15 * t, r = 6 + 7 * t;
    return Point(r * std::cos(a), r * std::sin(a), 0);
  });
  applied(editor, Add_guide{guide});
  const Finished_design guided = finished(editor);
  INFO(guided.guides[0].reason);
  REQUIRE(guided.guides[0].kept);
  CHECK(guided.guides[0].after.angle < 8);
  CHECK(worst_jacobian(guided.quads.mesh) > 0.2);
}

TEST_CASE("a stroke too short to matter is said to be") {
  Editor editor = torus_session();
  Guide guide;
  guide.points = {on_torus(half_turn / 2, 0), on_torus(half_turn / 2 + 0.05, 0)};
  const Edit_report report = applied(editor, Add_guide{guide});
  CHECK(report.remark.find("edges of quads long: shorter than 2, it hardly matters.") != std::string::npos);
}

TEST_CASE(
    "an automatic run with guides equals the replay of its recipe, and both threads' bytes are the same") {
  Quadrangulation_options options;
  options.quads = 300;
  options.prepare = false;
  options.extrema = {{Point(-1.4, 0, 0), false}, {Point(1.4, 0, 0), true}};
  options.guides = {along_the_tube(), around_the_tube(-0.5), along_the_tube(0.5)};
  const Triangle_surface torus = shape("torus", 1500);
  options.threads = 1;
  const Result<Quadrangulation> run = quadrangulate(torus, options);
  INFO((run ? "" : run.error().message));
  REQUIRE(bool(run));
  CHECK(run->guides.size() == 3);
  options.threads = 2;
  const Result<Quadrangulation> two = quadrangulate(torus, options);
  REQUIRE(bool(two));
  CHECK(two->mesh.points == run->mesh.points);
  const Result<Recipe> recipe = recipe_from_json(to_json(run->recipe));
  REQUIRE(bool(recipe));
  Result<Editor> editor = Editor::create(torus, recipe->options);
  REQUIRE(bool(editor));
  for (const Edit& edit : recipe->edits) REQUIRE(bool(editor->apply(edit)));
  const Result<Finished_design> again = editor->finished_quads(recipe->finish);
  REQUIRE(bool(again));
  CHECK(again->quads.mesh.points == run->mesh.points);
  CHECK(again->quads.mesh.quads == run->mesh.quads);
}
