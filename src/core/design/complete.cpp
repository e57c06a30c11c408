// SPDX-License-Identifier: GPL-3.0-or-later
// From contours to textures: what is new in a draft is mapped, sampled and filled.
#include "design/dislocation_places.h"
#include "design/draft.h"
#include "design/pole_texture.h"

#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>
#include <CGAL/Reeb_quadrangulation/layout_sampling.h>
#include <CGAL/Reeb_quadrangulation/place_texture.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

bool folds(const Chart& chart, const Chart_parameterization& map) {
  for (int f = 0; f < chart.mesh.number_of_faces(); ++f) {
    const Triangle& t = chart.mesh.triangles[f];
    const double v1 = map.v()[t[1]] + map.jump(3 * f) - map.v()[t[0]],
                 v2 = map.v()[t[2]] - map.jump(3 * f + 2) - map.v()[t[0]];
    const double u1 = map.u()[t[1]] - map.u()[t[0]], u2 = map.u()[t[2]] - map.u()[t[0]];
    const double size = std::abs(v1) + std::abs(v2) + std::abs(u1) + std::abs(u2);
    if (v1 * u2 - v2 * u1 < -1e-15 * size) return true;
  }
  return false;
}

int unmappable_chart(Draft& draft) {
  for (int c = 0; c < int(draft.atlas().charts.size()); ++c) {
    if (draft.origin(c) >= 0 || draft.chart(c).kind != Chart_kind::annulus) continue;
    const Result<Chart_parameterization> map = draft.naturally_solved_map(c);
    if (!map || folds(draft.chart(c), *map)) return c;
  }
  return -1;
}

namespace {

class Completion {
public:
  explicit Completion(Draft& draft) : m_draft(draft), m_before(draft.before()) {}

  Result<Design> run() {
    take_over();
    if (Result<void> kept = keep_locked(); !kept) return kept.error();
    using Step = Result<void> (Completion::*)();
    const std::pair<const char*, Step> steps[] = {{"charts", &Completion::prepare_maps},
                                                  {"sampling", &Completion::sample},
                                                  {"textures", &Completion::place}};
    for (const auto& [stage, step] : steps) {
      if (Result<void> going_on = m_draft.begin(stage); !going_on) return going_on.error();
      if (Result<void> done = (this->*step)(); !done) return done.error();
    }
    if (Result<void> mapped = check_maps(); !mapped) return mapped.error();
    m_design.atlas = m_draft.atlas();
    m_design.network = std::move(m_draft.network);
    m_design.extrema = std::move(m_draft.extrema);
    m_design.field = m_draft.field;
    keep_guides();
    return std::move(m_design);
  }

private:
  int number_of_charts() const { return int(m_draft.atlas().charts.size()); }
  const Design_chart* old_chart(int c) const {
    return m_draft.origin(c) >= 0 ? m_before.charts[m_draft.origin(c)].get() : nullptr;
  }

  // The contour of a guide may have been moved by other edits: then it has another number.
  void keep_guides() {
    m_design.guides = std::move(m_draft.guides);
    for (Design_guide& guide : m_design.guides)
      for (const auto& [edge, old] : m_draft.replaced)
        if (guide.contour == old) guide.contour = edge;
  }

  // Settings of the charts that stay; the others begin afresh.
  void take_over() {
    m_design.next_chart = m_before.next_chart;
    m_design.target_quads = m_draft.target_quads;
    m_design.edge_length = m_draft.edge_length;
    m_ids.resize(number_of_charts());
    m_settings.resize(number_of_charts());
    for (int c = 0; c < number_of_charts(); ++c) {
      const Design_chart* old = old_chart(c);
      m_ids[c] = old ? old->id : m_design.next_chart++;
      if (old) m_settings[c] = m_draft.settings.at(old->id);
      m_predecessors.push_back(old ? nullptr : predecessor(m_draft, c));
      if (!m_predecessors.back()) continue;
      for (const Walk& walk : m_draft.chart(c).walks)
        for (const Walk_edge& e : walk.edges)
          if (const auto replaced = m_draft.replaced.find(e.edge); replaced != m_draft.replaced.end())
            m_kept_counts[e.edge] = m_before.samples.counts[replaced->second];
    }
    inherit_dislocations();
  }

  static int fewest_rows(const Chart_settings& settings) {
    int most = 1;
    for (const Design_dislocation& d : settings.dislocations) most = std::max(most, std::abs(d.columns) / 2);
    return rows_for_dislocations(most);
  }

