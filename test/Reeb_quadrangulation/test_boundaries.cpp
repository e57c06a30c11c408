// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary loops that are filled while a design is made, and opened again in the end.
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;
using Catch::Contains;

namespace {

/// What is left of a surface without the faces whose middle is in a region, and without those that would
/// touch in a vertex alone.
Triangle_surface without(const Triangle_surface& s, const std::function<bool(const Point&)>& is_gone) {
  std::vector<char> gone;
  for (const Triangle& t : s.triangles)
    gone.push_back(is_gone(
        (s.points[std::size_t(t[0])] + s.points[std::size_t(t[1])] + s.points[std::size_t(t[2])]) / 3));
  for (;;) {
    Triangle_surface left;
    std::vector<int> number(s.points.size(), -1), origin;
    for (std::size_t f = 0; f < s.triangles.size(); ++f) {
      if (gone[f]) continue;
      Triangle kept = s.triangles[f];
      for (int& v : kept) {
        int& k = number[std::size_t(v)];
        if (k < 0) {
          k = left.number_of_vertices();
          left.points.push_back(s.points[std::size_t(v)]);
          origin.push_back(v);
        }
        v = k;
      }
      left.triangles.push_back(kept);
    }
    const Result<void> connected = left.connect();
    if (connected) return left;
    REQUIRE(connected.error().element == Element_kind::vertex);
    const int v = origin[std::size_t(connected.error().index)];
    for (std::size_t f = 0; f < s.triangles.size(); ++f)
      if (std::count(s.triangles[f].begin(), s.triangles[f].end(), v) > 0) gone[f] = 1;
  }
}

Triangle_surface dome() {
  return without(*make_shape("sphere", 3000), [](const Point& p) { return p.z() < -0.3; });
}

Quadrangulation_options filled(int quads) {
  Quadrangulation_options options;
  options.quads = quads;
  options.boundaries = Boundaries::fill;
  return options;
}

double distance_to_boundary(const Point& p, const Triangle_surface& s) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<int>& loop : boundary_loops(s))
    for (int h : loop) {
      const Point &a = s.points[std::size_t(s.source(h))], d = s.points[std::size_t(s.target(h))] - a;
      const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (a + t * d - p).norm());
    }
  return least;
}

/// Certified against the open surface, with its loops, on which all boundary vertices lie.
Quadrangulation opened(const Triangle_surface& surface, const Quadrangulation_options& options) {
  Result<Quadrangulation> made = quadrangulate(surface, options);
  INFO((made ? "" : made.error().message));
  REQUIRE(made);
  const Certificate certificate = certify({made->mesh, &surface, made->valences});
  INFO(to_text(certificate));
  CHECK(certificate.passed);
  CHECK(certificate.check("no_inverted_quads").measured == 0);
  CHECK(certificate.check("watertight").measured == double(boundary_loops(surface).size()));
  std::map<std::pair<int, int>, int> edges;
  for (const Quad& q : made->mesh.quads)
    for (int i = 0; i < 4; ++i) ++edges[std::minmax({q[std::size_t(i)], q[std::size_t((i + 1) % 4)]})];
  for (const auto& [edge, quads] : edges)
    if (quads == 1)
      for (int v : {edge.first, edge.second})
        CHECK(distance_to_boundary(made->mesh.points[std::size_t(v)], surface) < 1e-9);
  return std::move(*made);
}

} // namespace

TEST_CASE("a design goes across the filling of a dome, and its quads end on the rim") {
  const Triangle_surface surface = dome();
  const Quadrangulation made = opened(surface, filled(400));
  CHECK(boundary_loops(made.editor.working_surface()).empty());
  CHECK(made.mesh.quads.size() > 300);
  CHECK(made.mesh.quads.size() < 560);
}

TEST_CASE("both ends of a cylinder are filled and opened") {
  opened(*make_shape("cylinder", 2000), filled(500));
}

TEST_CASE("a hole in a torus takes no handle away") {
  const Triangle_surface torus = *make_shape("torus", 4000);
  opened(without(torus, [](const Point& p) { return (p - Point(1.4, 0, 0)).norm() < 0.35; }), filled(600));
  opened(without(torus, [](const Point& p) { return (p - Point(0, 1, 0.4)).norm() < 0.3; }), filled(600));
}

