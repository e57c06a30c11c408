// SPDX-License-Identifier: GPL-3.0-or-later
// `reebquad run` from file to certified quads, its report, its pictures, and how it stops.
#include "cli_process.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace {

using Json = nlohmann::json;

/// A folder with a built-in shape in it.
struct Shape {
  Shape(const std::string& name, int triangles) : file(folder.path(name + ".obj")) {
    REQUIRE(reebquad({"shape", name, "-o", file, "--triangles", std::to_string(triangles)}).code == 0);
  }
  Outcome run(std::vector<std::string> options, const Limits& limits = {}) const {
    options.insert(options.begin(), {"run", file, "-o", quads(), "--report", report_file()});
    return reebquad(options, limits);
  }
  std::string quads() const { return folder.path("quads.obj"); }
  std::string report_file() const { return folder.path("report.json"); }
  Json report() const { return Json::parse(contents(report_file())); }

  Temporary_folder folder;
  std::string file;
};

/// An OBJ file of points and triangles with its points scaled, then shifted along x, and its indices raised.
std::string transformed(const std::string& obj, const std::array<double, 3>& scale, double shift,
                        int first = 0) {
  std::istringstream lines(obj);
  std::ostringstream out;
  out.precision(17);
  std::string kind, rest;
  while (lines >> kind) {
    double x, y, z;
    int a, b, c;
    if (kind == "v" && lines >> x >> y >> z) {
      out << "v " << scale[0] * x + shift << ' ' << scale[1] * y << ' ' << scale[2] * z << '\n';
    } else if (kind == "f" && lines >> a >> b >> c) {
      out << "f " << a + first << ' ' << b + first << ' ' << c + first << '\n';
    }
    std::getline(lines, rest);
  }
  return out.str();
}

/// A torus and a sphere of the same radius, whose centre is `shift` away along x.
std::string torus_and_sphere(double shift) {
  const Shape torus("torus", 1500), sphere("sphere", 1500);
  const std::string first = transformed(contents(torus.file), {1, 1, 1}, 0);
  int points = 0;
  for (std::size_t at = first.find("v "); at != std::string::npos; at = first.find("v ", at + 1)) ++points;
  return first + transformed(contents(sphere.file), {1, 1, 1}, shift, points);
}

std::string status_of(const Json& report, const std::string& check) {
  for (const Json& entry : report["certificate"]["checks"])
    if (entry["name"] == check) return entry["status"];
  return "missing";
}

} // namespace

TEST_CASE("a torus becomes certified quads, about as many as asked for") {
  const Shape torus("torus", 3000);
  const Outcome outcome = torus.run({"--quads", "800"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "certified: " + torus.quads()));
  const Json report = torus.report();
  CHECK(report["status"] == 0);
  CHECK(report["certificate"]["passed"] == true);
  CHECK(report["certificate"]["components"][0]["euler_characteristic"] == 0);
  CHECK(std::abs(report["statistics"]["quads"].get<int>() - 800) <= 40);
  CHECK(status_of(report, "valences") == "passed");

  const Json& component = report["components"][0];
  CHECK(component["genus"] == 1);
  CHECK(component["layout"]["reeb_loops"] == 1);
  CHECK(component["layout"]["minima"].get<int>() - component["layout"]["saddles"].get<int>() +
            component["layout"]["maxima"].get<int>() ==
        0);
  CHECK(component["layout"]["charts"].size() == component["layout"]["reeb_arcs"]);
  CHECK(component["sampling"]["worst_count_ratio"].get<double>() >= 1);
  CHECK(component["stages"].size() > 5);
  CHECK(report["statistics"]["undersampled_area"].get<double>() < 0.05);

  SECTION("and `stats` certifies the file that was written") {
    const Outcome stats = reebquad({"stats", torus.quads(), "--against", torus.file, "--json"});
    REQUIRE(stats.code == 0);
    const Json again = Json::parse(stats.out);
    CHECK(again["certificate"]["passed"] == true);
    CHECK(again["statistics"]["scaled_jacobian"] == report["statistics"]["scaled_jacobian"]);
  }
}

TEST_CASE("the same bytes come out of one thread and of two") {
  const Shape hand("hand", 4000);
  REQUIRE(hand.run({"--threads", "1", "--quads", "1500"}).code == 0);
  const std::string one = contents(hand.quads());
  REQUIRE(hand.run({"--threads", "2", "--quads", "1500"}).code == 0);
  CHECK(one.size() > 1000);
  CHECK((one == contents(hand.quads())));
}

