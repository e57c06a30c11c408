// SPDX-License-Identifier: GPL-3.0-or-later
// The designs of the paper, replayed on built-in shapes: each has exactly the extraordinary vertices that it
// is for.
#include "recipe_table.h"

#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <catch2/catch.hpp>

#include <filesystem>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// The unit sphere by meridians and parallels, the same after a sixth of a turn: the field of three maxima
// that lie so has a monkey saddle at the north pole.
Triangle_surface globe(int meridians, int parallels) {
  Triangle_surface s;
  for (int i = 1; i < parallels; ++i)
    for (int j = 0; j < meridians; ++j) {
      const double latitude = M_PI * (0.5 - double(i) / parallels), longitude = 2 * M_PI * j / meridians;
      s.points.emplace_back(std::cos(latitude) * std::cos(longitude),
                            std::cos(latitude) * std::sin(longitude), std::sin(latitude));
    }
  const int north = int(s.points.size()), south = north + 1;
  s.points.emplace_back(0, 0, 1);
  s.points.emplace_back(0, 0, -1);
  for (int j = 0; j < meridians; ++j) {
    const int k = (j + 1) % meridians, last = (parallels - 2) * meridians;
    s.triangles.push_back({north, j, k});
    s.triangles.push_back({south, last + k, last + j});
    for (int i = 0; i < last; i += meridians) {
      s.triangles.push_back({i + j, i + meridians + j, i + meridians + k});
      s.triangles.push_back({i + j, i + meridians + k, i + k});
    }
  }
  return tiny::connected(std::move(s));
}

// The built-in hand without what is below its wrist.
Triangle_surface open_hand(int triangles) {
  const Result<Triangle_surface> hand = make_shape("hand", triangles);
  REQUIRE(bool(hand));
  Triangle_surface open;
  std::vector<int> renamed(hand->points.size(), -1);
  for (const Triangle& t : hand->triangles) {
    if (hand->points[t[0]].z() < -0.8 || hand->points[t[1]].z() < -0.8 || hand->points[t[2]].z() < -0.8)
      continue;
    Triangle kept{};
    for (int i = 0; i < 3; ++i) {
      if (renamed[t[i]] < 0) {
        renamed[t[i]] = int(open.points.size());
        open.points.push_back(hand->points[t[i]]);
      }
      kept[i] = renamed[t[i]];
    }
    open.triangles.push_back(kept);
  }
  return tiny::connected(std::move(open));
}

Triangle_surface surface_of(const recipes::Entry& entry, int triangles) {
  if (entry.input == "globe") return triangles < 5000 ? globe(24, 40) : globe(36, 60);
  if (entry.input == "open hand") return open_hand(triangles);
  Result<Triangle_surface> made = make_shape(entry.input, triangles);
  INFO(entry.input);
  REQUIRE(bool(made));
  return std::move(*made);
}

} // namespace

TEST_CASE("every recipe is in the table, and every entry of the table has a recipe") {
  std::vector<std::string> files, names{"expected"};
  for (const auto& file : std::filesystem::directory_iterator(std::string(REEBQUAD_TEST_DIR) + "/recipes"))
    files.push_back(file.path().stem().string());
  for (const recipes::Entry& entry : recipes::table()) {
    names.push_back(entry.name);
    CHECK(entry.input.empty() != entry.model.empty());
  }
  std::sort(files.begin(), files.end());
  std::sort(names.begin(), names.end());
  CHECK(files == names);
}

TEST_CASE("a recipe gives certified quads with exactly the extraordinary vertices that it is for") {
  for (const recipes::Entry& entry : recipes::table())
    if (!entry.input.empty()) recipes::check(entry, surface_of(entry, 4000));
}

TEST_CASE("a recipe made on one triangulation runs on a denser one with the same extraordinary vertices",
          "[slow]") {
  for (const recipes::Entry& entry : recipes::table()) {
    if (entry.input.empty()) continue;
    const Triangle_surface denser = surface_of(entry, 7000);
    const Recipe recipe = recipes::recipe(entry.name);
    INFO(entry.name << " on " << denser.number_of_faces() << " triangles");
    Result<Editor> editor = Editor::create(denser, recipe.options);
    REQUIRE(bool(editor));
    REQUIRE(recipes::replay(*editor, recipe.edits) == "");
    const Stitched_mesh quads = editor->quads();
    const Certificate certificate = certify({quads.mesh, &denser, quads.valences});
    CHECK(certificate.passed);
    CHECK(recipes::extraordinary(certificate.interior_valences) == recipes::extraordinary(entry.valences));
  }
}

TEST_CASE("on another shape a recipe says which edit no longer applies") {
  const Recipe recipe = recipes::recipe("torus_regular");
  const Result<Triangle_surface> sphere = make_shape("sphere", 1000);
  REQUIRE(bool(sphere));
  Result<Editor> editor = Editor::create(*sphere, recipe.options);
  REQUIRE(bool(editor));
  CHECK(recipes::replay(*editor, recipe.edits) == "edit 2 (split_saddle): there is no saddle");
  CHECK(editor->position() == 1);
}
