// SPDX-License-Identifier: GPL-3.0-or-later
// `reebquad suggest` lists hints, takes them, and writes a recipe that `replay` runs.
#include "cli_process.h"

#include <nlohmann/json.hpp>

using Json = nlohmann::json;

namespace {

const char* const two_extrema = R"({"format": "reebquad recipe", "version": 1, "options": {"quads": 1200},
  "edits": [{"edit": "set_extrema", "extrema": [{"at": {"point": [0, 0, -1]}, "maximum": false},
                                                {"at": {"point": [0, 0, 2]}, "maximum": true}]}]})";

struct Hand {
  Hand() : file(folder.path("hand.obj")), recipe(folder.path("two.json")), longer(folder.path("all.json")) {
    REQUIRE(reebquad({"shape", "hand", "-o", file, "--triangles", "4000"}).code == 0);
    std::ofstream(recipe) << two_extrema;
  }
  Temporary_folder folder;
  std::string file, recipe, longer;
};

} // namespace

TEST_CASE("suggest lists hints with their reasons, or as JSON") {
  const Hand hand;
  const Outcome text = reebquad({"suggest", hand.file, hand.recipe, "--kinds", "limbs"});
  CHECK(text.code == 0);
  CHECK(text.out.find("1. add_extremum: the protrusion at (") == 0);
  const Json list =
      Json::parse(reebquad({"suggest", hand.file, hand.recipe, "--kinds", "limbs", "--json"}).out);
  REQUIRE(list.size() >= 3);
  for (const Json& hint : list) {
    CHECK(hint["kind"] == "uncovered_limb");
    CHECK(hint["before"] > hint["after"]);
    CHECK(text.out.find(hint["reason"].get<std::string>()) != std::string::npos);
  }
  CHECK(reebquad({"suggest", hand.file, "--kinds", "sharp"}).out == "no hints\n");
}

TEST_CASE("suggest --apply writes the longer recipe, after which there are no hints") {
  const Hand hand;
  const Outcome taken = reebquad({"suggest", hand.file, hand.recipe, "--apply", "-o", hand.longer, "--json"});
  REQUIRE(taken.code == 0);
  const Json hints = Json::parse(taken.out), recipe = Json::parse(contents(hand.longer));
  REQUIRE(!hints.empty());
  REQUIRE(recipe["edits"].size() == 1 + hints.size());
  for (std::size_t i = 0; i < hints.size(); ++i) CHECK(recipe["edits"][i + 1] == hints[i]["edit"]);
  CHECK(reebquad({"suggest", hand.file, hand.longer}).out == "no hints\n");
  CHECK(reebquad({"replay", hand.file, hand.longer, "-o", hand.folder.path("quads.obj")}).code == 0);
}

TEST_CASE("suggest refuses what makes no sense") {
  const Hand hand;
  CHECK(reebquad({"suggest"}).code == 2);
  CHECK(reebquad({"suggest", hand.file, "--apply"}).code == 2);
  CHECK(reebquad({"suggest", hand.file, "-o", hand.longer}).code == 2);
  CHECK(reebquad({"suggest", hand.file, "--kinds", "fingers"}).code == 2);
  CHECK(reebquad({"suggest", hand.file, "--quads", "0"}).code == 2);
  CHECK(reebquad({"suggest", hand.file, hand.folder.path("none.json")}).code == 3);
}
