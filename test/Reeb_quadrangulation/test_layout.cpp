// SPDX-License-Identifier: GPL-3.0-or-later
// Contours on the surface, the charts between them, and the Reeb graph.
#include "layout_stages.h"

#include <CGAL/Reeb_quadrangulation/prepare_surface.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Named_layout {
  std::string name;
  Triangle_surface surface;
  Reeb_layout layout;
};

Named_layout named_layout(const std::string& name, Triangle_surface s, std::vector<int> minima,
                          std::vector<int> maxima, std::vector<bool> loops = {}) {
  const Designed_field field = stages::harmonic(s, std::move(minima), std::move(maxima),
                                                Weight_kind::clamped_cotangent, std::move(loops));
  Result<Reeb_layout> layout = make_layout(s, field);
  INFO(name << ": " << (layout ? "" : layout.error().message));
  REQUIRE(bool(layout));
  return {name, std::move(s), std::move(*layout)};
}

const std::vector<Named_layout>& layouts() {
  static const std::vector<Named_layout> all = [] {
    std::vector<Named_layout> l;
    l.push_back(named_layout("tetrahedron", tiny::tetrahedron(), {0}, {1}));
    l.push_back(named_layout("octahedron", tiny::octahedron(), {0, 1}, {2, 3}));
    l.push_back(named_layout("cube", tiny::cube(), {0}, {6, 7}));
    l.push_back(named_layout("smallest torus", tiny::torus(3, 3), {0}, {4}));
    l.push_back(named_layout("twisted torus", tiny::torus(3, 4, 0.4, 1), {0, 1}, {6}));
    l.push_back(named_layout("torus", tiny::torus(12, 9), {0}, {58}));
    l.push_back(named_layout("double torus", tiny::double_torus(3, 3), {0}, {14}));
    l.push_back(named_layout("larger double torus", tiny::double_torus(8, 6), {21}, {70, 80}));
    l.push_back(named_layout("figure of boxes", tiny::subdivided(tiny::boxes({"#####", "#.#.#", "#####"})),
                             {0}, {40, 41}));
    l.push_back(named_layout("disc", tiny::disc(7, 4), {0}, {}, {true}));
    l.push_back(named_layout("cylinder", tiny::open_cylinder(6, 5), {}, {}, {false, true}));
    l.push_back(named_layout("cylinder with extrema", tiny::open_cylinder(8, 6), {20}, {38}, {true, false}));
    l.push_back(named_layout("pair of pants", tiny::pair_of_pants(), {}, {}, {false, true, true}));
    return l;
  }();
  return all;
}

int wanted_loops(const Named_layout& l) {
  return stages::genus(l.surface);
}

} // namespace

TEST_CASE("every region is an annulus from a LOW to a HIGH walk, or a disc with one walk and one extremum") {
  for (const Named_layout& l : layouts()) {
    INFO(l.name);
    std::size_t discs = 0;
    for (const auto& shared_chart : l.layout.atlas.charts) {
      const Chart& chart = *shared_chart;
      const int chi = euler_characteristic(chart.mesh);
      const auto rims = boundary_loops(chart.mesh);
      REQUIRE(rims.size() == chart.walks.size());
      if (chart.kind == Chart_kind::annulus) {
        CHECK(chi == 0);
        REQUIRE(chart.walks.size() == 2);
        CHECK(chart.walks[0].side == Side::low);
        CHECK(chart.walks[1].side == Side::high);
        CHECK(chart.extremum < 0);
      } else {
        ++discs;
        CHECK(chi == 1);
        REQUIRE(chart.walks.size() == 1);
        const int v = chart.vertex_origin[chart.extremum];
        const auto& extrema =
            chart.walks[0].side == Side::low ? l.layout.critical.maxima : l.layout.critical.minima;
        CHECK(std::binary_search(extrema.begin(), extrema.end(), v));
      }
    }
    CHECK(discs == l.layout.critical.minima.size() + l.layout.critical.maxima.size());
  }
}

