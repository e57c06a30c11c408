// SPDX-License-Identifier: GPL-3.0-or-later
// Closed lines of sharp edges become contours as they are.
#include "editor_sessions.h"
#include "surface/sharp_patches.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>

#include <catch2/catch.hpp>

using namespace CGAL::Reeb_quadrangulation;

namespace {

using Kind = Sharp_curve_kind;

Triangle_surface cube() {
  Result<Triangle_surface> made = make_shape("cube", 1500);
  REQUIRE(bool(made));
  return std::move(*made);
}

// A washer: a square turned around an axis, with 4 n points around and four circles of sharp edges.
Triangle_surface washer(int m, int n) {
  Triangle_surface s = tiny::torus(m, 4 * n);
  const double tau = 2 * std::acos(-1.0);
  const double corner[4][2] = {{1, 0}, {2, 0}, {2, 1}, {1, 1}};
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < 4 * n; ++j) {
      const double t = double(j % n) / n, *a = corner[j / n], *b = corner[(j / n + 1) % 4];
      const double r = (1 - t) * a[0] + t * b[0], z = (1 - t) * a[1] + t * b[1];
      s.points[std::size_t(i * 4 * n + j)] = {r * std::cos(tau * i / m), r * std::sin(tau * i / m), z};
    }
  return s;
}

Editor session(const Triangle_surface& surface, int quads = 400) {
  Editor_options options;
  options.quads = quads;
  options.prepare = false;
  Result<Editor> editor = Editor::create(surface, options);
  REQUIRE(bool(editor));
  return std::move(*editor);
}

Set_extrema on_curves(const std::vector<Set_extrema::Sharp_curve>& curves) {
  Set_extrema edit;
  edit.curves = curves;
  return edit;
}

// The cap of the cube's face x = 0 or x = 1.
Set_extrema::Sharp_curve cap(double x, Kind kind) {
  return {sessions::at(x, 0.52, 0.48), sessions::at(x, 0, 0.5), kind};
}

Set_extrema::Sharp_curve circle(double r, double z, Kind kind) {
  return {sessions::at(1.5, 0, z), sessions::at(r, 0, z), kind}; // around the washer's upper or lower face
}

bool has_vertex_at(const Quad_mesh& mesh, const Point& p) {
  return std::any_of(mesh.points.begin(), mesh.points.end(),
                     [&](const Point& q) { return (p - q).norm() < 1e-12; });
}

} // namespace

TEST_CASE("a cube has six patches of one loop each, which turns four times") {
  const Triangle_surface surface = cube();
  const std::vector<Sharp_patch> patches = sharp_patches(surface, 45);
  REQUIRE(patches.size() == 6);
  std::size_t faces = 0;
  for (const Sharp_patch& patch : patches) {
    faces += patch.faces.size();
    REQUIRE(patch.loops.size() == 1);
    CHECK(patch.loops[0].is_simple);
    CHECK(turns_of(surface, patch.loops[0], 40, true).size() == 4);
    CHECK(rectangle_in(surface, patch.loops[0]) == turns_of(surface, patch.loops[0], 40, false));
  }
  CHECK(faces == std::size_t(surface.number_of_faces()));
}

TEST_CASE("caps on two opposite faces of a cube put its extraordinary vertices on its eight corners") {
  const Triangle_surface surface = cube();
  Editor editor = session(surface);
  const Edit edit = on_curves({cap(0, Kind::cap_of_minimum), cap(1, Kind::cap_of_maximum)});
  const Result<Edit_report> done = editor.apply(edit);
  INFO((done ? std::string() : done.error().message));
  REQUIRE(bool(done));
  const Stitched_mesh quads = editor.quads();
  CHECK(quads.valences.at(3) == 8);
  for (const auto& [valence, number] : quads.valences) CHECK((valence == 3 || valence == 4));
  for (int i = 0; i < 8; ++i) CHECK(has_vertex_at(quads.mesh, Point(i & 1, i / 2 & 1, i / 4)));
  CHECK(certify({quads.mesh, &surface, quads.valences}).passed);
}

