// SPDX-License-Identifier: GPL-3.0-or-later
// `reebquad batch` from outside: each mesh once, whatever is killed when; failures are recorded; names are
// only names.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>
#include <set>

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> quickly{"--", "--quads", "60", "--effort", "fast"};

/// A closed surface with `columns` x `rows` quads of two triangles, about the z axis.
std::string torus(int columns = 16, int rows = 8) {
  std::ostringstream off;
  off << "OFF\n" << columns * rows << ' ' << 2 * columns * rows << " 0\n";
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const double a = 2 * M_PI * i / columns, b = 2 * M_PI * j / rows, r = 1 + 0.4 * std::cos(b);
      off << r * std::cos(a) << ' ' << 0.4 * std::sin(b) << ' ' << r * std::sin(a) << '\n';
    }
  const auto v = [&](int i, int j) { return (i % columns) * rows + j % rows; };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      off << "3 " << v(i, j) << ' ' << v(i, j + 1) << ' ' << v(i + 1, j + 1) << '\n';
      off << "3 " << v(i, j) << ' ' << v(i + 1, j + 1) << ' ' << v(i + 1, j) << '\n';
    }
  return off.str();
}

Outcome batch(std::vector<std::string> arguments, const std::vector<std::string>& run = quickly,
              const Limits& limits = {}) {
  arguments.insert(arguments.begin(), "batch");
  arguments.insert(arguments.end(), run.begin(), run.end());
  return reebquad(arguments, limits);
}

/// The lines of batch.jsonl by the name of the mesh.
std::map<std::string, json> table(const std::string& folder) {
  std::map<std::string, json> rows;
  std::istringstream lines(contents(folder + "/batch.jsonl"));
  for (std::string line; std::getline(lines, line);) {
    const json row = json::parse(line);
    REQUIRE(rows.emplace(row.at("name"), row).second);
  }
  return rows;
}

/// When each result below the folder was written.
std::map<std::string, fs::file_time_type> times(const std::string& folder) {
  std::map<std::string, fs::file_time_type> result;
  for (const auto& entry : fs::recursive_directory_iterator(folder + "/meshes"))
    if (entry.is_regular_file()) result[entry.path().string()] = entry.last_write_time();
  return result;
}

std::size_t number_of_pieces(const std::string& text, const std::string& piece) {
  std::size_t n = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++n;
  return n;
}

} // namespace

