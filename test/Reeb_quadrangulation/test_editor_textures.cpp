// SPDX-License-Identifier: GPL-3.0-or-later
// Connectivity textures as edits of a design: each operator, what stays, what is refused, and that every
// state comes back.
#include "editor_sessions.h"

#include <CGAL/Reeb_quadrangulation/feature_edges.h>

using namespace CGAL::Reeb_quadrangulation;
using namespace sessions;
using Operator = Texture_operator;

namespace {

const Surface_point equator{Point(1, 0, 0), -1};

const Quad_texture& texture_at(const Editor& editor, const Surface_point& at) {
  return chart_at(editor, at).texture.texture;
}

// The quad of the texture around the equator that contains a point, and a point that means one of its parts.
int quad_near(const Editor& editor, const Surface_point& at) {
  const Design_chart& chart = chart_at(editor, at);
  int best = 0;
  double least = 1e300;
  for (std::size_t f = 0; f < chart.texture.texture.quads.size(); ++f) {
    const Texture_place place = quad_place(chart.texture.texture, int(f));
    if (const double d = (surface_point(chart, place).point - at.point).norm(); d < least) {
      least = d;
      best = int(f);
    }
  }
  return best;
}

Surface_point quad_point(const Editor& editor, const Surface_point& at, int quad) {
  return surface_point(chart_at(editor, at), quad_place(texture_at(editor, at), quad));
}

Surface_point edge_point(const Editor& editor, const Surface_point& at, int quad, int corner) {
  return surface_point(chart_at(editor, at), edge_place(texture_at(editor, at), {quad, corner}));
}

Surface_point vertex_point(const Editor& editor, const Surface_point& at, int quad, int corner) {
  return surface_point(chart_at(editor, at), vertex_place(texture_at(editor, at), {quad, corner}));
}

Edit_texture operation(Operator o, std::vector<Surface_point> points, double fraction = 0.5,
                       Edit_scope scope = Edit_scope::chart) {
  return {o, std::move(points), fraction, scope};
}

std::vector<Point> vertices_in_space(const Design_chart& chart) {
  std::vector<Point> points;
  for (const Chart_location& l : chart.texture.location) points.push_back(position(*chart.chart, l));
  return points;
}

bool has_vertex_at(const Stitched_mesh& quads, const Point& p) {
  return std::any_of(quads.mesh.points.begin(), quads.mesh.points.end(),
                     [&](const Point& q) { return (q - p).norm() < 1e-9; });
}

} // namespace

TEST_CASE("each operator on one chart changes this chart alone, and can be undone") {
  const Editor plain = sphere_session();
  const int q = quad_near(plain, equator);
  const Surface_point quad = quad_point(plain, equator, q), edge = edge_point(plain, equator, q, 0),
                      next = edge_point(plain, equator, q, 1), vertex = vertex_point(plain, equator, q, 0);
  const std::vector<Edit> edits{
      operation(Operator::subdivide, {equator}),
      operation(Operator::insert_polychord, {edge}, 0.4),
      operation(Operator::insert_polychord, {next}),
      operation(Operator::delete_polychord, {edge}),
      operation(Operator::inset_quads, {quad}, 0.3),
      operation(Operator::open_quad, {edge, next}),
      operation(Operator::close_quad, {vertex}),
      operation(Operator::rotate_edge, {edge}),
      operation(Operator::rotate_edge_back, {edge}),
      operation(Operator::rotate_vertex, {vertex}),
      operation(Operator::insert_doublet, {vertex}),
      Drag_vertices{{vertex}, quad, 0, Falloff::smooth, 2, 1, {}},
      Relax_texture{equator, 2, 0, {}, Edit_scope::chart},
  };
  for (const Edit& edit : edits) {
    Editor editor = sphere_session();
    const int id = chart_at(editor, equator).id;
    const Edit_report report = applied(editor, edit);
    CHECK(report.remeshed_charts == std::vector<int>{id});
    CHECK(report.new_charts.empty());
    CHECK(report.changed_counts.empty());
    for (const auto& chart : editor.design().charts) CHECK(chart->edited == (chart->id == id));
  }
}

