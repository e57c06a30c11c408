// SPDX-License-Identifier: GPL-3.0-or-later
// Editing sessions in tests: what an edit must keep, whatever it is.
#ifndef REEBQUAD_TEST_EDITOR_SESSIONS_H
#define REEBQUAD_TEST_EDITOR_SESSIONS_H

#include "layout_stages.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sessions {

using namespace CGAL::Reeb_quadrangulation;

struct Bytes {
  std::vector<Point> points;
  std::vector<Quad> quads;
  bool operator==(const Bytes& o) const { return points == o.points && quads == o.quads; }
};

inline Bytes bytes_of(const Editor& editor) {
  Stitched_mesh quads = editor.quads();
  return {std::move(quads.mesh.points), std::move(quads.mesh.quads)};
}

using Charts = std::map<int, std::shared_ptr<const Design_chart>>;

inline Charts charts_of(const Editor& editor) {
  Charts charts;
  for (const auto& chart : editor.design().charts) charts[chart->id] = chart;
  return charts;
}

inline std::vector<int> contours_of(const Editor& editor) {
  std::vector<int> alive;
  const Contour_network& network = editor.design().network;
  for (std::size_t e = 0; e < network.edges.size(); ++e)
    if (!network.is_removed(network.edges[e])) alive.push_back(int(e));
  return alive;
}

inline std::vector<int> only_in(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}

inline Surface_point at(double x, double y, double z) {
  return {Point(x, y, z), -1};
}

inline std::vector<Point> points_of(const Editor& editor, int contour) {
  std::vector<Point> points;
  const Contour_network& network = editor.design().network;
  for (int v : network.edges[std::size_t(contour)].vertices)
    points.push_back(network.position(editor.working_surface(), v));
  return points;
}

inline double length(const std::vector<Point>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

inline Edit extrema(const Point& minimum, const std::vector<Point>& maxima) {
  Set_extrema edit;
  edit.extrema.push_back({{minimum, -1}, false, -1});
  for (const Point& p : maxima) edit.extrema.push_back({{p, -1}, true, -1});
  return edit;
}

inline Editor session(const Triangle_surface& surface, const Edit& first, int quads = 300) {
  Editor_options options;
  options.quads = quads;
  options.prepare = false;
  Result<Editor> editor = Editor::create(surface, options);
  REQUIRE(bool(editor));
  const Result<Edit_report> done = editor->apply(first);
  INFO((done ? "" : done.error().message));
  REQUIRE(bool(done));
  return std::move(*editor);
}

inline Triangle_surface shape(const std::string& name, int triangles) {
  Result<Triangle_surface> made = make_shape(name, triangles);
  REQUIRE(bool(made));
  return std::move(*made);
}

inline Editor sphere_session() {
  return session(shape("sphere", 1200), extrema({0, 0, -1}, {{0, 0, 1}}));
}

inline Editor torus_session() {
  return session(shape("torus", 1500), extrema({-1.4, 0, 0}, {{1.4, 0, 0}}));
}

inline std::map<int, int> valences(const Editor& editor) {
  std::map<int, int> v = editor.quads().valences;
  v.erase(4);
  return v;
}

// Exactly the changes that the report names; all else is the very same object.
inline void check_report(const Edit_report& report, const Charts& before, const Charts& after) {
  std::vector<int> fresh, gone, remeshed;
  for (const auto& [id, chart] : after) {
    const auto old = before.find(id);
    if (old == before.end()) {
      fresh.push_back(id);
      continue;
    }
    if (old->second == chart) continue;
    remeshed.push_back(id);
    CHECK(old->second->chart == chart->chart); // the same piece of the surface
  }
  for (const auto& entry : before)
    if (!after.count(entry.first)) gone.push_back(entry.first);
  CHECK(report.new_charts == fresh);
  CHECK(report.removed_charts == gone);
  CHECK(report.remeshed_charts == remeshed);
}

// An edit that applies. It leaves certified quads, says what it changed, can be undone and redone, and gives
// what the list of edits gives from scratch.
inline Edit_report applied(Editor& editor, const Edit& edit) {
  INFO(to_json(edit));
  const Charts before = charts_of(editor);
  const std::vector<int> contours = contours_of(editor);
  const Bytes old = bytes_of(editor);
  const Result<Edit_report> done = editor.apply(edit);
  INFO((done ? "" : done.error().message));
  REQUIRE(bool(done));
  const Charts after = charts_of(editor);
  check_report(*done, before, after);
  CHECK(done->new_contours == only_in(contours_of(editor), contours));
  CHECK(done->removed_contours == only_in(contours, contours_of(editor)));
  const Stitched_mesh quads = editor.quads();
  CHECK(stages::faults(quads.mesh, editor.working_surface(), quads.valences, quads.components) == "");
  for (const auto& chart : editor.design().charts) CHECK(stages::folds(*chart->chart, *chart->map) == 0);

  const Bytes fresh = bytes_of(editor);
  const Edit_report back = editor.undo();
  CHECK(charts_of(editor) == before);
  CHECK(bytes_of(editor) == old);
  CHECK(back.new_charts == done->removed_charts);
  CHECK(back.removed_charts == done->new_charts);
  editor.redo();
  CHECK(charts_of(editor) == after);
  CHECK(bytes_of(editor) == fresh);

  const Result<Recipe> recipe = recipe_from_json(to_json(recipe_of(editor)));
  REQUIRE(bool(recipe));
  Result<Editor> again = Editor::create(editor.input(), recipe->options);
  REQUIRE(bool(again));
  for (const Edit& e : recipe->edits) REQUIRE(bool(again->apply(e)));
  CHECK(bytes_of(*again) == fresh);
  return *done;
}

// An edit that does not apply: it says why, and nothing is different.
inline void refused(Editor& editor, const Edit& edit, const std::string& sentence) {
  INFO(to_json(edit));
  const Design* design = &editor.design();
  const Bytes old = bytes_of(editor);
  const std::size_t edits = editor.edits().size();
  const bool redoable = editor.can_redo();
  const Result<Edit_report> done = editor.apply(edit);
  REQUIRE(!done);
  CHECK(done.error().message == sentence);
  CHECK(
      (done.error().code == Error_code::refused_edit || done.error().code == Error_code::impossible_request));
  CHECK(&editor.design() == design);
  CHECK(bytes_of(editor) == old);
  CHECK(editor.edits().size() == edits);
  CHECK(editor.can_redo() == redoable);
}

inline const Design_chart& chart_at(const Editor& editor, const Surface_point& point) {
  return *editor.design().charts.at(std::size_t(editor.chart_at(point)));
}

} // namespace sessions

#endif // REEBQUAD_TEST_EDITOR_SESSIONS_H