TEST_CASE("options change what they name") {
  const Shape torus("torus", 3000);
  const auto quads_of = [&](const std::vector<std::string>& options) {
    const Outcome outcome = torus.run(options);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return torus.report();
  };
  const Json usual = quads_of({"--quads", "600"});
  const std::string usual_bytes = contents(torus.quads());

  SECTION("--edge-length sets the length") {
    const Json report = quads_of({"--edge-length", "0.3"});
    CHECK(report["components"][0]["sampling"]["edge_length"].get<double>() == Approx(0.3));
    CHECK(report["statistics"]["edge_length"]["mean"].get<double>() == Approx(0.3).epsilon(0.35));
  }
  SECTION("--no-relax leaves the vertices where the textures put them") {
    const Json report = quads_of({"--quads", "600", "--no-relax"});
    CHECK(report["components"][0]["relaxation"]["moved_vertices"] == 0);
    CHECK(usual["components"][0]["relaxation"]["moved_vertices"] > 0);
    CHECK((usual_bytes != contents(torus.quads())));
  }
  SECTION("--min and --max place the extrema") {
    const Json report = quads_of({"--quads", "600", "--min", "1.4,0,0", "--max", "-1.4,0,0"});
    const Json& extrema = report["components"][0]["extrema"];
    REQUIRE(extrema.size() == 2);
    CHECK(extrema[0]["kind"] == "minimum");
    CHECK(extrema[0]["position"][0].get<double>() == Approx(1.4).margin(0.1));
    CHECK(extrema[1]["position"][0].get<double>() == Approx(-1.4).margin(0.1));
  }
  SECTION("--extrema reads them from a file") {
    const std::string file = torus.folder.write("extrema.txt", "min -1.4 0 0 # left\nmax 1.4 0 0\n");
    const Json extrema = quads_of({"--quads", "600", "--extrema", file})["components"][0]["extrema"];
    REQUIRE(extrema.size() == 2);
    CHECK(extrema[0]["position"][0].get<double>() == Approx(-1.4).margin(0.1));
  }
  SECTION("--axis turns up into down") {
    const Json report = quads_of({"--quads", "600", "--axis", "0,0,-1"});
    CHECK(report["components"][0]["extrema"] != usual["components"][0]["extrema"]);
  }
  SECTION("--quiet prints nothing, --timings every stage") {
    CHECK(torus.run({"--quads", "600", "--quiet"}).out.empty());
    const Outcome timed = torus.run({"--quads", "600", "--timings"});
    for (const std::string stage : {"reading", "field", "sampling", "certificate"})
      CHECK(contains(timed.err, stage));
  }
}

TEST_CASE("--field chooses the weights, which differ where triangles are obtuse") {
  const Shape torus("torus", 3000);
  torus.folder.write("torus.obj", transformed(contents(torus.file), {1, 0.3, 0.2}, 0));
  REQUIRE(torus.run({"--quads", "600", "--field", "cotangent"}).code == 0);
  const std::string cotangent = contents(torus.quads());
  REQUIRE(torus.run({"--quads", "600", "--field", "clamped"}).code == 0);
  CHECK((cotangent != contents(torus.quads())));
}

TEST_CASE("--feature-angle decides which edges are sharp") {
  const Shape shape("l-shape", 3000);
  const auto vertices_on_edges = [&](const std::string& angle) {
    REQUIRE(shape.run({"--quads", "1000", "--feature-angle", angle}).code == 0);
    return shape.report()["components"][0]["features"]["vertices"].get<int>();
  };
  CHECK(vertices_on_edges("0") == 0);
  CHECK(vertices_on_edges("45") > 20);
  CHECK(vertices_on_edges("120") == 0);
}

