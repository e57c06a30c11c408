// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of the charts, connectivity textures, sampling and stitching, on tiny surfaces.
#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#include "layout_stages.h"

#include <algorithm>
#include <numeric>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Named_run {
  std::string name;
  Triangle_surface surface;
  stages::Stages run;
};

Named_run named(const std::string& name, Triangle_surface s, std::vector<int> minima, std::vector<int> maxima,
                std::vector<bool> loops = {}) {
  const Designed_field field = stages::harmonic(s, std::move(minima), std::move(maxima),
                                                Weight_kind::clamped_cotangent, std::move(loops));
  Result<stages::Stages> run = stages::run(s, field, 500);
  INFO(name << ": " << (run ? "" : run.error().message));
  REQUIRE(bool(run));
  return {name, std::move(s), std::move(*run)};
}

std::vector<Named_run> make_runs() {
  std::vector<Named_run> l;
  l.push_back(named("tetrahedron", tiny::tetrahedron(), {0}, {1}));
  l.push_back(named("octahedron", tiny::octahedron(), {0, 1}, {2, 3}));
  l.push_back(named("cube", tiny::cube(), {0}, {6, 7}));
  l.push_back(named("smallest torus", tiny::torus(3, 3), {0}, {4}));
  l.push_back(named("torus", tiny::torus(12, 9), {0}, {58}));
  l.push_back(named("double torus", tiny::double_torus(8, 6), {21}, {70, 80}));
  l.push_back(named("boxes", tiny::subdivided(tiny::boxes({"#####", "#.#.#", "#####"})), {0}, {40, 41}));
  l.push_back(named("disc", tiny::disc(7, 4), {0}, {}, {true}));
  l.push_back(named("cylinder with extrema", tiny::open_cylinder(8, 6), {20}, {38}, {true, false}));
  l.push_back(named("pair of pants", tiny::pair_of_pants(), {}, {}, {false, true, true}));
  return l;
}

const std::vector<Named_run>& runs() {
  static const std::vector<Named_run> all = make_runs();
  return all;
}

// Calls `visit(chart, map, index of the chart, run)` for every chart of every run.
template <class Visit> void for_each_chart(const Visit& visit) {
  for (const Named_run& r : runs())
    for (std::size_t c = 0; c < r.run.maps.size(); ++c) {
      INFO(r.name << ", chart " << c);
      visit(*r.run.layout.atlas.charts[c], r.run.maps[c], c, r.run);
    }
}

} // namespace

TEST_CASE("jumps are antisymmetric and cancel around every inner vertex and along every face") {
  for_each_chart(
      [](const Chart& chart, const Chart_parameterization& map, std::size_t, const stages::Stages&) {
        const Triangle_surface& mesh = chart.mesh;
        for (int h = 0; h < mesh.number_of_halfedges(); ++h)
          if (!mesh.is_boundary(h)) CHECK(map.jump(h) == -map.jump(mesh.opposite[h]));
        for (int f = 0; f < mesh.number_of_faces(); ++f)
          CHECK(map.jump(3 * f) + map.jump(3 * f + 1) + map.jump(3 * f + 2) == 0);
      });
}

TEST_CASE("no triangle of any map is flipped, U is 0 and 1 on the walks and between them inside") {
  for_each_chart(
      [](const Chart& chart, const Chart_parameterization& map, std::size_t, const stages::Stages&) {
        CHECK(map.flipped(chart) == 0);
        if (chart.kind != Chart_kind::annulus) return;
        std::vector<char> on_walk(chart.mesh.points.size(), 0);
        for (int w = 0; w < 2; ++w)
          for (int v : chart.walks[w].vertices) {
            on_walk[v] = 1;
            CHECK(map.u()[v] == w);
          }
        for (std::size_t v = 0; v < on_walk.size(); ++v)
          if (!on_walk[v]) CHECK((map.u()[v] > 0 && map.u()[v] < 1));
      });
}

