// SPDX-License-Identifier: GPL-3.0-or-later
// The studio's session without sockets: what is exported, and what an edit sends to the page.
#include "temporary_folder.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include "session/Session.h"
#include "view/Design_drawing.h"
#include "view/Frame_patch.h"

#include <functional>
#include <map>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using reebquad::studio::Design_drawing;
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

/// The mesh that `reebquad replay` writes.
Polygon_soup replayed(const std::string& mesh, const std::string& recipe_text) {
  const Recipe recipe = *recipe_from_json(recipe_text);
  Mended_surface mended = *mend_surface(*parse_polygon_soup(mesh.data(), mesh.size(), Mesh_format::obj));
  Triangle_surface& surface = mended.components[std::max(recipe.component, 1) - 1].surface;
  Result<Editor> editor = Editor::create(std::move(surface), recipe.options);
  REQUIRE(editor);
  for (const Edit& edit : recipe.edits) REQUIRE(editor->apply(edit));
  const Result<Finished_design> finished = editor->finished_quads();
  REQUIRE(bool(finished));
  return with_fans(finished->quads.mesh, pole_fans(editor->design(), finished->quads));
}

/// One mesh after the other.
Polygon_soup joined(Polygon_soup all, const Polygon_soup& other) {
  const int first = all.number_of_points();
  all.points.insert(all.points.end(), other.points.begin(), other.points.end());
  for (int p = 0; p < other.number_of_polygons(); ++p) {
    for (int i = other.begin[p]; i < other.begin[p + 1]; ++i) all.corner.push_back(other.corner[i] + first);
    all.close_polygon();
  }
  return all;
}

/// A small sphere, and a torus and an octahedron far from it.
std::string three_parts() {
  Triangle_surface torus = *make_shape("torus", 2000), solid = *make_shape("octahedron", 400);
  for (Point& p : torus.points) p += Point(5, 0, 0);
  for (Point& p : solid.points) p += Point(0, 9, 0);
  return bytes_of(
      joined(joined(polygon_soup(*make_shape("sphere", 800)), polygon_soup(torus)), polygon_soup(solid)));
}

const Json suggestion{{"edit", "suggest"}, {"axis", {0, 0, 1}}};

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

/// The area of each chart's part of each face that is cut.
std::map<std::pair<int, int>, double>
areas_of_pieces(const Embedding& cut, const std::vector<int>& chart_of_face, const Triangle_surface& base) {
  std::map<std::pair<int, int>, double> areas;
  for (int f = 0; f < cut.surface.number_of_faces(); ++f) {
    const Triangle& t = cut.surface.triangles[f];
    if (f < base.number_of_faces() && t == base.triangles[f]) continue;
    const std::vector<Point>& p = cut.surface.points;
    areas[{cut.base_face[f], chart_of_face[f]}] += 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
  }
  return areas;
}

/// What is drawn of a design has each face in the charts in which it lies, with the area that it has there.
void check_drawing(Design_drawing& kept, const Editor& editor) {
  const Design& design = editor.design();
  const Triangle_surface& surface = editor.working_surface();
  const Reeb_graph graph = reeb_graph(design.atlas, design.network);
  kept.update(design);
  const auto drawn = kept.charted(design, graph);
  const Embedded_design whole = embed_design(surface, design);
  const auto found = areas_of_pieces(drawn.embedding, drawn.chart_of_face, surface),
             expected = areas_of_pieces(whole.embedding, whole.chart_of_face, surface);
  std::set<int> is_cut;
  for (const auto& [where, area] : expected) {
    is_cut.insert(where.first);
    REQUIRE(found.count(where));
    CHECK(found.at(where) == Approx(area));
  }
  int wrong = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    wrong += !is_cut.count(f) && drawn.chart_of_face[f] != whole.chart_of_face[f];
  CHECK(wrong == 0);

  Design_drawing fresh(surface);
  fresh.update(design);
  const auto again = fresh.charted(design, graph);
  CHECK(again.embedding.surface.triangles == drawn.embedding.surface.triangles);
  CHECK(again.embedding.base_face == drawn.embedding.base_face);
  CHECK(again.embedding.surface.points == drawn.embedding.surface.points);
  CHECK(again.values == drawn.values);
  CHECK(again.chart_of_face == drawn.chart_of_face);
  CHECK(*again.lines == *drawn.lines);
}

} // namespace

