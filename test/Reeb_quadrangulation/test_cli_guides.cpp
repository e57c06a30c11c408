// SPDX-License-Identifier: GPL-3.0-or-later
// Guides on the command line: where they are read from, and what is told of them.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <vector>

namespace {

using Json = nlohmann::json;

// A torus whose tube goes around the axis z.
std::string torus(const Temporary_folder& folder) {
  const std::string file = folder.path("torus.off");
  REQUIRE(reebquad({"shape", "torus", "-o", file, "--triangles", "1500"}).code == 0);
  return file;
}

// Along the tube, on its outside and upwards.
std::vector<std::vector<double>> stroke() {
  std::vector<std::vector<double>> points;
  for (int i = 0; i < 20; ++i) {
    const double a = 0.8 + 0.08 * i, b = 0.2 + 0.025 * i, r = 1 + 0.4 * std::cos(b);
    points.push_back({r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)});
  }
  return points;
}

std::string written(const Temporary_folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder.path(name)) << text;
  return folder.path(name);
}

std::vector<std::string> run_of(const Temporary_folder& folder, const std::string& input,
                                const std::string& guides) {
  return {"run",
          input,
          "-o",
          folder.path("q.obj"),
          "--force",
          "--quads",
          "400",
          "--effort",
          "fast",
          "--report",
          folder.path("report.json"),
          "--guides",
          guides,
          "--min",
          "-1.4,0,0",
          "--max",
          "1.4,0,0",
          "--write-recipe",
          folder.path("r.json")};
}

} // namespace

TEST_CASE("guides are read from JSON and from the lines of an OBJ file, and replay gives the bytes of run") {
  const Temporary_folder folder;
  const std::string input = torus(folder);
  std::string lines;
  for (const auto& p : stroke())
    lines += "v " + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
  lines += 'l';
  for (std::size_t i = 1; i <= stroke().size(); ++i) lines += ' ' + std::to_string(i);
  const Json json = {{"guides", {{{"points", stroke()}, {"strength", 1}, {"way", "flow"}}}}};
  for (const std::string& file :
       {written(folder, "guides.json", json.dump()), written(folder, "guides.obj", lines + '\n')}) {
    const Outcome run = reebquad(run_of(folder, input, file));
    INFO(run.err);
    REQUIRE(run.code == 0);
    CHECK(run.out.find("guide 1: edges of quads make an angle of ") != std::string::npos);
    const Json guides = Json::parse(contents(folder.path("report.json")))["components"][0]["guides"];
    REQUIRE(guides.size() == 1);
    CHECK(guides[0]["kept"] == true);
    CHECK(guides[0]["angle"] < 5);
    CHECK(guides[0]["on"] > 0.9);
    const std::string quads = contents(folder.path("q.obj"));
    const Outcome again = reebquad({"replay", input, folder.path("r.json"), "-o", folder.path("again.obj"),
                                    "--report", folder.path("again.json")});
    INFO(again.err);
    REQUIRE(again.code == 0);
    CHECK(contents(folder.path("again.obj")) == quads);
    CHECK(Json::parse(contents(folder.path("again.json")))["guides"] == guides);
  }
}

TEST_CASE("guides that cannot be are refused with a sentence, and short ones are warned of") {
  const Temporary_folder folder;
  const std::string input = torus(folder);
  const auto error_of = [&](const std::string& text, int code) {
    const Outcome run = reebquad(run_of(folder, input, written(folder, "guides.txt", text)));
    CHECK(run.code == code);
    return run.err;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
  };
  const Json far = {{"guides", {{{"points", {{1.4, 0, 0}, {1.2, 1.2, 0}}}}}}};
  CHECK(has(error_of(far.dump(), 2), "point 1 of the guide lies off the surface by"));
  CHECK(has(error_of(R"({"guides": [{"vertices": [0, 100000]}]})", 3), "guide 1: there is no point 100000"));
  CHECK(has(error_of(R"({"guides": [{"points": [[0, 0, null]]}]})", 3), "is not a finite number"));
  CHECK(has(error_of(R"({"guides": [{"points": [], "strenght": 1}]})", 3), "unknown field \"strenght\""));
  CHECK(has(error_of(R"({"guides": []})", 3), "it has no guides"));
  CHECK(has(error_of("{", 3), "it is not JSON with a list \"guides\" alone"));
  CHECK(has(error_of("v 0 0 0\nl 1 2\n", 3), "line 2: there is no such point before"));
  const std::vector<std::vector<double>> points = stroke();
  const Json tiny = {{"guides", {{{"points", {points[9], points[10]}}}}}};
  CHECK(has(error_of(tiny.dump(), 0), "edges of quads long: it hardly matters"));
}
