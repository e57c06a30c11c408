// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes on the command line: where they are read from, how they are met, and what is refused.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;

std::vector<std::array<double, 3>> points_of(const std::string& obj) {
  std::vector<std::array<double, 3>> points;
  std::istringstream in(contents(obj));
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream one(line);
    std::array<double, 3> p{};
    if (one >> word && word == "v" && one >> p[0] >> p[1] >> p[2]) points.push_back(p);
  }
  return points;
}

// A sphere, and sizes that are larger above.
struct Sized_sphere {
  explicit Sized_sphere(const Temporary_folder& folder)
      : mesh(folder.path("sphere.obj")), sizes(folder.path("sizes.txt")) {
    REQUIRE(reebquad({"shape", "sphere", "-o", mesh, "--triangles", "2000"}).code == 0);
    std::ofstream out(sizes);
    out << "# a line for each point\n";
    for (const auto& p : points_of(mesh)) out << 0.09 + 0.03 * p[2] << '\n';
  }
  std::string mesh, sizes;
};

Json sizes_in(const std::string& report) {
  return Json::parse(contents(report))["components"][0]["sizes"];
}

} // namespace

TEST_CASE("sizes are met in the mean and mostly everywhere, and the recipe makes the same bytes") {
  const Temporary_folder folder;
  const Sized_sphere sphere(folder);
  const std::string quads = folder.path("q.obj"), report = folder.path("report.json"),
                    recipe = folder.path("recipe.json");
  const Outcome run = reebquad({"run", sphere.mesh, "-o", quads, "--sizes", sphere.sizes, "--effort", "fast",
                                "--report", report, "--write-recipe", recipe});
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.out.find("sizes: edges are ") != std::string::npos);
  const Json met = sizes_in(report);
  CHECK(std::abs(met["mean"].get<double>() - 1) < 0.12);
  CHECK(met["met_within_20_percent"] > 0.5);
  CHECK(met["percentiles"]["5"] < met["percentiles"]["95"]);
  const std::string again = folder.path("again.obj");
  REQUIRE(reebquad({"replay", sphere.mesh, recipe, "-o", again}).code == 0);
  CHECK(contents(again) == contents(quads));
  const Outcome even = reebquad(
      {"run", sphere.mesh, "-o", folder.path("even.obj"), "--edge-length", "0.09", "--effort", "fast"});
  REQUIRE(even.code == 0);
  CHECK(contents(folder.path("even.obj")) != contents(quads));
}

TEST_CASE("a PLY file with sizes of another mesh of the shape serves as well") {
  const Temporary_folder folder;
  const Sized_sphere sphere(folder);
  const std::string coarse = folder.path("coarse.obj"), ply = folder.path("sizes.ply");
  REQUIRE(reebquad({"shape", "sphere", "-o", coarse, "--triangles", "500"}).code == 0);
  std::ofstream out(ply);
  const auto points = points_of(coarse);
  std::vector<std::string> faces;
  std::istringstream in(contents(coarse));
  for (std::string line; std::getline(in, line);)
    if (line.rfind("f ", 0) == 0) faces.push_back(line.substr(2));
  out << "ply\nformat ascii 1.0\nelement vertex " << points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty float quality\nelement face "
      << faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : points) out << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << 0.1 << '\n';
  for (const std::string& face : faces) {
    std::istringstream one(face);
    out << 3;
    for (std::string corner; one >> corner;) out << ' ' << std::stoi(corner) - 1;
    out << '\n';
  }
  out.close();
  const std::string report = folder.path("report.json");
  const Outcome run = reebquad({"run", sphere.mesh, "-o", folder.path("q.obj"), "--sizes", ply, "--effort",
                                "fast", "--report", report});
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(std::abs(sizes_in(report)["mean"].get<double>() - 1) < 0.12);
}

TEST_CASE("sizes that cannot be are refused with their line") {
  const Temporary_folder folder;
  const Sized_sphere sphere(folder);
  const std::string bad = folder.path("bad.txt");
  const auto refusal = [&](const std::string& text) {
    std::ofstream(bad) << text;
    const Outcome run = reebquad({"run", sphere.mesh, "-o", folder.path("q.obj"), "--sizes", bad});
    CHECK(run.code != 0);
    return run.err;
  };
  CHECK(refusal("0.1\n-0.2\n").find("line 2: expected one positive number") != std::string::npos);
  CHECK(refusal("0.1\n0.1 0.2\n").find("line 2: expected one positive number") != std::string::npos);
  CHECK(refusal("0.1\nnan\n").find("line 2: expected one positive number") != std::string::npos);
  CHECK(refusal("0.1\n0.1\n").find("it has 2 sizes, the mesh has ") != std::string::npos);
  CHECK(refusal("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float "
                "z\nend_header\n")
            .find("no property 'size'") != std::string::npos);
  const Outcome both =
      reebquad({"run", sphere.mesh, "-o", folder.path("q.obj"), "--sizes", sphere.sizes, "--quads", "500"});
  CHECK(both.code != 0);
  CHECK(both.err.find("--sizes excludes --quads") != std::string::npos);
}