TEST_CASE("the surface of a design, put together from its charts, is the one that is cut as a whole") {
  Result<Editor> editor = Editor::create(*make_shape("hand", 6000));
  REQUIRE(editor);
  Design_drawing kept(editor->working_surface());
  REQUIRE(editor->apply(Suggest{}));
  check_drawing(kept, *editor);
  const Triangle_surface& surface = editor->working_surface();
  const int tip = editor->design().extrema.back().vertex, beside = surface.target(surface.outgoing[tip]);
  Move_extremum move;
  move.from = {surface.points[tip], tip};
  move.to = {surface.points[beside], beside};
  REQUIRE(editor->apply(move));
  check_drawing(kept, *editor);
  editor->undo();
  check_drawing(kept, *editor);
  editor->redo();
  check_drawing(kept, *editor);
}

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
  CHECK(*exported == bytes_of(replayed(mesh, *desk.session.recipe())));

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
  desk.edit(suggestion);
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

TEST_CASE("each part of a file has its own design, and the export joins those that have quads") {
  const std::string mesh = three_parts();
  Desk desk(mesh);
  Session& session = desk.session;
  Json state = session.state();
  REQUIRE(state["file"]["components"].size() == 3);
  CHECK(state["file"]["component"] == 2); // the largest
  CHECK(state["file"]["genus"] == 1);
  CHECK(!session.export_quads("obj", desk.observer));
  desk.edit(suggestion);
  desk.edit({{"edit", "set_target"}, {"quads", 900}});
  REQUIRE(session.finish(desk.observer));
  const std::string of_torus = *session.recipe();
  CHECK(recipe_from_json(of_torus)->component == 2);
  CHECK(*session.export_quads("obj", desk.observer) == bytes_of(replayed(mesh, of_torus)));

  // The other parts are shown, too, each vertex with the number of its part.
  const auto parts_shown = [&] {
    const std::vector<std::uint32_t> parts = Frame_view(*session.layers().at("others")).words("part");
    return std::set<std::uint32_t>(parts.begin(), parts.end());
  };
  CHECK(parts_shown() == std::set<std::uint32_t>{1, 3});
  const auto others = session.layers().at("others");
  REQUIRE(session.undo());
  CHECK(session.layers().at("others") == others);
  REQUIRE(session.go_to(2));
  REQUIRE(session.choose(1, desk.observer));
  CHECK(parts_shown() == std::set<std::uint32_t>{2, 3});
  CHECK(session.state()["file"]["genus"] == 0);
  CHECK(session.state()["history"].empty());
  CHECK(!session.layers().count("quads"));
  desk.edit(suggestion);
  const std::string of_sphere = *session.recipe();
  const std::string both = *session.export_quads("obj", desk.observer);
  CHECK(both == bytes_of(joined(replayed(mesh, of_sphere), replayed(mesh, of_torus))));
  state = session.state();
  CHECK(state["file"]["components"][0]["quads"] > 0);
  CHECK(state["file"]["components"][2]["quads"] == 0);

  // Each has its own history; who comes back finds everything as it was.
  REQUIRE(session.undo());
  CHECK(!session.undo());
  REQUIRE(session.choose(2, desk.observer));
  CHECK(session.state()["applied"] == 2);
  CHECK(session.state()["certificate"]["passed"] == true);
  REQUIRE(session.undo());
  REQUIRE(session.redo());
  REQUIRE(session.choose(1, desk.observer));
  REQUIRE(session.redo());
  CHECK(*session.export_quads("obj", desk.observer) == both);
  for (const int none : {0, -1, 4}) CHECK(!session.choose(none, desk.observer));

  Session next{Folder(desk.folder.path(""))};
  CHECK(next.state()["last_session"]["edits"] == 3);
  REQUIRE(next.restore(desk.observer));
  CHECK(next.state()["file"]["component"] == 1);
  CHECK(*next.export_quads("obj", desk.observer) == both);
}

