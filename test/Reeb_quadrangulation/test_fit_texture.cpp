// SPDX-License-Identifier: GPL-3.0-or-later
// Textures whose edges lie on the sharp edges inside their charts.
#include "editor_sessions.h"
#include "model_files.h"

#include <CGAL/Reeb_quadrangulation/fit_texture.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include <iostream>

using namespace CGAL::Reeb_quadrangulation;
using namespace sessions;
using Operator = Texture_operator;

namespace {

const Surface_point anywhere{Point(0, 0, 0), -1};
const Fit_texture fit_all{anywhere, 45, Edit_scope::surface};

Editor sharp_session(const std::string& name, int quads) {
  return session(shape(name, 4000), Suggest{}, quads);
}

// The quads of a chart's texture, where they lie on the surface.
Quad_mesh quads_of(const Design_chart& chart) {
  Quad_mesh mesh;
  for (const Chart_location& l : chart.texture.location) mesh.points.push_back(position(*chart.chart, l));
  mesh.quads = chart.texture.texture.quads;
  return mesh;
}

// The length of the sharp edges inside the charts, and of the part that edges of the textures run along.
struct Covered {
  double all = 0, by_edges = 0;
  double part() const { return by_edges / all; }
};

double length_inside(const Chart& chart, const Triangle_surface& surface, double angle) {
  double sum = 0;
  for (const Feature_chain& chain : features_inside(chart, surface, angle).chains)
    for (int h : chain.halfedges)
      if (!chain.boundary)
        sum += (chart.mesh.points[chart.mesh.target(h)] - chart.mesh.points[chart.mesh.source(h)]).norm();
  return sum;
}

Covered covered(const Editor& editor) {
  Covered sum;
  for (const auto& chart : editor.design().charts) {
    const double length = length_inside(*chart->chart, editor.working_surface(), 45);
    if (!(length > 0)) continue;
    sum.all += length;
    sum.by_edges +=
        length * quad_statistics(quads_of(*chart), &chart->chart->mesh).covered_sharp_edges.value_or(0);
  }
  return sum;
}

double distance_to_sharp_edges(const Triangle_surface& s, const Point& p) {
  double least = 1e300;
  for (const Feature_chain& chain : feature_edges(s, 45).chains)
    for (int h : chain.halfedges) {
      const Point a = s.points[s.source(h)], way = s.points[s.target(h)] - a;
      const double t = std::min(1.0, std::max(0.0, way.dot(p - a) / way.squaredNorm()));
      least = std::min(least, (a + t * way - p).norm());
    }
  return least;
}

// What fitting must not change, and what it must not do to quads.
void check_fitted(const Design_chart& before, const Design_chart& after) {
  const Quad_texture &a = before.texture.texture, &b = after.texture.texture;
  CHECK(a.quads == b.quads);
  CHECK(a.sides == b.sides);
  CHECK(bool(check_texture_plane(b)));
  for (const std::vector<int>& side : a.sides)
    for (int v : side) {
      CHECK(a.v[v] == b.v[v]);
      CHECK(a.u[v] == b.u[v]);
    }
  const Quad_mesh was = quads_of(before), is = quads_of(after);
  int worse = 0;
  for (const Quad& q : a.quads) {
    const auto jacobian = [&](const std::vector<Point>& p) {
      return scaled_jacobian(p[q[0]], p[q[1]], p[q[2]], p[q[3]]);
    };
    worse += jacobian(is.points) < std::min(0.2, jacobian(was.points)) - 1e-9;
  }
  CHECK(worse == 0);
}

void check_fits(Editor& editor, double at_least) {
  const Charts before = charts_of(editor);
  const Covered was = covered(editor);
  applied(editor, fit_all);
  const Covered is = covered(editor);
  CHECK(is.all == was.all);
  CHECK(is.part() > was.part() + at_least);
  int fitted = 0;
  for (const auto& [id, chart] : charts_of(editor)) {
    if (chart == before.at(id)) continue;
    ++fitted;
    check_fitted(*before.at(id), *chart);
  }
  CHECK(fitted > 0);
  const Stitched_mesh quads = editor.quads();
  CHECK(quads.held_vertices.size() > 20);
  for (int v : quads.held_vertices)
    CHECK(distance_to_sharp_edges(editor.working_surface(), quads.mesh.points[std::size_t(v)]) < 1e-9);
}

Mesh_statistics finished(const Editor& editor) {
  const Result<Finished_design> quads = editor.finished_quads();
  REQUIRE(bool(quads));
  CHECK(stages::faults(quads->quads.mesh, editor.input(), quads->quads.valences, quads->quads.components) ==
        "");
  const Stitched_mesh raw = editor.quads();
  for (int v : raw.held_vertices)
    CHECK(quads->quads.mesh.points[std::size_t(v)] == raw.mesh.points[std::size_t(v)]);
  return quad_statistics(quads->quads.mesh, &editor.input());
}

} // namespace

