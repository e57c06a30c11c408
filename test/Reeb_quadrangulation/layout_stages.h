// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the stages from a field to the stitched quads one by one, keeping what each of them gives.
#ifndef REEBQUAD_TEST_LAYOUT_STAGES_H
#define REEBQUAD_TEST_LAYOUT_STAGES_H

#include "base/pointers_to.h"

#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/layout_sampling.h>
#include <CGAL/Reeb_quadrangulation/place_texture.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include "tiny_surfaces.h"

#include <string>
#include <vector>

namespace stages {

using namespace CGAL::Reeb_quadrangulation;

/// The harmonic field with value 0 on minima and 1 on maxima and boundary loops as they are labelled.
inline Designed_field harmonic(const Triangle_surface& s, std::vector<int> minima, std::vector<int> maxima,
                               Weight_kind weights = Weight_kind::clamped_cotangent,
                               std::vector<bool> boundary_is_maximum = {}) {
  Designed_field field{{}, std::move(minima), std::move(maxima), std::move(boundary_is_maximum)};
  Harmonic_field solver(s);
  solver.set_weights(weights);
  for (int v : field.minima) REQUIRE(bool(solver.set_constraint(v, 0)));
  for (int v : field.maxima) REQUIRE(bool(solver.set_constraint(v, 1)));
  const auto loops = boundary_loops(s);
  REQUIRE(loops.size() == field.boundary_is_maximum.size());
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (int h : loops[i])
      REQUIRE(bool(solver.set_constraint(s.source(h), field.boundary_is_maximum[i] ? 1 : 0)));
  const auto values = solver.solve();
  REQUIRE(bool(values));
  field.values = *values;
  return field;
}

/// Edges inside a chart that join two vertices of one walk: they would be mapped to the walk's line.
inline int chords(const Chart& chart) {
  std::vector<int> walk_of(chart.mesh.points.size(), -1);
  for (std::size_t w = 0; w < chart.walks.size(); ++w)
    for (int v : chart.walks[w].vertices) walk_of[v] = int(w);
  int count = 0;
  for (int h = 0; h < chart.mesh.number_of_halfedges(); ++h) {
    const int a = walk_of[chart.mesh.source(h)], b = walk_of[chart.mesh.target(h)];
    count += chart.mesh.opposite[h] > h && a >= 0 && a == b;
  }
  return count;
}

struct Stages {
  Reeb_layout layout;
  std::vector<Chart_parameterization> maps;
  std::vector<double> heights; ///< per chart
  Sampling sampling;           ///< counts per edge of the network
  Contour_samples samples;
  std::vector<Placed_texture> textures;
  Stitched_mesh stitched;
  int flipped = 0; ///< as the maps count
  int folds = 0;   ///< see `folds()`
};

/// Triangles of a chart's map that are turned over by more than the rounding of U and V, whose values
/// reach 1.
inline int folds(const Chart& chart, const Chart_parameterization& map) {
  int count = 0;
  for (int f = 0; f < chart.mesh.number_of_faces(); ++f) {
    const Triangle& t = chart.mesh.triangles[f];
    const double v1 = map.v()[t[1]] + map.jump(3 * f) - map.v()[t[0]],
                 v2 = map.v()[t[2]] - map.jump(3 * f + 2) - map.v()[t[0]];
    const double u1 = map.u()[t[1]] - map.u()[t[0]], u2 = map.u()[t[2]] - map.u()[t[0]];
    const double size = std::abs(v1) + std::abs(v2) + std::abs(u1) + std::abs(u2);
    count += v1 * u2 - v2 * u1 < -1e-14 * size;
  }
  return count;
}

/// Prepares the maps of all charts of `run.layout`.
inline Result<void> parameterize(Stages& run) {
  run.maps.clear();
  run.heights.clear();
  for (const auto& shared_chart : run.layout.atlas.charts) {
    const Chart& chart = *shared_chart;
    Result<Chart_parameterization> map = Chart_parameterization::prepare(chart);
    if (!map) return map.error();
    run.heights.push_back(chart.kind == Chart_kind::annulus ? map->profile().total() : 0);
    run.maps.push_back(std::move(*map));
  }
  return {};
}

/// Everything after the maps, for about `quads` quads.
inline Result<void> fill(Stages& run, int quads) {
  const Layout_sampling_problem problem = sampling_problem(run.layout, run.heights);
  Result<Sampling> sampling = sample_for_quads(problem.problem, quads);
  if (!sampling) return sampling.error();
  run.sampling = *sampling;
  run.sampling.counts.assign(run.layout.network.edges.size(), 0);
  for (std::size_t i = 0; i < problem.edges.size(); ++i)
    run.sampling.counts[problem.edges[i]] = sampling->counts[i];
  run.samples.counts = run.sampling.counts;
  run.samples.parameter = contour_parameters(run.layout.embedding.surface.points, run.layout.network,
                                             run.layout.atlas, internal::pointers_to(run.maps), 0.5);
  run.textures.clear();
  run.flipped = run.folds = 0;
  for (std::size_t c = 0; c < run.maps.size(); ++c) {
    const Chart& chart = *run.layout.atlas.charts[c];
    const std::array<int, 2> grid = run.sampling.grid[c];
    Result<Placed_texture> placed = chart.kind == Chart_kind::annulus
                                        ? place_annulus(chart, run.samples, grid[1], run.maps[c])
                                        : place_disc(chart, run.samples, grid[0], grid[1], run.maps[c]);
    if (!placed) return placed.error();
    run.textures.push_back(std::move(*placed));
    run.flipped += run.maps[c].flipped(chart);
    run.folds += folds(chart, run.maps[c]);
  }
  Result<Stitched_mesh> stitched =
      stitch_textures(run.layout.embedding.surface.points, run.layout.network, run.layout.atlas, run.samples,
                      internal::pointers_to(run.textures));
  if (!stitched) return stitched.error();
  if (stitched->t_junctions != 0)
    return make_error(Error_code::internal_error, "sides of charts do not meet sample by sample");
  run.stitched = std::move(*stitched);
  return {};
}

inline Result<Stages> run(const Triangle_surface& s, const Designed_field& field, int quads) {
  Stages result;
  Result<Reeb_layout> layout = make_layout(s, field);
  if (!layout) return layout.error();
  result.layout = std::move(*layout);
  if (Result<void> mapped = parameterize(result); !mapped) return mapped.error();
  if (Result<void> filled = fill(result, quads); !filled) return filled.error();
  return result;
}

/// A sentence for each check of topology and valences that failed. Tiny surfaces need not be embedded in
/// space, so nothing is asked about inside and outside.
inline std::string faults(const Quad_mesh& mesh, const Triangle_surface& s,
                          const std::map<int, int>& valences,
                          const std::vector<std::pair<int, int>>& components = {}) {
  Certificate_options options;
  options.measure_shape = options.find_self_intersections = false;
  const Certificate certificate = certify({mesh, &s, valences, components}, options);
  std::string text;
  for (const Certificate_check& check : certificate.checks)
    if (check.status == Check_status::failed && check.name != "outward" && check.name != "no_inverted_quads")
      text += check.name + ": " + check.message + "; ";
  return text;
}

inline int genus(const Triangle_surface& s) {
  return (2 - euler_characteristic(s) - int(boundary_loops(s).size())) / 2;
}

} // namespace stages

#endif // REEBQUAD_TEST_LAYOUT_STAGES_H
