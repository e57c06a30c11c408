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

TEST_CASE("of a file with several parts, the recipe or --component says which is designed") {
  const Temporary_folder folder;
  const std::string sphere = folder.path("sphere.obj"), parts = folder.path("parts.obj"),
                    out = folder.path("q.obj");
  REQUIRE(reebquad({"shape", "sphere", "-o", sphere, "--triangles", "800"}).code == 0);
  // A tetrahedron far away stands before the sphere.
  const std::string text = contents(sphere);
  std::string moved = "v 9 0 0\nv 10 0 0\nv 9 1 0\nv 9 0 1\n";
  std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("v ", 0) == 0) moved += line + "\n";
    if (line.rfind("f ", 0) != 0) continue;
    std::istringstream words(line.substr(2));
    faces += "f";
    for (int v; words >> v;) faces += " " + std::to_string(v + 4);
    faces += "\n";
  }
  std::ofstream(parts) << moved << faces;
  const auto recipe = [&](const std::string& component) {
    const std::string file = folder.path("r" + std::to_string(component.size()) + ".json");
    std::ofstream(file) << R"({"format": "reebquad recipe", "version": 1, )" << component
                        << R"("options": {"quads": 300}, "edits": [{"edit": "suggest"}]})";
    return file;
  };
  REQUIRE(reebquad({"replay", sphere, recipe(""), "-o", out}).code == 0);
  const std::string alone = contents(out);
  const Outcome unsaid = reebquad({"replay", parts, recipe(""), "-o", out});
  CHECK(unsaid.code != 0);
  CHECK(unsaid.err.find("this file has 2") != std::string::npos);
  for (const bool in_recipe : {true, false}) {
    std::filesystem::remove(out);
    const Outcome second =
        in_recipe
            ? reebquad({"replay", parts, recipe(R"("component": 2, )"), "-o", out})
            : reebquad({"replay", parts, recipe(R"("component": 1,  )"), "-o", out, "--component", "2"});
    INFO(second.err);
    REQUIRE(second.code == 0);
    CHECK(contents(out) == alone);
  }
  CHECK(reebquad({"replay", parts, recipe(""), "-o", out, "--component", "3"}).code != 0);
  CHECK(reebquad({"replay", parts, recipe(""), "-o", out, "--component", "0"}).code != 0);
  CHECK(reebquad({"replay", parts, recipe(R"("component": 0,   )"), "-o", out}).code != 0);
}

TEST_CASE("a run with filled boundaries, or with values of its loops, is replayed to the byte") {
  const Temporary_folder folder;
  const std::string cylinder = folder.path("c.obj"), recipe = folder.path("r.json"),
                    quads = folder.path("q.obj"), again = folder.path("a.obj");
  REQUIRE(reebquad({"shape", "cylinder", "-o", cylinder, "--triangles", "1500"}).code == 0);
  const std::vector<std::string> run{"run",     cylinder, "-o",       quads,  "--write-recipe", recipe,
                                     "--quads", "300",    "--effort", "fast", "--quiet"};
  const std::vector<std::vector<std::string>> ways{
      {"--boundaries", "fill", "--threads", "1"},
      {"--boundary-value", "0,0,0=max", "--boundary-value", "0,0,3=max:0.9", "--min", "1,0,1.5"}};
  for (const std::vector<std::string>& way : ways) {
    std::vector<std::string> arguments = run;
    arguments.insert(arguments.end(), way.begin(), way.end());
    const Outcome made = reebquad(arguments);
    INFO(made.err);
    REQUIRE(made.code == 0);
    REQUIRE(reebquad({"replay", cylinder, recipe, "-o", again, "--quiet", "--threads", "2"}).code == 0);
    CHECK(contents(again) == contents(quads));
  }
  const Outcome other =
      reebquad({"replay", cylinder, recipe, "-o", again, "--quiet", "--boundaries", "some"});
  CHECK(other.code == 2);
  CHECK(other.err.find("--boundaries is keep or fill") != std::string::npos);
  for (const char* wrong : {"0,0,0", "0,0,0=up", "0,0,0=max:2", "0,0=max"}) {
    std::vector<std::string> arguments = run;
    arguments.insert(arguments.end(), {"--boundary-value", wrong});
    CHECK(reebquad(arguments).code == 2);
  }
}

TEST_CASE(
    "an edit that is refused is named with its reason and with one that works, which does in its place") {
  const Temporary_folder folder;
  const std::string sphere = folder.path("sphere.obj"), file = folder.path("r.json"),
                    out = folder.path("q.obj");
  REQUIRE(reebquad({"shape", "sphere", "-o", sphere, "--triangles", "1200"}).code == 0);
  Json recipe =
      Json::parse(R"({"format": "reebquad recipe", "version": 1, "options": {"quads": 300}, "edits": [
    {"edit": "set_extrema", "extrema": [{"at": {"point": [0, 0, -1]}, "maximum": false},
                                        {"at": {"point": [0, 0, 1]}, "maximum": true}]},
    {"edit": "subdivide_chart", "at": {"point": [1, 0, 0]}},
    {"edit": "move_contour", "at": {"point": [1, 0, 0]}, "plane_point": [0, 0, 1.5],
     "plane_normal": [0, 0, 1]}]})");
  std::ofstream(file) << recipe;
  const Outcome refused = reebquad({"replay", sphere, file, "-o", out});
  CHECK(refused.code != 0);
  CHECK(!std::filesystem::exists(out));
  INFO(refused.err);
  CHECK(refused.err.find("edit 3 (move_contour) does not apply") != std::string::npos);
  const std::size_t words = refused.err.find("; what works: Move it "), edit = refused.err.find(", {", words);
  REQUIRE(words != std::string::npos);
  REQUIRE(edit != std::string::npos);
  recipe["edits"][2] = Json::parse(refused.err.substr(edit + 2));
  std::ofstream(file) << recipe;
  const Outcome done = reebquad({"replay", sphere, file, "-o", out});
  INFO(done.err);
  CHECK(done.code == 0);
}
