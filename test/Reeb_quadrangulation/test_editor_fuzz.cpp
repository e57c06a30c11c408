// SPDX-License-Identifier: GPL-3.0-or-later
// Random edits, undo and redo: whatever is asked, the quads are certified, and every state comes back to the
// byte.
#include "editor_sessions.h"
#include "random_edits.h"

#include <CGAL/Reeb_quadrangulation/pole_fans.h>

#include <cstdlib>
#include <iostream>
#include <map>

using namespace CGAL::Reeb_quadrangulation;
using namespace sessions;
using tiny::Random;

namespace {

// What the invariants say against the present state, or nothing.
std::string complaint(const Editor& editor) {
  const Stitched_mesh quads = with_paired_fans(editor.quads(), pole_fans(editor.design(), editor.quads()));
  std::string text = stages::faults(quads.mesh, editor.working_surface(), quads.valences, quads.components);
  for (const auto& chart : editor.design().charts)
    if (stages::folds(*chart->chart, *chart->map) > 0) text += "a chart folds; ";
  return text;
}

struct Tally {
  std::map<std::string, int> refused, applied;
  int undone = 0, redone = 0;
};

// "subdivide_chart", "edit_texture 3".
std::string kind(const Edit& edit) {
  const auto* texture = std::get_if<Edit_texture>(&edit);
  return name(edit) + (texture ? " " + std::to_string(int(texture->operation)) : "");
}

// The first sentence of a refusal.
std::string reason(const Error& error) {
  const std::string text =
      error.code == Error_code::infeasible_sampling ? "infeasible counts" : error.message;
  return text.substr(0, text.find(':'));
}

void edit_at_random(const Triangle_surface& surface, int edits, std::uint64_t seed, Tally& tally) {
  Random random(seed);
  Editor_options options;
  options.quads = 300;
  options.prepare = false;
  Result<Editor> made = Editor::create(surface, options);
  REQUIRE(bool(made));
  Editor& editor = *made;
  const Bytes empty = bytes_of(editor);
  const Result<Edit_report> first = editor.apply(Suggest{0.05, {0, 0, 1}});
  INFO("seed " << seed << (first ? "" : first.error().message));
  REQUIRE(bool(first));
  std::vector<Bytes> history{empty, bytes_of(editor)};
  for (int i = 0; i < edits; ++i) {
    const int what = random.below(10);
    if (what == 0 && editor.can_undo() && editor.position() > 1) {
      editor.undo();
      ++tally.undone;
      REQUIRE(bytes_of(editor) == history[editor.position()]);
      continue;
    }
    if (what == 1 && editor.can_redo()) {
      editor.redo();
      ++tally.redone;
      REQUIRE(bytes_of(editor) == history[editor.position()]);
      continue;
    }
    const Edit edit = random_edits::Generator(editor, random).next();
    INFO("edit " << i << " of seed " << seed << ": " << to_json(edit));
    const Result<Edit_report> done = editor.apply(edit);
    if (!done) {
      INFO(done.error().message);
      CHECK(done.error().code != Error_code::internal_error);
      ++tally.refused[reason(done.error())];
      REQUIRE(bytes_of(editor) == history[editor.position()]);
      continue;
    }
    ++tally.applied[kind(edit)];
    history.resize(editor.position());
    history.push_back(bytes_of(editor));
    REQUIRE(complaint(editor) == "");
  }
  const Result<Recipe> recipe = recipe_from_json(to_json(recipe_of(editor)));
  REQUIRE(bool(recipe));
  const Bytes last = bytes_of(editor);
  while (editor.can_undo()) editor.undo();
  CHECK(bytes_of(editor) == empty);
  Result<Editor> again = Editor::create(surface, recipe->options);
  REQUIRE(bool(again));
  for (const Edit& edit : recipe->edits) REQUIRE(bool(again->apply(edit)));
  CHECK(bytes_of(*again) == last);
}

int edits_asked() {
  const char* text = std::getenv("REEBQUAD_FUZZ_EDITS");
  return text ? std::max(1, std::atoi(text)) : 10000; // REEBQUAD_FUZZ_EDITS asks for another number
}

} // namespace

TEST_CASE("random edits of surfaces of genus 0 to 5 keep every invariant, and every state comes back") {
  Tally tally;
  const std::vector<std::string> names{"sphere",  "torus",   "bitorus", "genus-3",
                                       "genus-4", "genus-5", "l-shape", "cylinder"};
  const int runs = 5, each = std::max(1, edits_asked() / int(names.size()) / runs);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Result<Triangle_surface> surface = make_shape(names[i], 900);
    REQUIRE(bool(surface));
    for (int run = 0; run < runs; ++run) edit_at_random(*surface, each, 1000 * i + run, tally);
  }
  for (const auto& [what, number] : tally.applied) std::cout << "applied " << what << ": " << number << '\n';
  for (const auto& [what, number] : tally.refused) std::cout << "refused " << number << ": " << what << '\n';
  std::cout << "undone " << tally.undone << ", redone " << tally.redone << '\n';
  CHECK(tally.applied.size() >= 20);
  CHECK(tally.undone > 0);
  CHECK(tally.redone > 0);
}
