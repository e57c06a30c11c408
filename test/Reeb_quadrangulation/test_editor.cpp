// SPDX-License-Identifier: GPL-3.0-or-later
// Each edit as a theorem on small shapes: what it changes, what it leaves alone, how it is refused, and that
// every state comes back.
#include "editor_sessions.h"

#include <algorithm>
#include <memory>

using namespace CGAL::Reeb_quadrangulation;
using namespace sessions;

namespace {

double longest_edge(const Triangle_surface& s) {
  double longest = 0;
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    longest = std::max(longest, (s.points[s.target(h)] - s.points[s.source(h)]).norm());
  return longest;
}

} // namespace

TEST_CASE("a session begins empty, and only extrema can be placed") {
  Result<Editor> made = Editor::create(shape("sphere", 1200), {});
  REQUIRE(bool(made));
  CHECK(made->design().charts.empty());
  CHECK(made->quads().mesh.quads.empty());
  CHECK(!made->can_undo());
  refused(*made, Subdivide_chart{at(1, 0, 0)}, "the design is empty: place extrema first");
  CHECK(bool(made->apply(Suggest{})));
  CHECK(!made->design().charts.empty());
  CHECK(made->position() == 1);
}

TEST_CASE("a session begins with a function of the user's own, and its recipe gives the same bytes") {
  // So coarse that the working copy is refined: the function's extrema stay where they are.
  const Triangle_surface s = tiny::torus(14, 8);
  Set_field edit;
  for (const Point& p : s.points) edit.values.push_back(p.x() + 0.1 * p.y() + 0.03 * p.z());
  Editor_options options;
  options.quads = 600;
  Result<Editor> made = Editor::create(s, options);
  REQUIRE(bool(made));
  REQUIRE(made->working_surface().number_of_vertices() > s.number_of_vertices());
  applied(*made, edit);
  const auto range = std::minmax_element(edit.values.begin(), edit.values.end());
  REQUIRE(made->design().extrema.size() == 2);
  for (const Design_extremum& e : made->design().extrema) {
    const auto extreme = e.is_maximum ? range.second : range.first;
    CHECK(made->working_surface().points[std::size_t(e.vertex)] ==
          s.points[std::size_t(extreme - edit.values.begin())]);
    CHECK(e.value == (e.is_maximum ? 1 : 0));
  }
  CHECK(valences(*made) == std::map<int, int>{{3, 8}, {8, 2}});

  applied(*made, Subdivide_chart{at(0, 1.4, 0)}); // further edits work on it
  const Result<Recipe> recipe = recipe_from_json(to_json(recipe_of(*made)));
  REQUIRE(bool(recipe));
  Result<Editor> again = Editor::create(s, recipe->options);
  REQUIRE(bool(again));
  for (const Edit& each : recipe->edits) applied(*again, each);
  CHECK(bytes_of(*again) == bytes_of(*made));
  made->undo();

  edit.values.pop_back();
  refused(*made, edit, "the function has 111 values, the surface 112 vertices");
}

TEST_CASE("a surface of two pieces is refused") {
  Triangle_surface two = tiny::octahedron();
  const int n = int(two.points.size());
  const std::vector<Triangle> first = two.triangles;
  for (int v = 0; v < n; ++v) two.points.push_back(two.points[v] + Point(9, 0, 0));
  for (Triangle t : first) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  const Result<Editor> made = Editor::create(tiny::connected(std::move(two)), {});
  REQUIRE(!made);
  CHECK(made.error().code == Error_code::not_a_surface);
}

TEST_CASE("an extremum is added, moved and removed inside its charts") {
  Editor editor = sphere_session();
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  const int south = chart_at(editor, at(0, 0, -1)).id;
  applied(editor, Add_extremum{at(1, 0, 0), true});
  CHECK(valences(editor) == std::map<int, int>{{3, 12}, {8, 1}});
  CHECK(editor.design().extrema.size() == 3);
  CHECK(editor.design().index_of(south) >= 0); // the cap far away is still there
  const Edit_report moved = applied(editor, Move_extremum{at(1, 0, 0), at(0.97, 0.2, 0)});
  CHECK(std::find(moved.removed_charts.begin(), moved.removed_charts.end(), south) ==
        moved.removed_charts.end());
  applied(editor, Remove_extremum{at(0.97, 0.2, 0)});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  refused(editor, Add_extremum{at(0, 0, 1), true}, "two extrema at one vertex");
  refused(editor, Add_extremum{at(1, 0, 0), true, Edit_scope::chart, 1},
          "the strength of an extremum is between 0 and 1");
}