TEST_CASE("the charts' meshes are connected surfaces as connect() computes them") {
  for (const Named_layout& l : layouts())
    for (const auto& shared_chart : l.layout.atlas.charts) {
      const Chart& chart = *shared_chart;
      INFO(l.name);
      Triangle_surface anew = chart.mesh;
      REQUIRE(bool(anew.connect()));
      CHECK(anew.opposite == chart.mesh.opposite);
      CHECK(connected_components(anew).second == 1);
      for (int v = 0; v < anew.number_of_vertices(); ++v) {
        CHECK(chart.mesh.source(chart.mesh.outgoing[v]) == v);
        CHECK(chart.mesh.is_boundary(chart.mesh.outgoing[v]) == anew.is_boundary(anew.outgoing[v]));
      }
    }
}

TEST_CASE("no edge inside a chart joins two vertices of one walk") {
  for (const Named_layout& l : layouts())
    for (const auto& shared_chart : l.layout.atlas.charts) {
      const Chart& chart = *shared_chart;
      INFO(l.name);
      CHECK(stages::chords(chart) == 0);
    }
}

TEST_CASE("loops of the Reeb graph = genus where all saddles are simple") {
  for (const Named_layout& l : layouts()) {
    INFO(l.name);
    const auto& k = l.layout.critical.multiplicity;
    const bool simple = std::all_of(k.begin(), k.end(), [](int m) { return m == 1; });
    const Reeb_graph& graph = l.layout.graph;
    CHECK(graph.loops() == int(graph.arcs.size()) - graph.number_of_nodes() + 1);
    CHECK(graph.loops() <= wanted_loops(l));
    if (simple) CHECK(graph.loops() == wanted_loops(l));
  }
}

TEST_CASE("every contour edge has one LOW-side and one HIGH-side chart, a boundary loop one of them") {
  for (const Named_layout& l : layouts()) {
    INFO(l.name);
    const Contour_network& network = l.layout.network;
    std::vector<std::array<int, 2>> seen(network.edges.size(), {0, 0});
    for (std::size_t c = 0; c < l.layout.atlas.charts.size(); ++c)
      for (const Walk& walk : l.layout.atlas.charts[c]->walks)
        for (const Walk_edge& e : walk.edges) {
          ++seen[e.edge][walk.side == Side::low ? 0 : 1];
          CHECK(l.layout.atlas.charts_of_edge[e.edge][walk.side == Side::low ? 0 : 1] == int(c));
          CHECK(e.forward);
        }
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      if (network.nodes[network.edges[e].from].kind == Node_kind::boundary)
        CHECK(seen[e][0] + seen[e][1] == 1);
      else
        CHECK(seen[e] == std::array<int, 2>{1, 1});
    }
  }
}