TEST_CASE("edges of textures come to lie on the sharp edges inside the charts") {
  for (const char* name : {"l-shape", "twisted-bar"})
    for (const int quads : {200, 600}) {
      INFO(name << ", " << quads << " quads");
      Editor editor = sharp_session(name, quads);
      check_fits(editor, 0.25);
    }
}

TEST_CASE("what lies on sharp edges stays there, and the finished quads meet no less of them") {
  for (const char* name : {"l-shape", "twisted-bar"}) {
    INFO(name);
    Editor editor = sharp_session(name, 200);
    const Mesh_statistics plain = quad_statistics(editor.quads().mesh, &editor.input());
    applied(editor, fit_all);
    const Mesh_statistics raw = quad_statistics(editor.quads().mesh, &editor.input());
    const Mesh_statistics fitted = finished(editor);
    CHECK(*raw.covered_sharp_edges > *plain.covered_sharp_edges + 0.1);
    CHECK(*fitted.covered_sharp_edges >= *raw.covered_sharp_edges);
    CHECK(*fitted.folded_sharp_edges > 0.75);
    CHECK(fitted.inverted_quads == 0);
  }
  // The diagonals between vertices that are held on sharp edges are the ones that quads are cut along.
  Editor editor = sharp_session("l-shape", 600);
  applied(editor, fit_all);
  CHECK(*finished(editor).folded_sharp_edges > 0.95);
}

TEST_CASE("an edited texture is fitted too, and anchors stay where they are") {
  Editor editor = sharp_session("l-shape", 300);
  const int c = [&] {
    int best = 0;
    for (int i = 0; i < int(editor.design().charts.size()); ++i)
      if (editor.design().charts[std::size_t(i)]->texture.texture.quads.size() >
          editor.design().charts[std::size_t(best)]->texture.texture.quads.size())
        best = i;
    return best;
  }();
  const auto chart = [&]() -> const Design_chart& { return *editor.design().charts[std::size_t(c)]; };
  const auto vertex = [&](int quad) {
    return surface_point(chart(), vertex_place(chart().texture.texture, {quad, 2}));
  };
  const Surface_point inside = surface_point(chart(), quad_place(chart().texture.texture, 0));
  applied(editor, Edit_texture{Operator::subdivide, {inside}});
  const int quads = int(chart().texture.texture.quads.size());
  bool dragged = false;
  for (int q = quads / 2; q < quads && !dragged; ++q) {
    const Surface_point from = vertex(q);
    dragged = bool(editor.apply(Drag_vertices{
        {from},
        {0.8 * from.point +
             0.2 * quads_of(chart()).points[std::size_t(chart().texture.texture.quads[std::size_t(q)][0])],
         -1}}));
  }
  REQUIRE(dragged);
  const std::vector<int> held = anchored_vertices(chart().texture);
  REQUIRE(held.size() == 1);
  const std::size_t anchor = std::size_t(held[0]);
  const Design_chart before = chart();
  const int id = chart().id;
  const Edit_report report = applied(editor, Fit_texture{inside});
  CHECK(report.remeshed_charts == std::vector<int>{id});
  check_fitted(before, chart());
  CHECK(chart().texture.texture.v[anchor] == before.texture.texture.v[anchor]);
  CHECK(chart().texture.texture.u[anchor] == before.texture.texture.u[anchor]);
  CHECK(anchored_vertices(chart().texture).size() > 10);
  CHECK(quad_statistics(quads_of(chart()), &chart().chart->mesh).covered_sharp_edges >
        *quad_statistics(quads_of(before), &before.chart->mesh).covered_sharp_edges + 0.2);
  // Everything that was fitted is an anchor: a second time there is nothing left to do, or only other
  // vertices go.
  const std::vector<int> anchors = anchored_vertices(chart().texture);
  if (editor.apply(Fit_texture{inside})) {
    const std::vector<int> more = anchored_vertices(chart().texture);
    CHECK(more.size() > anchors.size());
    CHECK(std::includes(more.begin(), more.end(), anchors.begin(), anchors.end()));
  }
}