TEST_CASE("the last minimum and the last maximum cannot be removed") {
  Editor editor = sphere_session();
  refused(editor, Remove_extremum{at(0, 0, 1)}, "the field needs at least one maximum");
  refused(editor, Remove_extremum{at(0, 0, -1)}, "the field needs at least one minimum");
}

TEST_CASE("extrema are edited on the whole surface, too") {
  Editor editor = sphere_session();
  applied(editor, Add_extremum{at(1, 0, 0), true, Edit_scope::surface});
  CHECK(valences(editor) == std::map<int, int>{{3, 12}, {8, 1}});
  applied(editor, Move_extremum{at(1, 0, 0), at(0, 1, 0), Edit_scope::surface});
  applied(editor, Change_value{at(0, 1, 0), 0.8});
  for (const Design_extremum& e : editor.design().extrema) {
    const bool east = (editor.working_surface().points[e.vertex] - Point(0, 1, 0)).norm() < 0.2;
    CHECK(e.value == (east ? 0.8 : e.is_maximum ? 1.0 : 0.0));
  }
  applied(editor, Remove_extremum{at(0, 1, 0), Edit_scope::surface});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  refused(editor, Change_value{at(0, 0, 1), 2}, "the value of an extremum is between 0 and 1");
}

TEST_CASE("boundaries stay minima and maxima as they are when extrema are edited on the whole surface") {
  for (const double up : {1.0, -1.0}) {
    Suggest turned;
    turned.axis = Eigen::Vector3d(0, 0, up);
    Editor editor = session(shape("cylinder", 2000), turned);
    const auto values = [&] {
      std::map<bool, double> value; // of the boundaries above and below
      const Contour_network& network = editor.design().network;
      for (const Contour_edge& e : network.edges)
        if (!network.is_removed(e) && network.nodes[e.from].kind == Node_kind::boundary)
          value[network.position(editor.working_surface(), e.vertices[0]).z() > 1.5] = e.value;
      return value;
    };
    const std::map<bool, double> before = values();
    REQUIRE(before.size() == 2);
    REQUIRE(before.at(false) != before.at(true));
    int side = 0; // the vertex half way up (from 0 to 3)
    const Triangle_surface& s = editor.working_surface();
    for (int v = 0; v < s.number_of_vertices(); ++v)
      if (std::abs(s.points[v].z() - 1.5) < std::abs(s.points[side].z() - 1.5)) side = v;
    REQUIRE(bool(editor.apply(Add_extremum{{s.points[side], side}, true, Edit_scope::surface, 0.9})));
    CHECK(values() == before);
  }
}

TEST_CASE("a chart is divided by the level line through a vertex, and made whole again") {
  Editor editor = sphere_session();
  const int annulus = chart_at(editor, at(1, 0, 0)).id;
  const std::vector<int> before = contours_of(editor);
  const Edit_report report = applied(editor, Subdivide_chart{at(1, 0, 0)});
  CHECK(report.removed_charts == std::vector<int>{annulus});
  CHECK(report.new_charts.size() == 2);
  CHECK(report.new_contours.size() == 1);
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  int nearest = 0;
  const Triangle_surface& s = editor.working_surface();
  for (int v = 1; v < s.number_of_vertices(); ++v)
    if ((s.points[v] - Point(1, 0, 0)).norm() < (s.points[nearest] - Point(1, 0, 0)).norm()) nearest = v;
  const std::vector<Point> line = points_of(editor, report.new_contours[0]);
  CHECK(std::count(line.begin(), line.end(), s.points[nearest]) == 2); // where the loop begins and ends
  applied(editor, Remove_contour{{line[1], -1}});
  CHECK(contours_of(editor) == before);
  applied(editor, Remove_contour{at(0, 0, 1)}); // two discs on one contour are fine
  CHECK(editor.design().charts.size() == 2);
  Editor torus = torus_session(); // a disc on a figure eight is not
  refused(torus, Remove_contour{at(1.4, 0, 0)}, "an extremum needs a cap: a contour of its own");
}