TEST_CASE("--feature-lines lets edges of quads run along more of the sharp edges") {
  const Shape shape("l-shape", 3000);
  const auto covered = [&](const std::vector<std::string>& arguments) {
    REQUIRE(shape.run(arguments).code == 0);
    CHECK(shape.report()["statistics"]["inverted_quads"] == 0);
    return shape.report()["statistics"]["covered_sharp_edges"].get<double>();
  };
  // Extrema that are placed keep the search from laying contours there.
  std::vector<std::string> placed{"--quads", "1500",      "--min", "0,0,0",
                                  "--min",   "2,0.6,0.2", "--max", "0,1,2"};
  const double single = covered(placed);
  CHECK(shape.report()["components"][0]["features"]["on_lines"] == 0);
  placed.push_back("--feature-lines");
  CHECK(covered(placed) > single + 0.03);
  CHECK(shape.report()["components"][0]["features"]["on_lines"].get<int>() > 20);
}

TEST_CASE("--persistence decides how many protrusions get an extremum") {
  const Shape hand("hand", 4000);
  REQUIRE(hand.run({"--effort", "fast", "--persistence", "0.05"}).code == 0);
  const std::size_t many = hand.report()["components"][0]["extrema"].size();
  REQUIRE(hand.run({"--effort", "fast", "--persistence", "0.9"}).code == 0);
  const std::size_t few = hand.report()["components"][0]["extrema"].size();
  CHECK(many > few);
  CHECK(few >= 2);
}

TEST_CASE("the report says what more effort has changed") {
  const Shape hand("hand", 4000);
  const auto changes = [&](const std::string& effort) {
    REQUIRE(hand.run({"--quads", "800", "--persistence", "0.9", "--effort", effort}).code == 0);
    return hand.report()["components"][0]["search"];
  };
  CHECK(changes("fast").empty());
  const Json steps = changes("default");
  REQUIRE(!steps.empty());
  for (const Json& step : steps)
    CHECK(contains(step["reason"].get<std::string>(), "the mean scaled Jacobian from"));
  CHECK(steps.back()["energy"].get<double>() <= steps[0]["energy"].get<double>());
  CHECK(hand.run({"--effort", "much"}).code == 2);
}

TEST_CASE("--weights and --budget set what is searched and how long, and are refused with a sentence") {
  const Shape hand("hand", 4000);
  const auto extrema = [&](const std::string& option, const std::string& value) {
    REQUIRE(hand.run({"--quads", "800", "--persistence", "0.9", option, value}).code == 0);
    return hand.report()["components"][0]["extrema"].size();
  };
  CHECK(extrema("--weights", "vertices=10,shape=1") == 2);
  CHECK(extrema("--weights", "vertices=0") > 2);
  CHECK(extrema("--budget", "0.000001") == 2); // over after the first design
  for (const std::string wrong : {"beauty=1", "angle", "angle=", "angle=-1", "angle=nan", "angle=1x"})
    CHECK(contains(hand.run({"--weights", wrong}).err, "--weights: '" + wrong + "'"));
  CHECK(hand.run({"--weights", "angle=inf"}).code == 2);
  CHECK(hand.run({"--budget", "0"}).code == 2);
  CHECK(contains(hand.run({"--effort", "fast", "--budget", "5"}).err, "--effort fast has none"));
}

TEST_CASE("an open cylinder keeps its rims, or has them filled") {
  const Shape cylinder("cylinder", 2000);
  REQUIRE(cylinder.run({"--quads", "500"}).code == 0);
  CHECK(cylinder.report()["certificate"]["components"][0]["boundary_loops"] == 2);
  REQUIRE(cylinder.run({"--quads", "500", "--fill-holes", "--hole-edges", "500"}).code == 0);
  CHECK(cylinder.report()["certificate"]["components"][0]["boundary_loops"] == 0);
}

TEST_CASE("two components are meshed one by one") {
  const Temporary_folder folder;
  const std::string both = folder.write("both.obj", torus_and_sphere(5));
  const std::string quads = folder.path("quads.off"), report_file = folder.path("report.json");
  const Outcome outcome = reebquad({"run", both, "-o", quads, "--quads", "1000", "--report", report_file});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const Json report = Json::parse(contents(report_file));
  REQUIRE(report["components"].size() == 2);
  CHECK(report["components"][0]["genus"] == 1);
  CHECK(report["components"][1]["genus"] == 0);
  CHECK(report["certificate"]["components"].size() == 2);
  CHECK(std::abs(report["statistics"]["quads"].get<int>() - 1000) <= 50);
}

