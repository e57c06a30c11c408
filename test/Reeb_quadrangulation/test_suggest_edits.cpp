// SPDX-License-Identifier: GPL-3.0-or-later
// Hints as theorems on small shapes: where one must be, where none may be, that each one keeps its promise,
// and that taking them ends.
#include "editor_sessions.h"

#include <CGAL/Reeb_quadrangulation/IO/hints.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace sessions;

namespace {

Editor designed(const std::string& name, int triangles, const std::vector<Edit>& edits, int quads) {
  Editor editor = session(shape(name, triangles), edits[0], quads);
  for (std::size_t i = 1; i < edits.size(); ++i) REQUIRE(bool(editor.apply(edits[i])));
  return editor;
}

std::vector<Hint> hints_of(const Editor& editor, const Hint_options& options = {}) {
  Result<std::vector<Hint>> hints = suggest_edits(editor, options);
  INFO((hints ? "" : hints.error().message));
  REQUIRE(bool(hints));
  return std::move(*hints);
}

std::vector<Hint> of_kind(const std::vector<Hint>& hints, Hint_kind kind) {
  std::vector<Hint> some;
  std::copy_if(hints.begin(), hints.end(), std::back_inserter(some),
               [&](const Hint& h) { return h.kind == kind; });
  return some;
}

// Every hint applies, alone, to the editor that it was made for, and says numbers that get better.
void check_promises(Editor& editor, const std::vector<Hint>& hints) {
  for (const Hint& hint : hints) {
    INFO(hint.reason);
    CHECK(hint.after < hint.before);
    CHECK(hint.reason.size() > 20);
    CHECK(hint.reason.find("nan") == std::string::npos);
    const Result<Edit_report> done = editor.apply(hint.edit);
    INFO((done ? "" : done.error().message));
    REQUIRE(bool(done));
    const Stitched_mesh quads = editor.quads();
    CHECK(stages::faults(quads.mesh, editor.working_surface(), quads.valences) == "");
    editor.undo();
  }
}

// Taking all hints leaves none, and certified quads; the history is the hints.
std::vector<Hint> take_all(Editor& editor, const Hint_options& options = {}) {
  const int before = editor.position();
  Result<std::vector<Hint>> taken = apply_hints(editor, options);
  INFO((taken ? "" : taken.error().message));
  REQUIRE(bool(taken));
  CHECK(hints_of(editor, options).empty());
  REQUIRE(editor.position() == before + int(taken->size()));
  for (std::size_t i = 0; i < taken->size(); ++i)
    CHECK(to_json(editor.edits()[before + i]) == to_json((*taken)[i].edit));
  const Stitched_mesh quads = editor.quads();
  CHECK(stages::faults(quads.mesh, editor.working_surface(), quads.valences) == "");
  return std::move(*taken);
}

Editor hand_with_two_extrema() {
  return designed("hand", 6000, {extrema({0, 0, -1}, {{0, 0, 2}})}, 1500);
}

} // namespace

TEST_CASE("fingers without an extremum are uncovered limbs, and covered ones are not") {
  Editor editor = hand_with_two_extrema();
  const std::vector<Hint> limbs = of_kind(hints_of(editor), Hint_kind::uncovered_limb);
  REQUIRE(limbs.size() >= 3); // of the five fingers one has the maximum
  check_promises(editor, limbs);
  for (const Hint& hint : limbs) {
    CHECK(std::holds_alternative<Add_extremum>(hint.edit));
    CHECK(hint.after <= hint.before - 0.5);
    for (const Design_extremum& e : editor.design().extrema)
      CHECK((editor.working_surface().points[e.vertex] - hint.place).norm() > editor.design().edge_length);
  }
  CHECK(std::is_sorted(limbs.begin(), limbs.end(),
                       [](const Hint& a, const Hint& b) { return a.before > b.before; }));

  Hint_options only_limbs;
  only_limbs.thin_charts = only_limbs.sharp_edges = only_limbs.saddles = false;
  const std::size_t extrema_before = editor.design().extrema.size();
  const std::vector<Hint> taken = take_all(editor, only_limbs);
  CHECK(editor.design().extrema.size() == extrema_before + taken.size());
}

TEST_CASE("shapes that quads cover and nothing is thin on have no hints") {
  for (const std::string name : {"sphere", "ellipsoid"}) {
    INFO(name);
    Editor editor = designed(name, 3000, {extrema({0, 0, -2}, {{0, 0, 2}})}, 800);
    CHECK(hints_of(editor).empty());
    CHECK(take_all(editor).empty());
  }
}