TEST_CASE("a contour moves to a plane") {
  Editor editor = sphere_session();
  applied(editor, Subdivide_chart{at(1, 0, 0)});
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, 0, 1).normalized();
  const Edit_report moved = applied(editor, Move_contour{at(1, 0, 0), {0, 0, 0}, normal, {}});
  REQUIRE(moved.new_contours.size() == 1);
  // Crossings keep a distance from the vertices: 3 % of their edge.
  const double margin = 0.03 * longest_edge(editor.working_surface());
  for (const Point& p : points_of(editor, moved.new_contours[0])) CHECK(std::abs(p.dot(normal)) <= margin);
  refused(editor, Move_contour{at(1, 0, -0.3), {0, 0, 5}, {0, 0, 1}, {}},
          "the plane does not meet the surface");
  refused(editor, Move_contour{at(1, 0, -0.3), {0, 0.99, 0}, {0, 1, 0}, {}},
          "the plane leaves the charts beside the contour: another contour is in the way");
}

TEST_CASE("a saddle moves with all its contours to the plane that touches the surface, and back") {
  Editor editor = torus_session();
  const std::map<int, int> before = valences(editor);
  const double margin = 0.03 * longest_edge(editor.working_surface());
  // Along the inner circle of the torus the touching plane meets it in a figure eight: both loops lie in it.
  for (const double angle : {0.0, 0.4, -0.4, 0.0}) {
    const Point to(-0.6 * std::cos(angle), 0.6 * std::sin(angle), 0);
    const Edit_report report = applied(editor, Move_saddle{at(-0.6, 0, 0), {to, -1}});
    CHECK(report.new_contours.size() == 2);
    CHECK(report.removed_contours.size() == 2);
    CHECK(report.new_charts.size() == 3);
    CHECK(valences(editor) == before);
    const Contour_network& network = editor.design().network;
    const Contour_edge &first = network.edges[std::size_t(report.new_contours[0])],
                       &second = network.edges[std::size_t(report.new_contours[1])];
    CHECK(first.from == first.to);
    CHECK(second.from == first.from);
    CHECK(second.to == first.from);
    CHECK(network.nodes[std::size_t(first.from)].kind == Node_kind::saddle);
    const Triangle_surface& s = editor.working_surface();
    const int saddle = network.nodes[std::size_t(first.from)].vertex;
    CHECK((s.points[std::size_t(saddle)] - to).norm() < longest_edge(s));
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const Triangle& t : s.triangles)
      if (std::find(t.begin(), t.end(), saddle) != t.end())
        normal += (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
    double farthest = 0; // along the contours, from the saddle
    for (int e : report.new_contours)
      for (const Point& p : points_of(editor, e)) {
        CHECK(std::abs((p - s.points[std::size_t(saddle)]).dot(normal.normalized())) <= margin);
        farthest = std::max(farthest, (p - s.points[std::size_t(saddle)]).norm());
      }
    CHECK(farthest > 1);
  }
}

TEST_CASE("a saddle stays in its charts, and locked charts stay as they are") {
  Editor editor = torus_session();
  const Surface_point saddle = at(-0.6, 0, 0);
  refused(editor, Move_saddle{saddle, at(-1.4, 0, 0)}, "the saddle would leave its charts");
  refused(editor, Move_saddle{saddle, at(1.3, 0, 0.2)}, "the saddle would leave its charts");
  applied(editor, Lock_chart{at(0, 1.4, 0), true});
  refused(editor, Move_saddle{saddle, saddle}, "the edit would change a locked chart");
  Editor sphere = sphere_session();
  refused(sphere, Move_saddle{at(1, 0, 0), at(1, 0, 0)}, "there is no saddle");
}

