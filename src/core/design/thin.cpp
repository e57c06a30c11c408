// SPDX-License-Identifier: GPL-3.0-or-later
// Thin charts vanish: the saddles on both sides are aligned on one contour.
#include "design/draft.h"

#include <CGAL/Reeb_quadrangulation/layout_sampling.h>
#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

Result<void> collapse_chart(Draft& draft, int c) {
  if (draft.chart(c).kind != Chart_kind::annulus)
    return refuse("only annuli can be collapsed", {}, Element_kind::chart, draft.identity(c));
  const Result<Chart_parameterization> map = draft.naturally_solved_map(c);
  if (!map) return map.error();
  const std::shared_ptr<const Chart> chart = draft.atlas().charts[c];
  if (Result<void> done = collapse_chart(draft.surface(), *chart, *map, draft.network); !done)
    return refuse("the chart cannot be collapsed", done.error().message, Element_kind::chart,
                  draft.identity(c));
  return draft.cut();
}

namespace {

class Thin_charts {
public:
  explicit Thin_charts(Draft& draft) : m_draft(draft) {}

  Result<void> collapse() {
    for (;;) {
      if (Result<void> going_on = m_draft.begin("thin charts"); !going_on) return going_on;
      if (Result<void> prepared = m_draft.prepare_maps(); !prepared) return prepared;
      const Result<double> h = edge_length();
      if (!h) return h.error();
      const std::vector<int> thin = thinner_than(0.5 * *h);
      if (thin.empty()) return {};
      if (collapse(thin)) continue;
      // Together they fail: only the thinnest one, and never again if it fails alone.
      const std::vector<int> edges = contour_edges(m_draft.chart(thin[0]));
      if (!collapse({thin[0]})) m_refused.insert(edges);
    }
  }

private:
  double height(int c) const {
    const auto map = m_draft.map(c);
    CGAL_assertion(bool(map)); // it is prepared
    return (*map)->profile().total();
  }

  // Of the quads, as the counts of the charts that there are now would have it.
  Result<double> edge_length() const {
    if (!m_draft.resample || m_draft.target_quads <= 0) return m_draft.edge_length;
    std::vector<double> heights;
    for (int c = 0; c < number_of_charts(); ++c)
      heights.push_back(m_draft.chart(c).kind == Chart_kind::annulus ? height(c) : 0);
    const Layout_sampling_problem layout = sampling_problem(
        network_points(m_draft.surface(), m_draft.network), m_draft.network, m_draft.atlas(), heights);
    const Result<Sampling> sampling = sample_for_quads(layout.problem, m_draft.target_quads);
    if (!sampling) return sampling.error();
    return sampling->edge_length;
  }

  int number_of_charts() const { return int(m_draft.atlas().charts.size()); }

  bool is_saddle(int node) const { return m_draft.network.nodes[node].kind == Node_kind::saddle; }

  // The annuli below a height between contours of saddles alone, the lowest first, no two of them on one
  // contour.
  std::vector<int> thinner_than(double limit) const {
    std::vector<std::pair<double, int>> thin;
    for (int c = 0; c < number_of_charts(); ++c) {
      if (m_draft.chart(c).kind != Chart_kind::annulus || height(c) >= limit) continue;
      const std::vector<int> edges = contour_edges(m_draft.chart(c));
      const bool saddles = std::all_of(edges.begin(), edges.end(), [&](int e) {
        return is_saddle(m_draft.network.edges[e].from) && is_saddle(m_draft.network.edges[e].to);
      });
      if (saddles && !m_refused.count(edges)) thin.push_back({height(c), c});
    }
    std::sort(thin.begin(), thin.end());
    const Reeb_graph graph = reeb_graph(m_draft.atlas(), m_draft.network);
    std::set<int> used;
    std::vector<int> apart;
    for (const auto& [low, c] : thin) {
      const Reeb_graph::Arc& arc = graph.arcs[c];
      if (used.count(arc.low) || used.count(arc.high)) continue;
      used.insert({arc.low, arc.high});
      apart.push_back(c);
    }
    return apart;
  }

  // False, with everything as it was, if no charts would result.
  bool collapse(const std::vector<int>& thin) {
    Draft trial = m_draft;
    for (int c : thin) {
      const Result<Chart_parameterization> map = trial.naturally_solved_map(c);
      if (!map || !Reeb_quadrangulation::collapse_chart(trial.surface(), trial.chart(c), *map, trial.network))
        return false;
    }
    if (!trial.cut()) return false;
    trial.collapsed_charts += int(thin.size());
    m_draft.take(std::move(trial));
    return true;
  }

  Draft& m_draft;
  std::set<std::vector<int>> m_refused; // by their contour edges
};

} // namespace

Result<void> collapse_thin_charts(Draft& draft) {
  return Thin_charts(draft).collapse();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