  // Where contours have changed, dislocations stay in their places on the surface. A cap takes in all
  // columns, and has none.
  void inherit_dislocations() {
    std::vector<char> stays(m_before.charts.size(), 0);
    for (int c = 0; c < number_of_charts(); ++c)
      if (m_draft.origin(c) >= 0) stays[m_draft.origin(c)] = 1;
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const auto settings = m_draft.settings.find(m_before.charts[i]->id);
      if (stays[i] || settings == m_draft.settings.end()) continue;
      for (const Design_dislocation& d : settings->second.dislocations) {
        const int c = m_draft.chart_point_at(d.at).chart;
        if (c >= 0 && m_draft.origin(c) < 0 && m_draft.chart(c).kind == Chart_kind::annulus)
          m_settings[c].dislocations.push_back(d);
      }
    }
  }

  Result<void> keep_locked() const {
    std::vector<char> stays(m_before.charts.size(), 0);
    for (int c = 0; c < number_of_charts(); ++c)
      if (m_draft.origin(c) >= 0) stays[m_draft.origin(c)] = 1;
    for (std::size_t i = 0; i < stays.size(); ++i)
      if (!stays[i] && m_before.charts[i]->settings.locked)
        return refuse("the edit would change a locked chart", {}, Element_kind::chart,
                      m_before.charts[i]->id);
    return {};
  }

  // Where contours were pushed aside, rounding may fold the map of a chart that is left very thin.
  Result<void> check_maps() const {
    if (!m_draft.has_pushed_contours) return {};
    for (const auto& chart : m_design.charts)
      if (m_before.index_of(chart->id) < 0 && folds(*chart->chart, *chart->map))
        return refuse("the contours would come too near to each other", {}, Element_kind::chart, chart->id);
    return {};
  }

  Result<void> prepare_maps() { return m_draft.prepare_maps(); }

  const Chart_parameterization& map(int c) { return **m_draft.map(c); }

  // Counts stay where nothing demands a change; contour edges that stay keep their parameter.
  Result<void> sample() {
    const std::vector<Point> points = network_points(m_draft.surface(), m_draft.network);
    std::vector<const Chart_parameterization*> maps;
    const std::vector<double> density = m_draft.network_density();
    m_heights.assign(number_of_charts(), 0);
    for (int c = 0; c < number_of_charts(); ++c) {
      maps.push_back(&map(c));
      if (m_draft.chart(c).kind == Chart_kind::annulus) m_heights[c] = maps[c]->profile().total();
    }
    m_design.samples.parameter =
        contour_parameters(points, m_draft.network, m_draft.atlas(), maps, m_draft.options().sample_blend,
                           m_before.samples.parameter, density);
    Layout_sampling_problem layout =
        sampling_problem(points, m_draft.network, m_draft.atlas(), m_heights, density);
    Sampling_options options;
    add_wishes(layout, options);
    Result<Sampling> sampling = choose_counts(layout.problem, options);
    if (!sampling) return sampling.error();
    for (auto& [chart, places] : m_places) m_settings[chart].dislocations = places.place();
    if (Result<void> few = check_number(*sampling); !few) return few.error();
    m_design.counts = {sampling->quads, sampling->target_met, sampling->worst_ratio,
                       sampling->worst_edge < 0 ? -1 : layout.edges[std::size_t(sampling->worst_edge)]};
    m_design.edge_length = sampling->edge_length;
    m_design.samples.counts.assign(m_draft.network.edges.size(), 0);
    for (std::size_t i = 0; i < layout.edges.size(); ++i)
      m_design.samples.counts[layout.edges[i]] = sampling->counts[i];
    m_grid = sampling->grid;
    return {};
  }

  Result<Sampling> choose_counts(const Sampling_problem& problem, const Sampling_options& options) {
    if (m_draft.most_dislocations == 0) return sample_once(problem, m_draft.target_quads, options);
    Result<Sampling> sampling = sample_with_dislocations(problem, m_draft.target_quads, options);
    if (!sampling || !m_draft.resample || m_draft.target_quads == 0) return sampling;
    const double off = double(sampling->quads) / m_draft.target_quads;
    if (std::abs(off - 1) < 0.02) return sampling;
    // Where columns begin or end is not known before.
    return sample_with_dislocations(problem, std::max(1, int(m_draft.target_quads / off)), options);
  }

