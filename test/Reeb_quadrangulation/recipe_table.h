// SPDX-License-Identifier: GPL-3.0-or-later
// The recipes of the folder recipes/, what each of them is for and which extraordinary vertices it must give.
#ifndef REEBQUAD_TEST_RECIPE_TABLE_H
#define REEBQUAD_TEST_RECIPE_TABLE_H

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>

#include "editor_sessions.h"
#include "tiny_surfaces.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace recipes {

using namespace CGAL::Reeb_quadrangulation;
using sessions::Bytes;
using sessions::bytes_of;

struct Entry {
  std::string name;
  std::string input; ///< a surface of the tests, or empty
  std::string model; ///< a file of the folder of real meshes, or empty
  std::map<int, int> valences;
  std::vector<Point> corners; ///< where the recipe puts a vertex
};

inline std::string text_of(const std::string& file) {
  std::ifstream stream(std::string(REEBQUAD_TEST_DIR) + "/recipes/" + file);
  INFO(file);
  REQUIRE(stream.good());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline std::vector<Entry> table() {
  std::vector<Entry> entries;
  const nlohmann::json all = nlohmann::json::parse(text_of("expected.json"));
  for (const auto& [name, entry] : all.items()) {
    Entry e{name, entry.value("input", ""), entry.value("model", ""), {}, {}};
    for (const auto& [valence, number] : entry["valences"].items())
      e.valences[std::stoi(valence)] = number.get<int>();
    for (const auto& p : entry.value("corners", nlohmann::json::array()))
      e.corners.emplace_back(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
    entries.push_back(std::move(e));
  }
  return entries;
}

inline Recipe recipe(const std::string& name) {
  Result<Recipe> read = recipe_from_json(text_of(name + ".json"));
  INFO(name << (read ? "" : read.error().message));
  REQUIRE(bool(read));
  return std::move(*read);
}

/// "3: 8, 8: 2"; valence 4 is left out.
inline std::string extraordinary(const std::map<int, int>& valences) {
  std::string text;
  for (const auto& [valence, number] : valences)
    if (valence != 4)
      text += (text.empty() ? "" : ", ") + std::to_string(valence) + ": " + std::to_string(number);
  return text;
}

/// The error of the first edit that does not apply, with its name, or nothing.
inline std::string replay(Editor& editor, const std::vector<Edit>& edits) {
  for (std::size_t i = 0; i < edits.size(); ++i)
    if (const Result<Edit_report> done = editor.apply(edits[i]); !done)
      return "edit " + std::to_string(i + 1) + " (" + name(edits[i]) + "): " + done.error().message;
  return {};
}

/// Whether every corner of an entry is a vertex, but for a fraction of the surface's size.
inline bool has_corners(const Quad_mesh& mesh, const Entry& entry, const Triangle_surface& surface) {
  double size = 0;
  for (const Point& p : surface.points) size = std::max(size, (p - surface.points[0]).norm());
  return std::all_of(entry.corners.begin(), entry.corners.end(), [&](const Point& corner) {
    return std::any_of(mesh.points.begin(), mesh.points.end(),
                       [&](const Point& p) { return (p - corner).norm() < 1e-6 * size; });
  });
}

/// Replays a recipe on a surface: the quads are certified, with exactly the valences of the table, and every
/// state comes back to the byte by undo and redo.
inline void check(const Entry& entry, const Triangle_surface& surface) {
  INFO(entry.name << " on " << surface.number_of_faces() << " triangles");
  const Recipe recipe = recipes::recipe(entry.name);
  Result<Editor> made = Editor::create(surface, recipe.options);
  REQUIRE(bool(made));
  Editor& editor = *made;
  std::vector<Bytes> states{bytes_of(editor)};
  for (const Edit& edit : recipe.edits) {
    REQUIRE(replay(editor, {edit}) == "");
    states.push_back(bytes_of(editor));
  }
  const Stitched_mesh quads = editor.quads();
  const Certificate certificate = certify({quads.mesh, &surface, quads.valences, quads.components});
  CHECK(certificate.passed);
  CHECK(extraordinary(certificate.interior_valences) == extraordinary(entry.valences));
  CHECK(has_corners(quads.mesh, entry, surface));
  const Result<Finished_design> finished = editor.finished_quads();
  REQUIRE(bool(finished));
  const Certificate relaxed =
      certify({finished->quads.mesh, &surface, finished->quads.valences, finished->quads.components});
  CHECK(relaxed.passed);
  CHECK(relaxed.inverted_quads.empty());
  CHECK(has_corners(finished->quads.mesh, entry, surface));
  while (editor.can_undo()) {
    editor.undo();
    REQUIRE(bytes_of(editor) == states[editor.position()]);
  }
  CHECK(editor.position() == 0);
  while (editor.can_redo()) {
    editor.redo();
    REQUIRE(bytes_of(editor) == states[editor.position()]);
  }
  CHECK(editor.position() == int(recipe.edits.size()));
}

} // namespace recipes

#endif // REEBQUAD_TEST_RECIPE_TABLE_H