TEST_CASE("natural V increases by 1 around each walk and the profile by the heights of its bands") {
  for_each_chart(
      [](const Chart& chart, const Chart_parameterization& map, std::size_t, const stages::Stages&) {
        if (chart.kind != Chart_kind::annulus) return;
        for (const Side side : {Side::low, Side::high}) {
          const std::vector<double>& v = map.natural(side);
          REQUIRE(v.size() == chart.walk(side).vertices.size() + 1);
          CHECK(v.back() - v.front() == Approx(1));
          for (std::size_t i = 1; i < v.size(); ++i) CHECK(v[i - 1] < v[i]);
        }
        const Height_profile& profile = map.profile();
        CHECK(profile.total() > 0);
        CHECK(std::is_sorted(profile.height.begin(), profile.height.end()));
        CHECK(profile.level_at(0) == 0);
        CHECK(profile.level_at(1) == 1);
        CHECK(profile.level_at(0.3) < profile.level_at(0.6));
      });
}

TEST_CASE("a cylinder is mapped by its height and its angle") {
  const Triangle_surface s = tiny::open_cylinder(12, 8, 3);
  const Designed_field field = stages::harmonic(s, {}, {}, Weight_kind::clamped_cotangent, {false, true});
  const Result<Reeb_layout> layout = make_layout(s, field);
  REQUIRE(bool(layout));
  REQUIRE(layout->atlas.charts.size() == 1);
  const Chart& chart = *layout->atlas.charts[0];
  Result<Chart_parameterization> map = Chart_parameterization::prepare(chart);
  REQUIRE(bool(map));
  CHECK(map->profile().total() == Approx(3));
  CHECK(map->profile().level_at(0.25) == Approx(0.25));
  for (double length : map->profile().length) CHECK(length == Approx(24 * std::sin(std::acos(-1.0) / 12)));
  for (std::size_t v = 0; v < chart.mesh.points.size(); ++v)
    CHECK(map->u()[v] == Approx(chart.mesh.points[v].z() / 3).margin(1e-12));
  REQUIRE(bool(map->solve_columns(chart, map->natural(Side::low), map->natural(Side::high))));
  for (int h = 0; h < chart.mesh.number_of_halfedges(); ++h) {
    const Point &p = chart.mesh.points[chart.mesh.source(h)], &q = chart.mesh.points[chart.mesh.target(h)];
    const double turn = std::atan2(p.x() * q.y() - p.y() * q.x(), p.x() * q.x() + p.y() * q.y());
    const double step = map->v()[chart.mesh.target(h)] + map->jump(h) - map->v()[chart.mesh.source(h)];
    // The weight of a diagonal is 0 and raised to 0.01, which bends V by a little.
    CHECK(step == Approx(turn / (2 * std::acos(-1.0))).margin(1e-3));
  }
}

TEST_CASE("the field's order of elimination changes a chart's map by rounding only, whatever it leaves out") {
  for (const Named_run& named : runs()) {
    INFO(named.name);
    Harmonic_field field(named.surface);
    CHECK(field.elimination_order().empty());
    REQUIRE(bool(field.set_constraint(0, 0)));
    REQUIRE(bool(field.solve()));
    const Atlas& atlas = named.run.layout.atlas;
    const std::vector<int> place = places_in(field.elimination_order());
    for (std::size_t c = 0; c < atlas.charts.size(); ++c) {
      const Chart& chart = *atlas.charts[c];
      std::vector<char> expected(chart.mesh.points.size());
      for (std::size_t v = 0; v < expected.size(); ++v)
        expected[v] =
            chart.vertex_origin[v] >= 0 && chart.vertex_origin[v] < named.surface.number_of_vertices();
      for (const Walk& walk : chart.walks)
        for (const int v : walk.vertices) expected[v] = 0;
      std::vector<int> order = elimination_order(chart, place);
      CHECK(elimination_order(chart, {}).empty());
      CHECK(int(order.size()) == std::count(expected.begin(), expected.end(), 1));
      for (int round = 0; round < 2; ++round) {
        const auto map = Chart_parameterization::prepare(chart, clamped_cotangent_weights(chart.mesh), order);
        REQUIRE(bool(map));
        if (chart.kind == Chart_kind::annulus)
          for (std::size_t v = 0; v < expected.size(); ++v)
            CHECK(map->u()[v] == Approx(named.run.maps[c].u()[v]).margin(1e-9));
        order.resize(order.size() / 2);
      }
    }
  }
}