TEST_CASE("who stops while the last session comes back does not lose it") {
  const Temporary_folder folder;
  Silent silent;
  {
    Session session{Folder(folder.path(""))};
    REQUIRE(session.open_upload("mesh.obj", file_of("sphere", 800), silent));
    for (const int quads : {300, 400, 500, 600})
      REQUIRE(
          session.edit(quads == 300 ? suggestion : Json{{"edit", "set_target"}, {"quads", quads}}, silent));
    REQUIRE(session.undo());
  }
  const std::string name = ".reebquad/session-" + reebquad::studio::digest(file_of("sphere", 800)) + ".json";
  const auto kept = [&] { return contents(folder.path(name)); };
  const std::string before = kept();
  REQUIRE(!before.empty());
  // Stops at the n-th question whether to stop.
  struct Impatient : Observer {
    explicit Impatient(int n) : left(n) {}
    void progress(const std::string&, double) override {}
    bool cancelled() const override { return --left < 0; }
    mutable int left;
  };
  bool done = false;
  for (int n = 1; !done; n *= 3) {
    Session session{Folder(folder.path(""))};
    Impatient impatient(n);
    done = bool(session.restore(impatient));
    CHECK(kept() == before);
    if (done) CHECK(session.state()["applied"] == 3);
  }
}

TEST_CASE("opening a mesh again brings its edits back, and a crash the mesh that was open last") {
  const Temporary_folder folder;
  Silent silent;
  folder.write("a.obj", file_of("sphere", 800));
  folder.write("b.obj", file_of("torus", 800));
  {
    Session session{Folder(folder.path(""))};
    CHECK(session.resume(silent)); // nothing is there, and nothing is wrong
    REQUIRE(session.open_file("a.obj", silent));
    REQUIRE(session.edit(suggestion, silent));
    REQUIRE(session.open_file("b.obj", silent));
    CHECK(session.state()["applied"] == 0);
  }
  Session resumed{Folder(folder.path(""))};
  REQUIRE(resumed.resume(silent));
  CHECK(resumed.state()["file"]["name"] == "b.obj"); // though nothing was done to it yet
  Session again{Folder(folder.path(""))};
  REQUIRE(again.open_file("a.obj", silent));
  CHECK(again.state()["applied"] == 1);
  // The mesh is another now: the session waits for the old one.
  folder.write("a.obj", file_of("sphere", 900));
  Session changed{Folder(folder.path(""))};
  REQUIRE(changed.open_file("a.obj", silent));
  CHECK(changed.state()["applied"] == 0);
  folder.write("a.obj", file_of("sphere", 800));
  REQUIRE(changed.open_file("a.obj", silent));
  CHECK(changed.state()["applied"] == 1);
}

TEST_CASE("sessions that cannot be read, or whose edits are refused now, are kept and named") {
  const Temporary_folder folder;
  Silent silent;
  const std::string mesh = file_of("sphere", 800);
  folder.write("a.obj", mesh);
  std::filesystem::create_directory(folder.path(".reebquad"));
  folder.write(".reebquad/session.json", R"({"version": 3, "future": true})");
  const std::string name = ".reebquad/session-" + reebquad::studio::digest(mesh);
  folder.write(name + ".json", "{\"version\": 2, trunca");
  Session session{Folder(folder.path(""))};
  CHECK(session.state()["unreadable_sessions"].size() == 2);
  REQUIRE(session.open_file("a.obj", silent));
  CHECK(session.state()["last"]["warning"].get<std::string>().find(name + ".kept-1.json") !=
        std::string::npos);
  REQUIRE(session.edit(suggestion, silent));
  CHECK(contents(folder.path(".reebquad/session.json")) == R"({"version": 3, "future": true})");
  CHECK(contents(folder.path(name + ".kept-1.json")) == "{\"version\": 2, trunca");

  Json kept = Json::parse(contents(folder.path(name + ".json")));
  kept["parts"][0]["edits"].push_back({{"edit", "of the future"}});
  kept["parts"][0]["applied"] = 2;
  folder.write(name + ".json", kept.dump());
  Session next{Folder(folder.path(""))};
  REQUIRE(next.open_file("a.obj", silent));
  CHECK(next.state()["applied"] == 1); // what could be repeated
  CHECK(next.state()["last"]["text"].get<std::string>().find(name + ".kept-2.json") != std::string::npos);
  CHECK(Json::parse(contents(folder.path(name + ".kept-2.json"))) == kept);
}