TEST_CASE("embedding the contours leaves the geometry as it was") {
  for (const Named_layout& l : layouts()) {
    INFO(l.name);
    const Embedding& embedding = l.layout.embedding;
    const Triangle_surface& s = embedding.surface;
    Triangle_surface anew = s;
    REQUIRE(bool(anew.connect()));
    CHECK(anew.opposite == s.opposite);
    CHECK(euler_characteristic(s) == euler_characteristic(l.surface));
    std::vector<double> pieces(l.surface.number_of_faces(), 0.0);
    for (int f = 0; f < s.number_of_faces(); ++f) {
      const int base = embedding.base_face[f];
      pieces[base] += area(s, f);
      const Triangle &t = s.triangles[f], &b = l.surface.triangles[base];
      const Point n = (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
      const Point m = (s.points[b[1]] - s.points[b[0]]).cross(s.points[b[2]] - s.points[b[0]]);
      CHECK(n.dot(m) > 0);
    }
    for (int f = 0; f < l.surface.number_of_faces(); ++f)
      CHECK(pieces[f] == Approx(area(l.surface, f)).epsilon(1e-12));
  }
}

TEST_CASE("contours meet in nodes only and every crossing belongs to one contour") {
  for (const Named_layout& l : layouts()) {
    INFO(l.name);
    const Contour_network& network = l.layout.network;
    std::vector<int> uses(l.layout.embedding.surface.number_of_vertices(), 0);
    for (const Contour_edge& e : network.edges) {
      REQUIRE(e.vertices.size() == e.faces.size() + 1);
      CHECK(e.vertices.front() == network.nodes[e.from].vertex);
      CHECK(e.vertices.back() == network.nodes[e.to].vertex);
      for (std::size_t i = 1; i + 1 < e.vertices.size(); ++i) ++uses[e.vertices[i]];
    }
    std::vector<char> is_node(uses.size(), 0);
    for (const Contour_node& node : network.nodes) is_node[node.vertex] = 1;
    for (std::size_t v = 0; v < uses.size(); ++v) {
      if (is_node[v]) CHECK(uses[v] == 0);
      if (!is_node[v]) CHECK(uses[v] <= 1);
      if (!is_node[v] && network.is_crossing(int(v))) CHECK(uses[v] == 1);
    }
  }
}

TEST_CASE("crossings keep a distance on every edge") {
  for (const Named_layout& l : layouts()) {
    std::map<int, std::vector<double>> on_edge;
    for (const Edge_crossing& c : l.layout.network.crossings) on_edge[c.halfedge].push_back(c.t);
    for (auto& [edge, t] : on_edge) {
      CHECK(l.surface.edge(edge) == edge);
      const double gap = std::min(0.03, 1.0 / double(t.size() + 2)) * (1 - 1e-9);
      std::sort(t.begin(), t.end());
      CHECK(t.front() >= gap);
      CHECK(t.back() <= 1 - gap);
      for (std::size_t i = 1; i < t.size(); ++i) CHECK(t[i] - t[i - 1] >= gap);
    }
  }
}

TEST_CASE("a contour through a saddle of multiplicity k has k + 1 loops, the upper side on the left") {
  for (int n = 2; n <= 4; ++n) {
    const Triangle_surface s = tiny::subdivided(tiny::bipyramid(2 * n));
    std::vector<double> values(s.number_of_vertices(), 0.0);
    for (int v = 2; v < 2 * n + 2; ++v) values[v] = v % 2 == 0 ? 1 : -1;
    values[1] = -2;
    Vertex_order order = order_vertices(values);
    std::vector<int> maxima;
    for (int v = 2; v < 2 * n + 2; v += 2) maxima.push_back(v);
    remove_extrema(s, {1}, maxima, values, order);
    for (int v = 0; v < s.number_of_vertices(); ++v) {
      const Critical_points critical = critical_points(s, order);
      if (std::count(critical.minima.begin(), critical.minima.end(), v) +
          std::count(critical.maxima.begin(), critical.maxima.end(), v))
        continue;
      const auto saddle = std::find(critical.saddles.begin(), critical.saddles.end(), v);
      const int k =
          saddle == critical.saddles.end() ? 0 : critical.multiplicity[saddle - critical.saddles.begin()];
      const std::vector<Traced_contour> loops = trace_contour(s, order, v);
      REQUIRE(int(loops.size()) == k + 1);
      for (const Traced_contour& loop : loops)
        for (int h : loop.halfedges) {
          CHECK(order.rank[s.source(h)] < order.rank[v]);
          CHECK(order.rank[v] < order.rank[s.target(h)]);
        }
    }
  }
}

TEST_CASE("a figure eight visits its saddle twice from below and once from each side above") {
  // Two lobes above one body: the ring of a bipyramid goes up, down, up, down around the saddle at its top.
  const Triangle_surface s = tiny::bipyramid(4);
  const Designed_field field{{0, -2, 1, -1, 1, -1}, {1}, {2, 4}, {}};
  const Result<Reeb_layout> layout = make_layout(s, field);
  REQUIRE(bool(layout));
  CHECK(layout->critical.saddles == std::vector<int>{0});
  CHECK(layout->atlas.charts.size() == 6); // a body, two lobes, and a cap for each extremum
  std::vector<int> visits;
  for (const auto& chart : layout->atlas.charts)
    for (const Walk& walk : chart->walks)
      if (const int n = int(std::count_if(walk.vertices.begin(), walk.vertices.end(),
                                          [&](int v) { return chart->vertex_origin[v] == 0; }))) {
        visits.push_back(n);
        CHECK(walk.side == (n == 2 ? Side::high : Side::low));
        CHECK(int(walk.edges.size()) == n);
      }
  std::sort(visits.begin(), visits.end());
  CHECK(visits == std::vector<int>{1, 1, 2});
}

TEST_CASE("a monkey saddle on a torus may swallow the loop of the Reeb graph") {
  const Triangle_surface s = tiny::torus(3, 3);
  int found = 0, without_loop = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    tiny::Random random(seed);
    Designed_field field;
    for (int v = 0; v < 9; ++v) field.values.push_back(random.unit());
    const Critical_points critical = critical_points(s, order_vertices(field.values));
    if (critical.multiplicity != std::vector<int>{2}) continue;
    ++found;
    field.minima = critical.minima;
    field.maxima = critical.maxima;
    const Result<stages::Stages> run = stages::run(s, field, 200);
    REQUIRE(bool(run));
    CHECK(run->layout.graph.loops() <= 1);
    without_loop += run->layout.graph.loops() == 0;
    CHECK(stages::faults(run->stitched.mesh, s, run->stitched.valences).empty());
    CHECK(run->stitched.valences.at(12) == 1);
    CHECK(run->stitched.valences.at(3) == 8);
  }
  CHECK(found > 0);
  CHECK(without_loop > 0);
}

