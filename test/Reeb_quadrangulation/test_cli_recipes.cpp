// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's statistics (figures 13 to 15) of our designs, as `reebquad replay` reports them: prints the
// table of textures.md.
#include "cli_process.h"
#include "model_files.h"
#include "recipe_table.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Row {
  std::string title, recipe;
  bool feature_lines;
};

const std::vector<Row> rows{{"L-shape, a cube", "l_shape_cube", false},
                            {"L-shape, a polycube", "l_shape_polycube", true},
                            {"twisted bar", "twisted_bar", false},
                            {"bitorus, whole saddles", "bitorus_whole", false},
                            {"bitorus, half-saddles", "bitorus_half", false},
                            {"Moai", "moai", false},
                            {"Bimba", "bimba", false},
                            {"Bimba, bow refined", "bimba_bow", false},
                            {"Botijo", "botijo", false},
                            {"hand", "hand", false},
                            {"blade", "blade", false},
                            {"rocker arm", "rocker_arm", false},
                            {"rocker arm, hammer by textures", "rocker_arm_hammer", false}};

// The input of a recipe: a model, or a built-in shape that is written; nothing if the model is not there.
std::optional<std::string> input_of(const recipes::Entry& entry, const Temporary_folder& folder) {
  if (!entry.model.empty()) return model_file(entry.model);
  const std::string file = folder.path(entry.input + ".obj");
  REQUIRE(reebquad({"shape", entry.input, "-o", file, "--triangles", "7000"}).code == 0);
  return file;
}

std::map<int, int> valences(const nlohmann::json& json) {
  std::map<int, int> all;
  for (const auto& [valence, number] : json.items()) all[std::stoi(valence)] = number.get<int>();
  return all;
}

std::string rounded(double x, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, x);
  return text;
}

void print(const Row& row, const nlohmann::json& report) {
  const nlohmann::json& s = report["statistics"];
  std::string kinds;
  for (const auto& [valence, number] : valences(s["interior_valences"]))
    if (valence != 4)
      kinds += (kinds.empty() ? "" : " + ") + std::to_string(number) + "x" + std::to_string(valence);
  std::cout << "| " << row.title << " | " << s["vertices"] << " | " << s["extraordinary_vertices"] << " | "
            << kinds << " | " << s["largest_valence_difference"] << " | "
            << rounded(s["angle"]["mean"].get<double>(), 1) << " | "
            << rounded(s["scaled_jacobian"]["mean"].get<double>(), 3) << " | "
            << rounded(s["scaled_jacobian"]["minimum"].get<double>(), 2) << " | " << s["inverted_quads"]
            << " | " << (report["certificate"]["passed"].get<bool>() ? "passed" : "failed") << " |\n";
}

void check_design(const Row& row, const recipes::Entry& entry, const Temporary_folder& folder) {
  INFO(row.title);
  const std::optional<std::string> input = input_of(entry, folder);
  if (!input) return;
  std::vector<std::string> arguments{"replay",
                                     *input,
                                     std::string(REEBQUAD_TEST_DIR) + "/recipes/" + row.recipe + ".json",
                                     "-o",
                                     folder.path("quads.obj"),
                                     "--report",
                                     folder.path("report.json"),
                                     "--quiet"};
  if (row.feature_lines) arguments.push_back("--feature-lines");
  const Outcome done = reebquad(arguments);
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto report = nlohmann::json::parse(contents(folder.path("report.json")));
  CHECK(recipes::extraordinary(valences(report["statistics"]["interior_valences"])) ==
        recipes::extraordinary(entry.valences));
  CHECK(recipes::extraordinary(valences(report["predicted_valences"])) ==
        recipes::extraordinary(entry.valences));
  CHECK(report["certificate"]["passed"] == true);
  CHECK(report["statistics"]["inverted_quads"] == 0);
  print(row, report);
}

// Checks the designs whose input is a real mesh, or those whose input is a built-in shape.
void check_designs(bool of_models) {
  const Temporary_folder folder;
  const std::vector<recipes::Entry> table = recipes::table();
  std::cout
      << "| design | vertices | extraordinary | of valence | \\|valence - 4\\| at most | mean angle | scaled "
         "Jacobian, mean | least | inverted | certificate |\n|--|--|--|--|--|--|--|--|--|--|\n";
  int checked = 0;
  for (const Row& row : rows) {
    const auto entry = std::find_if(table.begin(), table.end(),
                                    [&](const recipes::Entry& e) { return e.name == row.recipe; });
    REQUIRE(entry != table.end());
    if (entry->model.empty() == of_models) continue;
    check_design(row, *entry, folder);
    ++checked;
  }
  CHECK(checked > 0);
}

} // namespace

// Each has exactly the extraordinary vertices of its recipe, and no inverted quad.
TEST_CASE("the paper's designs of built-in shapes") {
  check_designs(false);
}

TEST_CASE("the paper's designs of real meshes", "[models]") {
  check_designs(true);
}