TEST_CASE("the elements meant are those of the texture that are nearest") {
  Editor editor = sphere_session();
  const int q = quad_near(editor, equator);
  const Quad before = texture_at(editor, equator).quads[q];
  applied(editor, operation(Operator::inset_quads, {quad_point(editor, equator, q)}));
  const Quad_texture& after = texture_at(editor, equator);
  CHECK(std::none_of(after.quads.begin(), after.quads.end(), [&](const Quad& x) { return x == before; }));
  std::map<int, int> expected{
      {3, 12}, {5, 4}}; // eight corners of two caps, and a face of a cube: 4 x 3 inside, 4 x 5 around it
  CHECK(valences(editor) == expected);
}

TEST_CASE("a doublet of a design comes and goes") {
  Editor editor = sphere_session();
  const Bytes before = bytes_of(editor);
  const int q = quad_near(editor, equator);
  applied(editor, operation(Operator::insert_doublet, {vertex_point(editor, equator, q, 0)}));
  CHECK(valences(editor)[2] == 1);
  const Quad_texture& texture = texture_at(editor, equator);
  std::vector<int> quads(texture.v.size(), 0);
  for (const Quad& f : texture.quads)
    for (int v : f) ++quads[v];
  int doublet = -1, corner = 0;
  for (std::size_t f = 0; f < texture.quads.size() && doublet < 0; ++f)
    for (int i = 0; i < 4; ++i)
      if (quads[texture.quads[f][i]] == 2 && texture.u[texture.quads[f][i]] > 0 &&
          texture.u[texture.quads[f][i]] < 1) {
        doublet = int(f);
        corner = i;
      }
  REQUIRE(doublet >= 0);
  applied(editor, operation(Operator::remove_doublet, {vertex_point(editor, equator, doublet, corner)}));
  CHECK(bytes_of(editor).points.size() == before.points.size());
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
}

TEST_CASE("a chart subdivided alone is denser than its neighbours, whose textures stay, and coarsened it is "
          "as before") {
  Editor editor = sphere_session();
  const Charts before = charts_of(editor);
  const Bytes bytes = bytes_of(editor);
  const int id = chart_at(editor, equator).id;
  applied(editor, operation(Operator::subdivide, {equator}));
  CHECK(texture_at(editor, equator).quads.size() == 4 * before.at(id)->texture.texture.quads.size());
  const Stitched_mesh quads = editor.quads();
  CHECK(quads.t_junctions > 0);
  CHECK(!quads.interpolated.empty());
  const Surface_projector projector(editor.working_surface());
  for (int v : quads.interpolated) CHECK(projector.closest(quads.mesh.points[v]).squared_distance < 1e-24);
  applied(editor, operation(Operator::coarsen, {equator}));
  CHECK(bytes_of(editor) == bytes);
}

TEST_CASE(
    "all textures subdivided meet vertex by vertex: four times the quads, the same extraordinary vertices") {
  Editor editor = torus_session();
  const std::size_t quads = editor.quads().mesh.quads.size();
  const std::map<int, int> before = valences(editor);
  const Surface_point anywhere{editor.working_surface().points[0], -1};
  applied(editor, operation(Operator::subdivide, {anywhere}, 0.5, Edit_scope::surface));
  CHECK(editor.quads().t_junctions == 0);
  CHECK(editor.quads().mesh.quads.size() == 4 * quads);
  CHECK(valences(editor) == before);
}

TEST_CASE("a polychord goes on through all charts until it closes, and goes again the same way") {
  for (int corner : {0, 1}) {
    Editor editor = torus_session();
    const Surface_point at{Point(0, 0.9, 0), -1};
    const int q = quad_near(editor, at);
    const Surface_point edge = edge_point(editor, at, q, corner), middle = quad_point(editor, at, q);
    const std::map<int, int> before = valences(editor);
    const std::size_t quads = editor.quads().mesh.quads.size();
    applied(editor, operation(Operator::insert_polychord, {edge}, 0.3, Edit_scope::surface));
    CHECK(editor.quads().t_junctions == 0);
    CHECK(valences(editor) == before);
    CHECK(editor.quads().mesh.quads.size() > quads);
    // Of the two strips that it made of one, the wider is deleted: as many quads as before.
    const int wider = quad_near(editor, middle);
    Surface_point across = edge_point(editor, middle, wider, 0);
    for (int i = 1; i < 4; ++i)
      if (const Surface_point p = edge_point(editor, middle, wider, i);
          (p.point - edge.point).norm() < (across.point - edge.point).norm())
        across = p;
    applied(editor, operation(Operator::delete_polychord, {across}, 0.5, Edit_scope::surface));
    CHECK(editor.quads().t_junctions == 0);
    CHECK(valences(editor) == before);
    CHECK(editor.quads().mesh.quads.size() == quads);
  }
}

