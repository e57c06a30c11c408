// SPDX-License-Identifier: GPL-3.0-or-later
// `reebquad replay` says what it makes where a design asks for triangles.
#include "cli_process.h"

#include <nlohmann/json.hpp>

using Json = nlohmann::json;

namespace {

// The corners of each face of an OBJ file.
std::vector<int> face_sizes(const std::string& obj) {
  std::vector<int> sizes;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("f ", 0) != 0) continue;
    std::istringstream words(line.substr(2));
    int corners = 0;
    for (std::string word; words >> word;) ++corners;
    sizes.push_back(corners);
  }
  return sizes;
}

Json replayed(const std::string& last_edit, std::string& out, std::vector<int>& sizes) {
  const Temporary_folder folder;
  const std::string sphere = folder.path("sphere.obj"), recipe = folder.path("r.json"),
                    quads = folder.path("q.obj"), report = folder.path("report.json");
  REQUIRE(reebquad({"shape", "sphere", "-o", sphere, "--triangles", "1200"}).code == 0);
  std::ofstream(recipe)
      << R"({"format": "reebquad recipe", "version": 1, "options": {"quads": 300}, "edits": [
    {"edit": "set_extrema", "extrema": [{"at": {"point": [0, 0, -1]}, "maximum": false},
                                        {"at": {"point": [0, 0, 1]}, "maximum": true}]}, )"
      << last_edit << "]}";
  const Outcome outcome = reebquad({"replay", sphere, recipe, "-o", quads, "--report", report});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  out = outcome.out;
  sizes = face_sizes(contents(quads));
  return Json::parse(contents(report));
}

} // namespace

TEST_CASE("a whole pole is written as triangles, certified, and said not to be all-quad") {
  std::string out;
  std::vector<int> sizes;
  const Json report =
      replayed(R"({"edit": "split_pole", "at": {"point": [0, 0, 1]}, "kind": "whole"})", out, sizes);
  CHECK(report["all_quad"] == false);
  REQUIRE(report["fans"].size() == 1);
  const int triangles = int(std::count(sizes.begin(), sizes.end(), 3));
  CHECK(triangles == report["fans"][0]["triangles"]);
  CHECK(triangles >= 4);
  CHECK(report["certificate"]["passed"] == true);
  CHECK(out.find("not all-quad: " + std::to_string(triangles) +
                 " triangles in fans at 1 whole pole, asked for by the design") != std::string::npos);
}

TEST_CASE("without one, all faces are quads, and the report says so") {
  std::string out;
  std::vector<int> sizes;
  const Json report =
      replayed(R"({"edit": "split_pole", "at": {"point": [0, 0, 1]}, "kind": "half"})", out, sizes);
  CHECK(report["all_quad"] == true);
  CHECK(report["fans"].empty());
  CHECK(std::count(sizes.begin(), sizes.end(), 4) == int(sizes.size()));
  CHECK(out.find("not all-quad") == std::string::npos);
}