TEST_CASE("a field without a minimum or a maximum is refused") {
  const Triangle_surface s = tiny::octahedron();
  const std::vector<double> values(6, 0.0);
  for (const Designed_field& field :
       {Designed_field{values, {}, {1}, {}}, Designed_field{values, {1}, {}, {}}}) {
    const auto layout = make_layout(s, field);
    REQUIRE_FALSE(layout);
    CHECK(layout.error().code == Error_code::impossible_request);
  }
}

TEST_CASE("two boundary loops that an edge joins are refused, until the edge is split") {
  const Triangle_surface narrow = tiny::sheet({"#######", "##.#.##", "#######"});
  Designed_field field{std::vector<double>(narrow.number_of_vertices(), 0.5), {}, {}, {true, false, false}};
  const auto refused = make_layout(narrow, field);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == Error_code::impossible_request);
  CHECK(refused.error().element == Element_kind::vertex);
  CHECK(narrow.is_boundary(narrow.outgoing[refused.error().index]));

  const Result<Prepared_surface> prepared = prepare_surface(narrow);
  REQUIRE(bool(prepared));
  field.values.assign(prepared->surface.points.size(), 0.5);
  const auto layout = make_layout(prepared->surface, field);
  INFO((layout ? "" : layout.error().message));
  REQUIRE(bool(layout));
  CHECK(layout->atlas.charts.size() == 3);
}

TEST_CASE("a contour that crosses another one along an edge of the surface cannot be embedded") {
  const Triangle_surface s = tiny::octahedron();
  Contour_network network;
  network.surface_vertices = s.number_of_vertices();
  Contour_edge equator; // along edges
  equator.vertices = {0, 2, 1, 3, 0};
  equator.faces.assign(4, -1);
  equator.from = equator.to = add_node(network, 0);
  network.edges.push_back(equator);
  CHECK(bool(embed(s, network)));
  const auto around = [&](int vertex) { // a loop over all edges of a vertex
    Contour_edge loop;
    const int first = s.outgoing[vertex];
    int h = first;
    do {
      loop.vertices.push_back(add_crossing(network, {s.edge(h), 0.5}));
      loop.faces.push_back(h / 3);
      h = s.rotate_ccw(h);
    } while (h != first);
    loop.vertices.push_back(loop.vertices.front());
    loop.from = loop.to = add_node(network, loop.vertices.front());
    network.edges.push_back(std::move(loop));
  };
  around(4); // the pole: beside the equator
  CHECK(bool(embed(s, network)));
  around(0); // on the equator: over two of its edges
  std::vector<int> half{0, 1, 2, 3, 4, 5};
  for (const Result<Embedding>& refused : {embed(s, network), embed(s, network, half)}) {
    REQUIRE_FALSE(refused);
    CHECK(refused.error().element == Element_kind::face);
  }
}

