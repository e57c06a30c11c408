// SPDX-License-Identifier: GPL-3.0-or-later
// A run finds the sharp edges that its contours should be.
#include "automatic/search_curves.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <catch2/catch.hpp>

using namespace CGAL::Reeb_quadrangulation;

namespace {

Triangle_surface shape(const char* name, int triangles) {
  Result<Triangle_surface> made = make_shape(name, triangles);
  REQUIRE(bool(made));
  return std::move(*made);
}

// A bar with a quarter of a turn in it.
Triangle_surface twisted(Triangle_surface s, double turn) {
  for (Point& p : s.points) {
    const double x = p.x() - 0.5, y = p.y() - 0.5, a = turn * p.z();
    p = {std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y, 2 * p.z()};
  }
  return s;
}

Quadrangulation made(const Triangle_surface& surface, Effort effort, int threads = 1) {
  Quadrangulation_options options;
  options.quads = 400;
  options.effort = effort;
  options.threads = threads;
  Result<Quadrangulation> result = quadrangulate(surface, options);
  INFO((result ? std::string() : result.error().message));
  REQUIRE(bool(result));
  return std::move(*result);
}

} // namespace

TEST_CASE(
    "quads miss no sharp edge of a cube that they follow, and all of those that they cross at 45 degrees") {
  const Triangle_surface surface = tiny::subdivided(tiny::subdivided(tiny::cube()));
  Quad_mesh straight, oblique;
  straight.points = {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)};
  straight.quads = {{0, 1, 2, 3}};
  oblique = straight;
  for (Point& p : oblique.points) p = Point(p.x() - p.y(), p.x() + p.y(), 0);
  // One quad is as large as the surface: no chain is as long as two of its edges.
  CHECK(internal::missed_features(straight, surface, 45) == 0);
  for (Quad_mesh* mesh : {&straight, &oblique}) mesh->quads.resize(400, {0, 1, 2, 3});
  const double met = internal::missed_features(straight, surface, 45);
  CHECK(met < 0.4); // the four edges across the plane are missed
  CHECK(met > 0.3);
  CHECK(internal::missed_features(oblique, surface, 45) == Approx(1));
}

TEST_CASE("a run finds the caps of a twisted bar: eight extraordinary vertices, on its corners") {
  const Triangle_surface surface = twisted(shape("cube", 2000), 1.5);
  const Quadrangulation q = made(surface, Effort::normal);
  REQUIRE(!q.search.empty());
  for (std::size_t i = 1; i < q.search.size(); ++i) CHECK(q.search[i].energy < q.search[i - 1].energy);
  const auto& edit = std::get<Set_extrema>(q.recipe.edits[0]);
  CHECK(edit.curves.size() == 2);
  CHECK(q.valences.at(3) == 8);
  CHECK(q.valences.size() == 2);
  CHECK(certify({q.mesh, &surface, q.valences}).passed);
  for (int i = 0; i < 8; ++i) {
    const double x = (i & 1) - 0.5, y = (i / 2 & 1) - 0.5, z = i / 4, a = 1.5 * z;
    const Point corner(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y, 2 * z);
    CHECK(std::any_of(q.mesh.points.begin(), q.mesh.points.end(),
                      [&](const Point& p) { return (p - corner).norm() < 1e-9; }));
  }
}

TEST_CASE("a run with curves has the bytes of its recipe, on any number of threads") {
  const Triangle_surface surface = twisted(shape("cube", 2000), 1.5);
  const Quadrangulation one = made(surface, Effort::fast, 1), two = made(surface, Effort::fast, 2);
  CHECK(one.mesh.points == two.mesh.points);
  Result<Editor> editor = Editor::create(surface, one.recipe.options);
  REQUIRE(bool(editor));
  for (const Edit& edit : one.recipe.edits) REQUIRE(bool(editor->apply(edit)));
  const Result<Finished_design> replayed = editor->finished_quads(one.recipe.finish);
  REQUIRE(bool(replayed));
  CHECK(replayed->quads.mesh.points == one.mesh.points);
  CHECK(replayed->quads.mesh.quads == one.mesh.quads);
}

TEST_CASE("a surface without sharp edges has no curve to try") {
  Editor_options options;
  options.quads = 400;
  Result<Editor> editor = Editor::create(shape("sphere", 2000), options);
  REQUIRE(bool(editor));
  const auto found = internal::search_curves(*editor, Suggest(), 45, Search_options(), nullptr);
  REQUIRE(bool(found));
  CHECK(found->tries == 0);
  CHECK(!found->edit);
}
