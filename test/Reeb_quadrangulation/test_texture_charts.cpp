// SPDX-License-Identifier: GPL-3.0-or-later
// Textures of charts that are edited alone, and stitched all the same.
#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>

#include "layout_stages.h"
#include "tiny_textures.h"

#include <algorithm>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using Catch::Contains;

namespace {

struct Named_run {
  std::string name;
  Triangle_surface surface;
  stages::Stages run;
};

Named_run named(const std::string& name, Triangle_surface s, std::vector<int> minima, std::vector<int> maxima,
                std::vector<bool> loops = {}, int quads = 200) {
  const Designed_field field = stages::harmonic(s, std::move(minima), std::move(maxima),
                                                Weight_kind::clamped_cotangent, std::move(loops));
  Result<stages::Stages> run = stages::run(s, field, quads);
  REQUIRE(bool(run));
  return {name, std::move(s), std::move(*run)};
}

const std::vector<Named_run>& runs() {
  static const std::vector<Named_run> all = [] {
    std::vector<Named_run> l;
    l.push_back(named("octahedron", tiny::octahedron(), {0, 1}, {2, 3}));
    l.push_back(named("torus", tiny::torus(12, 9), {0}, {58}));
    l.push_back(named("double torus", tiny::double_torus(8, 6), {21}, {70, 80}));
    l.push_back(named("boxes", tiny::subdivided(tiny::boxes({"#####", "#.#.#", "#####"})), {0}, {40, 41}));
    l.push_back(named("disc", tiny::disc(7, 4), {0}, {}, {true}));
    l.push_back(named("cylinder with extrema", tiny::open_cylinder(8, 6), {20}, {38}, {true, false}));
    l.push_back(named("pair of pants", tiny::pair_of_pants(), {}, {}, {false, true, true}));
    return l;
  }();
  return all;
}

Result<Stitched_mesh> joined(const stages::Stages& run, const std::vector<Placed_texture>& textures,
                             const T_junction_options& options = {}) {
  return stitch_textures(run.layout.embedding.surface.points, run.layout.network, run.layout.atlas,
                         run.samples, internal::pointers_to(textures), options);
}

Result<Placed_texture> edited(const stages::Stages& run, const std::vector<Placed_texture>& textures, int c,
                              const Texture_edit& edit) {
  return edit_texture(textures[c], *run.layout.atlas.charts[c], run.maps[c], run.samples, edit);
}

/// A sentence if the mesh is not an all-quad manifold with the surface's Euler characteristic and the
/// predicted valences.
std::string fault(const Stitched_mesh& stitched, const Triangle_surface& s) {
  std::set<std::pair<int, int>> directed;
  std::vector<int> leaving(stitched.mesh.points.size(), 0), rim(stitched.mesh.points.size(), 0);
  for (const Quad& q : stitched.mesh.quads)
    for (int i = 0; i < 4; ++i) {
      ++leaving[q[i]];
      if (q[i] == q[(i + 2) % 4]) return "a quad has a vertex twice";
      if (!directed.insert({q[i], q[(i + 1) % 4]}).second) return "an edge is passed twice";
    }
  int edges = 0, boundary = 0;
  for (const auto& [a, b] : directed) {
    const bool inner = directed.count({b, a}) > 0;
    edges += !inner || a < b;
    boundary += !inner;
    if (!inner && ++rim[a] > 1) return "the boundary passes a vertex twice";
  }
  if ((boundary == 0) != boundary_loops(s).empty()) return "the mesh is not as open as the surface";
  if (int(stitched.mesh.points.size()) - edges + int(stitched.mesh.quads.size()) != euler_characteristic(s))
    return "the Euler characteristic is not the surface's";
  std::map<int, int> valences;
  for (std::size_t v = 0; v < leaving.size(); ++v)
    if (leaving[v] == 0)
      return "a vertex has no quad";
    else if (rim[v] == 0)
      ++valences[leaving[v]];
  return valences == stitched.valences ? "" : "the valences are not as predicted";
}

} // namespace

TEST_CASE("without edits, stitching by places is stitching by identity") {
  for (const Named_run& r : runs()) {
    INFO(r.name);
    const auto stitched = joined(r.run, r.run.textures);
    REQUIRE(stitched);
    CHECK(stitched->t_junctions == 0);
    CHECK(stitched->mesh.quads == r.run.stitched.mesh.quads);
    CHECK(stitched->valences == r.run.stitched.valences);
  }
}