TEST_CASE("the rim of a filling may turn, and run across the quads") {
  // A sphere without a slanted square, and one whose rim is a wave.
  const Triangle_surface sphere = *make_shape("sphere", 6000);
  opened(without(sphere,
                 [](const Point& p) {
                   return p.x() > 0.5 && std::abs(p.y() + p.z()) < 0.6 && std::abs(p.y() - p.z()) < 0.6;
                 }),
         filled(600));
  opened(without(sphere,
                 [](const Point& p) { return p.x() < -0.2 + 0.25 * std::sin(5 * std::atan2(p.z(), p.y())); }),
         filled(600));
}

TEST_CASE("a closed surface has nothing to fill") {
  const Triangle_surface sphere = *make_shape("sphere", 1500);
  Quadrangulation_options keep = filled(200);
  keep.boundaries = Boundaries::keep;
  const Result<Quadrangulation> some = quadrangulate(sphere, filled(200)), same = quadrangulate(sphere, keep);
  REQUIRE(some);
  REQUIRE(same);
  CHECK(some->mesh.points == same->mesh.points);
  CHECK(some->mesh.quads == same->mesh.quads);
}

TEST_CASE("the recipe of a run with filled boundaries gives its bytes, also when it was text") {
  const Triangle_surface surface = dome();
  const Quadrangulation made = opened(surface, filled(300));
  const Result<Recipe> read = recipe_from_json(to_json(made.recipe));
  REQUIRE(read);
  CHECK(read->options.boundaries == Boundaries::fill);
  Result<Editor> editor = Editor::create(surface, read->options);
  REQUIRE(editor);
  for (const Edit& edit : read->edits) REQUIRE(editor->apply(edit));
  const Result<Finished_design> again = editor->finished_quads(read->finish);
  REQUIRE(again);
  CHECK(again->quads.mesh.points == made.mesh.points);
  CHECK(again->quads.mesh.quads == made.mesh.quads);
}

TEST_CASE("an extremum may lie in a filling, and edits name its places") {
  const Triangle_surface surface = dome();
  Editor_options options;
  options.quads = 300;
  options.boundaries = Boundaries::fill;
  Result<Editor> editor = Editor::create(surface, options);
  REQUIRE(editor);
  Set_extrema extrema;
  extrema.extrema = {{{Point(0.1, 0, -0.3), -1}, false, -1}, {{Point(0, 0, 1), -1}, true, -1}};
  REQUIRE(editor->apply(extrema));
  const Stitched_mesh whole = editor->quads();
  const Result<Stitched_mesh> open = editor->open_quads();
  REQUIRE(open);
  CHECK(open->mesh.quads.size() < whole.mesh.quads.size());
  Set_target target;
  target.quads = 600;
  REQUIRE(editor->apply(target));
  const Result<Finished_design> finished = editor->finished_quads();
  REQUIRE(finished);
  CHECK(certify({finished->quads.mesh, &surface}).passed);
  CHECK(std::abs(double(finished->quads.mesh.quads.size()) - 600) < 120);
  Split_pole pole;
  pole.at = {Point(0, 0, 1), -1};
  pole.kind = Pole_kind::whole;
  if (editor->apply(pole)) CHECK_THAT(editor->open_quads().error().message, Contains("whole pole"));
}

TEST_CASE("a mirror and filled boundaries exclude each other") {
  Quadrangulation_options options = filled(200);
  options.mirror.emplace();
  const Result<Quadrangulation> made = quadrangulate(dome(), options);
  REQUIRE(!made);
  CHECK_THAT(made.error().message, Contains("exclude each other"));
}

