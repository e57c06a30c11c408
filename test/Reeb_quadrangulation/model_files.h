// SPDX-License-Identifier: GPL-3.0-or-later
// Real meshes, which are no part of the project: tests that need them are skipped, loudly, where their folder
// is missing.
#ifndef REEBQUAD_TEST_MODEL_FILES_H
#define REEBQUAD_TEST_MODEL_FILES_H

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <catch2/catch.hpp>

#include <optional>
#include <string>

/// The path of a file in the folder of real meshes (REEBQUAD_MODELS_DIR). Where it is missing, says so and
/// has the program end as skipped, which ctest and ./check count. Only for test cases with the tag [models],
/// which ctest runs by themselves: a case without it fails here.
std::optional<std::string> model_file(const std::string& name);

/// The largest component of a mesh in that folder, mended, or nothing where it is missing.
inline std::optional<CGAL::Reeb_quadrangulation::Triangle_surface> model(const std::string& name) {
  const std::optional<std::string> file = model_file(name);
  if (!file) return std::nullopt;
  const auto soup = CGAL::Reeb_quadrangulation::read_polygon_soup(*file);
  REQUIRE(bool(soup));
  auto mended = CGAL::Reeb_quadrangulation::mend_surface(*soup);
  REQUIRE(bool(mended));
  return std::move(mended->components.front().surface);
}

#endif // REEBQUAD_TEST_MODEL_FILES_H
