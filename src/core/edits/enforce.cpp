// SPDX-License-Identifier: GPL-3.0-or-later
// A saddle's loop enforced by the field alone, on the whole surface.
#include "edits/steps.h"

#include <CGAL/Reeb_quadrangulation/constrained_field.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The field that the draft's charts make up, at the vertices of the surface.
Result<std::vector<double>> values_of(Draft& draft) {
  const int n = draft.surface().number_of_vertices();
  std::vector<double> values(n, 0.0);
  for (std::size_t c = 0; c < draft.atlas().charts.size(); ++c) {
    const Chart& chart = draft.chart(int(c));
    const Result<std::vector<double>> level = level_field(draft, int(c));
    if (!level) return level.error();
    const std::array<double, 2> range = value_range(draft, chart);
    for (std::size_t v = 0; v < chart.vertex_origin.size(); ++v)
      if (const int o = chart.vertex_origin[v]; o >= 0 && o < n)
        values[o] = range[0] + (*level)[v] * (range[1] - range[0]);
  }
  return values;
}

// The critical contours, if all others are caps and boundary loops: only these come back from a field.
Result<std::vector<int>> critical_contours(const Draft& draft) {
  const Error other = refuse("the field alone holds no contours but those of saddles and caps");
  std::vector<int> edges;
  for (std::size_t e = 0; e < draft.network.edges.size(); ++e) {
    if (draft.network.is_removed(draft.network.edges[e])) continue;
    const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
    if (sides[0] < 0 || sides[1] < 0) continue;
    if (cap_contour(draft, sides[0]) == int(e) || cap_contour(draft, sides[1]) == int(e)) continue;
    const Contour_edge& edge = draft.network.edges[e];
    for (int node : {edge.from, edge.to})
      if (draft.network.nodes[node].kind != Node_kind::saddle) return other;
    edges.push_back(int(e));
  }
  return edges;
}

Designed_field field_of(const Draft& draft, std::vector<double> values) {
  Designed_field field;
  for (const Design_extremum& e : draft.extrema) {
    (e.is_maximum ? field.maxima : field.minima).push_back(e.vertex);
    values[e.vertex] = e.value;
  }
  field.values = std::move(values);
  for (const std::vector<int>& loop : boundary_loops(draft.surface()))
    field.boundary_is_maximum.push_back(field.values[draft.surface().source(loop[0])] > 0.5);
  field.elimination_order = draft.solver().order();
  return field;
}

// What each contour joins: the extrema that its charts end in, and -1 for each chart that ends in another contour.
std::vector<std::vector<int>> joined_ends(const Atlas& atlas, const Contour_network& network) {
  const Reeb_graph graph = reeb_graph(atlas, network);
  std::vector<std::vector<int>> ends(graph.number_of_nodes());
  for (const Reeb_graph::Arc& arc : graph.arcs) {
    ends[arc.low].push_back(graph.extremum[arc.high]);
    ends[arc.high].push_back(graph.extremum[arc.low]);
  }
  for (std::vector<int>& list : ends) std::sort(list.begin(), list.end());
  std::sort(ends.begin(), ends.end());
  return ends;
}

} // namespace

Result<void> enforce_by_field(Draft& draft, int old, Contour_edge fresh) {
  const Result<std::vector<int>> critical = critical_contours(draft);
  if (!critical) return critical.error();
  if (std::find(critical->begin(), critical->end(), old) == critical->end())
    return refuse("the field alone moves contours of saddles only", {}, Element_kind::contour, old);
  Result<std::vector<double>> values = values_of(draft);
  if (!values) return values.error();
  Designed_field field = field_of(draft, std::move(*values));
  Contour_network wanted = draft.network;
  fresh.value = wanted.edges[old].value;
  wanted.edges[old] = std::move(fresh);
  Result<std::vector<double>> solved =
      constrained_field(draft.surface(), field, wanted, *critical, draft.field_solver());
  if (!solved) return refuse("the field cannot be solved", solved.error().message);
  field.values = std::move(*solved);
  Result<Reeb_layout> layout = layout_of(draft, field);
  if (!layout) return layout.error();
  if (joined_ends(draft.atlas(), draft.network) != joined_ends(layout->atlas, layout->network))
    return refuse("the contour would change the topology of the field");
  draft.adopt(std::move(*layout));
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