namespace {

/// The values of a design's field on the loops of a cylinder: at the bottom and at the top.
std::pair<double, double> loop_values(const Editor& editor) {
  const Triangle_surface& s = editor.working_surface();
  std::pair<double, double> found(-1, -1);
  for (const std::vector<int>& loop : boundary_loops(s)) {
    const int v = s.source(loop[0]);
    const bool top = s.points[std::size_t(v)].z() > 1;
    (top ? found.second : found.first) = editor.design().field->values[std::size_t(v)];
    for (int h : loop)
      CHECK(editor.design().field->values[std::size_t(s.source(h))] == (top ? found.second : found.first));
  }
  return found;
}

Editor cylinder_session() {
  Editor_options options;
  options.quads = 300;
  Result<Editor> editor = Editor::create(*make_shape("cylinder", 2000), options);
  REQUIRE(editor);
  return std::move(*editor);
}

const Surface_point at_bottom{Point(0, 0, -10), -1}, at_top{Point(0, 0, 10), -1},
    at_side{Point(1, 0, 1.5), -1};

} // namespace

TEST_CASE("a boundary loop is a minimum or a maximum by its height, or as it is asked for") {
  Editor editor = cylinder_session();
  REQUIRE(editor.apply(Suggest()));
  CHECK(loop_values(editor) == std::pair(0.0, 1.0));
  Suggest turned;
  turned.boundary = {{at_bottom, true, -1}, {at_top, false, -1}};
  REQUIRE(editor.apply(turned));
  CHECK(loop_values(editor) == std::pair(1.0, 0.0));
  // Both are maxima: then the field falls to a minimum between them, and there is a saddle.
  Set_extrema between;
  between.extrema = {{at_side, false, -1}};
  between.boundary = {{at_bottom, true, -1}, {at_top, true, -1}};
  REQUIRE(editor.apply(between));
  CHECK(loop_values(editor) == std::pair(1.0, 1.0));
  int saddles = 0;
  for (const Contour_node& n : editor.design().network.nodes) saddles += n.kind == Node_kind::saddle;
  CHECK(saddles == 1);
  CHECK(certify({editor.quads().mesh, &editor.input()}).passed);
}

TEST_CASE("the value of a boundary loop is a number that edits change and keep") {
  Editor editor = cylinder_session();
  Set_extrema extrema;
  extrema.extrema = {{at_side, true, -1}};
  extrema.boundary = {{at_top, true, 0.6}, {at_bottom, false, -1}};
  REQUIRE(editor.apply(extrema));
  CHECK(loop_values(editor) == std::pair(0.0, 0.6));
  const Triangle_surface& s = editor.working_surface();
  int top = -1;
  for (const std::vector<int>& loop : boundary_loops(s))
    if (s.points[std::size_t(s.source(loop[0]))].z() > 1) top = s.source(loop[0]);
  REQUIRE(editor.apply(Change_value{{s.points[std::size_t(top)], top}, 0.7}));
  CHECK(loop_values(editor) == std::pair(0.0, 0.7));
  // The next field on the whole surface keeps it.
  REQUIRE(editor.apply(Change_value{at_side, 0.9}));
  CHECK(loop_values(editor) == std::pair(0.0, 0.7));
  CHECK(certify({editor.quads().mesh, &editor.input()}).passed);
}

TEST_CASE("what boundary loops are is part of a recipe, and of a surface with a boundary") {
  Set_extrema edit;
  edit.boundary = {{at_top, false, 0.25}};
  const Result<Edit> read = edit_from_json(to_json(Edit(edit)));
  REQUIRE(read);
  REQUIRE(std::get<Set_extrema>(*read).boundary.size() == 1);
  CHECK(std::get<Set_extrema>(*read).boundary[0].value == 0.25);
  CHECK(!std::get<Set_extrema>(*read).boundary[0].is_maximum);
  Result<Editor> closed = Editor::create(*make_shape("sphere", 500));
  REQUIRE(closed);
  Suggest suggest;
  suggest.boundary = {{at_top, true, -1}};
  CHECK_THAT(closed->apply(suggest).error().message, Contains("no boundary loop"));
}

TEST_CASE("a run may say what its boundary loops are, and its search keeps it") {
  Quadrangulation_options options;
  options.quads = 300;
  options.effort = Effort::normal;
  options.boundary_values = {{at_bottom, true, -1}, {at_top, false, -1}};
  const Result<Quadrangulation> made = quadrangulate(*make_shape("cylinder", 1500), options);
  REQUIRE(made);
  CHECK(loop_values(made->editor) == std::pair(1.0, 0.0));
}