TEST_CASE("the first mesh that is opened tells of sessions of others that cannot be read") {
  const Temporary_folder folder;
  Silent silent;
  folder.write("a.obj", file_of("sphere", 800));
  std::filesystem::create_directory(folder.path(".reebquad"));
  folder.write(".reebquad/session.json", R"({"version": 3})");
  Session session{Folder(folder.path(""))};
  REQUIRE(session.open_file("a.obj", silent));
  CHECK(session.state()["last"]["warning"].get<std::string>().find(".reebquad/session.json") !=
        std::string::npos);
  REQUIRE(session.edit(suggestion, silent));
  CHECK(!session.state()["last"].contains("warning"));
}

TEST_CASE("a followed recipe makes the quads of its replay, with its options, and is restored with them") {
  const Temporary_folder folder;
  Silent silent;
  const std::string mesh = file_of("sphere", 800);
  folder.write("a.obj", mesh);
  Recipe recipe;
  recipe.options.quads = 300;
  recipe.edits.push_back(*edit_from_json(suggestion.dump()));
  folder.write("a.recipe.json", to_json(recipe));
  std::string exported;
  {
    Session session{Folder(folder.path(""))};
    CHECK(!session.open_recipe_file("a.recipe.json", silent)); // no mesh
    REQUIRE(session.open_file("a.obj", silent));
    REQUIRE(session.edit(suggestion, silent));
    REQUIRE(session.edit({{"edit", "set_target"}, {"quads", 999}}, silent));
    REQUIRE(session.open_recipe_file("a.recipe.json", silent));
    CHECK(session.state()["history"].size() == 1);
    CHECK(recipe_from_json(*session.recipe())->options.quads == 300);
    exported = *session.export_quads("obj", silent);
    CHECK(exported == bytes_of(replayed(mesh, *session.recipe())));
  }
  Session next{Folder(folder.path(""))};
  REQUIRE(next.restore(silent));
  CHECK(*next.export_quads("obj", silent) == exported);

  // One that cannot be followed leaves everything as it was.
  recipe.edits.push_back(*edit_from_json(R"({"edit": "set_target", "quads": -5})"));
  const std::int64_t revision = next.revision();
  const Result<void> refused = next.open_recipe("b.recipe.json", to_json(recipe), silent);
  REQUIRE(!refused);
  CHECK(refused.error().message.find("step 2 of 2") != std::string::npos);
  CHECK(next.revision() == revision);

  // Half of a mesh is not shown for the whole.
  recipe.edits.pop_back();
  recipe.mirror.emplace();
  const Result<void> half = next.open_recipe("half.recipe.json", to_json(recipe), silent);
  REQUIRE(!half);
  CHECK(half.error().message.find("one half of a mirrored mesh") != std::string::npos);
  CHECK(next.revision() == revision);
}

TEST_CASE("a drag that ends where nothing can be, or is cancelled, leaves no trace") {
  const Temporary_folder folder;
  Silent silent;
  folder.write("a.obj", file_of("sphere", 800));
  Session session{Folder(folder.path(""))};
  REQUIRE(session.open_file("a.obj", silent));
  REQUIRE(session.edit(suggestion, silent));
  const Json history = session.state()["history"];
  const auto target = [](int quads) { return Json{{"edit", "set_target"}, {"quads", quads}}; };
  REQUIRE(session.edit(target(400), silent, 7, true));
  REQUIRE(session.edit(target(500), silent, 7, true));
  CHECK(!session.edit(target(-5), silent, 7, true));
  CHECK(session.state()["history"].size() == 2); // the place before is back while the button is down
  CHECK(!session.edit(target(-5), silent, 7, false));
  CHECK(session.state()["history"] == history);
  CHECK(!session.redo());

  REQUIRE(session.edit(target(400), silent, 8, true));
  session.cancel_drag(7); // another one
  CHECK(session.state()["history"].size() == 2);
  session.cancel_drag(8);
  CHECK(session.state()["history"] == history);
  CHECK(!session.redo());
}