TEST_CASE("points are found where they are") {
  for_each_chart(
      [](const Chart& chart, const Chart_parameterization& map, std::size_t, const stages::Stages&) {
        const bool periodic = chart.kind == Chart_kind::annulus;
        const auto at = [&](int f, const std::array<double, 3>& w) {
          const Triangle& t = chart.mesh.triangles[f];
          return std::pair(w[0] * map.v()[t[0]] + w[1] * (map.v()[t[1]] + map.jump(3 * f)) +
                               w[2] * (map.v()[t[2]] - map.jump(3 * f + 2)),
                           w[0] * map.u()[t[0]] + w[1] * map.u()[t[1]] + w[2] * map.u()[t[2]]);
        };
        tiny::Random random(7);
        std::vector<double> v, u;
        for (int i = 0; i < 200; ++i) {
          const double a = random.unit(), b = random.unit() * (1 - a);
          const auto [x, y] = at(random.below(chart.mesh.number_of_faces()), {a, b, 1 - a - b});
          v.push_back(periodic ? x - std::floor(x) : x);
          u.push_back(y);
        }
        const std::vector<Chart_location> found = locate(chart, map, v, u);
        REQUIRE(found.size() == v.size());
        for (std::size_t i = 0; i < v.size(); ++i) {
          const auto [face, w] = found[i];
          REQUIRE(face >= 0);
          CHECK(*std::min_element(w.begin(), w.end()) >= -1e-9);
          CHECK(w[0] + w[1] + w[2] == Approx(1));
          auto [x, y] = at(face, w);
          if (periodic) x -= std::round(x - v[i]);
          CHECK(x == Approx(v[i]).margin(1e-9));
          CHECK(y == Approx(u[i]).margin(1e-9));
        }
      });
}

TEST_CASE("a point outside of a disc's border, in a corner that it cuts off, is put on the border nearby") {
  // The cap around a corner of a tetrahedron has three border vertices, so four corners cannot all be
  // vertices.
  const Named_run& r = runs()[0];
  REQUIRE(r.name == "tetrahedron");
  for (std::size_t c = 0; c < r.run.maps.size(); ++c) {
    const Chart& chart = *r.run.layout.atlas.charts[c];
    if (chart.kind != Chart_kind::disc) continue;
    std::vector<char> on_border(chart.mesh.points.size(), 0);
    for (int v : chart.walks[0].vertices) on_border[v] = 1;
    const Chart_parameterization& map = r.run.maps[c];
    const auto [a, b] = r.run.sampling.grid[c];
    int outside = 0;
    for (const Chart_location& l :
         locate(chart, map, {0.0, double(a), double(a), 0.0}, {0.0, 0.0, double(b), double(b)}))
      for (int i = 0; i < 3; ++i) outside += l.weights[i] == 0 && !on_border[chart.mesh.triangles[l.face][i]];
    CHECK(outside >= 1);
  }
}