TEST_CASE("between two anchors a part of a contour moves alone") {
  Editor editor = sphere_session();
  applied(editor, Subdivide_chart{at(1, 0, 0)});
  applied(editor, Move_contour{at(1, 0, 0), {0, 0, 0}, {0, 0, 1}, {}});
  const std::vector<Point> before = points_of(editor, contours_of(editor).back());
  const Edit_report report =
      applied(editor, Move_contour{at(1, 0, 0), {0, 0, 0}, {0.5, 0, 1}, {at(0, 1, 0), at(0, -1, 0)}});
  REQUIRE(report.new_contours.size() == 2); // the part that moved, and the part that stayed
  int stayed = 0, lifted = 0;
  for (int e : report.new_contours)
    for (const Point& p : points_of(editor, e)) {
      stayed += std::find(before.begin(), before.end(), p) != before.end();
      lifted += std::abs(p.z() + 0.5 * p.x()) < 0.05 && p.x() > 0.3;
    }
  CHECK(stayed >= int(before.size()) / 3);
  CHECK(lifted >= 5);
  refused(editor, Remove_contour{at(-1, 0, 0)}, "the contour goes through a saddle or an anchor");
}

TEST_CASE("a contour is dragged to a vertex, and straightened") {
  Editor editor = session(shape("twisted-bar", 1500), extrema({0, 0, 0}, {{0, 0, 4}}));
  applied(editor, Subdivide_chart{at(0.5, 0, 2)});
  const Edit_report dragged = applied(editor, Drag_contour{at(0.5, 0, 2), at(-0.3, 0.5, 1.3)});
  REQUIRE(dragged.new_contours.size() == 1);
  const Edit_report tilted = applied(editor, Move_contour{at(-0.3, 0.5, 1.3), {0, 0, 1.5}, {0.4, 0, 1}, {}});
  REQUIRE(tilted.new_contours.size() == 1);
  const double loose = length(points_of(editor, tilted.new_contours[0]));
  const Edit_report tight = applied(editor, Straighten_contour{at(0, 0.5, 1.5)});
  REQUIRE(tight.new_contours.size() == 1);
  CHECK(length(points_of(editor, tight.new_contours[0])) < 0.98 * loose);
  refused(editor, Drag_contour{at(0, 0.5, 1.5), at(0, 0, 4)}, "the contour would leave its charts");
}

TEST_CASE("a contour snaps onto the sharp edges beside it") {
  Editor editor = session(shape("l-shape", 1500), extrema({2, 0.5, 0.5}, {{0.5, 0.5, 2}}));
  const Edit_report report = applied(editor, Snap_contour{at(1.8, 0, 0.5), 45});
  REQUIRE(report.new_contours.size() == 1);
  const std::vector<Point> line = points_of(editor, report.new_contours[0]);
  for (const Point& p : line) {
    CHECK(p.x() == 2); // the border of the end face
    CHECK((p.y() == 0 || p.y() == 1 || p.z() == 0 || p.z() == 1));
  }
  CHECK(length(line) == Approx(4));
  const auto is_integer = [](double x) { return x == std::round(x); };
  CHECK((is_integer(line[0].y()) && is_integer(line[0].z()))); // it begins at a corner
  Editor round = sphere_session();
  refused(round, Snap_contour{at(0, 0, 0.9), 45}, "no closed chain of sharp edges lies beside the contour");
}

TEST_CASE("saddles are joined on one contour, and the chart between them vanishes") {
  Editor editor = session(shape("bitorus", 2500), extrema({-1.35, 0, 0}, {{3.35, 0, 0}}), 500);
  const std::map<int, int> before = valences(editor);
  const std::size_t charts = editor.design().charts.size();
  applied(editor, Align_saddles{at(0.65, 0, 0), at(1.35, 0, 0)});
  CHECK(editor.design().charts.size() == charts - 1);
  CHECK(valences(editor) == before); // the saddles keep their valence
  refused(editor, Align_saddles{at(0.65, 0, 0), at(0.65, 0, 0)}, "two saddles are needed");
  refused(editor, Collapse_thin_charts{}, "no chart is thinner than half a quad and can be collapsed");
}