TEST_CASE("a vertex is dragged exactly to a point of its chart, and anchors stay") {
  Editor editor = sphere_session();
  const int q = quad_near(editor, equator);
  const Quad quad = texture_at(editor, equator).quads[q];
  const std::vector<Point> before = vertices_in_space(chart_at(editor, equator));
  const Surface_point to = quad_point(editor, equator, q), vertex = vertex_point(editor, equator, q, 0),
                      anchor = vertex_point(editor, equator, q, 1);
  applied(editor, Drag_vertices{{vertex}, to, 0.5, Falloff::linear, 2, 3, {anchor}});
  const std::vector<Point> after = vertices_in_space(chart_at(editor, equator));
  CHECK((after[quad[0]] - to.point).norm() < 1e-9);
  CHECK(after[quad[1]] == before[quad[1]]);
  int moved = 0;
  for (std::size_t v = 0; v < before.size(); ++v) moved += after[v] != before[v];
  CHECK(moved > 3);
  // Relaxed, the vertex goes back towards even spacing.
  applied(editor, Relax_texture{vertex, 20, 0.4, {}, Edit_scope::chart});
  CHECK((vertices_in_space(chart_at(editor, equator))[quad[0]] - before[quad[0]]).norm() <
        0.5 * (to.point - before[quad[0]]).norm());
}

TEST_CASE("vertices snap onto sharp edges and their corners") {
  Editor editor = session(shape("l-shape", 3000), extrema({1, 0.5, 0.1}, {{0.1, 0.5, 1}}), 200);
  const Feature_edges features = feature_edges(editor.working_surface(), 45);
  REQUIRE(!features.corners.empty());
  int snapped = 0, on_corners = 0;
  for (const auto& chart : std::vector<std::shared_ptr<const Design_chart>>(editor.design().charts))
    for (int f = 0; f < int(chart->texture.texture.quads.size()); f += 3) {
      const Surface_point p = surface_point(*chart, vertex_place(chart->texture.texture, {f, 2}));
      const Result<Edit_report> done = editor.apply(Snap_vertices{{p}, 45});
      if (!done) continue;
      ++snapped;
      const Stitched_mesh quads = editor.quads();
      for (int v : features.corners) on_corners += has_vertex_at(quads, editor.working_surface().points[v]);
      editor.undo();
    }
  CHECK(snapped > 3);
  CHECK(on_corners > 0);
}

TEST_CASE("an edited texture stays in its place to the bit when counts around it change") {
  Editor editor = sphere_session();
  applied(editor, Subdivide_chart{{Point(0.9, 0, 0.436), -1}});
  const int q = quad_near(editor, at(0.95, 0, -0.3));
  const Surface_point middle = quad_point(editor, at(0.95, 0, -0.3), q);
  applied(editor, operation(Operator::inset_quads, {middle}));
  const std::vector<Point> before = vertices_in_space(chart_at(editor, middle));
  const Quad_texture texture = texture_at(editor, middle);
  applied(editor, Lock_chart{middle, true});
  CHECK(vertices_in_space(chart_at(editor, middle)) == before);
  applied(editor, Lock_chart{middle, false});
  const Edit_report report = applied(editor, Set_target{900, 0});
  CHECK(!report.changed_counts.empty());
  CHECK(vertices_in_space(chart_at(editor, middle)) == before);
  CHECK(texture_at(editor, middle).quads == texture.quads);
  CHECK(editor.quads().t_junctions > 0);
  refused(editor, Lock_chart{middle, true},
          "the quads of a locked chart would be split where its neighbours are denser");
  applied(editor, Reset_texture{middle, Edit_scope::chart});
  CHECK(!chart_at(editor, middle).edited);
  CHECK(editor.quads().t_junctions == 0);
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
}

