// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs and surroundings that mean no good: the program ends with a sentence, soon, within little memory,
// and nothing is lost.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

namespace {

using Json = nlohmann::json;

/// The exit code of a shell command in which $R is the program.
int shell(const std::string& command) {
  const int status = std::system(("R='" REEBQUAD_PROGRAM "'; " + command).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// A sphere and quads of it in a folder.
struct Sphere {
  Sphere() {
    REQUIRE(reebquad({"shape", "sphere", "-o", file, "--triangles", "1500"}).code == 0);
    REQUIRE(reebquad({"run", file, "-o", quads, "--quads", "300", "--quiet"}).code == 0);
    bytes = contents(file);
  }
  Temporary_folder folder;
  std::string file = folder.path("sphere.off"), quads = folder.path("quads.obj"),
              out = folder.path("out.obj");
  std::string bytes;
};

std::string recipe(const Json& edits) {
  return Json{{"format", "reebquad recipe"}, {"version", 1}, {"options", {{"quads", 300}}}, {"edits", edits}}
      .dump();
}

Json place(double x, double y, double z) {
  return {{"point", {x, y, z}}};
}

bool has_ended_itself(const Outcome& outcome) {
  return outcome.code >= 0 && outcome.code < 128;
}

} // namespace

TEST_CASE("coordinates whose squares overflow are places like others") {
  const Sphere sphere;
  for (const double far : {1e12, 1e100, 1e160, 1e200, 1e308, -1.7e308}) {
    CAPTURE(far);
    const Json extrema = {{{"at", place(far, 0, 0)}, {"maximum", true}},
                          {{"at", place(0, -far, -far)}, {"maximum", false}}};
    const Json edits = {{{"edit", "set_extrema"}, {"extrema", extrema}},
                        {{"edit", "move_extremum"}, {"from", place(far, 0, 0)}, {"to", place(far, far, 0)}},
                        {{"edit", "lock_chart"}, {"at", place(far, 0, 0)}}};
    const Outcome replayed = reebquad(
        {"replay", sphere.file, sphere.folder.write("far.json", recipe(edits)), "-o", sphere.out, "--quiet"});
    INFO(replayed.err);
    CHECK((replayed.code == 0 || replayed.code == 2));
    std::ostringstream number;
    number << far;
    const std::string at = number.str() + ",0,0";
    for (const std::string& op : {"rotate_edge " + at, "move_vertices " + at + " 0,0," + number.str()}) {
      const Outcome edited =
          reebquad({"texture", sphere.quads, "--on", sphere.file, "-o", sphere.out, "--op", op});
      INFO(op << ": " << edited.err);
      CHECK((edited.code == 0 || edited.code == 2 || edited.code == 5));
    }
  }
}

TEST_CASE("no number in a recipe makes an edit run without end") {
  const Sphere sphere;
  const Json drag = {{"edit", "drag_vertices"}, {"points", {place(1, 0, 0)}}, {"to", place(0.98, 0.1, 0)}};
  const auto replay = [&](const Json& changes) {
    Json edit = drag;
    edit.update(changes);
    const std::string file = sphere.folder.write("drag.json", recipe({{{"edit", "suggest"}}, edit}));
    return reebquad({"replay", sphere.file, file, "-o", sphere.out, "--quiet"}, {20});
  };
  const Outcome wide = replay({{"rings", 1000000000}, {"steps", 5}});
  INFO(wide.err);
  CHECK(wide.code == 0);
  CHECK(replay({{"steps", 1000000000}}).code == 2);
  CHECK(replay({{"radius", 1e300}}).code == 0);
  CHECK(has_ended_itself(replay({{"points", Json(std::vector<Json>(3000, place(1, 0, 0)))}})));
}

TEST_CASE("an output that is also an input is refused, by whatever name") {
  const Sphere sphere;
  const auto refused = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = reebquad(arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contents(sphere.file) == sphere.bytes);
  };
  const std::string link = sphere.folder.path("link.off"), hard = sphere.folder.path("hard.off"),
                    design = sphere.folder.write("design.json", recipe({{{"edit", "suggest"}}}));
  std::filesystem::create_symlink(sphere.file, link);
  std::filesystem::create_hard_link(sphere.file, hard);
  for (const std::string& output :
       {sphere.file, link, hard,
        sphere.folder.path("./../") +
            std::filesystem::path(sphere.folder.path("")).parent_path().filename().string() + "/sphere.off"})
    refused({"run", sphere.file, "-o", output, "--quads", "200"});
  refused({"run", link, "-o", sphere.file});
  refused({"run", sphere.file, "-o", sphere.out, "--report", sphere.file});
  refused({"run", sphere.file, "-o", sphere.out, "--report", sphere.out});
  refused({"run", sphere.file, "-o", sphere.out, "--report", sphere.folder.path("./out.obj")});
  refused({"replay", sphere.file, design, "-o", sphere.file});
  refused({"replay", sphere.file, design, "-o", sphere.out, "--report", design});
  refused({"suggest", sphere.file, design, "--apply", "-o", design});
  refused({"texture", sphere.quads, "--on", sphere.file, "-o", sphere.file, "--op", "rotate_edge 1,0,0"});
  refused({"polygons", sphere.quads, "-o", sphere.quads});
  std::filesystem::create_directory(sphere.folder.path("pictures"));
  std::filesystem::create_symlink(sphere.file, sphere.folder.path("pictures/quads.png"));
  refused({"run", sphere.file, "-o", sphere.out, "--pictures", sphere.folder.path("pictures")});
  CHECK(contents(design) == recipe({{{"edit", "suggest"}}}));

  CHECK(reebquad({"run", sphere.file, "-o", link, "--quads", "200", "--quiet", "--force"}).code == 0);
  CHECK(contents(sphere.file) != sphere.bytes);
}

TEST_CASE("what cannot be printed is no success") {
  const Sphere sphere;
  const std::string f = "'" + sphere.file + "'", err = sphere.folder.path("err");
  for (const std::string& command :
       std::vector<std::string>{"check " + f + " --json", "check " + f, "version", "help", "shape --list",
                                "stats '" + sphere.quads + "'", "suggest " + f, "run --help"}) {
    CAPTURE(command);
    CHECK(shell("\"$R\" " + command + " >/dev/full 2>'" + err + "'") == 1);
    CHECK(contents(err).find("the standard output cannot be written") != std::string::npos);
  }
  // A reader who goes away does not end a run before its file is written.
  CHECK(shell("(\"$R\" run " + f + " -o '" + sphere.out + "' --quads 200; echo $? >'" + err + "') | true") ==
        0);
  CHECK(std::filesystem::file_size(sphere.out) > 0);
}

TEST_CASE("a full disk, a limit of files and one of memory end with a sentence and leave nothing") {
  const Sphere sphere;
  const std::string folder = sphere.folder.path("small"), err = sphere.folder.path("err");
  std::filesystem::create_directory(folder);
  CHECK(shell("ulimit -f 1; \"$R\" shape sphere -o '" + folder + "/a.off' --triangles 5000 2>'" + err +
              "'") == 1);
  CHECK(contents(err).find("Cannot write") != std::string::npos);
  CHECK(std::filesystem::is_empty(folder));
  if (!memory_is_limited) return;
  const std::string large = sphere.folder.path("large.off");
  REQUIRE(reebquad({"shape", "sphere", "-o", large, "--triangles", "20000"}).code == 0);
  for (int megabytes = 40; megabytes <= 200; megabytes += 8) {
    const int code = shell("ulimit -v " + std::to_string(1024 * megabytes) + "; \"$R\" run '" + large +
                           "' -o '" + folder + "/q.obj' --quiet --threads 2 2>'" + err + "'");
    CAPTURE(megabytes, contents(err));
    CHECK((code == 0 || code == 1 || code == 127)); // 127: not even the libraries can be loaded
    if (code == 0) break;
  }
}

TEST_CASE("text files are regular files, or pipes that someone writes into") {
  const Sphere sphere;
  const std::string fifo = sphere.folder.path("fifo");
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  for (const std::string& bad : {fifo, std::string("/dev/zero")})
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
             {"replay", sphere.file, bad, "-o", sphere.out},
             {"suggest", sphere.file, bad},
             {"run", sphere.file, "-o", sphere.out, "--extrema", bad},
             {"texture", sphere.quads, "--on", sphere.file, "-o", sphere.out, "--ops", bad},
             {"texture", sphere.quads, "--on", sphere.file, "-o", sphere.out, "--recipe", bad}}) {
      const Outcome outcome = reebquad(command, {5});
      INFO(command[0] << " " << bad << ": " << outcome.err);
      CHECK(outcome.code == 3);
    }
  const std::string design = sphere.folder.write("design.json", recipe({{{"edit", "suggest"}}}));
  CHECK(shell("cat '" + design + "' | \"$R\" replay '" + sphere.file + "' /dev/stdin -o '" + sphere.out +
              "' --quiet") == 0);
}