TEST_CASE("a pole is split into halves and put together again") {
  Editor editor = sphere_session();
  applied(editor, Split_pole{at(0, 0, 1), Pole_kind::half, {at(0.6, 0, 0.8), at(-0.6, 0, 0.8)}});
  CHECK(valences(editor) == std::map<int, int>{{2, 2}, {3, 4}});
  refused(editor, Split_pole{at(0, 0, 1), Pole_kind::half, {}}, "the pole is of this kind already");
  refused(editor, Move_extremum{at(0, 0, 1), at(0.1, 0, 1)}, "a half-pole: make it a quarter-pole first");
  applied(editor, Split_pole{at(0, 0, 1), Pole_kind::quarter, {}});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  refused(editor, Split_pole{at(0, 0, 1), Pole_kind::half, {at(0.6, 0, 0.8)}},
          "a half-pole needs two ends, or none");
}

TEST_CASE("a half-pole that a contour parts from its extremum becomes a pole at its own segment") {
  Editor editor = sphere_session();
  applied(editor, Split_pole{at(0, 0, 1), Pole_kind::half, {at(0.5, 0.3, 0.81), at(0.5, -0.3, 0.81)}});
  const std::vector<Design_extremum> before = editor.design().extrema;
  applied(editor, Subdivide_chart{at(0.4, 0, 0.91)}); // the pole is beyond
  applied(editor, Split_pole{at(0.5, 0, 0.86), Pole_kind::quarter, {}});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  const auto is_old = [&](const Design_extremum& e) {
    return std::any_of(before.begin(), before.end(),
                       [&](const Design_extremum& b) { return b.vertex == e.vertex; });
  };
  const std::vector<Design_extremum>& after = editor.design().extrema;
  CHECK(std::count_if(after.begin(), after.end(), is_old) == 1);
}

TEST_CASE("the corners of a cap move along its contour") {
  Editor editor = sphere_session();
  const int disc = chart_at(editor, at(0, 0, 1)).id;
  const Design_chart& before = chart_at(editor, at(0, 0, 1));
  const int n = 2 * (before.grid[0] + before.grid[1]);
  const int old = ((-before.texture.offset[0]) % n + n) % n;
  std::vector<Point> corners; // the vertices of valence 3 in the north
  const Stitched_mesh quads = editor.quads();
  std::vector<std::vector<int>> around(quads.mesh.points.size());
  for (const Quad& q : quads.mesh.quads)
    for (int i = 0; i < 4; ++i) around[q[i]].push_back(q[(i + 1) % 4]);
  Point next = Point::Zero();
  for (std::size_t v = 0; v < around.size(); ++v)
    if (around[v].size() == 3 && quads.mesh.points[v].z() > 0) {
      corners.push_back(quads.mesh.points[v]);
      for (int w : around[v]) // a neighbour along the cap's contour
        if (std::abs(quads.mesh.points[w].z() - quads.mesh.points[v].z()) < 0.05) next = quads.mesh.points[w];
      if (next != Point::Zero()) break;
    }
  REQUIRE(corners.size() == 1);
  REQUIRE(next != Point::Zero());
  const Edit_report report =
      applied(editor, Move_corner{{0.99 * corners[0] + Point(0, 0, 0.1), -1}, {next, -1}});
  CHECK(report.remeshed_charts == std::vector<int>{disc});
  CHECK(report.new_charts.empty());
  const int now = ((-chart_at(editor, at(0, 0, 1)).texture.offset[0]) % n + n) % n;
  CHECK(now != old);
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  refused(editor, Move_corner{at(1, 0, 0), at(0, 1, 0)}, "there is no cap with corners to move");
}