TEST_CASE("an edited texture stays when a contour of its chart moves") {
  for (const bool in_cap : {false, true}) {
    Editor editor = sphere_session();
    applied(editor, Subdivide_chart{{Point(0.9, 0, 0.436), -1}});
    const Surface_point place = in_cap ? at(0, 0, 1) : at(0.95, 0, -0.3);
    const int q = quad_near(editor, place), id = chart_at(editor, place).id;
    applied(editor, operation(Operator::inset_quads, {quad_point(editor, place, q)}));
    const std::vector<Quad> quads = texture_at(editor, place).quads;
    const Surface_point line = at(0.9, 0, 0.436), cap = at(0.3, 0, 0.95);
    const Edit_report report = applied(editor, in_cap ? Move_contour{cap, {0, 0, 0.85}, {0.1, 0, 1}, {}}
                                                      : Move_contour{line, {0, 0, 0.5}, {0.1, 0.1, 1}, {}});
    CHECK(std::count(report.removed_charts.begin(), report.removed_charts.end(), id) == 1);
    CHECK(report.lost_textures.empty());
    CHECK(chart_at(editor, place).edited);
    CHECK(chart_at(editor, place).id != id);
    CHECK(texture_at(editor, place).quads == quads);
    CHECK(valences(editor) == std::map<int, int>{{3, 12}, {5, 4}});
    const Edit_report again = applied(editor, in_cap ? Move_contour{cap, {0, 0, 0.8}, {0, 0.1, 1}, {}}
                                                     : Move_contour{line, {0, 0, 0.4}, {0, 0, 1}, {}});
    CHECK(again.lost_textures.empty());
    CHECK(texture_at(editor, place).quads == quads);
    applied(editor, Reset_texture{place, Edit_scope::chart});
    CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  }
}

TEST_CASE(
    "edited textures stay when a saddle moves with all its contours, and are made on the way back too") {
  Editor editor = torus_session();
  const Surface_point saddle = at(-0.6, 0, 0), other = at(0.6, 0, 0);
  // The chart below the saddle, whose texture is inset; an arm, which is subdivided alone, with a vertex that
  // is dragged; the other arm stays regular, and the chart above the other saddle has no contour of this one.
  const Surface_point below = at(-1, 0, 0.4), left = at(0, 1.4, 0), right = at(0, -1.4, 0),
                      far = at(1, 0, 0.4);
  for (const Surface_point& place : {below, far})
    applied(editor, operation(Operator::inset_quads, {quad_point(editor, place, quad_near(editor, place))}));
  applied(editor, operation(Operator::subdivide, {left}));
  const int q = quad_near(editor, left);
  const Surface_point vertex = vertex_point(editor, left, q, 0);
  applied(editor,
          Drag_vertices{{vertex}, {0.7 * vertex.point + 0.3 * quad_point(editor, left, q).point, -1}});
  REQUIRE(editor.quads().held_vertices.size() == 1);
  REQUIRE(editor.quads().t_junctions > 0);
  std::map<int, Quad_texture> textures; // by their identity
  for (const auto& chart : editor.design().charts)
    if (chart->edited) textures[chart->texture_id] = chart->texture.texture;
  const std::shared_ptr<const Design_chart> beyond =
      editor.design().charts.at(std::size_t(editor.chart_at(far)));
  REQUIRE(textures.size() == 3);
  const std::map<int, int> before = valences(editor);
  for (const double angle : {0.4, -0.3, 0.0}) {
    const Point to(-0.6 * std::cos(angle), 0.6 * std::sin(angle), 0);
    const Edit_report report = applied(editor, Move_saddle{saddle, {to, -1}});
    CHECK(report.new_charts.size() == 3);
    CHECK(report.lost_textures.empty());
    CHECK(editor.design().charts.at(std::size_t(editor.chart_at(far))) == beyond);
    std::size_t edited = 0;
    for (const auto& chart : editor.design().charts) {
      if (!chart->edited) continue;
      ++edited;
      REQUIRE(textures.count(chart->texture_id) == 1);
      const Quad_texture& was = textures.at(chart->texture_id);
      CHECK(chart->texture.texture.quads == was.quads);
      CHECK(chart->texture.texture.v == was.v);
      CHECK(chart->texture.texture.u == was.u);
      CHECK(bool(check_texture_plane(chart->texture.texture)));
    }
    CHECK(edited == 3);
    CHECK(!chart_at(editor, right).edited);
    CHECK(valences(editor) == before);
    CHECK(editor.quads().t_junctions > 0);
    const Result<Finished_design> finished = editor.finished_quads();
    REQUIRE(bool(finished));
    CHECK(stages::faults(finished->quads.mesh, editor.input(), finished->quads.valences,
                         finished->quads.components) == "");
    CHECK(editor.quads().held_vertices.empty()); // the dragged vertex has gone with the map
  }
  // A saddle that is cut otherwise takes the textures around it away, and the report says which.
  const int id = chart_at(editor, far).id;
  const Edit_report report = applied(editor, Split_saddle{other, Saddle_kind::half, {}, 0});
  CHECK(std::count(report.lost_textures.begin(), report.lost_textures.end(), id) == 1);
}

