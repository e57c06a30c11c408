// SPDX-License-Identifier: GPL-3.0-or-later
// The base complex of a design, told from its integers; and the edit that brings extraordinary vertices in
// line.
#include "editor_sessions.h"

#include "design/layout_lines.h"

#include <CGAL/Reeb_quadrangulation/base_domain.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

using namespace CGAL::Reeb_quadrangulation;
using namespace sessions;

namespace {

int patches_of_quads(const Editor& editor) {
  const auto domain = base_domain(editor.quads().mesh);
  REQUIRE(domain);
  return int(domain->patches.size());
}

int predicted(const Editor& editor) {
  std::optional<Layout_lines> lines = Layout_lines::of(editor.design());
  REQUIRE(lines);
  return lines->patches();
}

Editor suggested(const std::string& name, int quads = 500) {
  return session(shape(name, 2500), Suggest{}, quads);
}

std::vector<std::pair<std::string, Editor>> tiny_sessions() {
  std::vector<std::pair<std::string, Editor>> out;
  out.emplace_back("sphere", sphere_session());
  out.emplace_back("torus", torus_session());
  for (const char* name : {"bitorus", "genus-3"}) out.emplace_back(name, suggested(name));
  return out;
}

Surface_point inside(const Editor& editor, const Design_chart& chart) {
  Surface_point point;
  const Chart& c = *chart.chart;
  for (std::size_t f = 0; f < c.mesh.triangles.size(); ++f) {
    const Triangle& t = c.mesh.triangles[f];
    point.point = (c.mesh.points[t[0]] + c.mesh.points[t[1]] + c.mesh.points[t[2]]) / 3;
    const int found = editor.chart_at(point);
    if (found >= 0 && editor.design().charts[found]->id == chart.id) return point;
  }
  FAIL("a chart without a point of its own");
  return point;
}

// The shapes that are made here are symmetric and begin in line: their annuli are turned by one and two
// columns.
Editor out_of_line(const std::string& name) {
  Editor editor = suggested(name);
  std::vector<Surface_point> annuli;
  for (const auto& chart : editor.design().charts)
    if (chart->chart->kind == Chart_kind::annulus) annuli.push_back(inside(editor, *chart));
  for (std::size_t i = 0; i < annuli.size(); ++i) REQUIRE(editor.apply(Set_shift{annuli[i], 1 + int(i) % 2}));
  return editor;
}

Quadrangulation run_on(const Triangle_surface& surface, Effort effort, bool align, int threads = 1) {
  Quadrangulation_options options;
  options.quads = 800;
  options.effort = effort;
  options.align = align;
  options.threads = threads;
  Result<Quadrangulation> made = quadrangulate(surface, options);
  REQUIRE(bool(made));
  return std::move(*made);
}

// What a run compares, told anew from the quads: the shapes after three sweeps, and the patches.
double worth(const Quadrangulation& run) {
  const Energy_weights weights;
  const Surface_projector projector(run.editor.working_surface());
  return design_energy(run.editor.quads(), projector, Surface_samples()).total(weights) +
         weights.patches * std::log(double(patches_of_quads(run.editor)));
}

} // namespace

TEST_CASE("the patches of the base complex are told from counts, shifts and corners alone") {
  for (auto& [name, editor] : tiny_sessions()) {
    INFO(name);
    CHECK(predicted(editor) == patches_of_quads(editor));
    for (int round = 1; round <= 3; ++round) {
      std::vector<Surface_point> annuli;
      for (const auto& chart : editor.design().charts)
        if (chart->chart->kind == Chart_kind::annulus) annuli.push_back(inside(editor, *chart));
      for (std::size_t i = 0; i < annuli.size(); ++i)
        REQUIRE(editor.apply(Set_shift{annuli[i], (int(i) * 7 + round * 3) % 5 - 2}));
      CHECK(predicted(editor) == patches_of_quads(editor));
      REQUIRE(editor.apply(Set_target{300 + 200 * round, 0}));
      CHECK(predicted(editor) == patches_of_quads(editor));
    }
  }
}