TEST_CASE("good components are meshed where another is refused, unless it is to be all or nothing") {
  const Temporary_folder folder;
  std::string torus = transformed(contents(Shape("torus", 1000).file), {1, 1, 1}, 0);
  int points = 0;
  for (std::size_t at = torus.find("v "); at != std::string::npos; at = torus.find("v ", at + 1)) ++points;
  for (int i = 0; i < 12; ++i) // a Moebius band
    for (const double side : {-0.3, 0.3}) {
      const double a = 2 * std::acos(-1.0) * i / 12, r = 1 + side * std::cos(a / 2);
      torus += "v " + std::to_string(9 + r * std::cos(a)) + ' ' + std::to_string(r * std::sin(a)) + ' ' +
               std::to_string(side * std::sin(a / 2)) + '\n';
    }
  for (int i = 0; i < 12; ++i) {
    const int a = points + 2 * i + 1, b = a + 1, c = i < 11 ? a + 2 : points + 2,
              d = i < 11 ? a + 3 : points + 1;
    for (const auto& t : {std::array<int, 3>{a, c, d}, {a, d, b}})
      torus += "f " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]) + '\n';
  }
  const std::string input = folder.write("both.obj", torus), quads = folder.path("quads.obj"),
                    report_file = folder.path("report.json");
  std::vector<std::string> run{"run", input, "-o", quads, "--quads", "400", "--report", report_file};
  const Outcome part = reebquad(run);
  INFO(part.err);
  CHECK(part.code == 6);
  CHECK(contains(part.err, "in part: 1 component is written, 1 is left out"));
  CHECK(contains(part.err, "only one side"));
  CHECK(contains(part.err, "cut it open across"));
  const Json report = Json::parse(contents(report_file));
  CHECK(report["status"] == 6);
  CHECK(report["output"] == quads);
  CHECK(report["refused"].size() == 1);
  CHECK(report["components"].size() == 1);
  CHECK(reebquad({"stats", quads}).code == 0);
  const Outcome checked = reebquad({"check", input});
  CHECK(checked.code == 6);
  CHECK(contains(checked.out, "in part a surface"));
  std::filesystem::remove(quads);
  run.push_back("--all-or-nothing");
  const Outcome nothing = reebquad(run);
  CHECK(nothing.code == 4);
  CHECK(contains(nothing.err, "only one side"));
  CHECK_FALSE(std::filesystem::exists(quads));
}

