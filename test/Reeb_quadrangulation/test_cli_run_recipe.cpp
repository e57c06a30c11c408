// SPDX-License-Identifier: GPL-3.0-or-later
// One engine: `run` makes the bytes that `replay` makes of the recipe it writes.
#include "cli_process.h"
#include "model_files.h"

#include <fstream>

namespace {

void check_same_bytes(const std::string& input, const std::vector<std::string>& options) {
  const Temporary_folder folder;
  const std::string run_quads = folder.path("run.obj"), recipe = folder.path("recipe.json"),
                    replayed = folder.path("replay.obj");
  std::vector<std::string> arguments{"run", input, "-o", run_quads, "--write-recipe", recipe, "--quiet"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  Limits limits;
  limits.seconds = 600; // real meshes on a busy machine
  const Outcome run = reebquad(arguments, limits);
  INFO(input << ": " << run.err);
  REQUIRE(run.code == 0);
  const Outcome replay = reebquad({"replay", input, recipe, "-o", replayed, "--quiet"}, limits);
  INFO(replay.err);
  REQUIRE(replay.code == 0);
  CHECK((contents(run_quads) == contents(replayed)));
  CHECK(contents(run_quads).size() > 1000);
}

} // namespace

TEST_CASE("run equals replay of its recipe, byte for byte, whatever the options") {
  const Temporary_folder folder;
  const auto shape = [&](const std::string& name, const std::string& triangles) {
    const std::string file = folder.path(name + ".off");
    REQUIRE(reebquad({"shape", name, "-o", file, "--triangles", triangles}).code == 0);
    return file;
  };
  const std::string hand = shape("hand", "4000"), bar = shape("l-shape", "3000"),
                    torus = shape("torus", "2000");
  check_same_bytes(hand, {"--quads", "800"});
  check_same_bytes(hand, {"--quads", "800", "--effort", "fast", "--adaptive", "2"});
  check_same_bytes(bar, {"--quads", "700", "--effort", "fast", "--feature-lines", "--field", "clamped"});
  const std::string marks = folder.path("marks.obj");
  std::ofstream(marks) << "v 0 0 1\nv 1 0 1\nv 1 1 1\nl 1 2 3\n";
  check_same_bytes(bar, {"--quads", "700", "--effort", "fast", "--marks", marks, "--feature-angle", "0"});
  check_same_bytes(torus, {"--edge-length", "0.1", "--no-relax", "--no-collapse"});
  check_same_bytes(torus, {"--quads", "500", "--mirror", "auto", "--effort", "fast"});
  check_same_bytes(torus,
                   {"--quads", "500", "--min", "-1.4,0,0", "--max", "1.4,0,0", "--feature-angle", "0"});
}

TEST_CASE("a recipe of a file with several components is for one of them") {
  const Temporary_folder folder;
  const std::string two = folder.path("two.off"), recipe = folder.path("recipe.json"),
                    quads = folder.path("q.obj");
  std::ofstream(two) << "OFF\n8 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 0 0\n6 0 0\n5 1 0\n5 0 1\n"
                        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 4 6 5\n3 4 5 7\n3 5 6 7\n3 4 7 6\n";
  const Outcome refused = reebquad({"run", two, "-o", quads, "--quads", "200", "--write-recipe", recipe});
  CHECK(refused.code == 2);
  CHECK(refused.err.find("--component") != std::string::npos);
  check_same_bytes(two, {"--quads", "200", "--component", "2"});
  CHECK(reebquad({"run", two, "-o", quads, "--component", "3"}).code == 4);
}

TEST_CASE("run equals replay of its recipe on ten real meshes", "[models]") {
  for (const char* file :
       {"bunny_low.off", "camelhead.off", "casting.off", "cube_twist.obj", "eight_low.off", "elk.off",
        "punctured_torus.obj", "rocker_arm_2500.obj", "spot_6k.obj", "wingnut.obj"}) {
    const std::optional<std::string> path = model_file(file);
    if (!path) continue;
    check_same_bytes(*path, {"--quads", "1500", "--threads", "2"});
  }
}