TEST_CASE("fitting again and again comes to an end, and says so") {
  Editor editor = sharp_session("twisted-bar", 200);
  int times = 0;
  Result<Edit_report> done = editor.apply(fit_all);
  for (; done && times < 20; ++times) done = editor.apply(fit_all);
  REQUIRE(!done);
  CHECK(times >= 1);
  refused(editor, fit_all, "no further vertex of the texture can be put onto the sharp edges");
}

TEST_CASE("where a contour moves, the texture goes with the map, and is fitted anew") {
  Editor editor = session(shape("twisted-bar", 4000), extrema({0, 0, 0}, {{0, 0, 4}}), 300);
  applied(editor, Subdivide_chart{at(0.5, 0, 2)});
  const Surface_point low = at(0.5, 0, 1.5);
  applied(editor, Fit_texture{low});
  const std::size_t held = editor.quads().held_vertices.size();
  CHECK(held > 10);
  const Edit_report report = applied(editor, Move_contour{at(0.5, 0, 2), {0, 0, 2.3}, {0, 0, 1}, {}});
  CHECK(report.lost_textures.empty());
  CHECK(chart_at(editor, low).edited);
  CHECK(editor.quads().held_vertices.empty());
  const Covered was = covered(editor);
  applied(editor, Fit_texture{low});
  CHECK(covered(editor).part() > was.part() + 0.05);
  for (int v : editor.quads().held_vertices)
    CHECK(distance_to_sharp_edges(editor.working_surface(), editor.quads().mesh.points[std::size_t(v)]) <
          1e-9);
}

TEST_CASE("where nothing is sharp, the edit says why it does not apply") {
  Editor sphere = sphere_session();
  const Surface_point belt{Point(1, 0, 0), -1};
  refused(sphere, Fit_texture{belt, 45}, "no sharp edge lies inside the chart: none of more than 45 degrees");
  refused(sphere, Fit_texture{belt, 22.5, Edit_scope::surface},
          "no sharp edge lies inside a chart: none of more than 22.5 degrees");
  for (const double angle : {0.0, -3.0, 181.0})
    refused(sphere, Fit_texture{belt, angle}, "the feature angle lies between 0 and 180 degrees");
  Editor bar = sharp_session("twisted-bar", 200);
  refused(bar, Fit_texture{anywhere, 170, Edit_scope::surface},
          "no sharp edge lies inside a chart: none of more than 170 degrees");
  const Surface_point middle{bar.working_surface().points[0], -1};
  applied(bar, Lock_chart{middle, true});
  refused(bar, Fit_texture{middle}, "the edit would change a locked chart");
  refused(bar, fit_all, "the edit would change a locked chart");
}

TEST_CASE("edges that only the cutting of charts has made are not sharp, whatever rounding does to them") {
  Editor editor = sharp_session("l-shape", 300);
  double sharp = 0, all = 0;
  for (const auto& chart : editor.design().charts) {
    sharp += length_inside(*chart->chart, editor.working_surface(), 45);
    all += length_inside(*chart->chart, editor.working_surface(), 0.01); // all faces are flat
  }
  CHECK(sharp > 10);
  CHECK(all == sharp);
}

TEST_CASE("the textures of the fandisk are fitted", "[models]") {
  const std::optional<Triangle_surface> fandisk = model("fandisk.obj");
  if (!fandisk) return;
  Editor editor = session(*fandisk, Suggest{}, 600);
  const Mesh_statistics plain = finished(editor);
  check_fits(editor, 0.25);
  const Mesh_statistics fitted = finished(editor);
  CHECK(*fitted.covered_sharp_edges > *plain.covered_sharp_edges - 0.02);
  CHECK(fitted.inverted_quads <= plain.inverted_quads);
  std::cout << "fandisk, 600 quads: by edges " << *plain.covered_sharp_edges << ", fitted "
            << *fitted.covered_sharp_edges << '\n';
}