TEST_CASE("an extremum that the field does not have is reported as lost") {
  // Two minima of equal value that are neighbours: the second is no minimum in any order.
  const Triangle_surface s = tiny::torus(8, 7);
  const Named_layout l = named_layout("adjacent minima", s, {0, s.target(s.outgoing[0])}, {30});
  CHECK(l.layout.lost_extrema.size() == 1);
  CHECK(l.layout.critical.minima.size() == 1);
  CHECK(named_layout("one minimum", s, {0}, {30}).layout.lost_extrema.empty());
}

TEST_CASE("a noisy field is cleaned before it is cut") {
  const Triangle_surface s = tiny::torus(8, 7);
  tiny::Random random(3);
  Designed_field field{{}, {5}, {33}, {}};
  for (int v = 0; v < s.number_of_vertices(); ++v) field.values.push_back(random.unit());
  const Result<Reeb_layout> layout = make_layout(s, field);
  REQUIRE(bool(layout));
  CHECK(layout->cleanup_rounds > 0);
  CHECK(layout->critical.minima == field.minima);
  CHECK(layout->critical.maxima == field.maxima);
}

namespace {

std::vector<double> values_on(const Triangle_surface& s,
                              const std::function<double(const Point&)>& function) {
  std::vector<double> values;
  for (const Point& p : s.points) values.push_back(function(p));
  return values;
}

} // namespace

TEST_CASE("a function's own extrema and critical contours are those of its layout") {
  const Triangle_surface s = tiny::torus(24, 12);
  const auto height = [](const Point& p) { return 7 + 1000 * (p.x() + 0.01 * p.y() + 0.003 * p.z()); };
  const std::vector<double> values = values_on(s, height);
  const Result<Designed_field> field = design_function(s, values);
  REQUIRE(bool(field));
  CHECK(field->minima ==
        std::vector<int>{int(std::min_element(values.begin(), values.end()) - values.begin())});
  CHECK(field->maxima ==
        std::vector<int>{int(std::max_element(values.begin(), values.end()) - values.begin())});
  CHECK(field->extremal_values.at(field->minima[0]) == 0);
  CHECK(field->extremal_values.at(field->maxima[0]) == 1);
  const Result<Reeb_layout> layout = make_layout(s, *field);
  REQUIRE(bool(layout));
  CHECK(layout->cleanup_rounds == 0);
  CHECK(layout->graph.loops() == 1);
  REQUIRE(layout->critical.saddles.size() == 2);
  const double low = *std::min_element(values.begin(), values.end()),
               range = *std::max_element(values.begin(), values.end()) - low;
  for (const Contour_edge& e : layout->network.edges)
    for (int node : {e.from, e.to})
      if (const Contour_node& n = layout->network.nodes[std::size_t(node)]; n.kind == Node_kind::saddle)
        CHECK(e.value == Approx((values[std::size_t(n.vertex)] - low) / range));
}

