// SPDX-License-Identifier: GPL-3.0-or-later
// `reebquad run --html`: one file that holds everything it shows.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <regex>

namespace {

using Json = nlohmann::json;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
  return number;
}

/// What stands between two texts, the first time.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before);
  REQUIRE(begin != std::string::npos);
  return text.substr(begin + before.size(), text.find(after, begin + before.size()) - begin - before.size());
}

struct Torus_run {
  Torus_run() {
    REQUIRE(reebquad({"shape", "torus", "-o", folder.path("torus.obj"), "--triangles", "1500"}).code == 0);
    outcome = reebquad({"run", folder.path("torus.obj"), "-o", folder.path("quads.obj"), "--quads", "400",
                        "--quiet", "--html", html(), "--report", folder.path("report.json")});
  }
  std::string html() const { return folder.path("report.html"); }

  Temporary_folder folder;
  Outcome outcome;
};

} // namespace

TEST_CASE("a run's HTML report has the numbers of its JSON report, all layers, and no address to load from") {
  const Torus_run run;
  INFO(run.outcome.err);
  if (run.outcome.code != 0) {
    // A program without the page says so before it works.
    CHECK(run.outcome.err.find("npm") != std::string::npos);
    CHECK(!std::filesystem::exists(run.folder.path("quads.obj")));
    return;
  }
  const std::string html = contents(run.html());
  const Json facts = Json::parse(between(html, "id=\"facts\">", "</script>"));
  const Json report = Json::parse(contents(run.folder.path("report.json")));
  CHECK(facts["certificate"] == report["certificate"]);
  CHECK(facts["statistics"] == report["statistics"]);
  for (const char* layer : {"surface", "cuts", "field", "charts", "contours", "critical", "reeb", "quads"}) {
    CAPTURE(layer);
    CHECK(count(html, "data-layer=\"" + std::string(layer) + "\">UlFT") == 1); // "RQS" begins each message
  }
  CHECK(
      html.find(
          "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:") !=
      std::string::npos);
  CHECK(!std::regex_search(html.substr(0, html.find("<script>")), std::regex("(src|href)=")));
  CHECK(count(html, "</script>") == count(html, "<script"));
  CHECK(html.size() < 3000000);
}

TEST_CASE("a report that cannot be written is told") {
  const Temporary_folder folder;
  REQUIRE(reebquad({"shape", "torus", "-o", folder.path("torus.obj"), "--triangles", "600"}).code == 0);
  const Outcome outcome =
      reebquad({"run", folder.path("torus.obj"), "-o", folder.path("quads.obj"), "--quads", "300", "--quiet",
                "--html", folder.path("missing/report.html")});
  CHECK(outcome.code != 0);
  CHECK(outcome.err.find("report.html") != std::string::npos);
}
