// SPDX-License-Identifier: GPL-3.0-or-later
// The studio's session without sockets: what is exported, and what an edit sends to the page.
#include "temporary_folder.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <server/Frame_patch.h>
#include <server/Session.h>

using namespace CGAL::Reeb_quadrangulation;
using reebquad::studio::Folder;
using reebquad::studio::frame_patch;
using reebquad::studio::Frame_view;
using reebquad::studio::Json;
using reebquad::studio::Layers;
using reebquad::studio::Session;

namespace {

class Silent : public Observer {
public:
  void progress(const std::string&, double) override {}
  bool cancelled() const override { return false; }
};

std::string bytes_of(const Polygon_soup& soup) {
  return encode_mesh(soup, Mesh_format::obj)->bytes;
}

std::string file_of(const std::string& shape, int triangles) {
  return bytes_of(polygon_soup(*make_shape(shape, triangles)));
}

/// What `reebquad replay` writes.
std::string replayed(const std::string& mesh, const std::string& recipe_text) {
  const Recipe recipe = *recipe_from_json(recipe_text);
  Mended_surface mended = *mend_surface(*parse_polygon_soup(mesh.data(), mesh.size(), Mesh_format::obj));
  Result<Editor> editor = Editor::create(std::move(mended.components[0].surface), recipe.options);
  REQUIRE(editor);
  for (const Edit& edit : recipe.edits) REQUIRE(editor->apply(edit));
  const Result<Stitched_mesh> quads = editor->finished_quads();
  REQUIRE(quads);
  return bytes_of(with_fans(quads->mesh, pole_fans(editor->design(), *quads)));
}

/// An open session that does what it is told.
struct Desk {
  explicit Desk(const std::string& mesh) : session(Folder(folder.path(""))) {
    REQUIRE(session.open_upload("mesh.obj", mesh, observer));
  }
  void edit(const Json& edit) {
    const Result<Json> done = session.edit(edit, observer);
    INFO(edit.dump());
    REQUIRE(done);
  }

  Temporary_folder folder;
  Silent observer;
  Session session;
};

/// The sum of 4 - valence over the inner vertices and of 3 - valence over those on the boundary.
int index_sum(const Json& budget) {
  int sum = 0;
  for (const auto& [valence, number] : budget["interior"].items())
    sum += (4 - std::stoi(valence)) * number.get<int>();
  for (const auto& [valence, number] : budget["boundary"].items())
    sum += (3 - std::stoi(valence)) * number.get<int>();
  return sum;
}

/// A point of the surface inside the chart, amid vertices that have only its faces around.
Json point_inside(Session& session, int chart) {
  const Layers& layers = session.layers();
  const auto charts = Frame_view(*layers.at("charts")).words("chart");
  const auto triangles = Frame_view(*layers.at("surface")).words("triangle");
  const auto bits = Frame_view(*layers.at("surface")).words("position");
  std::vector<char> other(bits.size() / 3, 0), inside(bits.size() / 3, 0);
  for (std::size_t f = 0; f < charts.size(); ++f)
    for (std::size_t i = 3 * f; i < 3 * f + 3; ++i)
      (int(charts[f]) == chart ? inside : other)[triangles[i]] = 1;
  std::vector<std::size_t> found;
  for (std::size_t v = 0; v < inside.size(); ++v)
    if (inside[v] && !other[v]) found.push_back(v);
  REQUIRE(!found.empty());
  const Json origin = session.state()["file"]["origin"];
  Json point = Json::array();
  for (std::size_t k = 0; k < 3; ++k) {
    float x = 0;
    std::memcpy(&x, &bits[3 * found[found.size() / 2] + k], sizeof x);
    point.push_back(x + origin[k].get<double>());
  }
  return point;
}

} // namespace

TEST_CASE("with a whole pole the studio exports the fan that replay writes, draws it and certifies it") {
  const std::string mesh = file_of("sphere", 1200);
  Desk desk(mesh);
  desk.edit(
      Json::parse(R"({"edit": "set_extrema", "extrema": [{"at": {"point": [0, 0, -1]}, "maximum": false},
                                                               {"at": {"point": [0, 0, 1]}, "maximum": true}]})"));
  CHECK(desk.session.state()["facts"]["fans"] == "");
  desk.edit(Json::parse(R"({"edit": "split_pole", "at": {"point": [0, 0, 1]}, "kind": "whole"})"));
  const Result<std::string> exported = desk.session.export_quads("obj", desk.observer);
  REQUIRE(exported);
  CHECK(*exported == replayed(mesh, *desk.session.recipe()));

  const Json state = desk.session.state();
  CHECK(state["facts"]["fans"].get<std::string>().find("1 whole pole") != std::string::npos);
  CHECK(state["certificate"]["passed"] == true);
  CHECK(index_sum(state["budget"]) == 8);
  const auto quads = Frame_view(*desk.session.layers().at("quads")).words("quad");
  int triangles = 0;
  for (std::size_t i = 0; i < quads.size(); i += 4) triangles += quads[i + 2] == quads[i + 3];
  CHECK(triangles >= 4);
  CHECK(desk.session.certify(desk.observer));
  CHECK(desk.session.state()["certificate"]["passed"] == true);
}

TEST_CASE("an edit of one chart sends a small part of what the surface's layers are") {
  Desk desk(file_of("hand", 12000));
  desk.edit({{"edit", "suggest"}, {"axis", {0, 0, 1}}});
  REQUIRE(desk.session.finish(desk.observer));
  // The smallest tube that has some faces to cut.
  const auto charts = Frame_view(*desk.session.layers().at("charts")).words("chart");
  int chart = -1;
  std::ptrdiff_t fewest = std::ptrdiff_t(charts.size());
  const Json state = desk.session.state();
  for (const Json& fact : state["facts"]["charts"]) {
    const auto faces = std::count(charts.begin(), charts.end(), fact["id"].get<std::uint32_t>());
    if (fact["kind"] == "annulus" && faces > 500 && faces < fewest) {
      fewest = faces;
      chart = fact["id"];
    }
  }
  REQUIRE(chart >= 0);
  const Json at{{"point", point_inside(desk.session, chart)}};

  const auto sent = [&](const char* what, const std::function<void()>& change, double part) {
    CAPTURE(what);
    const Layers before = desk.session.layers();
    change();
    const Layers& now = desk.session.layers();
    CHECK(*now.at("surface") == *before.at("surface"));
    for (const char* name : {"cuts", "field", "charts"}) {
      CAPTURE(name);
      const auto patch = frame_patch(*before.at(name), *now.at(name));
      REQUIRE(patch);
      CHECK(double(patch->size()) < part * double(now.at(name)->size()));
    }
  };
  sent(
      "rows",
      [&] {
        desk.edit({{"edit", "set_rows"}, {"at", at}, {"rows", 6}});
      },
      0.02);
  sent(
      "subdivide",
      [&] {
        desk.edit({{"edit", "subdivide_chart"}, {"at", at}});
      },
      0.2);
  sent(
      "undo", [&] { REQUIRE(desk.session.undo()); }, 0.2);
  sent(
      "redo", [&] { REQUIRE(desk.session.redo()); }, 0.2);
}