TEST_CASE("a chart that is cut anew loses its edited texture, and the report says so") {
  Editor editor = sphere_session();
  const int id = chart_at(editor, equator).id;
  applied(editor, operation(Operator::inset_quads, {equator}));
  const Edit_report report = applied(editor, Subdivide_chart{equator});
  CHECK(report.lost_textures == std::vector<int>{id});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
}

TEST_CASE("deleted quads are holes, and come back") {
  Editor editor = sphere_session();
  const Bytes before = bytes_of(editor);
  const int q = quad_near(editor, equator);
  const Surface_point quad = quad_point(editor, equator, q);
  applied(editor, operation(Operator::delete_quads, {quad}));
  CHECK(editor.quads().holes == 1);
  CHECK(editor.quads().held_vertices.size() == 4);
  CHECK(editor.quads().components == std::vector<std::pair<int, int>>{{1, 1}});
  const Result<Finished_design> finished = editor.finished_quads();
  REQUIRE(bool(finished));
  CHECK(stages::faults(finished->quads.mesh, editor.input(), finished->quads.valences,
                       finished->quads.components) == "");
  CHECK(stages::faults(finished->quads.mesh, editor.input(), finished->quads.valences) !=
        ""); // a hole that nobody predicted
  for (int v : finished->quads.held_vertices)
    CHECK(has_vertex_at(editor.quads(), finished->quads.mesh.points[std::size_t(v)]));
  CHECK(editor.quads().mesh.quads.size() == before.quads.size() - 1);
  applied(editor, operation(Operator::restore_quads, {quad}));
  CHECK(bytes_of(editor) == before);
}

TEST_CASE("texture edits that do not apply say why") {
  Editor editor = sphere_session();
  const int q = quad_near(editor, equator), id = chart_at(editor, equator).id;
  const Surface_point edge = edge_point(editor, equator, q, 0), vertex = vertex_point(editor, equator, q, 0);
  refused(editor, operation(Operator::rotate_edge, {}), "exactly one point is needed");
  refused(editor, operation(Operator::open_quad, {edge}), "two points are needed, one for each edge");
  refused(editor, operation(Operator::inset_quads, {}), "a point is needed for each quad");
  refused(editor, operation(Operator::rotate_edge, {edge}, 0.3), "the operator has no fraction");
  refused(editor, operation(Operator::rotate_edge, {edge}, 0.5, Edit_scope::surface),
          "the operator works in one chart");
  refused(editor, operation(Operator::open_quad, {edge, at(0, 0, 1)}), "the points lie in different charts");
  refused(editor, Snap_vertices{{vertex}, 45}, "the surface has no sharp edges");
  refused(editor, Reset_texture{equator, Edit_scope::surface}, "the texture is a regular one already");
  refused(editor, Drag_vertices{{}, equator}, "no points are given");
  refused(editor, Relax_texture{equator, 0}, "the radius is not negative, and the steps are 1 to 1000");
  const Result<Edit_report> done = editor.apply(operation(Operator::remove_doublet, {vertex}));
  REQUIRE(!done);
  CHECK(done.error().element == Element_kind::chart);
  CHECK(done.error().index == id);
  applied(editor, operation(Operator::inset_quads, {equator}));
  refused(editor, Set_rows{equator, 7}, "the chart's texture has been edited: reset it first");
  applied(editor, Lock_chart{equator, true});
  for (const Edit& edit :
       std::vector<Edit>{operation(Operator::subdivide, {equator}),
                         operation(Operator::subdivide, {at(0, 0, 1)}, 0.5, Edit_scope::surface),
                         Reset_texture{equator}, Relax_texture{equator}})
    refused(editor, edit, "the edit would change a locked chart");
}

