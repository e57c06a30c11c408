// SPDX-License-Identifier: GPL-3.0-or-later
// The program's contract with the shell: exit codes, sentences, and files that are written whole or not at
// all.
#include "cli_process.h"

#include <random>

namespace {

const std::string quad_cube = "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                              "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// A band of `n` squares, each divided into triangles, glued with a half twist if asked.
std::string band(int n, bool twisted) {
  std::ostringstream off;
  off << "OFF\n" << 2 * n << ' ' << 2 * n << " 0\n";
  for (int i = 0; i < n; ++i)
    for (const double side : {-0.4, 0.4}) {
      const double a = 2 * 3.141592653589793 * i / n, tilt = twisted ? a / 2 : 0;
      const double r = 2 + side * std::cos(tilt);
      off << r * std::cos(a) << ' ' << r * std::sin(a) << ' ' << side * std::sin(tilt) + (twisted ? 0 : side)
          << '\n';
    }
  for (int i = 0; i < n; ++i) {
    const bool flip = twisted && i == n - 1;
    const int a = 2 * i, b = 2 * i + 1, c = 2 * ((i + 1) % n) + (flip ? 1 : 0),
              d = 2 * ((i + 1) % n) + (flip ? 0 : 1);
    off << "3 " << a << ' ' << c << ' ' << d << "\n3 " << a << ' ' << d << ' ' << b << '\n';
  }
  return off.str();
}

std::string random_bytes(std::size_t size) {
  std::mt19937 generator(7);
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += char(generator() & 255);
  return bytes;
}

constexpr Limits hostile{10, 400, -1};

} // namespace

TEST_CASE("usage errors return 2 and say what was wrong") {
  const Temporary_folder folder;
  const std::string cube = folder.write("cube.off", quad_cube);
  struct Case {
    std::vector<std::string> arguments;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {{}, "no command is given"},
      {{"frobnicate"}, "no command 'frobnicate'"},
      {{"check"}, "FILE is missing"},
      {{"check", cube, "--frob"}, "--frob"},
      {{"check", cube, "another"}, "too many positional"},
      {{"run", cube}, "output is missing"},
      {{"run", cube, "-o", folder.path("q.xyz")}, "extension"},
      {{"run", cube, "-o", folder.path("q.obj"), "--quads", "many"}, "--quads"},
      {{"run", cube, "-o", folder.path("q.obj"), "--quads", "0"}, "--quads lies between 1"},
      {{"run", cube, "-o", folder.path("q.obj"), "--quads", "9", "--edge-length", "1"}, "exclude each other"},
      {{"run", cube, "-o", folder.path("q.obj"), "--edge-length", "-1"}, "positive length"},
      {{"run", cube, "-o", folder.path("q.obj"), "--axis", "0,0,0"}, "no direction"},
      {{"run", cube, "-o", folder.path("q.obj"), "--axis", "0,0"}, "three numbers"},
      {{"run", cube, "-o", folder.path("q.obj"), "--max", "1,2,x"}, "three numbers"},
      {{"run", cube, "-o", folder.path("q.obj"), "--persistence", "2"}, "--persistence lies between"},
      {{"run", cube, "-o", folder.path("q.obj"), "--field", "magnetic"}, "cotangent, clamped"},
      {{"run", cube, "-o", folder.path("q.obj"), "--hole-edges", "5"}, "without --fill-holes"},
      {{"run", cube, "-o", folder.path("q.obj"), "--weld", "-1"}, "--weld takes a distance"},
      {{"check", cube, "--drop-components-below", "5x"}, "it got '5x'"},
      {{"check", cube, "--drop-components-below", "120%"}, "it got '120%'"},
      {{"check", cube, "--drop-components-below", "-1"}, "it got '-1'"},
      {{"shape", "teapot", "-o", folder.path("t.obj")}, "no shape 'teapot'"},
      {{"shape", "torus", "-o", folder.path("t.xyz")}, "extension"},
  };
  for (const Case& c : cases) {
    const Outcome outcome = reebquad(c.arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.rfind("reebquad: ", 0) == 0);
    CHECK(contains(outcome.err, c.sentence));
    CHECK(outcome.out.empty());
  }
}

TEST_CASE("every command explains itself") {
  for (const std::string command : {"run", "check", "replay", "suggest", "stats", "shape"}) {
    const Outcome outcome = reebquad({command, "--help"});
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.out, "Usage: reebquad " + command));
    CHECK(outcome.err.empty());
  }
  CHECK(contains(reebquad({"help"}).out, "run"));
}

TEST_CASE("the version tells the libraries and whether the studio has its page") {
  const std::string version = reebquad({"version"}).out;
  CHECK(contains(version, "CGAL"));
  CHECK(contains(version, "pictures: "));
  CHECK(contains(version, "solvers: multifrontal, "));
  const bool with_page = contains(version, "studio: with its page");
  CHECK(with_page != contains(version, "studio: without its page ("));
  if (with_page) return;
  // The studio gives the same reason.
  const std::size_t begin = version.find('(', version.find("without its page"));
  const std::string reason = version.substr(begin, version.find(')', begin) + 1 - begin);
  const Outcome refused = reebquad({"studio", "--no-browser"});
  CHECK(refused.code == 1);
  CHECK(contains(refused.err, reason));
}