  Result<Sampling> sample_once(const Sampling_problem& problem, int quads,
                               const Sampling_options& options) const {
    Sampling_options afresh;
    afresh.column_price = options.column_price;
    return m_draft.resample && m_draft.target_quads > 0
               ? sample_for_quads(problem, quads, afresh)
               : sample_layout(problem, m_draft.edge_length, options);
  }

  // The dearer dislocations are the fewer there are, and none in the end.
  Result<Sampling> sample_with_dislocations(const Sampling_problem& problem, int quads,
                                            Sampling_options options) {
    for (options.column_price = m_draft.column_price;; options.column_price *= 1.5) {
      Result<Sampling> sampling = sample_once(problem, quads, options);
      if (!sampling) return sampling;
      m_places.clear();
      int number = 0;
      for (int c = 0; c < number_of_charts(); ++c) {
        if (problem.charts[c].free_gain == 0) continue;
        Dislocation_places places(*old_chart(c), sampling->grid[c], sampling->edge_length);
        number += places.choose_rows(sampling->gained[c], price_of_end * options.column_price);
        sampling->quads += places.quads() - std::int64_t(sampling->grid[c][0] + sampling->gained[c] / 2) *
                                                sampling->grid[c][1];
        m_places.emplace(c, std::move(places));
      }
      if (number <= m_draft.most_dislocations || options.column_price > 1e12) return sampling;
    }
  }

  // How many columns an annulus may gain or lose, beside those that somebody has asked for: two dislocations
  // and more, if it is not thin, and as many as it has place for.
  int free_gain(int c) const {
    const Design_chart* old = old_chart(c);
    const Chart_settings& settings = m_settings[c];
    if (m_draft.most_dislocations == 0 || !old || old->edited || settings.locked || settings.columns > 0 ||
        !settings.dislocations.empty() || old->grid[1] < 4)
      return 0;
    return 2 * std::max(1, std::min(old->grid[0] / 4, (old->grid[1] - 2) * old->grid[0] / 24));
  }

  // Layouts in which one count forces others may need many more quads than the edge length asks for. Where
  // all counts are chosen anew, they are the fewest that the layout can have.
  Result<void> check_number(const Sampling& sampling) const {
    constexpr double few = 1e4;
    if (double(sampling.quads) <= few || m_draft.resample) return {};
    const double expected = area(m_draft.surface()) / (sampling.edge_length * sampling.edge_length);
    if (double(sampling.quads) <= few + 30 * expected) return {};
    return refuse("the counts would need too many quads", std::to_string(sampling.quads));
  }

  void add_wishes(Layout_sampling_problem& layout, Sampling_options& options) const {
    if (!m_draft.resample) {
      options.previous_edge_length = m_draft.edge_length;
      for (int e : layout.edges) {
        const bool known = e < int(m_before.samples.counts.size());
        const auto replaced = m_kept_counts.find(e);
        options.previous_counts.push_back(known                             ? m_before.samples.counts[e]
                                          : replaced != m_kept_counts.end() ? replaced->second
                                                                            : 0);
      }
      for (int c = 0; c < number_of_charts(); ++c)
        options.previous_rows.push_back(old_chart(c) ? old_chart(c)->grid[1] : 0);
    }
    std::vector<int> index(m_draft.network.edges.size(), -1);
    for (std::size_t i = 0; i < layout.edges.size(); ++i) {
      index[layout.edges[i]] = int(i);
      if (!m_draft.counts.empty()) layout.problem.edges[i].locked = m_draft.counts[layout.edges[i]];
    }
    for (int c = 0; c < number_of_charts(); ++c) {
      Sampling_chart& chart = layout.problem.charts[c];
      if (chart.kind == Sampling_chart::Kind::annulus) {
        chart.locked_rows = m_settings[c].rows;
        chart.locked_columns = m_settings[c].columns;
        chart.columns_gained = m_settings[c].columns_gained();
        chart.free_gain = free_gain(c);
        chart.fewest_rows = fewest_rows(m_settings[c]);
      }
      if (!m_settings[c].locked || !old_chart(c)) continue;
      chart.locked_columns = 0;
      if (chart.kind == Sampling_chart::Kind::annulus) chart.locked_rows = old_chart(c)->grid[1];
      for (const Walk& walk : m_draft.chart(c).walks)
        for (const Walk_edge& e : walk.edges)
          layout.problem.edges[index[e.edge]].locked = m_before.samples.counts[e.edge];
    }
  }