TEST_CASE("names do not command the terminal") {
  const Temporary_folder folder;
  const std::string name = "a\x1b]0;title\x07\x7f\xc2\x9b"
                           "2J\xc3\xa9.off";
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"check", folder.path(name)}, {"check", folder.write(name, "OFF\n0 0 0\n")}}) {
    const Outcome outcome = reebquad(command);
    const std::string text = outcome.out + outcome.err;
    CHECK(text.find("\\x1b]0;title\\x07\\x7f\\xc2\\x9b2J\xc3\xa9.off") != std::string::npos);
    CHECK(text.find('\x1b') == std::string::npos);
    CHECK(text.find("\xc2\x9b") == std::string::npos);
  }
}

TEST_CASE("one long edge does not take the memory") {
  // A box a hundred thousand times as long as it is wide; the program may take what cli_process.h allows.
  const Temporary_folder folder;
  std::string box = "OFF\n8 12 0\n";
  for (const char* x : {"0", "100000"})
    for (const char* yz : {"0 0", "1 0", "1 1", "0 1"}) box += std::string(x) + " " + yz + "\n";
  box += "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 "
         "4\n3 3 4 7\n";
  const Outcome outcome =
      reebquad({"run", folder.write("needle.off", box), "-o", folder.path("q.obj"), "--quads", "200"}, {120});
  INFO(outcome.err);
  CHECK(has_ended_itself(outcome));
  CHECK(outcome.err.find("memory ran out") == std::string::npos);
}