TEST_CASE("the quads of a locked chart are not split by its neighbours' T-junctions") {
  Editor editor = sphere_session();
  applied(editor, Lock_chart{at(0, 0, 1), true});
  refused(editor, operation(Operator::subdivide, {equator}),
          "the quads of a locked chart would be split where its neighbours are denser");
  applied(editor, operation(Operator::inset_quads, {equator}));
}

TEST_CASE("a recipe with texture edits runs on another triangulation, with the same extraordinary vertices") {
  Editor editor = sphere_session();
  const int q = quad_near(editor, equator);
  applied(editor, operation(Operator::inset_quads, {quad_point(editor, equator, q)}));
  applied(editor, operation(Operator::insert_polychord,
                            {edge_point(editor, equator, quad_near(editor, at(0, 1, 0)), 0)}, 0.4,
                            Edit_scope::surface));
  const Recipe recipe = recipe_of(editor);
  Result<Editor> other = Editor::create(shape("sphere", 2000), recipe.options);
  REQUIRE(bool(other));
  for (const Edit& edit : recipe.edits) {
    const Result<Edit_report> done = other->apply(edit);
    INFO(to_json(edit) << (done ? "" : done.error().message));
    REQUIRE(bool(done));
  }
  CHECK(valences(*other) == valences(editor));
}

TEST_CASE("the members of texture edits go through JSON") {
  const std::vector<Edit> edits{
      operation(Operator::rotate_edge_back, {equator, at(1, 2, 3)}, 0.25, Edit_scope::surface),
      Drag_vertices{{equator}, at(0.1, 0.2, 0.3), 0.7, Falloff::linear, 3, 4, {at(1, 1, 1)}},
      Relax_texture{equator, 7, 0.3, {at(0, 1, 0)}, Edit_scope::surface},
      Snap_vertices{{equator}, 30},
      Reset_texture{equator, Edit_scope::surface},
      Fit_texture{equator, 30, Edit_scope::surface}};
  for (const Edit& edit : edits) {
    const Result<Edit> read = edit_from_json(to_json(edit));
    REQUIRE(bool(read));
    CHECK(to_json(*read) == to_json(edit));
  }
  CHECK(to_json(edits[0]).find("\"operator\":\"rotate_edge_back\"") != std::string::npos);
  CHECK(!edit_from_json(R"({"edit": "edit_texture", "operator": "turn", "points": []})"));
}

TEST_CASE("a texture edit that would fold quads of two charts onto each other is refused") {
  // At the end of a half-pole two quads of the cap meet; across its contour two others would have the same
  // corners.
  Editor editor = session(shape("sphere", 1200), extrema({0, 0, -1}, {{0, 0, 1}}), 32);
  applied(editor, Split_pole{at(0, 0, -1), Pole_kind::half, {}});
  const Surface_point pole = at(0, 0, -1);
  int folded = 0;
  for (int q = 0; q < int(texture_at(editor, pole).quads.size()); ++q)
    for (int i = 0; i < 4; ++i) {
      const Edit_texture turn = operation(Operator::rotate_vertex, {vertex_point(editor, pole, q, i)});
      const Result<Edit_report> done = editor.apply(turn);
      if (done) {
        const Stitched_mesh quads = editor.quads();
        CHECK(stages::faults(quads.mesh, editor.working_surface(), quads.valences, quads.components) == "");
        editor.undo();
      } else if (done.error().message == "quads of neighbouring charts would be folded onto each other" &&
                 ++folded == 1)
        refused(editor, turn, done.error().message);
    }
  CHECK(folded > 0);
}

