// SPDX-License-Identifier: GPL-3.0-or-later
// The designs of the paper on real meshes, where their folder is there.
#include "recipe_table.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <catch2/catch.hpp>

#include <filesystem>

using namespace CGAL::Reeb_quadrangulation;

TEST_CASE(
    "a recipe for a real mesh gives certified quads with exactly the extraordinary vertices that it is for") {
  for (const recipes::Entry& entry : recipes::table()) {
    const std::filesystem::path file = std::filesystem::path(REEBQUAD_MODELS_DIR) / entry.model;
    if (entry.model.empty()) continue;
    if (!std::filesystem::exists(file)) {
      WARN(entry.model << " is not there: skipped");
      continue;
    }
    const Result<Polygon_soup> soup = read_polygon_soup(file.string());
    REQUIRE(bool(soup));
    const Result<Mended_surface> mended = mend_surface(*soup);
    REQUIRE(bool(mended));
    REQUIRE(mended->components.size() == 1);
    recipes::check(entry, mended->components[0].surface);
  }
}
