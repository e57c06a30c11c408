// SPDX-License-Identifier: GPL-3.0-or-later
// run --mirror: what is promised is checked on the file that is written.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace {

using Json = nlohmann::json;

struct Quads {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 4>> quads;
};

Quads read_obj(const std::string& file) {
  Quads result;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      std::array<double, 3> p{};
      for (double& x : p) {
        words >> word;
        x = std::stod(word);
      }
      result.points.push_back(p);
    } else if (word == "f") {
      std::array<int, 4> q{};
      for (int& v : q) words >> v;
      result.quads.push_back(q);
    }
  }
  return result;
}

bool is_negated(double a, double b) {
  return a == -b;
}

} // namespace

TEST_CASE("the quads of run --mirror x equal their mirror image in the file, and the report has the pairs") {
  const Temporary_folder folder;
  const std::string torus = folder.path("torus.off"), quads = folder.path("q.obj"),
                    report = folder.path("r.json"), recipe = folder.path("recipe.json"),
                    again = folder.path("again.obj"), other = folder.path("other.json");
  REQUIRE(reebquad({"shape", "torus", "-o", torus, "--triangles", "2000"}).code == 0);
  // Of the file's own middle, which lies a rounding away from 0: x = 0 as the user says it.
  const Outcome run = reebquad({"run", torus, "-o", quads, "--quads", "400", "--effort", "fast", "--mirror",
                                "0,0,0,1,0,0", "--report", report, "--write-recipe", recipe});
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.out.find("equals its mirror image in x = 0 to the bit") != std::string::npos);
  const Quads mesh = read_obj(quads);
  const Json mirror = Json::parse(contents(report))["mirror"];
  CHECK(mirror["exact"] == true);
  CHECK(mirror["plane"]["normal"] == Json({1.0, 0.0, 0.0}));
  const std::vector<int> image = mirror["image"];
  REQUIRE(image.size() == mesh.points.size());
  for (std::size_t v = 0; v < image.size(); ++v) {
    const std::array<double, 3>&p = mesh.points[v], &q = mesh.points[std::size_t(image[v])];
    CHECK((is_negated(p[0], q[0]) && p[1] == q[1] && p[2] == q[2]));
  }
  REQUIRE(reebquad({"replay", torus, recipe, "-o", again, "--report", other, "--quiet"}).code == 0);
  CHECK((contents(again) == contents(quads)));
  CHECK(Json::parse(contents(other))["mirror"] == mirror);
}

TEST_CASE("a shape that is not symmetric is refused with the deviation, and bad planes as a usage error") {
  const Temporary_folder folder;
  const std::string hand = folder.path("hand.off"), quads = folder.path("q.obj");
  REQUIRE(reebquad({"shape", "hand", "-o", hand, "--triangles", "2000"}).code == 0);
  const Outcome refused = reebquad({"run", hand, "-o", quads, "--mirror", "x"});
  CHECK(refused.code == 2);
  CHECK(refused.err.find("the surface is not symmetric") != std::string::npos);
  for (const char* plane : {"w", "1,2,3", "0,0,0,0,0,0", "0,0,0,1,0", "0,0,0,1,0,nan"})
    CHECK(reebquad({"run", hand, "-o", quads, "--mirror", plane}).code == 2);
  CHECK(reebquad({"run", hand, "-o", quads, "--mirror", "x", "--mirror-positions", "roughly"}).code == 2);
  CHECK(!std::ifstream(quads));
}