TEST_CASE("unreadable files return 3, soon, within little memory, and name the file and the place") {
  const Temporary_folder folder;
  std::filesystem::create_directory(folder.path("folder.obj"));
  const std::string gzip_head("\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03", 10);
  struct Case {
    std::string file, place;
  };
  const std::vector<Case> cases = {
      {folder.path("missing.off"), "No such file"},
      {folder.path("folder.obj"), "folder"},
      {folder.write("empty.off", ""), "empty"},
      {folder.write("header.off", "OFF\n"), "line 2"},
      {folder.write("counts.off", "OFF\n1000000000 2000000000 0\n0 0 0\n"), "line 2"},
      {folder.write("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6"},
      {folder.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "line 4"},
      {folder.write("zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), "line 4"},
      {folder.write("header.ply",
                    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
                    "property float y\nproperty float z\nend_header\n"),
       "byte"},
      {folder.write("squeezed.obj", gzip_head + random_bytes(100)), "gzip"},
      {folder.write("random.ply", random_bytes(5000)), "random.ply"},
      {folder.write("random.stl", random_bytes(5000)), "random.stl"},
  };
  for (const std::string command : {"check", "run"})
    for (const Case& c : cases) {
      std::vector<std::string> arguments{command, c.file};
      if (command == "run") arguments.insert(arguments.end(), {"-o", folder.path("quads.obj")});
      const Outcome outcome = reebquad(arguments, hostile);
      INFO(outcome.err);
      CHECK(outcome.code == 3);
      CHECK(contains(outcome.err, c.file));
      CHECK(contains(outcome.err, c.place));
      CHECK_FALSE(std::filesystem::exists(folder.path("quads.obj")));
    }
}

TEST_CASE("what is not a surface returns 4") {
  const Temporary_folder folder;
  const std::string nan = "OFF\n4 4 0\nnan 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::string book = "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n";
  const std::string tiny =
      "OFF\n4 4 0\n0 0 0\n1e-160 0 0\n0 1e-160 0\n0 0 1e-160\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::vector<std::string> files = {
      folder.write("moebius.off", band(12, true)),
      folder.write("nan.off", nan),
      folder.write("tiny.off", tiny),
      folder.write("points.off", "OFF\n1 0 0\n0 0 0\n"),
  };
  for (const std::string& file : files) {
    INFO(file);
    const Outcome checked = reebquad({"check", file}, hostile);
    CHECK(checked.code == 4);
    CHECK(contains(checked.out, "not a surface that the method takes"));
    const Outcome run = reebquad({"run", file, "-o", folder.path("quads.obj")}, hostile);
    INFO(run.err);
    CHECK(run.code == 4);
    CHECK(run.err.rfind("reebquad: ", 0) == 0);
    CHECK_FALSE(std::filesystem::exists(folder.path("quads.obj")));
  }
  CHECK(reebquad({"check", folder.write("band.off", band(12, false))}).code == 0);
  const std::string three_sheets = folder.write("book.off", book);
  CHECK(reebquad({"check", three_sheets}).code == 0);
  const Outcome refused = reebquad({"check", three_sheets, "--refuse-non-manifold"});
  CHECK(refused.code == 4);
  CHECK(contains(refused.out, "has 3 faces; let it be cut there"));
}

TEST_CASE("stats certifies quads of any origin: 0 if they are a surface, 5 if not, 4 if they are not quads") {
  const Temporary_folder folder;
  const Outcome good = reebquad({"stats", folder.write("cube.off", quad_cube)});
  CHECK(good.code == 0);
  CHECK(contains(good.out, "watertight"));
  std::string open_cube = quad_cube;
  open_cube.replace(open_cube.find("8 6 0"), 5, "8 5 0");
  open_cube.erase(open_cube.rfind("4 3 0 4 7"));
  const Outcome open = reebquad({"stats", folder.write("open.off", open_cube)});
  CHECK(open.code == 5);
  const Outcome triangles = reebquad({"stats", folder.write("band.off", band(8, false))});
  CHECK(triangles.code == 4);
  CHECK(contains(triangles.err, "face 0 has 3 corners"));
}

TEST_CASE("a file of extrema is checked line by line") {
  const Temporary_folder folder;
  const std::string cube = folder.write("cube.off", quad_cube), quads = folder.path("quads.obj");
  const auto run = [&](const std::string& text) {
    return reebquad({"run", cube, "-o", quads, "--extrema", folder.write("extrema.txt", text)});
  };
  CHECK(contains(run("min 0 0 0\nmid 0 0 1\n").err, "line 2"));
  CHECK(contains(run("min 0 0 0\n# a comment\n\nmax 0 0\n").err, "line 4"));
  CHECK(contains(run("max 0 0 0 0\n").err, "line 1"));
  CHECK(contains(run("# nothing\n").err, "places no extremum"));
  CHECK(run("min 0 0 inf\n").code == 3);
}