TEST_CASE("an editor without a design has no hints, and asks for nothing") {
  const Editor editor = std::move(*Editor::create(shape("sphere", 1000)));
  CHECK(hints_of(editor).empty());
}

TEST_CASE("saddles of nearly the same value have a thin chart between them, which a hint takes away") {
  // Three maxima around a minimum: the two saddles have values as near as the mesh is regular.
  Editor editor = designed("sphere", 4000,
                           {extrema({0, 0, -1}, {{1, 0, 0.1}, {-0.5, 0.87, 0.1}, {-0.5, -0.87, 0.1}})}, 800);
  const std::vector<Hint> thin = of_kind(hints_of(editor), Hint_kind::thin_chart);
  REQUIRE(thin.size() == 1);
  check_promises(editor, thin);
  CHECK(thin[0].before > 2);
  const std::size_t charts = editor.design().charts.size();
  Hint_options only_thin;
  only_thin.limbs = only_thin.sharp_edges = only_thin.saddles = false;
  take_all(editor, only_thin);
  CHECK(editor.design().charts.size() == charts - 1);

  Hint_options strict;
  strict.thin = 0; // no chart is lower than nothing
  editor.undo();
  CHECK(of_kind(hints_of(editor, strict), Hint_kind::thin_chart).empty());
}

TEST_CASE("a contour beside the sharp edges of a cube is snapped to them, and then lies on them") {
  Editor editor = designed("cube", 3000,
                           {extrema({0.5, 0.5, 0}, {{0.5, 0.5, 1}}), Subdivide_chart{at(1, 0.5, 0.95)}}, 600);
  std::vector<Hint> snaps = of_kind(hints_of(editor), Hint_kind::sharp_edge);
  REQUIRE(!snaps.empty());
  check_promises(editor, snaps);
  CHECK(snaps[0].after < 1e-9);
  CHECK(snaps[0].before <= 1);

  Hint_options only_sharp;
  only_sharp.limbs = only_sharp.thin_charts = only_sharp.saddles = false;
  take_all(editor, only_sharp);

  SECTION("but not one in the middle between them") {
    Editor middle = designed(
        "cube", 3000, {extrema({0.5, 0.5, 0}, {{0.5, 0.5, 1}}), Subdivide_chart{at(1, 0.5, 0.5)}}, 600);
    for (const Hint& hint : of_kind(hints_of(middle), Hint_kind::sharp_edge))
      CHECK(std::abs(hint.place.z() - 0.5) > 0.3);
  }
  SECTION("nor where no edge is sharp") {
    Editor sphere =
        designed("sphere", 3000, {extrema({0, 0, -1}, {{0, 0, 1}}), Subdivide_chart{at(1, 0, 0)}}, 600);
    CHECK(of_kind(hints_of(sphere), Hint_kind::sharp_edge).empty());
  }
}

TEST_CASE("saddles with room around are to be split, once") {
  Editor editor = designed("bitorus", 4000, {extrema({-1.35, 0, 0}, {{3.35, 0, 0}})}, 1500);
  const std::vector<Hint> saddles = of_kind(hints_of(editor), Hint_kind::saddle);
  REQUIRE(saddles.size() >= 2);
  check_promises(editor, saddles);
  for (const Hint& hint : saddles) CHECK(hint.before == 4);
  const int whole = editor.quads().valences[8];
  const std::vector<Hint> taken = take_all(editor);
  CHECK(editor.quads().valences[8] == whole - int(taken.size()));

  SECTION("but not where there is none") {
    Hint_options spacious;
    spacious.room = 1000;
    Editor again = designed("bitorus", 4000, {extrema({-1.35, 0, 0}, {{3.35, 0, 0}})}, 1500);
    CHECK(of_kind(hints_of(again, spacious), Hint_kind::saddle).empty());
  }
}

