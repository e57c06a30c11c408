// SPDX-License-Identifier: GPL-3.0-or-later
// The designs of the paper on real meshes, where their folder is there.
#include "model_files.h"
#include "recipe_table.h"

#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include <catch2/catch.hpp>

#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

namespace {

Stitched_mesh finished(const Triangle_surface& surface, const Recipe& recipe) {
  Result<Editor> editor = Editor::create(surface, recipe.options);
  REQUIRE(bool(editor));
  REQUIRE(recipes::replay(*editor, recipe.edits) == "");
  Result<Finished_design> quads = editor->finished_quads();
  REQUIRE(bool(quads));
  return std::move(quads->quads);
}

} // namespace

TEST_CASE(
    "a recipe for a real mesh gives certified quads with exactly the extraordinary vertices that it is for",
    "[models]") {
  for (const recipes::Entry& entry : recipes::table())
    if (const auto surface = entry.model.empty() ? std::nullopt : model(entry.model))
      recipes::check(entry, *surface);
}

TEST_CASE("the rocker arm's hammer has its corners by cube subdivision, and has not by contours alone",
          "[models]") {
  const std::optional<Triangle_surface> found = model("rocker_arm.obj");
  if (!found) return;
  const Triangle_surface& surface = *found;
  Recipe recipe = recipes::recipe("rocker_arm_hammer"), contours = recipe;
  const Stitched_mesh quads = finished(surface, recipe);
  // The same atlas, filled regularly with as many quads.
  const auto is_of_textures = [](const Edit& e) {
    return std::holds_alternative<Edit_texture>(e) || std::holds_alternative<Drag_vertices>(e);
  };
  contours.edits.erase(std::find_if(contours.edits.begin(), contours.edits.end(), is_of_textures),
                       contours.edits.end());
  contours.edits.push_back(Set_target{int(quads.mesh.quads.size()), 0});
  const Stitched_mesh regular = finished(surface, contours);
  CHECK(std::abs(double(regular.mesh.quads.size()) / double(quads.mesh.quads.size()) - 1) < 0.05);
  for (const recipes::Entry& entry : recipes::table())
    if (entry.name == "rocker_arm_hammer") {
      CHECK(recipes::has_corners(quads.mesh, entry, surface));
      CHECK(!recipes::has_corners(regular.mesh, entry, surface));
    }
  const Mesh_statistics ours = quad_statistics(quads.mesh, &surface),
                        theirs = quad_statistics(regular.mesh, &surface);
  CHECK(ours.inverted_quads == 0);
  CHECK(*ours.undersampled_area < *theirs.undersampled_area);
  std::cout << "scaled Jacobian: connectivity textures " << ours.scaled_jacobian.mean << ", contours "
            << theirs.scaled_jacobian.mean << '\n';
  for (std::size_t i = 10; i < 20; ++i)
    std::cout << "  from " << double(i) / 10 - 1 << ": " << ours.scaled_jacobian_histogram[i] << ", "
              << theirs.scaled_jacobian_histogram[i] << '\n';
}

TEST_CASE("bimba's bow is denser than the rest, whose textures stay as they were", "[models]") {
  const std::optional<Triangle_surface> found = model("bimba.obj");
  if (!found) return;
  const Triangle_surface& surface = *found;
  const Recipe recipe = recipes::recipe("bimba_bow");
  Result<Editor> editor = Editor::create(surface, recipe.options);
  REQUIRE(bool(editor));
  int refined = 0;
  for (const Edit& edit : recipe.edits) {
    const sessions::Charts before = sessions::charts_of(*editor);
    const Result<Edit_report> done = editor->apply(edit);
    REQUIRE(bool(done));
    if (!std::holds_alternative<Edit_texture>(edit)) continue;
    ++refined;
    REQUIRE(done->remeshed_charts.size() == 1);
    for (const auto& [id, chart] : sessions::charts_of(*editor))
      CHECK((chart == before.at(id)) == (id != done->remeshed_charts[0]));
    CHECK(editor->quads().t_junctions > 0);
  }
  CHECK(refined == 2);
}