TEST_CASE("a refused edit is offered one that works, which is one step; a recipe that cannot be followed "
          "names it") {
  const Temporary_folder folder;
  Silent silent;
  folder.write("a.obj", file_of("sphere", 1200));
  Session session{Folder(folder.path(""))};
  const Json far =
      Json::parse(R"({"edit": "move_contour", "at": {"point": [1, 0, 0]}, "plane_point": [0, 0, 1.5],
                                   "plane_normal": [0, 0, 1]})");
  CHECK(!session.offer(far, silent)); // no mesh
  REQUIRE(session.open_file("a.obj", silent));
  CHECK(session.offer(far, silent)->is_null()); // no design
  const Json poles = Json::parse(R"({"edit": "set_extrema", "extrema": [
    {"at": {"point": [0, 0, -1]}, "maximum": false}, {"at": {"point": [0, 0, 1]}, "maximum": true}]})");
  REQUIRE(session.edit(poles, silent));
  const Json ring = Json::parse(R"({"edit": "subdivide_chart", "at": {"point": [1, 0, 0]}})");
  REQUIRE(session.edit(ring, silent));
  CHECK(session.offer(ring, silent)); // whether or not it would be refused
  const Result<Json> refused = session.edit(far, silent);
  REQUIRE(!refused);
  CHECK(refused.error().element == Element_kind::contour);
  const std::int64_t revision = session.revision();
  const Result<Json> offer = session.offer(far, silent);
  REQUIRE(bool(offer));
  REQUIRE(offer->is_object());
  CHECK(session.revision() == revision);
  CHECK((*offer)["words"].get<std::string>().find("of the way instead") != std::string::npos);
  CHECK((*offer)["place"].size() == 3);
  CHECK(session.offer((*offer)["edit"], silent)->is_null()); // it works: nothing else is needed
  REQUIRE(session.edit((*offer)["edit"], silent));
  CHECK(session.state()["history"].size() == 3);
  REQUIRE(session.undo());

  Recipe recipe;
  for (const Json& edit : {poles, ring, far}) recipe.edits.push_back(*edit_from_json(edit.dump()));
  const Result<void> followed = session.open_recipe("r.recipe.json", to_json(recipe), silent);
  REQUIRE(!followed);
  CHECK(followed.error().message.find("What works: Move it") != std::string::npos);
}

TEST_CASE("pictures and preferences are kept by the folder, and go with what they belong to") {
  const Temporary_folder folder;
  Silent silent;
  folder.write("a.obj", file_of("sphere", 800));
  Session session{Folder(folder.path(""))};
  REQUIRE(session.open_file("a.obj", silent));
  CHECK(!session.keep_picture("no picture"));
  CHECK(!session.keep_picture("data:image/webp;base64," + std::string(1 << 20, 'A')));
  REQUIRE(session.keep_picture("data:image/webp;base64,AAAA"));
  CHECK(session.sessions()[0]["picture"] == "data:image/webp;base64,AAAA");
  REQUIRE(session.store().save_preferences({{"shading", "flat"}}));
  CHECK(Session{Folder(folder.path(""))}.store().preferences()["shading"] == "flat");
  folder.write(".reebquad/preferences.json", "[1");
  CHECK(session.store().preferences() == Json::object());
  session.forget(session.state()["file"]["digest"]);
  CHECK(session.sessions().empty());
  CHECK(!std::filesystem::exists(
      folder.path(".reebquad/picture-" + session.state()["file"]["digest"].get<std::string>())));
}
