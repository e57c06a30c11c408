// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad texture and reebquad polygons, as a shell runs them.
#include "cli_process.h"
#include "tiny_quads.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// A cube of 4 x 4 quads a side, and its triangles.
struct Files {
  Temporary_folder folder;
  Quad_mesh quads = tiny::subdivided(tiny::subdivided(tiny::quad_cube()));
  std::string mesh = folder.path("cube.obj"), surface = folder.path("cube.off"), out = folder.path("out.obj");

  Files() {
    REQUIRE(write_mesh(mesh, quads));
    REQUIRE(write_mesh(surface, tiny::triangulated(quads)));
  }
  Outcome texture(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"texture", mesh, "--on", surface};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return reebquad(arguments);
  }
};

} // namespace

TEST_CASE("without edits the patches are counted") {
  const Files files;
  const Outcome told = files.texture({});
  CHECK(told.code == 0);
  CHECK(contains(told.out, "96 quads in 6 patches"));
  CHECK(contains(files.texture({"--cut", "everywhere"}).out, "96 quads in 96 patches"));
}

TEST_CASE("the edited side of a cube is finer, the others keep their points") {
  const Files files;
  const Outcome done = files.texture({"-o", files.out, "--op", "subdivide_texture 0.5,0.5,1", "--op",
                                      "inset_quads 0.5,0.4,1 at=0.3", "--pictures", files.folder.path("p")});
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK(contains(done.out, "passed"));
  CHECK(std::filesystem::exists(files.folder.path("p") + "/patches.png"));
  CHECK(std::filesystem::exists(files.folder.path("p") + "/quads.png"));
  const auto soup = read_polygon_soup(files.out);
  REQUIRE(soup);
  CHECK(soup->number_of_polygons() > 96 + 3 * 16 + 16);
  std::set<std::array<double, 3>> found;
  for (const Point& p : soup->points) found.insert({p.x(), p.y(), p.z()});
  for (const Point& p : files.quads.points)
    if (p.z() < 1) CHECK(found.count({p.x(), p.y(), p.z()}) == 1);
}

TEST_CASE("edits come from a file too, before those of the command line") {
  const Files files;
  std::ofstream(files.folder.path("edits.txt")) << "# finer on top\nsubdivide_texture 0.5,0.5,1\n\n";
  const Outcome done = files.texture(
      {"-o", files.out, "--ops", files.folder.path("edits.txt"), "--op", "coarsen_texture 0.5,0.5,1"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto soup = read_polygon_soup(files.out);
  REQUIRE(soup);
  CHECK(soup->number_of_polygons() == 96);
}

TEST_CASE("edits are written as a recipe, which gives the same quads") {
  const Files files;
  const std::string recipe = files.folder.path("edits.json"), again = files.folder.path("again.json"),
                    same = files.folder.path("same.obj");
  const Outcome done =
      files.texture({"-o", files.out, "--write-recipe", recipe, "--op", "subdivide_texture 0.5,0.5,1", "--op",
                     "inset_quads 0.5,0.4,1 at=0.3", "--op", "move_vertices 0.5,0.5,1 0.52,0.5,1", "--op",
                     "relax_vertices 0.5,0.5,1"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const Outcome replayed = files.texture({"-o", same, "--recipe", recipe, "--write-recipe", again});
  INFO(replayed.err);
  REQUIRE(replayed.code == 0);
  CHECK(contents(same) == contents(files.out));
  CHECK(contents(again) == contents(recipe));
}

TEST_CASE("a recipe whose edits are not of one patch is refused with the edit's number") {
  const Files files;
  const std::string recipe = files.folder.path("edits.json");
  const std::string first =
      R"({"edit": "edit_texture", "operator": "subdivide", "points": [{"point": [0.5, 0.5, 1]}]})";
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"({"edit": "suggest"})", "edit 2 (suggest): it is no edit of a texture"},
      {R"({"edit": "edit_texture", "operator": "coarsen", "points": [{"point": [0, 0, 1]}], "scope": "surface"})",
       "edit 2 (edit_texture): the scope"},
      {R"({"edit": "relax_texture", "at": {"point": [0.5, 0.5, 1]}, "radius": 1})", "no radius"}};
  for (const auto& [edit, sentence] : cases) {
    std::ofstream(recipe)
        << R"({"format": "reebquad recipe", "version": 1, "options": {"quads": 100}, "edits": [)" << first
        << ", " << edit << "]}";
    const Outcome outcome = files.texture({"-o", files.out, "--recipe", recipe});
    INFO(outcome.err);
    CHECK(outcome.code != 0);
    CHECK(contains(outcome.err, sentence));
  }
  CHECK(!std::filesystem::exists(files.out));
}

TEST_CASE("what cannot be done is said, and nothing is written") {
  const Files files;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--op", "subdivide_texture 0,0,1"}, "-o FILE"},
      {{"-o", files.out, "--op", "frobnicate 0,0,1"}, "no operator"},
      {{"-o", files.out, "--op", "open_quad 0,0,1"}, "two points"},
      {{"-o", files.out, "--op", "inset_quads 0.5,0.5"}, "neither a point"},
      {{"-o", files.out, "--op", "inset_quads 0.5,0.5,1 0.5,0.5,0"}, "different patches"},
      {{"-o", files.out, "--op", "delete_polychord 0.5,0.3,1"}, "does not apply"},
      {{"--cut", "nowhere"}, "separatrices"}};
  for (const auto& [arguments, sentence] : cases) {
    const Outcome outcome = files.texture(arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, sentence));
  }
  CHECK(!std::filesystem::exists(files.out));
  CHECK(reebquad({"texture", files.mesh}).code == 2);
  CHECK(reebquad({"texture", files.surface, "--on", files.surface}).code == 4);
}

TEST_CASE("polygons say that they are not all-quad") {
  const Files files;
  for (const std::string kind : {"hex", "dual", "diagonal"}) {
    const Outcome done = reebquad({"polygons", files.mesh, "-o", files.out, "--kind", kind, "--on",
                                   files.surface, "--picture", files.folder.path("p.png")});
    INFO(done.err);
    REQUIRE(done.code == 0);
    CHECK(contains(done.out, "not all-quad"));
    CHECK(std::filesystem::exists(files.folder.path("p.png")));
    const auto soup = read_polygon_soup(files.out);
    REQUIRE(soup);
    CHECK(soup->number_of_polygons() == (kind == "diagonal" ? 192 : 98));
    std::ifstream stream(files.out);
    std::string first;
    std::getline(stream, first);
    CHECK(contains(first, "# not all-quad"));
    for (const Point& p : soup->points) { // on the cube
      const Point d = (p - Point(0.5, 0.5, 0.5)).cwiseAbs();
      CHECK(d.maxCoeff() == Approx(0.5));
    }
  }
  CHECK(reebquad({"polygons", files.mesh, "-o", files.out, "--kind", "stars"}).code == 2);
}