TEST_CASE("a chart subdivided alone closes with its neighbours, whose quads away from it stay as they are") {
  for (const Named_run& r : runs())
    for (int c = 0; c < int(r.run.textures.size()); ++c) {
      INFO(r.name << ", chart " << c);
      std::vector<Placed_texture> textures = r.run.textures;
      const auto fine = edited(r.run, textures, c, Subdivide_texture{});
      REQUIRE(fine);
      textures[c] = *fine;
      T_junction_options options;
      options.may_end_on_boundary = false;
      const auto stitched = joined(r.run, textures, options);
      REQUIRE(stitched);
      CHECK(fault(*stitched, r.surface) == "");
      CHECK(stitched->t_junctions > 0);
      CHECK(!stitched->extraordinary.empty());
      CHECK(stages::faults(stitched->mesh, r.surface, stitched->valences) == "");
      // Quads whose corners are all old points are quads of the mesh before.
      std::set<std::vector<std::array<double, 3>>> before;
      const auto corners = [](const Quad_mesh& m, const Quad& q) {
        std::vector<std::array<double, 3>> p;
        for (int v : q) p.push_back({m.points[v].x(), m.points[v].y(), m.points[v].z()});
        return p;
      };
      std::size_t wanted = 0, kept = 0;
      for (const Quad& q : r.run.stitched.mesh.quads) before.insert(corners(r.run.stitched.mesh, q));
      for (std::size_t f = 0; f < stitched->mesh.quads.size(); ++f)
        kept += stitched->chart_of_quad[f] != c &&
                before.count(corners(stitched->mesh, stitched->mesh.quads[f])) > 0;
      for (int chart : r.run.stitched.chart_of_quad) wanted += chart != c;
      CHECK(kept + std::size_t(3 * stitched->t_junctions) >= wanted);
    }
}

TEST_CASE("all charts subdivided meet by identity again") {
  for (const Named_run& r : runs()) {
    INFO(r.name);
    std::vector<Placed_texture> textures = r.run.textures;
    for (int c = 0; c < int(textures.size()); ++c) {
      const auto fine = edited(r.run, textures, c, Subdivide_texture{});
      REQUIRE(fine);
      textures[c] = *fine;
    }
    const auto stitched = joined(r.run, textures);
    REQUIRE(stitched);
    CHECK(stitched->t_junctions == 0);
    CHECK(stitched->mesh.quads.size() == 4 * r.run.stitched.mesh.quads.size());
    CHECK(fault(*stitched, r.surface) == "");
    std::map<int, int> a = stitched->valences, b = r.run.stitched.valences;
    a.erase(4);
    b.erase(4);
    CHECK(a == b);
    for (int c = 0; c < int(textures.size()); ++c) {
      const auto coarse = edited(r.run, textures, c, Coarsen_texture{});
      REQUIRE(coarse);
      textures[c] = *coarse;
    }
    const auto back = joined(r.run, textures);
    REQUIRE(back);
    CHECK(back->mesh.quads == r.run.stitched.mesh.quads);
    CHECK(back->mesh.points == r.run.stitched.mesh.points);
  }
}

TEST_CASE("a polychord carried through all charts leaves no T-junction and no extraordinary vertex") {
  for (const Named_run& r : runs())
    for (int c = 0; c < int(r.run.textures.size()); ++c)
      for (int corner : {0, 1})
        for (double at : {0.5, 0.25}) {
          INFO(r.name << ", chart " << c);
          const Quad_texture& texture = r.run.textures[c].texture;
          const Chart_polychord start{c, {edge_place(texture, {int(texture.quads.size()) / 2, corner}), at}};
          const auto all = polychord_through_charts(r.run.layout.atlas, r.run.samples,
                                                    internal::pointers_to(r.run.textures), start);
          REQUIRE(all);
          std::vector<Placed_texture> textures = r.run.textures;
          for (const Chart_polychord& p : *all) {
            const auto next = edited(r.run, textures, p.chart, p.edit);
            if (!next) FAIL(next.error().message);
            textures[p.chart] = *next;
          }
          const auto stitched = joined(r.run, textures);
          REQUIRE(stitched);
          CHECK(stitched->t_junctions == 0);
          CHECK(fault(*stitched, r.surface) == "");
          std::map<int, int> a = stitched->valences, b = r.run.stitched.valences;
          CHECK(a[4] > b[4]);
          a.erase(4);
          b.erase(4);
          CHECK(a == b);
        }
}