TEST_CASE("specks that eat the count are told, and can be left out") {
  const Temporary_folder folder;
  std::string ball = transformed(contents(Shape("sphere", 400).file), {1, 1, 1}, 0);
  int points = 0;
  for (std::size_t at = ball.find("v "); at != std::string::npos; at = ball.find("v ", at + 1)) ++points;
  for (int i = 0; i < 20; ++i) { // tetrahedra
    const double x = 2 + 0.1 * i;
    for (const auto& d : {std::array<double, 3>{0, 0, 0}, {0.02, 0, 0}, {0, 0.02, 0}, {0, 0, 0.02}})
      ball +=
          "v " + std::to_string(x + d[0]) + ' ' + std::to_string(d[1]) + ' ' + std::to_string(d[2]) + '\n';
    const int a = points + 4 * i + 1;
    for (const auto& t : {std::array<int, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
      ball += "f " + std::to_string(a + t[0]) + ' ' + std::to_string(a + t[1]) + ' ' +
              std::to_string(a + t[2]) + '\n';
  }
  const std::string input = folder.write("dust.obj", ball), quads = folder.path("quads.obj");
  const Outcome all = reebquad({"run", input, "-o", quads, "--quads", "200"});
  INFO(all.err);
  CHECK(all.code == 0);
  CHECK(contains(all.err, "warning: "));
  CHECK(contains(all.err, "200 asked: 20 components need at least"));
  const Outcome clean =
      reebquad({"run", input, "-o", quads, "--quads", "200", "--drop-components-below", "5%"});
  CHECK(clean.code == 0);
  CHECK(contains(clean.err, "20 small components were dropped (80 faces)"));
  CHECK_FALSE(contains(clean.err, "asked:"));
}

TEST_CASE("a failed run writes nothing under the asked name and keeps what is there") {
  const Shape torus("torus", 1000);
  const std::string kept = torus.folder.write("quads.obj", "kept");
  REQUIRE(torus.run({"--min", "1.4,0,0", "--max", "1.4,0,0"}).code == 2); // one vertex cannot be both
  CHECK(contents(kept) == "kept");
  std::filesystem::create_directory(torus.folder.path("taken.obj"));
  const Outcome refused = reebquad({"run", torus.file, "-o", torus.folder.path("taken.obj")});
  CHECK(refused.code == 1);
  CHECK(contains(refused.err, "taken.obj"));
}

TEST_CASE("an input that intersects itself is no fault of the quads: a warning, which fails with --strict") {
  const Temporary_folder folder;
  const std::string input = folder.write("crossing.obj", torus_and_sphere(1)),
                    report_file = folder.path("report.json");
  const std::string quads = folder.write("quads.obj", "kept");
  std::vector<std::string> run{"run", input,      "-o",        quads,     "--quads",
                               "500", "--report", report_file, "--strict"};
  const Outcome outcome = reebquad(run);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.code == 5);
  CHECK(contains(outcome.out, "warning: the input intersects itself"));
  CHECK(contains(outcome.err, "the shape is not kept"));
  CHECK(contains(outcome.err, "nothing is written"));
  CHECK(contents(quads) == "kept");
  const Json report = Json::parse(contents(report_file));
  CHECK(report["status"] == 5);
  CHECK(report["output"].is_null());
  const Json& certificate = report["certificate"];
  CHECK(certificate["passed"] == true);
  CHECK(certificate["strictly_valid"] == false);
  CHECK(certificate["valid_as_input"] == true);
  CHECK(certificate["input_intersections"] == certificate["intersecting_quads"].size());
  CHECK(certificate["warnings"][0]["name"] == "input_intersections");
  run.back() = "--validate";
  CHECK(reebquad(run).code == 0);

  const Outcome checked = reebquad({"check", input});
  CHECK(checked.code == 0);
  CHECK(contains(checked.out, "self-intersections: 0 pairs of triangles within components"));
  CHECK_FALSE(contains(checked.out, "a clean surface"));
}

TEST_CASE("the run says how much of the shape is kept, against the file as it was read") {
  const Shape sphere("sphere", 1500);
  const Outcome outcome = sphere.run({"--quads", "400"});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "\nkept: distance at most "));
  const Json kept = sphere.report()["certificate"]["shape"];
  CHECK(kept["distance"].get<double>() > 0);
  CHECK(kept["distance"].get<double>() <= kept["bound"].get<double>());
  CHECK(kept["bound"].get<double>() < 0.03);
  CHECK(kept["quads_asked"] == 400);
  CHECK(contains(outcome.out, kept["summary"].get<std::string>()));
}

TEST_CASE("triangle formats come with a warning") {
  const Shape torus("torus", 1000);
  for (const std::string name : {"quads.stl", "quads.glb"}) {
    const std::string file = torus.folder.path(name);
    const Outcome outcome = reebquad({"run", torus.file, "-o", file, "--quads", "300"});
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.err, "triangles"));
    CHECK(std::filesystem::file_size(file) > 1000);
  }
}

TEST_CASE("pictures are PNG files, the same bytes every time") {
  const Shape torus("torus", 1000);
  const std::vector<std::string> names = {
      "field.png",   "charts.png",           "reeb_graph.png", "quads.png", "quads_four_views.png",
      "quality.png", "quality_histogram.png"};
  const std::string first = torus.folder.path("a"), second = torus.folder.path("b/c");
  REQUIRE(torus.run({"--quads", "300", "--pictures", first}).code == 0);
  REQUIRE(torus.run({"--quads", "300", "--pictures", second}).code == 0);
  for (const std::string& name : names) {
    INFO(name);
    const std::string bytes = contents(first + "/" + name);
    CHECK(bytes.substr(1, 3) == "PNG");
    CHECK((bytes == contents(second + "/" + name)));
  }
}

TEST_CASE("Ctrl-C ends the run within half a second and leaves nothing behind") {
  const Shape genus("genus-3", 150000);
  for (const double moment : {0.05, 0.3, 0.7}) {
    Limits limits;
    limits.interrupt_after = moment;
    limits.megabytes = 4000;
    const Outcome outcome = genus.run({"--quads", "20000"}, limits);
    INFO("after " << moment << " s: " << outcome.seconds_after_signal << " s " << outcome.err);
    CHECK(outcome.code == 130);
    CHECK(outcome.seconds_after_signal < 0.5 * patience + 0.5); // half a second more for a busy machine
    CHECK_FALSE(std::filesystem::exists(genus.quads()));
  }
}