TEST_CASE("rings at the four sharp circles of a washer give quads without an extraordinary vertex") {
  const Triangle_surface surface = washer(48, 6);
  Editor editor = session(surface);
  const Edit edit = on_curves({circle(1, 0, Kind::minimum), circle(2, 0, Kind::maximum),
                               circle(2, 1, Kind::minimum), circle(1, 1, Kind::maximum)});
  const Result<Edit_report> done = editor.apply(edit);
  INFO((done ? std::string() : done.error().message));
  REQUIRE(bool(done));
  CHECK(editor.design().charts.size() == 4);
  const Stitched_mesh quads = editor.quads();
  CHECK(quads.valences.size() == 1);
  CHECK(quads.valences.count(4) == 1);
  CHECK(certify({quads.mesh, &surface, quads.valences}).passed);
  // Every circle is a closed line of quads' edges: its vertices are there on all four.
  for (double r : {1.0, 2.0})
    for (double z : {0.0, 1.0}) {
      int on_circle = 0;
      for (const Point& p : quads.mesh.points)
        on_circle += std::abs(p.z() - z) < 1e-9 && std::abs(p.head<2>().norm() - r) < 0.01 * r;
      CHECK(on_circle >= 4);
    }
}

TEST_CASE(
    "a recipe with curves is read as it was written, and gives the same bytes on any number of threads") {
  const Triangle_surface surface = washer(48, 6);
  Recipe recipe;
  recipe.options.quads = 400;
  recipe.edits.push_back(on_curves({circle(1, 0, Kind::minimum), circle(2, 1, Kind::maximum)}));
  Result<Recipe> read = recipe_from_json(to_json(recipe));
  REQUIRE(bool(read));
  std::vector<sessions::Bytes> bytes;
  for (int threads : {1, 2}) {
    read->options.threads = threads;
    Result<Editor> editor = Editor::create(surface, read->options);
    REQUIRE(bool(editor));
    const Result<Edit_report> done = editor->apply(read->edits[0]);
    INFO((done ? std::string() : done.error().message));
    REQUIRE(bool(done));
    bytes.push_back(sessions::bytes_of(*editor));
  }
  CHECK(bytes[0] == bytes[1]);
}

TEST_CASE("curves that cannot all be contours are refused, and the design stays") {
  const Triangle_surface surface = cube(), ring = washer(48, 6), open = tiny::open_cylinder(24, 4);
  Editor on_cube = session(surface), on_ring = session(ring), on_open = session(open);
  const auto refused = [](Editor& editor, const Set_extrema& edit) {
    const Result<Edit_report> done = editor.apply(edit);
    REQUIRE(!done);
    CHECK(done.error().code == Error_code::refused_edit);
    CHECK(editor.design().charts.empty());
  };
  refused(on_cube, on_curves({cap(0, Kind::cap_of_minimum), cap(0, Kind::cap_of_maximum)}));
  refused(on_cube, on_curves({cap(0, Kind::cap_of_minimum),
                              {sessions::at(0.5, 0.52, 0), sessions::at(0.5, 0, 0), Kind::maximum}}));
  refused(on_cube,
          on_curves({cap(0, Kind::maximum), cap(1, Kind::minimum)})); // their insides lack an extremum
  refused(on_ring, on_curves({circle(1, 0, Kind::cap_of_maximum)}));  // the face has two loops
  refused(on_open, on_curves({cap(1, Kind::maximum)}));
  Set_extrema extremum_on_curve = on_curves({cap(0, Kind::cap_of_minimum)});
  extremum_on_curve.extrema.push_back({sessions::at(0, 0, 0), true, 1});
  refused(on_cube, extremum_on_curve);
  Set_extrema no_angle = on_curves({cap(0, Kind::cap_of_minimum)});
  no_angle.curves[0].feature_angle = 0;
  const Result<Edit_report> done = on_cube.apply(no_angle);
  REQUIRE(!done);
  CHECK(done.error().code == Error_code::impossible_request);
}