TEST_CASE("the same design has the same hints on one thread and on two") {
  std::vector<std::string> texts;
  for (int threads : {1, 2}) {
    Editor_options options;
    options.quads = 1200;
    options.threads = threads;
    Result<Editor> editor = Editor::create(shape("hand", 4000), options);
    REQUIRE(bool(editor->apply(extrema({0, 0, -1}, {{0, 0, 2}}))));
    texts.push_back(to_json(hints_of(*editor)));
  }
  CHECK(texts[0] == texts[1]);
  const nlohmann::json list = nlohmann::json::parse(texts[0]);
  REQUIRE(list.is_array());
  REQUIRE(!list.empty());
  CHECK(list[0]["kind"] == "uncovered_limb");
  CHECK(bool(edit_from_json(list[0]["edit"].dump())));
}

TEST_CASE("options out of range are refused, and a preview changes nothing") {
  Editor editor = designed("bitorus", 3000, {extrema({-1.35, 0, 0}, {{3.35, 0, 0}})}, 600);
  Hint_options negative;
  negative.thin = -1;
  CHECK(suggest_edits(editor, negative).error().code == Error_code::impossible_request);
  Hint_options flat;
  flat.feature_angle = 180;
  CHECK(suggest_edits(editor, flat).error().code == Error_code::impossible_request);
  Hint_options all;
  all.persistence = 0;
  CHECK(suggest_edits(editor, all).error().code == Error_code::impossible_request);

  const Stitched_mesh before = editor.quads();
  const Result<Design> design = editor.preview(Subdivide_chart{at(1, 0.4, 0.3)});
  REQUIRE(bool(design));
  CHECK(design->charts.size() == editor.design().charts.size() + 1);
  CHECK(editor.position() == 1);
  CHECK(editor.quads().mesh.points == before.mesh.points);
  const int pole = editor.design().extrema[0].vertex;
  const Result<Design> refused =
      editor.preview(Subdivide_chart{{editor.working_surface().points[pole], pole}});
  REQUIRE(!refused);
  CHECK(refused.error().code == Error_code::refused_edit);
}

TEST_CASE("no hint costs a texture that the user has made") {
  Editor editor = hand_with_two_extrema();
  const std::vector<Hint> before = of_kind(hints_of(editor), Hint_kind::uncovered_limb);
  REQUIRE(!before.empty());
  const Surface_point tip{before[0].place, -1};
  const int id = chart_at(editor, tip).id;
  REQUIRE(bool(editor.apply(Edit_texture{Texture_operator::subdivide, {tip}, 0.5, Edit_scope::chart})));
  for (const Hint& hint : hints_of(editor)) {
    REQUIRE(bool(editor.apply(hint.edit)));
    CHECK(editor.design().index_of(id) >= 0);
    editor.undo();
  }
}

TEST_CASE("hints stop where the observer asks") {
  struct Impatient : Observer {
    bool cancelled() const override { return true; }
  } observer;
  Editor editor = hand_with_two_extrema();
  CHECK(suggest_edits(editor, {}, &observer).error().code == Error_code::cancelled);
  CHECK(editor.position() == 1);
}

TEST_CASE(
    "what finished quads lose of the shape is worth hints, each of which loses less; where nothing is lost "
    "there are none") {
  Editor editor = designed("l-shape", 3000, {Suggest{}}, 250);
  Finish_options rough;
  rough.features.feature_angle = 0; // vertices stay where they fall
  const Result<Finished_design> finished = editor.finished_quads(rough);
  REQUIRE(bool(finished));
  Hint_options options;
  options.limbs = options.thin_charts = options.sharp_edges = options.saddles = false;
  CHECK(hints_of(editor, options).empty());
  options.finished = &finished->quads.mesh;
  const std::vector<Hint> hints = hints_of(editor, options);
  REQUIRE(!hints.empty());
  for (const Hint& hint : hints) CHECK(hint.kind >= Hint_kind::lost_place);
  CHECK(!of_kind(hints, Hint_kind::lost_edge).empty());
  check_promises(editor, hints);
  for (std::size_t i = 1; i < hints.size(); ++i) // none is there twice
    CHECK((hints[i].kind != hints[i - 1].kind || hints[i].after != hints[i - 1].after ||
           hints[i].kind == Hint_kind::lost_corner));
  CHECK(to_json(hints_of(editor, options)) == to_json(hints));
  CHECK(apply_hints(editor, options)->empty());

  Editor sphere = designed("sphere", 3000, {extrema({0, 0, -1}, {{0, 0, 1}})}, 600);
  const Result<Finished_design> smooth = sphere.finished_quads();
  REQUIRE(bool(smooth));
  options.finished = &smooth->quads.mesh;
  CHECK(hints_of(sphere, options).empty());
}
