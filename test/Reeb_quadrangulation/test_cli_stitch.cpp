// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad stitch and reebquad texture --stitch, as a shell runs them.
#include "cli_process.h"
#include "patch_samples.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// The halves of a torus, of 8 and of 12 quads around, in a file each and together, and its triangles.
struct Torus_files {
  Temporary_folder folder;
  std::string some = folder.path("some.obj"), others = folder.path("others.ply"),
              both = folder.path("both.off"), surface = folder.path("torus.stl"),
              out = folder.path("out.obj"), report = folder.path("report.json");

  Torus_files() {
    const double pi = std::acos(-1.0);
    const Quad_mesh a = tiny::torus_part(0, pi, 8, 8),
                    b = tiny::turned_around(tiny::torus_part(pi, 2 * pi, 8, 12));
    REQUIRE(write_mesh(some, a));
    REQUIRE(write_mesh(others, b));
    REQUIRE(write_mesh(both, tiny::together(a, b)));
    REQUIRE(write_mesh(surface, tiny::triangulated(tiny::quad_torus(48, 32))));
  }

  /// Refused with this code and these words, and nothing is written.
  void refused(const std::vector<std::string>& arguments, int code, const std::string& words) const {
    const Outcome done = reebquad(arguments);
    INFO(done.err);
    CHECK(done.code == code);
    CHECK(contains(done.err, words));
    CHECK(!std::filesystem::exists(out));
  }
};

} // namespace

TEST_CASE("files of patches become one closed mesh, with a report") {
  const Torus_files files;
  const Outcome done =
      reebquad({"stitch", files.some, files.others, "-o", files.out, "--report", files.report});
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK(contains(done.out, "2 patches, 1 turned around"));
  CHECK(contains(done.out, "8 T-junctions taken away"));
  const auto report = nlohmann::json::parse(contents(files.report));
  CHECK(report["status"] == 0);
  CHECK(report["output"] == files.out);
  CHECK(report["patches"][1]["file"] == files.others);
  CHECK(report["patches"][1]["quads_before"] == 96);
  CHECK(report["patches"][1]["turned"] == true);
  CHECK(report["stitching"]["t_junctions"] == 8);
  CHECK(report["certificate"]["passed"] == true);
  CHECK(report["statistics"]["quads"] > 160);
  CHECK(reebquad({"stats", files.out}).code == 0);
}

TEST_CASE("components of one file give the same bytes as files of their own") {
  const Torus_files files;
  REQUIRE(reebquad({"stitch", files.some, files.others, "-o", files.out, "--quiet"}).code == 0);
  const std::string same = files.folder.path("same.obj");
  const Outcome done = reebquad({"stitch", files.both, "-o", same, "--quiet"});
  CHECK(done.code == 0);
  CHECK(done.out.empty());
  CHECK(contents(same) == contents(files.out));
}

TEST_CASE("with a surface the certificate compares with it") {
  const Torus_files files;
  const Outcome done = reebquad({"stitch", files.both, "-o", files.out, "--surface", files.surface,
                                 "--validate", "--report", files.report});
  INFO(done.err << done.out);
  REQUIRE(done.code == 0);
  const auto report = nlohmann::json::parse(contents(files.report));
  CHECK(report["certificate"]["strictly_valid"] == true);
  CHECK(!report["certificate"]["shape"].is_null());
  // Half of it is missing in the end: a warning, and with --strict a failure.
  std::filesystem::remove(files.out);
  files.refused({"stitch", files.some, "-o", files.out, "--open", "--surface", files.surface}, 5,
                "certificate");
}

TEST_CASE("refusals of stitching name file, patch and place, and write nothing") {
  const Torus_files files;
  files.refused({"stitch", files.some, "-o", files.out}, 2,
                files.some + ": patch 1 (64 quads): a rim meets no other, at (");
  files.refused({"stitch", files.surface, "-o", files.out}, 4, files.surface + ": face 0, at (");
  files.refused({"stitch", files.both, "-o", files.both}, 2, "would be overwritten");
  files.refused({"stitch", files.both, "-o", files.out, "--report", files.out}, 2, "two outputs");
  files.refused({"stitch", files.both, files.folder.path("none.obj"), "-o", files.out}, 3, "none.obj");
  files.refused({"stitch", "-o", files.out}, 2, "PATCHES is missing");
  files.refused({"stitch", files.both, "-o", files.out, "--alpha", "0.7"}, 2, "--alpha");
  files.refused({"stitch", files.both, "-o", files.folder.path("out.txt")}, 2, "extension");
}

TEST_CASE("a rim that meets nothing stays where --open says so") {
  const Torus_files files;
  const Outcome done = reebquad({"stitch", files.some, "-o", files.out, "--open"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto soup = read_polygon_soup(files.out);
  REQUIRE(soup);
  CHECK(soup->number_of_polygons() == 64);
}

TEST_CASE("a texture is drawn on patches that touch without equal samples") {
  const Torus_files files;
  const std::vector<std::string> edit{"texture", files.both, "--on", files.surface,
                                      "-o",      files.out,  "--op", "inset_quads 0,1.4,0 at=0.3"};
  files.refused(edit, 5, "certificate failed");
  std::vector<std::string> stitched = edit;
  stitched.push_back("--stitch");
  const Outcome done = reebquad(stitched);
  INFO(done.err << done.out);
  REQUIRE(done.code == 0);
  CHECK(contains(done.out, "8 T-junctions taken away"));
  CHECK(reebquad({"stats", files.out, "--against", files.surface}).code == 0);
}