TEST_CASE("a regular texture of an annulus has its rows and columns, of a disc its four corners") {
  const Quad_texture ring = regular_annulus_texture(6, {0, 0.3, 1});
  CHECK(ring.v.size() == 18);
  CHECK(ring.quads.size() == 12);
  REQUIRE(ring.sides.size() == 2);
  for (int c = 0; c < 6; ++c) {
    CHECK(ring.u[ring.sides[0][c]] == 0);
    CHECK(ring.u[ring.sides[1][c]] == 1);
    CHECK(ring.v[ring.sides[0][c]] == Approx(c / 6.0));
  }
  for (const bool clockwise : {false, true}) {
    const Quad_texture disc = regular_disc_texture(3, 2, clockwise);
    CHECK(disc.v.size() == 12);
    CHECK(disc.quads.size() == 6);
    REQUIRE(disc.sides[0].size() == 10);
    const auto at = [&](int i) { return Point(disc.v[disc.sides[0][i]], disc.u[disc.sides[0][i]], 0); };
    CHECK(at(0) == Point(0, 0, 0));
    CHECK(at(clockwise ? 2 : 3) == (clockwise ? Point(0, 2, 0) : Point(3, 0, 0)));
    CHECK(at(5) == Point(3, 2, 0));
  }
}

TEST_CASE("every contour edge is sampled by one increasing parameter, whatever the blend") {
  for (const Named_run& r : runs())
    for (const double blend : {0.0, 0.5, 1.0}) {
      const auto parameter = contour_parameters(r.run.layout.embedding.surface.points, r.run.layout.network,
                                                r.run.layout.atlas, internal::pointers_to(r.run.maps), blend);
      REQUIRE(parameter.size() == r.run.layout.network.edges.size());
      for (std::size_t e = 0; e < parameter.size(); ++e) {
        INFO(r.name << ", contour " << e << ", blend " << blend);
        REQUIRE(parameter[e].size() == r.run.layout.network.edges[e].vertices.size());
        CHECK(parameter[e].front() == 0);
        CHECK(parameter[e].back() == 1);
        for (std::size_t i = 1; i < parameter[e].size(); ++i) CHECK(parameter[e][i - 1] < parameter[e][i]);
      }
    }
}

TEST_CASE("counts are even and at least 4 on loops, conserved through every chart, and rows are at least 2") {
  for_each_chart([](const Chart& chart, const Chart_parameterization&, std::size_t c,
                    const stages::Stages& run) {
    std::vector<int> sums;
    for (const Walk& walk : chart.walks) {
      sums.push_back(0);
      for (const Walk_edge& e : walk.edges) {
        const int n = run.samples.counts[e.edge];
        CHECK(n % 2 == 0);
        CHECK(n >= (run.layout.network.edges[e.edge].from == run.layout.network.edges[e.edge].to ? 4 : 2));
        sums.back() += n;
      }
      CHECK(walk_coordinates(walk, run.samples).back() == sums.back());
    }
    const std::array<int, 2> grid = run.sampling.grid[c];
    if (chart.kind == Chart_kind::annulus) {
      CHECK(sums[0] == sums[1]);
      CHECK(grid[0] == sums[0]);
      CHECK(grid[1] >= 2);
    } else {
      CHECK(2 * (grid[0] + grid[1]) == sums[0]);
    }
  });
}

TEST_CASE("the quads are certified: each edge twice, the right Euler characteristic, valences as predicted") {
  for (const Named_run& r : runs()) {
    INFO(r.name);
    const Quad_mesh& mesh = r.run.stitched.mesh;
    CHECK(stages::faults(mesh, r.surface, r.run.stitched.valences) == "");
    std::map<std::pair<int, int>, int> directed;
    for (const Quad& q : mesh.quads)
      for (int i = 0; i < 4; ++i) {
        CHECK(q[i] != q[(i + 2) % 4]);
        ++directed[{q[i], q[(i + 1) % 4]}];
      }
    int rim = 0;
    for (const auto& [edge, times] : directed) {
      CHECK(times == 1);
      rim += directed.count({edge.second, edge.first}) == 0;
    }
    CHECK((rim == 0) == boundary_loops(r.surface).empty());
  }
}