namespace {

// A torus of four charts without an extraordinary vertex: two arms between two rectangles.
const Surface_point arm = at(0, 1.4, 0);

Editor regular_torus() {
  Editor editor = torus_session();
  for (const double x : {-0.6, 0.6}) applied(editor, Split_saddle{at(x, 0, 0), Saddle_kind::half, {}, 0});
  for (const double x : {-1.4, 1.4}) applied(editor, Pin_corners{at(x, 0, 0)});
  REQUIRE(valences(editor) == std::map<int, int>{});
  return editor;
}

// An edge from column to column: its polychord runs from row to row.
Surface_point edge_across(const Editor& editor, const Surface_point& at) {
  const int q = quad_near(editor, at);
  const Quad_texture& texture = texture_at(editor, at);
  const Quad& quad = texture.quads[std::size_t(q)];
  return edge_point(editor, at, q, std::abs(texture.u[quad[0]] - texture.u[quad[1]]) < 0.01 ? 0 : 1);
}

} // namespace

TEST_CASE(
    "a polychord that winds round a twisted torus is inserted and deleted, or refused with the reason") {
  std::vector<std::size_t> added;
  int deleted = 0;
  for (const int shift : {0, 1, 2, 3}) {
    INFO("shift " << shift);
    Editor editor = regular_torus();
    if (shift > 0) applied(editor, Set_shift{arm, shift});
    const Bytes before = bytes_of(editor);
    const Surface_point edge = edge_across(editor, arm);
    const auto quads = [&] {
      const Stitched_mesh now = editor.quads();
      CHECK(stages::faults(now.mesh, editor.working_surface(), now.valences, now.components) == "");
      CHECK(now.t_junctions == 0);
      CHECK(valences(editor) == std::map<int, int>{});
      return now.mesh.quads.size();
    };
    REQUIRE(editor.apply(operation(Operator::insert_polychord, {edge}, 0.5, Edit_scope::surface)));
    added.push_back(quads() - before.quads.size());
    editor.undo();
    CHECK(bytes_of(editor) == before);
    const Result<Edit_report> done =
        editor.apply(operation(Operator::delete_polychord, {edge}, 0.5, Edit_scope::surface));
    if (done) {
      ++deleted;
      CHECK(quads() < before.quads.size());
      editor.undo();
    } else
      CHECK((done.error().message == "the edit would invert a quad in the plane" ||
             done.error().message == "the edit would join two vertices by two edges"));
    CHECK(bytes_of(editor) == before);
  }
  CHECK(deleted >= 2);
  // Turned by a column, the arm sends the polychord round several times before it closes.
  CHECK(added[1] > added[0]);
}

TEST_CASE("a polychord that goes through large charts again and again is refused before any work is done") {
  const std::string reason = "the polychord goes through the charts too often before it closes: more than ";
  Editor editor = regular_torus();
  int refusals = 0;
  for (const int quads : {1200, 20000}) {
    REQUIRE(editor.apply(Set_target{quads, 0}));
    for (const int shift : {1, 2, 3, 4}) { // beyond the best fit: some of them wind many times
      REQUIRE(editor.apply(Set_shift{arm, shift}));
      const Result<Edit_report> done = editor.apply(
          operation(Operator::insert_polychord, {edge_across(editor, arm)}, 0.5, Edit_scope::surface));
      INFO(quads << " quads, shift " << shift << (done ? "" : ": " + done.error().message));
      if (done) {
        CHECK(valences(editor) == std::map<int, int>{});
        editor.undo();
        continue;
      }
      ++refusals;
      CHECK(quads == 20000);
      CHECK(done.error().code == Error_code::refused_edit);
      CHECK(done.error().element == Element_kind::chart);
      CHECK(done.error().message.substr(0, reason.size()) == reason);
      CHECK(std::stoi(done.error().message.substr(reason.size())) >= 64);
    }
  }
  CHECK(refusals > 0);
}