TEST_CASE("a contour without saddles is no line of the base complex") {
  Editor editor = torus_session();
  for (const auto& chart : editor.design().charts)
    if (chart->chart->kind == Chart_kind::annulus) {
      REQUIRE(editor.apply(Subdivide_chart{inside(editor, *chart)}));
      break;
    }
  CHECK(predicted(editor) == patches_of_quads(editor));
}

TEST_CASE("the patches of split saddles are told too, and textures that are not regular are refused") {
  Editor editor = torus_session();
  for (const Contour_node& node : editor.design().network.nodes)
    if (node.kind == Node_kind::saddle) {
      const Surface_point at{editor.design().network.position(editor.working_surface(), node.vertex), -1};
      if (editor.apply(Split_saddle{at, Saddle_kind::quarter, {}, 0})) break;
    }
  CHECK(predicted(editor) == patches_of_quads(editor));
  Editor other = torus_session();
  REQUIRE(other.apply(Edit_texture{Texture_operator::subdivide, {inside(other, *other.design().charts[0])}}));
  const auto refused = other.apply(Align_layout{});
  REQUIRE(!refused);
  CHECK(refused.error().code == Error_code::refused_edit);
}

TEST_CASE("aligned layouts have fewer patches, and as many as was told") {
  for (auto& [name, editor] : tiny_sessions()) {
    INFO(name);
    const int before = patches_of_quads(editor);
    const std::map<int, int> valences_before = valences(editor);
    const std::int64_t quads = editor.design().counts.quads;
    Align_layout edit;
    edit.tries = 3000;
    applied(editor, edit);
    CHECK(patches_of_quads(editor) == predicted(editor));
    CHECK(patches_of_quads(editor) <= before);
    CHECK(valences(editor) == valences_before);
    CHECK(std::abs(double(editor.design().counts.quads - quads)) <= 0.05 * double(quads));
  }
}

TEST_CASE("an alignment finds the lines of a layout whose annuli were turned out of line") {
  const int in_line = patches_of_quads(suggested("genus-3"));
  Editor editor = out_of_line("genus-3");
  const int before = patches_of_quads(editor);
  REQUIRE(before > in_line);
  Align_layout edit;
  edit.tries = 3000;
  REQUIRE(editor.apply(edit));
  CHECK(patches_of_quads(editor) < before);
  CHECK(patches_of_quads(editor) == predicted(editor));
}

TEST_CASE("an alignment leaves locked charts as they are, and counts if they are not to change") {
  Editor editor = out_of_line("genus-3");
  std::vector<int> locked;
  for (std::size_t c = 0; c < editor.design().charts.size(); c += 3) {
    locked.push_back(editor.design().charts[c]->id);
    REQUIRE(editor.apply(Lock_chart{inside(editor, *editor.design().charts[c]), true}));
  }
  const Charts before = charts_of(editor);
  const std::vector<int> counts = editor.design().samples.counts;
  Align_layout edit;
  edit.tries = 2000;
  edit.counts = 1;
  REQUIRE(editor.apply(edit));
  CHECK(editor.design().samples.counts == counts);
  CHECK(charts_of(editor) != before);
  edit.counts = 1.5;
  REQUIRE(editor.apply(edit));
  Charts after = charts_of(editor);
  for (int id : locked) CHECK(after.at(id) == before.at(id));
}

