// SPDX-License-Identifier: GPL-3.0-or-later
// Marks on the command line: where they are read from, and what is told of them.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace {

using Json = nlohmann::json;

// The cube [0, 2]^3 with a point in the middle of each edge and face, in two groups with seams: below and
// above z = 1.
std::string cube(const Temporary_folder& folder, bool groups, bool seams) {
  const std::string file = folder.path(groups ? "groups.obj" : seams ? "seams.obj" : "cube.obj");
  std::ofstream out(file);
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) out << "v " << x << ' ' << y << ' ' << z << '\n';
  for (int i = 0; i < 54; ++i) out << "vt " << 0.01 * i << " 0\n";
  for (int upper = 0; upper < 2; ++upper) {
    if (groups) out << (upper ? "usemtl top\n" : "g bottom\n");
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 3; side += 2)
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b) {
            const int low = axis == 2 ? side / 2 : axis == 0 ? b : a; // the layer that the face lies in
            if (low != upper) continue;
            out << 'f';
            for (int k = 0; k < 4; ++k) {
              const int corner = side ? k : 3 - k;
              int c[3];
              c[axis] = side;
              c[(axis + 1) % 3] = a + (corner == 1 || corner == 2);
              c[(axis + 2) % 3] = b + (corner >= 2);
              const int v = 1 + c[0] + 3 * c[1] + 9 * c[2];
              out << ' ' << v << '/' << v + (seams && upper ? 27 : 0);
            }
            out << '\n';
          }
  }
  return file;
}

Json report_of(const Temporary_folder& folder, const std::string& input, std::vector<std::string> options,
               std::string* err = nullptr) {
  const std::string report = folder.path("report.json");
  std::vector<std::string> arguments{
      "run",  input,      "-o",   folder.path("q.obj"), "--force", "--quads", "300", "--effort",
      "fast", "--report", report, "--feature-angle",    "0"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = reebquad(arguments);
  INFO(run.err);
  REQUIRE(run.code == 0);
  if (err) *err = run.err;
  return Json::parse(contents(report))["components"][0]["marks"];
}

double length(const Json& marks) {
  double sum = 0;
  for (const Json& chain : marks["chains"]) sum += chain["length"].get<double>();
  return sum;
}

} // namespace

TEST_CASE("marks are read as pairs of points, as positions and as lines of an OBJ file") {
  const Temporary_folder folder;
  const std::string input = cube(folder, false, false);
  const std::string text = folder.path("marks.txt"), lines = folder.path("lines.obj");
  std::ofstream(text) << "# the upper rim\nmark 18 19\nmark 19 20\nmark 2 0 2  2 2 2\n";
  std::ofstream(lines) << "v 0 0 2\nv 2 0 2\nv 2 2 2\nl 1 2 -1\n";
  for (const std::string& file : {text, lines}) {
    const Json marks = report_of(folder, input, {"--marks", file});
    CHECK(length(marks) == Approx(4));
    CHECK(marks["not_on_surface"] == 0);
    for (const Json& chain : marks["chains"])
      CHECK(chain["on"].get<double>() + chain["near"].get<double>() + chain["lost"].get<double>() ==
            Approx(chain["length"].get<double>()));
  }
  CHECK(report_of(folder, input, {}).is_null());
}

TEST_CASE("the borders of groups and the seams of texture coordinates are marked") {
  const Temporary_folder folder;
  for (const bool groups : {true, false}) {
    const Json marks =
        report_of(folder, cube(folder, groups, !groups), {groups ? "--mark-groups" : "--mark-seams"});
    CHECK(marks["marks"] == 8);
    CHECK(length(marks) == Approx(8));
  }
}

TEST_CASE("marks beside the surface are told, and lines that cannot be read are refused by number") {
  const Temporary_folder folder;
  const std::string input = cube(folder, false, false), file = folder.path("marks.txt");
  std::ofstream(file) << "mark 0 1\nmark 0 0 5 1 0 5\n";
  std::string err;
  CHECK(report_of(folder, input, {"--marks", file}, &err)["not_on_surface"] == 1);
  CHECK(err.find("1 of 2 marks lie on no edges of the mended surface, first the one at (0, 0, 5)") !=
        std::string::npos);
  for (const char* bad :
       {"mark 0 27\n", "mark 0\n", "mark a b\n", "line 0 1\n", "mark 0 nan\n", "mark 0 1.5\n"}) {
    std::ofstream(file) << "# first\n" << bad;
    const Outcome run = reebquad({"run", input, "-o", folder.path("q.obj"), "--force", "--marks", file});
    INFO(bad << run.err);
    CHECK(run.code == 3);
    CHECK(run.err.find("line 2") != std::string::npos);
  }
}

TEST_CASE("a file without groups has no borders of groups to mark") {
  const Temporary_folder folder;
  const std::string off = folder.path("cube.off");
  REQUIRE(reebquad({"shape", "cube", "-o", off}).code == 0);
  const Outcome run = reebquad({"run", off, "-o", folder.path("q.obj"), "--mark-groups"});
  CHECK(run.code == 3);
  CHECK(run.err.find("OBJ") != std::string::npos);
}