TEST_CASE("edits keep the nodes of contours") {
  const stages::Stages& run = runs()[2].run;
  int refused = 0, applied = 0;
  for (int c = 0; c < int(run.textures.size()); ++c)
    for (int i = 0; i < int(run.textures[c].texture.sides[0].size()); ++i) {
      const Quad_texture& texture = run.textures[c].texture;
      std::vector<Placed_texture> textures = run.textures;
      const auto less =
          edited(run, textures, c, Delete_polychord{edge_place(texture, side_edge(texture, 0, i)), 0.5});
      if (!less) {
        ++refused;
        continue;
      }
      ++applied;
      textures[c] = *less;
      const auto stitched = joined(run, textures);
      REQUIRE(stitched);
      CHECK(stitched->t_junctions > 0);
      CHECK(fault(*stitched, runs()[2].surface) == "");
    }
  CHECK(applied > 0);
  CHECK(applied > refused);
}

TEST_CASE("holes open the mesh") {
  const Named_run& r = runs()[1];
  std::vector<Placed_texture> textures = r.run.textures;
  int c = 0;
  while (r.run.layout.atlas.charts[c]->kind != Chart_kind::annulus) ++c;
  const auto hole = edited(r.run, textures, c, Delete_quads{{quad_place(textures[c].texture, 0)}});
  REQUIRE(hole);
  textures[c] = *hole;
  const auto stitched = joined(r.run, textures);
  REQUIRE(stitched);
  CHECK(stitched->holes == 1);
  CHECK(stitched->mesh.quads.size() == r.run.stitched.mesh.quads.size() - 1);
  CHECK(stitched->mesh.points.size() == r.run.stitched.mesh.points.size());
  int inside = 0, before = 0;
  for (const auto& [valence, number] : stitched->valences) inside += number;
  for (const auto& [valence, number] : r.run.stitched.valences) before += number;
  CHECK(inside == before - 4);
}

TEST_CASE("a displacement along the surface moves a point of the texture along with it") {
  for (const Named_run& r : runs())
    for (std::size_t c = 0; c < r.run.textures.size(); ++c) {
      const Chart& chart = *r.run.layout.atlas.charts[c];
      const Chart_parameterization& map = r.run.maps[c];
      for (int f = 0; f < chart.mesh.number_of_faces(); f += 7) {
        const Triangle& t = chart.mesh.triangles[f];
        const Chart_location location{f, {{0.5, 0.25, 0.25}}};
        const Eigen::Vector3d d = 0.1 * (chart.mesh.points[t[1]] - chart.mesh.points[t[0]]);
        const Eigen::Vector2d p = parameter_displacement(chart, map, location, d);
        CHECK(p.x() == Approx(0.1 * (map.v()[t[1]] + map.jump(3 * f) - map.v()[t[0]])).margin(1e-12));
        CHECK(p.y() == Approx(0.1 * (map.u()[t[1]] - map.u()[t[0]])).margin(1e-12));
      }
    }
}

TEST_CASE("2,000 random refinements of single charts: watertight, all quads, valences as predicted") {
  tiny::Random random(20);
  int done = 0, junctions = 0;
  while (done < 2000) {
    const Named_run& r = runs()[random.below(int(runs().size()))];
    std::vector<Placed_texture> textures = r.run.textures;
    const int steps = 1 + random.below(3);
    for (int k = 0; k < steps; ++k) {
      const int c = random.below(int(textures.size()));
      const Quad_texture& t = textures[c].texture;
      if (t.quads.size() > 800) continue;
      const int w = random.below(int(t.sides.size()));
      const Texture_place edge = edge_place(t, side_edge(t, w, random.below(int(t.sides[w].size()))));
      const int kind = random.below(5);
      const Texture_edit edit = kind == 0   ? Texture_edit(Subdivide_texture{})
                                : kind == 1 ? Texture_edit(Delete_polychord{edge, random.unit()})
                                            : Texture_edit(Insert_polychord{edge, 0.1 + 0.8 * random.unit()});
      const auto next = edited(r.run, textures, c, edit);
      if (next) textures[c] = *next;
    }
    T_junction_options options;
    options.turn_cost = random.below(2) == 0 ? 4 : 1;
    const auto stitched = joined(r.run, textures, options);
    INFO(r.name << ", refinement " << done);
    if (!stitched) FAIL(stitched.error().message);
    const std::string wrong = fault(*stitched, r.surface);
    if (!wrong.empty()) FAIL(wrong);
    junctions += stitched->t_junctions;
    ++done;
  }
  CHECK(junctions > 2000);
}