TEST_CASE("simple saddles on a closed surface: 4 E vertices of valence 3, S of valence 8, and sum (4 - "
          "valence) = 4 chi") {
  int simple = 0;
  for (const Named_run& r : runs()) {
    INFO(r.name);
    const Critical_points& critical = r.run.layout.critical;
    if (!boundary_loops(r.surface).empty()) continue;
    int sum = 0;
    for (const auto& [valence, number] : r.run.stitched.valences) sum += (4 - valence) * number;
    CHECK(sum == 4 * euler_characteristic(r.surface));
    std::map<int, int> wanted;
    wanted[3] = 4 * int(critical.minima.size() + critical.maxima.size());
    for (int k : critical.multiplicity) ++wanted[4 * (k + 1)];
    std::map<int, int> found = r.run.stitched.valences;
    found.erase(4);
    CHECK(found == wanted);
    simple +=
        !critical.saddles.empty() && critical.multiplicity == std::vector<int>(critical.saddles.size(), 1);
  }
  CHECK(simple > 0);
}

TEST_CASE("nodes are vertices of the quad mesh where they are on the surface") {
  for (const Named_run& r : runs())
    for (std::size_t i = 0; i < r.run.layout.network.nodes.size(); ++i)
      CHECK(r.run.stitched.mesh.points[r.run.stitched.node_vertex[i]] ==
            r.run.layout.embedding.surface.points[r.run.layout.network.nodes[i].vertex]);
}

TEST_CASE("collapsing a chart between saddles keeps the valences") {
  int collapsed = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    tiny::Random random(seed);
    const Triangle_surface s = seed % 2 == 0 ? tiny::subdivided(tiny::boxes({"#####", "#.#.#", "#####"}))
                                             : tiny::subdivided(tiny::double_torus(6, 5));
    const int a = random.below(s.number_of_vertices()), b = random.below(s.number_of_vertices());
    if (a == b) continue;
    Result<stages::Stages> run = stages::run(s, stages::harmonic(s, {a}, {b}), 600);
    REQUIRE(bool(run));
    std::map<int, int> wanted = run->stitched.valences;
    wanted.erase(4);
    for (std::size_t c = 0; c < run->maps.size(); ++c) {
      const Chart& chart = *run->layout.atlas.charts[c];
      if (chart.kind != Chart_kind::annulus) continue;
      Chart_parameterization& map = run->maps[c];
      Contour_network network = run->layout.network;
      REQUIRE(bool(map.solve_columns(chart, map.natural(Side::low), map.natural(Side::high))));
      if (!collapse_chart(s, chart, map, network)) continue;
      stages::Stages joined;
      joined.layout.critical = run->layout.critical;
      joined.layout.network = std::move(network);
      Result<Embedding> embedding = embed(s, joined.layout.network);
      if (!embedding) continue; // the lines met: the run keeps such a chart
      joined.layout.embedding = std::move(*embedding);
      Result<Atlas> atlas = build_atlas(joined.layout.embedding, joined.layout.network, {a, b});
      if (!atlas) continue;
      joined.layout.atlas = std::move(*atlas);
      joined.layout.graph = reeb_graph(joined.layout.atlas, joined.layout.network);
      INFO("seed " << seed << ", chart " << c);
      CHECK(joined.layout.atlas.charts.size() + 1 == run->layout.atlas.charts.size());
      REQUIRE(bool(stages::parameterize(joined)));
      REQUIRE(bool(stages::fill(joined, 600)));
      CHECK(stages::faults(joined.stitched.mesh, s, joined.stitched.valences) == "");
      for (const auto& part : joined.layout.atlas.charts) CHECK(stages::chords(*part) == 0);
      CHECK(joined.folds == 0); // long inlets of a joined contour leave U at 1 up to rounding
      std::map<int, int> found = joined.stitched.valences;
      found.erase(4);
      CHECK(found == wanted);
      ++collapsed;
    }
  }
  CHECK(collapsed >= 20);
}