TEST_CASE("plateaus have one extremum each, and noise below the persistence has none") {
  const Triangle_surface s = tiny::torus(40, 20);
  tiny::Random random(7);
  std::vector<double> flat = values_on(s, [](const Point& p) { return std::clamp(p.x(), -1.2, 1.2); });
  const Result<Designed_field> plateaus = design_function(s, flat);
  REQUIRE(bool(plateaus));
  CHECK(plateaus->minima.size() == 1);
  CHECK(plateaus->maxima.size() == 1);
  for (double& value : flat) value += 0.02 * random.unit();
  const Result<Designed_field> noisy = design_function(s, flat), clean = design_function(s, flat, 0.05);
  REQUIRE(bool(noisy));
  REQUIRE(bool(clean));
  CHECK(noisy->minima.size() > 1);
  CHECK(clean->minima.size() == 1);
  CHECK(clean->maxima.size() == 1);
  const Result<Reeb_layout> layout = make_layout(s, *clean);
  REQUIRE(bool(layout));
  CHECK(layout->lost_extrema.empty());
  CHECK(layout->critical.minima == clean->minima);
  CHECK(layout->critical.maxima == clean->maxima);
}

TEST_CASE("boundary loops are minima and maxima of a function that is constant there, or it is refused") {
  const Triangle_surface s = tiny::open_cylinder(12, 9);
  const auto refused = [&](const Triangle_surface& on, std::vector<double> values, double persistence = 0) {
    const Result<Designed_field> field = design_function(on, values, persistence);
    REQUIRE(!field);
    CHECK(field.error().code == Error_code::impossible_request);
    return field.error();
  };
  std::vector<double> values = values_on(s, [](const Point& p) { return p.z(); });
  const Result<Designed_field> field = design_function(s, values);
  REQUIRE(bool(field));
  const auto loops = boundary_loops(s);
  const double highest = *std::max_element(values.begin(), values.end());
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(field->boundary_is_maximum[i] == (values[std::size_t(s.source(loops[i][0]))] == highest));
  const Result<Reeb_layout> layout = make_layout(s, *field);
  REQUIRE(bool(layout));
  CHECK(layout->atlas.charts.size() == 1);

  const Error ends = refused(s, values_on(s, [](const Point& p) { return p.x(); }));
  CHECK(ends.element == Element_kind::vertex);
  CHECK(s.is_boundary(s.outgoing[std::size_t(ends.index)]));
  // A slope across the loops, which are constant themselves.
  for (int v = 0; v < s.number_of_vertices(); ++v)
    values[std::size_t(v)] = s.is_boundary(s.outgoing[v]) ? 0 : s.points[std::size_t(v)].x();
  CHECK(refused(s, values).message.find("rises and falls") != std::string::npos);

  const Triangle_surface closed = tiny::octahedron();
  refused(closed, std::vector<double>(6, 3));
  refused(closed, std::vector<double>(5, 3));
  refused(closed, {0, 1, 2, std::numeric_limits<double>::quiet_NaN(), 4, 5});
  refused(closed, {0, 1, 2, 3, 4, std::numeric_limits<double>::infinity()});
  refused(closed, {0, 1, 2, 3, 4, 5}, 1);
  refused(closed, {0, 1, 2, 3, 4, 5}, -0.1);
  CHECK(bool(design_function(closed, {0, 1, 2, 3, -1.7e308, 1.7e308})));
}

TEST_CASE("an atlas built anew takes over every chart whose contours are the same") {
  for (const Named_layout& l : layouts()) {
    INFO(l.name);
    std::vector<int> extrema = l.layout.critical.minima, reused;
    extrema.insert(extrema.end(), l.layout.critical.maxima.begin(), l.layout.critical.maxima.end());
    Atlas previous = l.layout.atlas;
    const Result<Atlas> again =
        build_atlas(l.layout.embedding, l.layout.network, extrema, &previous, &reused);
    REQUIRE(bool(again));
    REQUIRE(again->charts.size() == l.layout.atlas.charts.size());
    for (std::size_t c = 0; c < reused.size(); ++c) {
      CHECK(reused[c] == int(c));
      CHECK(again->charts[c]->vertex_origin == l.layout.atlas.charts[c]->vertex_origin);
    }
  }
}