TEST_CASE("saddles are split: 8, twice 6, four times 5; with pinned corners a torus is regular") {
  Editor editor = torus_session();
  CHECK(valences(editor) == std::map<int, int>{{3, 8}, {8, 2}});
  applied(editor, Split_saddle{at(-0.6, 0, 0), Saddle_kind::quarter, {}, 0.25});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}, {5, 4}, {8, 1}});
  editor.undo();
  refused(editor, Pin_corners{at(-1.4, 0, 0)},
          "the contour around the cap does not pass half-saddles four times");
  applied(editor, Split_saddle{at(-0.6, 0, 0), Saddle_kind::half, {}, 0});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}, {6, 2}, {8, 1}});
  applied(editor, Split_saddle{at(0.6, 0, 0), Saddle_kind::half, {}, 0});
  CHECK(valences(editor) == std::map<int, int>{{3, 8}, {6, 4}});
  applied(editor, Pin_corners{at(-1.4, 0, 0)});
  CHECK(valences(editor) == std::map<int, int>{{3, 4}, {6, 2}});
  applied(editor, Pin_corners{at(1.4, 0, 0)});
  CHECK(valences(editor).empty());
  refused(editor, Split_saddle{at(0.6, 0, 0), Saddle_kind::half, {}, 0}, "there is no saddle");
  Editor other = torus_session();
  refused(other, Split_saddle{at(0.6, 0, 0), Saddle_kind::half, {at(0, 1, 0)}, 0},
          "half-saddles need two points, or none");
  refused(other, Split_saddle{at(0.6, 0, 0), Saddle_kind::quarter, {at(0, 1, 0)}, 0},
          "quarter-saddles need four points, or none");
  refused(other, Split_saddle{at(0.6, 0, 0), Saddle_kind::half, {}, -1}, "a size is not negative");
}

TEST_CASE("columns and rows are as they are asked for") {
  Editor editor = sphere_session();
  const Surface_point belt = at(1, 0, 0);
  const int id = chart_at(editor, belt).id;
  applied(editor, Set_columns{belt, 24});
  CHECK(chart_at(editor, belt).grid[0] == 24);
  for (int e : contours_of(editor)) CHECK(editor.design().samples.counts[e] == 24);
  const Edit_report rows = applied(editor, Set_rows{belt, 7});
  CHECK(chart_at(editor, belt).grid[1] == 7);
  CHECK(rows.remeshed_charts == std::vector<int>{id}); // rows are the chart's own business
  CHECK(rows.changed_counts.empty());
  applied(editor, Set_target{0, 0.6 * editor.design().edge_length});
  CHECK(chart_at(editor, belt).grid == std::array<int, 2>{{24, 7}}); // wishes outlive another size
  applied(editor, Set_columns{belt, 0});
  applied(editor, Set_rows{belt, 0});
  CHECK(chart_at(editor, belt).grid[1] != 7);
  refused(editor, Set_columns{belt, 7}, "the number of columns is even and at least 4, or 0");
  refused(editor, Set_rows{belt, 1}, "the number of rows is at least 2, or 0");
  refused(editor, Set_rows{at(0, 0, 1), 5}, "a disc has no columns and rows of its own");
}

TEST_CASE("the target sets the size of the quads") {
  Editor editor = sphere_session();
  applied(editor, Set_target{0, 0.1});
  CHECK(editor.design().edge_length == 0.1);
  applied(editor, Set_target{1000, 0});
  CHECK(std::abs(int(editor.quads().mesh.quads.size()) - 1000) < 100);
  refused(editor, Set_target{0, 0}, "either a number of quads or an edge length must be positive");
  refused(editor, Set_target{100, 0.1}, "either a number of quads or an edge length must be positive");
}

TEST_CASE("the upper contour of an annulus turns by columns") {
  Editor editor = sphere_session();
  const Surface_point belt = at(1, 0, 0);
  const Design_chart before = chart_at(editor, belt);
  const Edit_report report = applied(editor, Set_shift{belt, 3});
  CHECK(report.remeshed_charts == std::vector<int>{before.id});
  const Design_chart& after = chart_at(editor, belt);
  const int n = before.grid[0], low = after.texture.offset[0] - before.texture.offset[0],
            high = after.texture.offset[1] - before.texture.offset[1];
  const int turned = ((high - low) % n + n) % n;
  CHECK((turned == 3 || turned == n - 3));
  applied(editor, Set_shift{belt, 0});
  CHECK(chart_at(editor, belt).texture.offset == before.texture.offset);
}