TEST_CASE("A batch meshes what its folders hold, and what does not mesh is recorded, not lost") {
  const Temporary_folder folder;
  fs::create_directories(folder.path("in/deep/.hidden"));
  folder.write("in/good.off", torus());
  folder.write("in/deep/good.off", torus(12, 6));
  folder.write("in/broken.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  folder.write("in/notes.txt", "no mesh");
  folder.write("in/deep/.hidden/no.off", torus());
  const std::string out = folder.path("in/out"); // in the input itself
  const Outcome first = batch({folder.path("in"), "-o", out});
  INFO(first.err);
  CHECK(first.code == 6);
  CHECK(first.out.find("3 meshes: 2 certified, 0 in part, 1 failed") != std::string::npos);

  std::map<std::string, json> rows = table(out);
  REQUIRE(rows.size() == 3);
  CHECK(rows.at("in/good.off").at("outcome") == "certified");
  CHECK(rows.at("in/deep/good.off").at("quads") > 0);
  CHECK(rows.at("in/broken.off").at("exit_code") == 3);
  CHECK(rows.at("in/broken.off").at("sentence").get<std::string>().find("broken.off") != std::string::npos);
  CHECK(fs::exists(out + "/meshes/in/good.off/quads.obj"));
  CHECK_FALSE(fs::exists(out + "/meshes/in/broken.off/quads.obj"));

  SECTION("the quads are those of run alone") {
    const std::vector<std::string> run{
        "run", folder.path("in/good.off"), "-o", folder.path("alone.obj"), "--quads", "60", "--effort",
        "fast"};
    REQUIRE(reebquad(run).code == 0);
    CHECK(contents(folder.path("alone.obj")) == contents(out + "/meshes/in/good.off/quads.obj"));
  }
  SECTION("nothing is done twice, and results are no input") {
    const auto before = times(out);
    CHECK(batch({folder.path("in"), "-o", out}).code == 6);
    CHECK(times(out) == before);
  }
  SECTION("a touched file with the same bytes is done, other bytes or other options are not") {
    folder.write("in/good.off", torus());
    CHECK(batch({folder.path("in"), "-o", out, "--pending"}).out.empty());
    folder.write("in/good.off", torus(14, 8));
    CHECK(batch({folder.path("in"), "-o", out, "--pending"}).out == "in/good.off\n");
    const Outcome other = batch({folder.path("in"), "-o", out, "--pending"}, {"--", "--quads", "80"});
    CHECK(other.out == "in/broken.off\nin/deep/good.off\nin/good.off\n");
  }
  SECTION("what failed is tried again only when that is asked for") {
    CHECK(batch({folder.path("in"), "-o", out, "--pending", "--retry"}).out == "in/broken.off\n");
    folder.write("in/broken.off", torus());
    CHECK(batch({folder.path("in"), "-o", out}).code == 0);
  }
  SECTION("the overview has failures first and needs nothing from outside") {
    const std::string html = contents(out + "/batch.html");
    CHECK(html.find("in/broken.off") < html.find("in/deep/good.off"));
    CHECK(number_of_pieces(html, "data:image/png;base64,") == 2);
    CHECK(html.find("http") == html.find("http-equiv"));
    CHECK(number_of_pieces(contents(out + "/batch.csv"), "\r\n") == 4);
  }
}

TEST_CASE("Meshes whose names are alike do not overwrite each other") {
  const Temporary_folder folder;
  for (const char* sub : {"a/in", "b/in"}) fs::create_directories(folder.path(sub));
  folder.write("a/in/m.off", torus());
  folder.write("b/in/m.off", torus(12, 6));
  folder.write("a/in/m.obj", "v 0 0 0\n");
  const std::string out = folder.path("out");
  CHECK(batch({folder.path("a/in"), folder.path("b/in"), folder.path("a/in/m.off"), "-o", out}).code == 6);
  const auto rows = table(out);
  REQUIRE(rows.size() == 3); // a file that is given twice counts once
  std::set<int> faces;
  for (const auto& [name, row] : rows) {
    if (row.at("outcome") == "certified") faces.insert(row.at("input").at("faces").get<int>());
    // A name leads back to its mesh.
    CHECK(batch({folder.path("a/in"), folder.path("b/in"), "-o", out, "--one", name, "--table"}).code ==
          (row.at("outcome") == "certified" ? 0 : 6));
  }
  CHECK(faces == std::set<int>{256, 144});

  const Outcome other = batch({folder.path("b/in"), "-o", out});
  CHECK(other.code == 0); // in/m.off is another name than those with a digest
  const Outcome again = batch({folder.path("a/in"), "-o", out});
  CHECK(again.code == 2);
  CHECK(again.err.find("the results of another mesh") != std::string::npos);
}

TEST_CASE("Shares are everything together, each mesh in one of them") {
  const Temporary_folder folder;
  fs::create_directories(folder.path("in"));
  for (int i = 0; i < 7; ++i) folder.write("in/" + std::to_string(i) + ".off", torus());
  std::multiset<std::string> all;
  for (const char* share : {"1/3", "2/3", "3/3"}) {
    std::istringstream names(
        batch({folder.path("in"), "-o", folder.path("out"), "--pending", "--shard", share}).out);
    for (std::string name; std::getline(names, name);) all.insert(name);
  }
  CHECK(all.size() == 7);
  CHECK(std::set<std::string>(all.begin(), all.end()).size() == 7);
  for (const char* bad : {"0/3", "4/3", "1", "1/3x", "-1/3"})
    CHECK(batch({folder.path("in"), "-o", folder.path("out"), "--shard", bad}).code == 2);
}

TEST_CASE("Time and memory that a mesh may take end that mesh only") {
  const Temporary_folder folder;
  fs::create_directories(folder.path("in"));
  folder.write("in/small.off", torus());
  folder.write("in/large.off", torus(700, 200));
  const std::string out = folder.path("out");
  CHECK(batch({folder.path("in"), "-o", out, "--time", "0.35", "--jobs", "2"}).code == 6);
  const json stopped = table(out).at("in/large.off");
  CHECK(stopped.at("exit_code") == 137);
  CHECK(stopped.at("sentence") == "0.35 s are over (--time)");
  CHECK_FALSE(fs::exists(out + "/meshes/in/large.off/quads.obj"));
  if (!memory_is_limited) return;
  CHECK(batch({folder.path("in"), "-o", out, "--memory", "150", "--retry"}).code == 6);
  const json full = table(out).at("in/large.off");
  CHECK(full.at("exit_code") == 1);
  CHECK(full.at("sentence") == "memory ran out at 150 MB (--memory)");
  CHECK(table(out).at("in/small.off").at("outcome") == "certified");
}

TEST_CASE("A batch that is killed at any time goes on where it was, and leaves nothing half") {
  const Temporary_folder folder;
  fs::create_directories(folder.path("in"));
  for (int i = 0; i < 6; ++i) folder.write("in/" + std::to_string(i) + ".off", torus(20 + i, 10));
  const std::string out = folder.path("out");
  std::map<std::string, fs::file_time_type> recorded; // what has a record keeps its bytes and its time
  for (int round = 0; round < 4; ++round) {
    Limits limits;
    limits.seconds = (0.1 + 0.06 * round) / patience; // then it is killed
    batch({folder.path("in"), "-o", out, "--jobs", "2"}, quickly, limits);
    if (!fs::exists(out + "/meshes")) continue;
    const auto now = times(out);
    for (const auto& [file, time] : recorded) CHECK(now.at(file) == time);
    for (const auto& [file, time] : now)
      if (fs::path(file).filename() == "record.json") recorded[file] = time;
  }
  CHECK(batch({folder.path("in"), "-o", out, "--jobs", "2"}).code == 0);
  CHECK(table(out).size() == 6);
  const auto now = times(out);
  for (const auto& [file, time] : recorded) CHECK(now.at(file) == time);
  for (const auto& [file, time] : now)
    CHECK(std::set<std::string>{"record.json", "report.json", "thumbnail.png", "quads.obj"}.count(
              fs::path(file).filename().string()) == 1);
}

TEST_CASE("Ctrl-C ends a batch and its children, and says what is left") {
  const Temporary_folder folder;
  fs::create_directories(folder.path("in"));
  folder.write("in/large.off", torus(700, 200));
  Limits limits;
  limits.interrupt_after = 0.3 * patience;
  const Outcome outcome = batch({folder.path("in"), "-o", folder.path("out")}, quickly, limits);
  CHECK(outcome.code == 130);
  CHECK(outcome.err.find("1 mesh is left") != std::string::npos);
  CHECK(outcome.seconds_after_signal < 1 * patience);
  CHECK_FALSE(fs::exists(folder.path("out/meshes/in/large.off/record.json")));
}

TEST_CASE("Several batches on one folder do each mesh once") {
  const Temporary_folder folder;
  fs::create_directories(folder.path("in"));
  for (int i = 0; i < 5; ++i) folder.write("in/" + std::to_string(i) + ".off", torus(20 + i, 10));
  const std::string out = folder.path("out");
  std::vector<std::string> arguments{"batch", folder.path("in"), "-o", out, "--jobs", "1"};
  arguments.insert(arguments.end(), quickly.begin(), quickly.end());
  std::array<pid_t, 3> processes{};
  for (std::size_t i = 0; i < processes.size(); ++i) {
    processes[i] = fork();
    REQUIRE(processes[i] >= 0);
    const std::string number = std::to_string(i);
    if (processes[i] == 0)
      become_program(arguments, folder.path("out" + number), folder.path("err" + number), {});
  }
  std::string told;
  for (std::size_t i = 0; i < processes.size(); ++i) {
    int status = -1;
    CHECK(waitpid(processes[i], &status, 0) == processes[i]);
    CHECK(status == 0);
    told += contents(folder.path("err" + std::to_string(i)));
  }
  for (int i = 0; i < 5; ++i)
    CHECK(number_of_pieces(told, "in/" + std::to_string(i) + ".off: certified") == 1);
}

TEST_CASE("A hostile name commands neither the terminal, nor the tables, nor the browser") {
  const Temporary_folder folder;
  fs::create_directories(folder.path("in"));
  const std::string name = "\x1b[2J<script>alert(1)<\xff\n\"',=1+1.off";
  folder.write("in/" + name, "no mesh");
  folder.write("=cmd.off", "no mesh");
  const std::string out = folder.path("out");
  const Outcome outcome = batch({folder.path("in"), folder.path("=cmd.off"), "-o", out});
  CHECK(outcome.code == 6);
  const std::string csv = contents(out + "/batch.csv"), html = contents(out + "/batch.html");
  for (const std::string& text : {outcome.err, outcome.out, csv, html, contents(out + "/batch.jsonl")})
    for (const char* bad : {"\x1b", "\xff"}) CHECK(text.find(bad) == std::string::npos);
  CHECK(number_of_pieces(outcome.err, "\n") == 2);
  CHECK(number_of_pieces(csv, "\n") == 3);
  CHECK(csv.find("\"./=cmd.off\"") != std::string::npos);
  CHECK(number_of_pieces(html, "<script>") == 1);
  const std::string pending = batch({folder.path("in"), "-o", folder.path("other"), "--pending"}).out;
  const Outcome one =
      batch({folder.path("in"), "-o", folder.path("other"), "--one", pending.substr(0, pending.size() - 1)});
  CHECK(one.code == 6);
  CHECK(one.out.find("1 mesh: 0 certified, 0 in part, 1 failed") != std::string::npos);
}

TEST_CASE("What cannot be meant by a batch is told before anything begins") {
  const Temporary_folder folder;
  folder.write("m.off", torus());
  const std::string in = folder.path("m.off"), out = folder.path("out");
  CHECK(batch({in, "-o", out}, {"--", "--quadz", "60"}).code == 2);
  CHECK(batch({in, "-o", out}, {"--", "-o", "x.obj"}).code == 2);
  CHECK(batch({in, "-o", out}, {"--", "--report=x"}).code == 2);
  CHECK(batch({in, "-o", out, "--format", "blend"}).code == 2);
  CHECK(batch({in, "-o", out, "--one", "../m.off"}).code == 2);
  CHECK(batch({in, "-o", out, "--jobs", "0"}).code == 2);
  CHECK(batch({folder.path("missing"), "-o", out}).code == 3);
  CHECK(batch({"-o", out}).code == 2);
  CHECK_FALSE(fs::exists(out));
}