TEST_CASE("a polychord through all charts closes sooner once the extraordinary vertices are in line") {
  const auto quads_of_chords = [](const Editor& editor) {
    // The mean length of the polychords, by quads: each quad is crossed by two of them.
    const Quad_mesh mesh = editor.quads().mesh;
    std::map<std::pair<int, int>, int> index;
    std::vector<int> parent;
    const auto root = [&](int i) {
      while (parent[i] != i) i = parent[i];
      return i;
    };
    const auto edge = [&](int v, int w) {
      const auto [place, added] = index.insert({std::minmax(v, w), int(parent.size())});
      if (added) parent.push_back(place->second);
      return place->second;
    };
    for (const Quad& q : mesh.quads)
      for (int i = 0; i < 2; ++i) {
        const int a = root(edge(q[i], q[i + 1])), b = root(edge(q[(i + 2) % 4], q[(i + 3) % 4]));
        parent[a] = b;
      }
    int chords = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) chords += parent[i] == int(i);
    return 2.0 * double(mesh.quads.size()) / chords;
  };
  Editor editor = out_of_line("genus-3");
  const double before = quads_of_chords(editor);
  Align_layout edit;
  edit.tries = 5000;
  REQUIRE(editor.apply(edit));
  CHECK(quads_of_chords(editor) < before);
}

TEST_CASE("an automatic run ends with an alignment, which never makes a design worth less") {
  int aligned = 0;
  for (const char* name : {"torus", "bitorus", "genus-3"}) {
    INFO(name);
    const Triangle_surface surface = shape(name, 3000);
    const Quadrangulation with = run_on(surface, Effort::fast, true);
    const Quadrangulation without = run_on(surface, Effort::fast, false);
    CHECK(without.recipe.edits.size() == 1);
    CHECK(without.base_patches[0] == 0);
    CHECK(with.base_patches[0] == patches_of_quads(without.editor));
    CHECK(with.base_patches[1] == patches_of_quads(with.editor));
    CHECK(with.base_patches[1] <= with.base_patches[0]);
    CHECK(worth(with) <= worth(without) + 1e-12);
    CHECK(with.valences == without.valences);
    const bool has_edit = std::holds_alternative<Align_layout>(with.recipe.edits.back());
    CHECK(has_edit == (with.base_patches[1] < with.base_patches[0]));
    CHECK(!with.editor.can_redo());
    aligned += has_edit;
  }
  CHECK(aligned > 0);
}

TEST_CASE("a run with an alignment has the bytes of its recipe, on any number of threads, and says what it "
          "gained") {
  const Triangle_surface surface = shape("genus-3", 3000);
  const Quadrangulation one = run_on(surface, Effort::normal, true, 1);
  const Quadrangulation two = run_on(surface, Effort::normal, true, 2);
  REQUIRE(std::holds_alternative<Align_layout>(one.recipe.edits.back()));
  REQUIRE(!one.search.empty());
  CHECK(one.search.back().reason.find("patches of the base complex from " +
                                      std::to_string(one.base_patches[0])) != std::string::npos);
  CHECK(one.mesh.points == two.mesh.points);
  Result<Editor> editor = Editor::create(surface, one.recipe.options);
  REQUIRE(bool(editor));
  for (const Edit& edit : one.recipe.edits) REQUIRE(bool(editor->apply(edit)));
  const Result<Finished_design> replayed = editor->finished_quads(one.recipe.finish);
  REQUIRE(bool(replayed));
  CHECK(replayed->quads.mesh.points == one.mesh.points);
  CHECK(replayed->quads.mesh.quads == one.mesh.quads);
}

TEST_CASE("what was undone can be forgotten") {
  Editor editor = suggested("torus");
  const Charts before = charts_of(editor);
  REQUIRE(editor.apply(Set_target{700, 0}));
  editor.undo();
  REQUIRE(editor.can_redo());
  editor.forget_undone();
  CHECK(!editor.can_redo());
  CHECK(int(editor.edits().size()) == editor.position());
  CHECK(charts_of(editor) == before);
}

TEST_CASE("an alignment demands a strength, a factor and tries that make sense") {
  Editor editor = sphere_session();
  for (const Align_layout& edit : {Align_layout{0, 1.25, 100}, Align_layout{2, 1.25, 100},
                                   Align_layout{0.01, 0.5, 100}, Align_layout{0.01, 1.25, 0}}) {
    const auto refused = editor.apply(edit);
    REQUIRE(!refused);
    CHECK(refused.error().code == Error_code::impossible_request);
  }
}