TEST_CASE("rows become denser at one end") {
  // The rows of a cylinder are circles: their heights are the differences of z.
  Editor editor = session(shape("cylinder", 1200), Set_extrema{});
  REQUIRE(editor.design().charts.size() == 1);
  const Surface_point side = at(1, 0, 0);
  applied(editor, Set_rows{side, 6});
  applied(editor, Set_grading{side, 4});
  std::vector<double> z;
  for (const Point& p : editor.quads().mesh.points) z.push_back(p.z());
  std::sort(z.begin(), z.end());
  std::vector<double> levels{z[0]}; // rings are flat but for the surface's own roughness
  for (double value : z)
    if (value - levels.back() > 0.02 * (z.back() - z.front())) levels.push_back(value);
  REQUIRE(levels.size() == 7);
  const double lowest = levels[1] - levels[0], highest = levels[6] - levels[5];
  CHECK(std::max(highest / lowest, lowest / highest) == Approx(4).epsilon(0.15));
  refused(editor, Set_grading{side, 0}, "the ratio of the rows' heights is between 0.001 and 1000");
}

TEST_CASE("a locked chart stays, and edits that would change it are refused") {
  Editor editor = sphere_session();
  applied(editor, Subdivide_chart{at(1, 0, 0)});
  const Surface_point north = at(0.8, 0, 0.6), south = at(0.8, 0, -0.6);
  applied(editor, Lock_chart{north, true});
  const Design_chart locked = chart_at(editor, north);
  CHECK(locked.settings.locked);
  refused(editor, Set_rows{north, 5}, "the edit would change a locked chart");
  refused(editor, Set_shift{north, 1}, "the edit would change a locked chart");
  refused(editor, Subdivide_chart{north}, "the edit would change a locked chart");
  refused(editor, Remove_contour{at(1, 0, 0)}, "the edit would change a locked chart");
  applied(editor, Set_target{0, 0.5 * editor.design().edge_length});
  CHECK(chart_at(editor, north).texture.texture.quads == locked.texture.texture.quads);
  CHECK(chart_at(editor, north).grid == locked.grid);
  applied(editor, Set_rows{south, 9}); // elsewhere all is free
  applied(editor, Lock_chart{north, false});
  applied(editor, Set_rows{north, 5});
}

TEST_CASE("what was undone can be redone until another edit is applied") {
  Editor editor = sphere_session();
  applied(editor, Subdivide_chart{at(1, 0, 0)});
  applied(editor, Set_target{600, 0});
  editor.undo();
  editor.undo();
  CHECK(editor.position() == 1);
  CHECK(editor.edits().size() == 3);
  CHECK(recipe_of(editor).edits.size() == 1);
  refused(editor, Pin_corners{at(0, 0, 1)},
          "the contour around the cap does not pass half-saddles four times");
  CHECK(editor.can_redo()); // a refusal forgets nothing
  applied(editor, Set_target{200, 0});
  CHECK(!editor.can_redo());
  CHECK(editor.edits().size() == 2);
}

TEST_CASE("one thread or four: the same bytes") {
  const Triangle_surface torus = shape("torus", 1500);
  std::vector<Bytes> results;
  for (int threads : {1, 4}) {
    Editor_options options;
    options.quads = 400;
    options.threads = threads;
    Result<Editor> editor = Editor::create(torus, options);
    REQUIRE(bool(editor));
    for (const Edit& edit :
         {extrema({-1.4, 0, 0}, {{1.4, 0, 0}}), Edit(Split_saddle{at(-0.6, 0, 0), Saddle_kind::half, {}, 0}),
          Edit(Set_target{700, 0})})
      REQUIRE(bool(editor->apply(edit)));
    results.push_back(bytes_of(*editor));
  }
  CHECK(results[0] == results[1]);
}

TEST_CASE("a cancelled edit leaves everything as it was") {
  struct Impatient : Observer {
    bool cancelled() const override { return true; }
  } observer;
  Editor editor = sphere_session();
  const Bytes old = bytes_of(editor);
  const Result<Edit_report> done = editor.apply(Subdivide_chart{at(1, 0, 0)}, &observer);
  REQUIRE(!done);
  CHECK(done.error().code == Error_code::cancelled);
  CHECK(bytes_of(editor) == old);
}