  bool same_counts(int c) const {
    for (const Walk& walk : m_draft.chart(c).walks)
      for (const Walk_edge& e : walk.edges)
        if (m_before.samples.counts[e.edge] != m_design.samples.counts[e.edge]) return false;
    return true;
  }

  Result<void> place() {
    m_design.charts.resize(number_of_charts());
    std::vector<int> changed;
    for (int c = 0; c < number_of_charts(); ++c) {
      const Design_chart* old = old_chart(c);
      const bool kept = old && !m_draft.reset_textures.count(old->id);
      if (kept && old->settings == m_settings[c] && old->grid == m_grid[c] && same_counts(c))
        m_design.charts[c] = m_before.charts[m_draft.origin(c)];
      else if (kept && old->edited)
        keep_texture(c);
      else
        changed.push_back(c);
    }
    return m_draft.for_each_chart(changed, [&](int c) { return fill(c); });
  }

  // The user's texture stays in its place, whatever the counts around it are now.
  void keep_texture(int c) {
    auto made = std::make_shared<Design_chart>(*old_chart(c));
    made->texture = with_counts(made->texture, *made->chart, m_before.samples, m_design.samples);
    made->grid = m_grid[c];
    made->settings = m_settings[c];
    m_design.charts[c] = std::move(made);
  }

  Texture_maker disc_maker(const Chart& chart) const {
    Texture_maker maker = m_draft.options().textures;
    for (const Design_extremum& e : m_draft.extrema)
      if (chart.extremum >= 0 && chart.vertex_origin[chart.extremum] == e.vertex &&
          e.pole == Pole_kind::whole)
        maker.disc = pole_texture;
    return maker;
  }

  Result<void> fill(int c) {
    const Chart& chart = m_draft.chart(c);
    auto made = std::make_shared<Design_chart>();
    made->id = m_ids[c];
    made->chart = m_draft.atlas().charts[c];
    made->grid = m_grid[c];
    made->height = m_heights[c];
    made->settings = m_settings[c];
    if (m_predecessors[c] && inherit_texture(m_draft, *m_predecessors[c], m_design.samples, map(c), *made)) {
      m_design.charts[c] = std::move(made);
      return {};
    }
    Chart_parameterization solved = map(c);
    Texture_placement placement = m_settings[c].placement();
    for (const Design_dislocation& d : m_settings[c].dislocations)
      placement.dislocations.push_back({m_draft.chart_point_at(d.at, c).location, d.columns});
    std::array<int, 2> grid = m_grid[c];
    const std::vector<int> corners = rectangle_corners(m_draft.network, chart);
    if (!corners.empty()) {
      placement.corner = 0;
      for (int i = 0; i < corners[0]; ++i)
        placement.corner += m_design.samples.counts[chart.walks[0].edges[i].edge];
      if (chart.walks[0].side == Side::high) std::swap(grid[0], grid[1]);
    }
    Result<Placed_texture> placed =
        chart.kind == Chart_kind::annulus
            ? place_annulus(chart, m_design.samples, grid[1], solved, m_draft.options().textures, placement)
            : place_disc(chart, m_design.samples, grid[0], grid[1], solved, disc_maker(chart), placement);
    if (!placed && !placement.dislocations.empty() && placed.error().code == Error_code::impossible_request)
      return refuse("a chart has no room for its dislocations", placed.error().message, Element_kind::chart,
                    m_ids[c]);
    if (!placed) return placed.error();
    made->texture = std::move(*placed);
    made->map = std::make_shared<const Chart_parameterization>(std::move(solved));
    m_design.charts[c] = std::move(made);
    return {};
  }

  static constexpr double price_of_end = 2.5; // of a dislocation's end, in columns that begin or end

  Draft& m_draft;
  const Design& m_before;
  Design m_design;
  std::vector<int> m_ids;
  std::vector<Chart_settings> m_settings;
  std::vector<double> m_heights;
  std::vector<std::array<int, 2>> m_grid;
  std::vector<const Design_chart*> m_predecessors; ///< per chart, whose edited texture it takes over, or null
  std::map<int, Dislocation_places> m_places;      ///< per chart, of dislocations that are added
  std::map<int, int> m_kept_counts;                ///< of contour edges that took the place of others
};

} // namespace

Result<Design> complete_design(Draft& draft) {
  return Completion(draft).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
