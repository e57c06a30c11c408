// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include "base/parallel_for.h"
#include "base/pointers_to.h"
#include "base/stage_clock.h"
#include "features/finisher.h"
#include <CGAL/Reeb_quadrangulation/place_texture.h>
#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The nearest vertex that is not on the boundary, or -1.
int nearest_vertex(const Triangle_surface& s, const Point& p) {
  int best = -1;
  for (int v = 0; v < s.number_of_vertices(); ++v)
    if (s.outgoing[v] >= 0 && !s.is_boundary(s.outgoing[v]) &&
        (best < 0 || (s.points[v] - p).squaredNorm() < (s.points[best] - p).squaredNorm()))
      best = v;
  return best;
}

} // namespace

Result<Designed_field> choose_extrema(const Triangle_surface& surface, const Quadrangulation_options& options,
                                      Observer* observer) {
  Designed_field field;
  Result<Suggestion> suggested = suggest_extrema(surface, options.suggestion, observer);
  if (!suggested) return suggested.error();
  field.boundary_is_maximum = suggested->boundary_is_maximum;
  if (options.extrema.empty()) {
    for (const Suggested_extremum& e : suggested->extrema)
      (e.is_maximum ? field.maxima : field.minima).push_back(e.vertex);
  } else {
    for (const Placed_extremum& e : options.extrema)
      (e.is_maximum ? field.maxima : field.minima).push_back(nearest_vertex(surface, e.point));
  }
  for (auto* list : {&field.minima, &field.maxima}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  for (int v : field.minima)
    if (std::binary_search(field.maxima.begin(), field.maxima.end(), v))
      return make_error(Error_code::impossible_request, "a vertex is asked to be a minimum and a maximum",
                        Element_kind::vertex, v);
  return field;
}

Result<void> solve_field(const Triangle_surface& surface, const Quadrangulation_options& options,
                         Designed_field& field) {
  Harmonic_field harmonic(surface);
  harmonic.set_weights(options.weights);
  harmonic.set_method(options.constraints);
  harmonic.set_threads(internal::number_of_threads(options.threads));
  return solve_field(surface, harmonic, field);
}

namespace {

using internal::Finisher;

class Pipeline {
public:
  Pipeline(const Triangle_surface& input, const Quadrangulation_options& options, Observer* observer)
      : m_input(input), m_options(options), m_clock(observer, m_result.stages) {
    m_threads = internal::number_of_threads(options.threads);
  }

  Result<Quadrangulation> run() {
    using Step = Result<void> (Pipeline::*)();
    const std::pair<const char*, Step> steps[] = {{"check", &Pipeline::check},
                                                  {"prepare", &Pipeline::prepare},
                                                  {"extrema", &Pipeline::choose_extrema},
                                                  {"field", &Pipeline::solve_field},
                                                  {"layout", &Pipeline::cut},
                                                  {"charts", &Pipeline::parameterize},
                                                  {"thin charts", &Pipeline::collapse},
                                                  {"sampling", &Pipeline::sample},
                                                  {"textures", &Pipeline::place},
                                                  {"stitching", &Pipeline::join},
                                                  {"relaxation", &Pipeline::relax}};
    for (const auto& [name, step] : steps) {
      if (!m_clock.begin(name)) return make_error(Error_code::cancelled, "cancelled by the user");
      if (Result<void> done = (this->*step)(); !done) return done.error();
      m_clock.end();
    }
    return std::move(m_result);
  }

private:
  Result<void> check() {
    if (m_input.number_of_faces() == 0)
      return make_error(Error_code::not_a_surface, "the surface has no faces");
    if (connected_components(m_input).second != 1)
      return make_error(Error_code::not_a_surface,
                        "the surface has several components: mesh them one by one");
    if (m_options.edge_length <= 0 && m_options.quads < 1)
      return make_error(Error_code::impossible_request, "the number of quads must be positive");
    m_result.genus = (2 - euler_characteristic(m_input) - int(boundary_loops(m_input).size())) / 2;
    return {};
  }

  Result<void> prepare() {
    if (!m_options.prepare) {
      m_result.working_surface = m_input;
      return {};
    }
    const double h =
        m_options.edge_length > 0 ? m_options.edge_length : std::sqrt(area(m_input) / m_options.quads);
    Prepare_options options;
    options.max_edge = h;
    options.min_edge = 1e-3 * h;
    Result<Prepared_surface> prepared = prepare_surface(m_input, options, m_clock.observer());
    if (!prepared) return prepared.error();
    m_result.working_surface = std::move(prepared->surface);
    m_result.preparation = prepared->report;
    return {};
  }

  Result<void> choose_extrema() {
    Result<Designed_field> field =
        Reeb_quadrangulation::choose_extrema(m_result.working_surface, m_options, m_clock.observer());
    if (!field) return field.error();
    m_result.field = std::move(*field);
    return {};
  }

  Result<void> solve_field() {
    return Reeb_quadrangulation::solve_field(m_result.working_surface, m_options, m_result.field);
  }

  Result<void> cut() {
    Result<Reeb_layout> layout = make_layout(m_result.working_surface, m_result.field);
    if (!layout) return layout.error();
    m_result.layout = std::move(*layout);
    return {};
  }

  Result<void> parameterize() {
    m_maps.clear();
    m_maps.resize(m_result.layout.atlas.charts.size());
    std::vector<int> all(m_maps.size(), -1);
    return prepare_maps(all);
  }

  // Prepares the maps of the charts that have none yet (`reused[c] < 0`).
  Result<void> prepare_maps(const std::vector<int>& reused) {
    const std::vector<std::shared_ptr<const Chart>>& charts = m_result.layout.atlas.charts;
    const std::vector<int> place = places_in(m_result.field.elimination_order);
    const Result<void> done = for_each_chart([&](int c) -> Result<void> {
      if (reused[c] >= 0) return {};
      Edge_weights weights = m_options.chart_weights ? m_options.chart_weights(*charts[c])
                                                     : clamped_cotangent_weights(charts[c]->mesh);
      Result<Chart_parameterization> map = Chart_parameterization::prepare(
          *charts[c], std::move(weights), elimination_order(*charts[c], place));
      if (!map) return map.error();
      m_maps[c] = std::move(*map);
      return {};
    });
    if (!done) return done;
    m_result.chart_height.assign(charts.size(), 0);
    for (std::size_t c = 0; c < charts.size(); ++c)
      if (charts[c]->kind == Chart_kind::annulus) m_result.chart_height[c] = m_maps[c].profile().total();
    return {};
  }

  // Thin charts vanish one after the other, the thinnest first, as long as that gives charts again.
  Result<void> collapse() {
    if (!m_options.collapse_thin) return {};
    std::set<std::vector<int>> refused;
    for (;;) {
      if (m_clock.cancelled()) return make_error(Error_code::cancelled, "cancelled by the user");
      if (Result<void> sampled = solve_sampling(); !sampled) return sampled;
      const std::vector<int> thin = thin_charts(0.5 * m_result.sampling.edge_length, refused);
      if (thin.empty()) return {};
      if (Result<bool> done = collapse_charts(thin); !done)
        return done.error();
      else if (*done)
        continue;
      // Together they failed: only the thinnest one, and never again if it fails alone.
      if (Result<bool> done = collapse_charts({thin[0]}); !done)
        return done.error();
      else if (!*done)
        refused.insert(contour_edges(*m_result.layout.atlas.charts[thin[0]]));
    }
  }

  // Charts lower than `height` between contours of saddles alone, lowest first, no two of them on the same contour.
  std::vector<int> thin_charts(double height, const std::set<std::vector<int>>& refused) const {
    const Reeb_layout& layout = m_result.layout;
    std::vector<int> thin;
    for (int c = 0; c < int(layout.atlas.charts.size()); ++c) {
      if (layout.atlas.charts[c]->kind != Chart_kind::annulus || m_result.chart_height[c] >= height) continue;
      const std::vector<int> edges = contour_edges(*layout.atlas.charts[c]);
      const bool saddles = std::all_of(edges.begin(), edges.end(), [&](int e) {
        return layout.network.nodes[layout.network.edges[e].from].kind == Node_kind::saddle &&
               layout.network.nodes[layout.network.edges[e].to].kind == Node_kind::saddle;
      });
      if (saddles && !refused.count(edges)) thin.push_back(c);
    }
    std::sort(thin.begin(), thin.end(), [&](int a, int b) {
      const double ha = m_result.chart_height[a], hb = m_result.chart_height[b];
      return ha != hb ? ha < hb : a < b;
    });
    std::set<int> used;
    std::vector<int> apart;
    for (int c : thin) {
      const Reeb_graph::Arc& arc = layout.graph.arcs[c];
      if (used.count(arc.low) || used.count(arc.high)) continue;
      used.insert(arc.low);
      used.insert(arc.high);
      apart.push_back(c);
    }
    return apart;
  }

  // False, with everything as it was, if the contours cannot be joined so that charts result.
  Result<bool> collapse_charts(const std::vector<int>& thin) {
    Reeb_layout& layout = m_result.layout;
    Contour_network network = layout.network;
    for (int c : thin) {
      const Chart& chart = *layout.atlas.charts[c];
      if (Result<void> solved =
              m_maps[c].solve_columns(chart, m_maps[c].natural(Side::low), m_maps[c].natural(Side::high));
          !solved)
        return solved.error();
      if (!collapse_chart(m_result.working_surface, chart, m_maps[c], network)) return false;
    }
    Result<Embedding> embedding = embed(m_result.working_surface, network);
    if (!embedding) return false;
    std::vector<int> extrema = layout.critical.minima, reused;
    extrema.insert(extrema.end(), layout.critical.maxima.begin(), layout.critical.maxima.end());
    Result<Atlas> atlas = build_atlas(*embedding, network, extrema, &layout.atlas, &reused);
    if (!atlas) return false;
    layout.network = std::move(network);
    layout.embedding = std::move(*embedding);
    layout.atlas = std::move(*atlas);
    layout.graph = reeb_graph(layout.atlas, layout.network);
    std::vector<Chart_parameterization> maps(reused.size());
    for (std::size_t c = 0; c < reused.size(); ++c)
      if (reused[c] >= 0) maps[c] = std::move(m_maps[reused[c]]);
    m_maps = std::move(maps);
    m_result.collapsed_charts += int(thin.size());
    if (Result<void> prepared = prepare_maps(reused); !prepared) return prepared.error();
    return true;
  }

  Result<void> solve_sampling() {
    const Layout_sampling_problem layout = sampling_problem(m_result.layout, m_result.chart_height);
    Result<Sampling> sampling = m_options.edge_length > 0
                                    ? sample_for_edge_length(layout.problem, m_options.edge_length)
                                    : sample_for_quads(layout.problem, base_quads());
    if (!sampling) return sampling.error();
    m_result.sampling = std::move(*sampling);
    m_samples.counts.assign(m_result.layout.network.edges.size(), 0);
    for (std::size_t i = 0; i < layout.edges.size(); ++i)
      m_samples.counts[layout.edges[i]] = m_result.sampling.counts[i];
    if (m_result.sampling.worst_edge >= 0)
      m_result.sampling.worst_edge = layout.edges[m_result.sampling.worst_edge];
    m_result.sampling.counts = m_samples.counts;
    return {};
  }

  Result<void> sample() {
    if (Result<void> sampled = solve_sampling(); !sampled) return sampled;
    const Reeb_layout& layout = m_result.layout;
    m_samples.parameter = contour_parameters(layout.embedding.surface.points, layout.network, layout.atlas,
                                             internal::pointers_to(m_maps), m_options.sample_blend);
    return {};
  }

  Result<void> place() {
    const std::vector<std::shared_ptr<const Chart>>& charts = m_result.layout.atlas.charts;
    m_textures.resize(charts.size());
    std::vector<int> flipped(charts.size(), 0);
    const Result<void> done = for_each_chart([&](int c) -> Result<void> {
      const std::array<int, 2> grid = m_result.sampling.grid[c];
      Result<Placed_texture> placed =
          charts[c]->kind == Chart_kind::annulus
              ? place_annulus(*charts[c], m_samples, grid[1], m_maps[c], m_options.textures)
              : place_disc(*charts[c], m_samples, grid[0], grid[1], m_maps[c], m_options.textures);
      if (!placed) return placed.error();
      m_textures[c] = std::move(*placed);
      flipped[c] = m_maps[c].flipped(*charts[c]);
      return {};
    });
    for (int n : flipped) m_result.flipped_triangles += n;
    return done;
  }

  Result<void> join() {
    const Reeb_layout& layout = m_result.layout;
    Stitched_mesh stitched = stitch(layout.embedding.surface.points, layout.network, layout.atlas, m_samples,
                                    internal::pointers_to(m_textures));
    m_result.mesh = std::move(stitched.mesh);
    m_result.valences = std::move(stitched.valences);
    m_result.chart_of_quad = std::move(stitched.chart_of_quad);
    return {};
  }

  // The number of quads before some are subdivided. The coarser, the more can be; but quads that are too coarse fit the surface badly.
  int base_quads() const {
    return std::max(1, int(m_options.quads / std::sqrt(double(m_options.adaptive.ratio))));
  }

  // Where quads would be inverted, other lines between fine and coarse quads are tried, then a lower ratio.
  Result<void> relax() {
    if (!m_options.relax && m_options.adaptive.ratio == 1) return {};
    m_projector.emplace(m_input);
    if (m_options.relax)
      if (Result<void> finished = finish(); !finished) return finished;
    if (m_options.adaptive.ratio == 1) return {};
    const Quads base = quads();
    std::optional<Quads> best;
    for (int ratio = m_options.adaptive.ratio; ratio > 1; ratio /= 2)
      for (const double lines : {1.0, 0.25, 4.0}) {
        take(base);
        if (Result<void> adapted = adapt(ratio, lines); !adapted) return adapted;
        if (!m_options.relax) return {};
        if (Result<void> finished = finish(); !finished) return finished;
        if (m_result.relaxation.inverted_after <= base.relaxation.inverted_after) return {};
        if (!best || m_result.relaxation.inverted_after < best->relaxation.inverted_after) best = quads();
      }
    take(*best);
    return {};
  }

  // What subdividing quads changes.
  struct Quads {
    Quad_mesh mesh;
    std::map<int, int> valences;
    std::vector<int> chart_of_quad;
    Relax_report relaxation;
    Snap_report features;
    int subdivided, t_junctions;
  };

  Quads quads() const {
    return {m_result.mesh,     m_result.valences,         m_result.chart_of_quad, m_result.relaxation,
            m_result.features, m_result.subdivided_quads, m_result.t_junctions};
  }

  void take(const Quads& quads) {
    m_result.mesh = quads.mesh;
    m_result.valences = quads.valences;
    m_result.chart_of_quad = quads.chart_of_quad;
    m_result.relaxation = quads.relaxation;
    m_result.features = quads.features;
    m_result.subdivided_quads = quads.subdivided;
    m_result.t_junctions = quads.t_junctions;
  }

  Result<void> adapt(int ratio, double lines) {
    Adaptive_options options = m_options.adaptive;
    options.ratio = ratio;
    options.lines.turn_cost *= lines;
    if (options.quads == 0 && m_options.edge_length <= 0) options.quads = m_options.quads;
    Result<Adapted_quads> adapted = adapt_quads(m_result.mesh, *m_projector, options);
    if (!adapted) return adapted.error();
    m_result.mesh = std::move(adapted->mesh);
    std::vector<int> chart;
    for (int parent : adapted->parent) chart.push_back(m_result.chart_of_quad[parent]);
    m_result.chart_of_quad = std::move(chart);
    for (const auto& [valence, number] : adapted->valence_changes)
      if ((m_result.valences[valence] += number) == 0) m_result.valences.erase(valence);
    m_result.subdivided_quads = adapted->subdivided;
    m_result.t_junctions = adapted->t_junctions;
    return {};
  }

  Result<void> finish() {
    Relax_options options = m_options.relaxation;
    options.threads = m_threads;
    Snap_options features = m_options.features;
    if (!m_options.keep_features) features.feature_angle = 0;
    Result<Finished_quads> finished =
        Finisher(*m_projector, options, features, m_clock.observer(), {}).run(std::move(m_result.mesh));
    if (!finished) return finished.error();
    m_result.mesh = std::move(finished->mesh);
    m_result.relaxation = finished->relaxation;
    m_result.features = finished->features;
    return {};
  }

  // Charts are independent; the largest ones start first so that two threads end together.
  template <class Work> Result<void> for_each_chart(const Work& work) {
    const std::vector<std::shared_ptr<const Chart>>& charts = m_result.layout.atlas.charts;
    std::vector<int> order(charts.size());
    for (std::size_t c = 0; c < order.size(); ++c) order[c] = int(c);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      const int fa = charts[a]->mesh.number_of_faces(), fb = charts[b]->mesh.number_of_faces();
      return fa != fb ? fa > fb : a < b;
    });
    std::vector<Result<void>> done(charts.size());
    internal::parallel_for(int(order.size()), m_threads, [&](int i) {
      if (m_clock.cancelled())
        done[order[i]] = make_error(Error_code::cancelled, "cancelled by the user");
      else
        done[order[i]] = work(order[i]);
    });
    for (Result<void>& result : done)
      if (!result) return result;
    return {};
  }

  const Triangle_surface& m_input;
  const Quadrangulation_options& m_options;
  Quadrangulation m_result;
  internal::Stage_clock<Stage_time> m_clock;
  int m_threads = 1;
  std::vector<Chart_parameterization> m_maps;
  Contour_samples m_samples;
  std::vector<Placed_texture> m_textures;
  std::optional<Surface_projector> m_projector; ///< of the input, for all attempts
};

} // namespace

Result<Quadrangulation> quadrangulate(const Triangle_surface& surface, const Quadrangulation_options& options,
                                      Observer* observer) {
  return Pipeline(surface, options, observer).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