TEST_CASE("a concave quad can be subdivided, and polychords go across each of its edges") {
  Editor editor = sphere_session();
  const int q = quad_near(editor, equator);
  const Point corner = vertex_point(editor, equator, q, 0).point,
              across = vertex_point(editor, equator, q, 2).point;
  applied(editor, Drag_vertices{{{corner, -1}}, {corner + 0.6 * (across - corner), -1}});
  const Quad_texture texture = texture_at(editor, equator);
  const Quad quad = texture.quads[std::size_t(q)];
  const auto side = [&](int i) { // of the quad's corner i, as seen along the way from the corner before
    const auto p = [&](int k) {
      return Eigen::Vector2d(texture.v[quad[(i + k + 4) % 4]], texture.u[quad[(i + k + 4) % 4]]);
    };
    const Eigen::Vector2d a = p(0) - p(-1), b = p(1) - p(0);
    return a.x() * b.y() - a.y() * b.x();
  };
  REQUIRE(side(0) < 0);
  // Each of its edges can be named, also by what goes on through all charts; where that inverts a quad, the
  // reason is given.
  int inserted = 0;
  for (int i = 0; i < 4; ++i)
    for (const Edit_scope scope : {Edit_scope::chart, Edit_scope::surface}) {
      INFO("edge " << i);
      const Surface_point edge = edge_point(editor, equator, q, i);
      const Result<Edit_report> done =
          editor.apply(operation(Operator::insert_polychord, {edge}, 0.5, scope));
      if (!done) {
        CHECK(done.error().message == "the edit would invert a quad in the plane");
        continue;
      }
      ++inserted;
      editor.undo();
      applied(editor, operation(Operator::insert_polychord, {edge}, 0.5, scope));
      editor.undo();
    }
  CHECK(inserted >= 4);
  applied(editor, operation(Operator::subdivide, {equator}));
}

TEST_CASE("the final relaxation leaves dragged vertices where the user has put them") {
  Editor editor = sphere_session();
  const int q = quad_near(editor, equator);
  const Surface_point vertex = vertex_point(editor, equator, q, 0);
  const Point to = (0.6 * vertex.point + 0.4 * quad_point(editor, equator, q).point).normalized();
  applied(editor, Drag_vertices{{vertex}, {to, -1}, 0, Falloff::smooth, 2, 0, {}});
  const Stitched_mesh quads = editor.quads();
  REQUIRE(quads.held_vertices.size() == 1);
  const std::size_t v = std::size_t(quads.held_vertices[0]);
  CHECK((quads.mesh.points[v] - to).norm() < 0.02);
  CHECK(editor.finished_quads()->quads.mesh.points[v] == quads.mesh.points[v]);
  // Its number changes, its place does not.
  applied(editor, operation(Operator::subdivide, {equator}));
  REQUIRE(editor.quads().held_vertices.size() == 1);
  CHECK(editor.quads().mesh.points[std::size_t(editor.quads().held_vertices[0])] == quads.mesh.points[v]);
  applied(editor, Reset_texture{equator, Edit_scope::chart});
  CHECK(editor.quads().held_vertices.empty());
}

TEST_CASE("a vertex dragged onto a sharp edge, and one dragged off it, stay there") {
  Editor editor = session(shape("l-shape", 3000), extrema({1, 0.5, 0.1}, {{0.1, 0.5, 1}}), 200);
  int on = 0, off = 0;
  for (const auto& chart : std::vector<std::shared_ptr<const Design_chart>>(editor.design().charts))
    for (int f = 0; f < int(chart->texture.texture.quads.size()) && (on < 3 || off < 3); f += 5) {
      const Surface_point p = surface_point(*chart, vertex_place(chart->texture.texture, {f, 2}));
      const bool snaps = bool(editor.apply(Snap_vertices{{p}, 45}));
      if (!snaps) continue;
      Stitched_mesh quads = editor.quads();
      REQUIRE(quads.held_vertices.size() == 1);
      const std::size_t v = std::size_t(quads.held_vertices[0]);
      const Point sharp = quads.mesh.points[v];
      CHECK(editor.finished_quads()->quads.mesh.points[v] == sharp);
      ++on;
      // A little towards where it came from: near enough to be snapped back, were it not held.
      if (editor.apply(Drag_vertices{{{sharp, -1}}, {sharp + 0.2 * (p.point - sharp), -1}})) {
        quads = editor.quads();
        REQUIRE(quads.held_vertices.size() == 1);
        CHECK(editor.finished_quads()->quads.mesh.points[v] == quads.mesh.points[v]);
        off += quads.mesh.points[v] != sharp;
        editor.undo();
      }
      editor.undo();
    }
  CHECK(on >= 3);
  CHECK(off >= 1);
}
