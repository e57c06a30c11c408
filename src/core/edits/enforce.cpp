// SPDX-License-Identifier: GPL-3.0-or-later
// A saddle's loop enforced by the field alone, on the whole surface.
#include "atlas/region_curve.h"
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

// A free loop that is no cap: the level line of a value.
struct Ring {
  int edge = -1;
  double value = 0;
};

struct Held {
  std::vector<int> critical; // contour edges of saddles
  std::vector<Ring> rings;
};

// The contours that a field brings back, as level lines: those of saddles, and rings. Caps and boundary loops
// come back by themselves.
Result<Held> held_contours(const Draft& draft) {
  Held held;
  for (std::size_t e = 0; e < draft.network.edges.size(); ++e) {
    if (draft.network.is_removed(draft.network.edges[e])) continue;
    const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
    if (sides[0] < 0 || sides[1] < 0) continue;
    if (cap_contour(draft, sides[0]) == int(e) || cap_contour(draft, sides[1]) == int(e)) continue;
    const Contour_edge& edge = draft.network.edges[e];
    if (draft.is_free_loop(int(e))) {
      held.rings.push_back({int(e), edge.value});
      continue;
    }
    for (int node : {edge.from, edge.to})
      if (draft.network.nodes[node].kind != Node_kind::saddle)
        return refuse("the field alone holds no contours but those of saddles, rings and caps", {},
                      Element_kind::contour, int(e));
    held.critical.push_back(int(e));
  }
  return held;
}

// The line in a chart where the field on the surface has a value.
Result<Contour_edge> line_of_value(Draft& draft, int c, double value) {
  const Chart& chart = draft.chart(c);
  Open_region region{chart, {}};
  Region_sides asked;
  asked.home.assign(chart.vertex_origin.size(), 0);
  for (const Walk& walk : chart.walks) {
    region.walls.resize(region.walls.size() + walk.vertices.size());
    for (int v : walk.vertices) asked.home[v] = static_cast<signed char>(walk.side == Side::low ? -1 : 1);
  }
  const std::vector<double>& values = draft.field->values;
  for (std::size_t v = 0; v < chart.vertex_origin.size(); ++v) {
    const int o = chart.vertex_origin[v];
    const bool is_known = o >= 0 && o < int(values.size()) && asked.home[v] == 0;
    asked.wish.push_back(is_known ? values[o] - value : 1e-9 * asked.home[v]);
    if (asked.home[v] == 0) asked.home[v] = static_cast<signed char>(asked.wish.back() > 0 ? 1 : -1);
  }
  if (chart.extremum >= 0) {
    asked.home[chart.extremum] = static_cast<signed char>(chart.walks[0].side == Side::low ? 1 : -1);
    asked.held.push_back(chart.extremum);
  }
  const Result<std::vector<signed char>> sides = part_region(region, asked);
  if (!sides) return sides.error();
  const Result<Region_curve> curve = curve_between(region, *sides, asked);
  if (!curve) return curve.error();
  Result<Contour_edge> line = contour_of_curve(draft.surface(), region, *curve, -1, -1, draft.network);
  if (line) line->value = value;
  return line;
}

// The level line of the new field that has a ring's value nearest to where it was.
Result<void> draw_ring(Draft& draft, const Ring& ring, const std::vector<Point>& place) {
  const std::vector<double>& values = draft.field->values;
  int seed = -1;
  double least = 0;
  const Eigen::AlignedBox3d box = [&] {
    Eigen::AlignedBox3d b;
    for (const Point& p : place) b.extend(p);
    return b;
  }();
  const double reach = 4 * draft.edge_length, size = box.diagonal().norm();
  for (int v = 0; v < draft.surface().number_of_vertices(); ++v) {
    const Point& p = draft.surface().points[v];
    if (box.exteriorDistance(p) > reach) continue;
    double near = reach;
    for (const Point& q : place) near = std::min(near, (p - q).norm());
    if (near >= reach) continue;
    const double off = std::abs(values[v] - ring.value) + 0.05 * near / size;
    if (seed >= 0 && off >= least) continue;
    if (draft.chart_of_vertex(v) < 0) continue;
    seed = v;
    least = off;
  }
  if (seed < 0) return refuse("a ring has no place in the field", {}, Element_kind::contour, ring.edge);
  Result<Contour_edge> line = line_of_value(draft, draft.chart_of_vertex(seed), ring.value);
  if (!line) return line.error();
  line->from = line->to = add_node(draft.network, line->vertices.front());
  draft.network.edges.push_back(std::move(*line));
  if (Result<void> cut = draft.cut(); !cut) return cut;
  return check_caps(draft);
}

Designed_field field_of(const Draft& draft, std::vector<double> values) {
  Designed_field field;
  for (const Design_extremum& e : draft.extrema) {
    (e.is_maximum ? field.maxima : field.minima).push_back(e.vertex);
    values[e.vertex] = e.value;
  }
  field.values = std::move(values);
  field.boundary_is_maximum = present_boundary_kinds(draft);
  field.elimination_order = draft.solver().order();
  return field;
}

// What each contour joins: the extrema that its charts end in, and -1 for each chart that ends in another
// contour.
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

Result<void> enforce_by_field(Draft& draft, int old, const Draft& trial) {
  const Result<Held> held = held_contours(draft);
  if (!held) return held.error();
  for (int c : draft.atlas().charts_of_edge[old])
    if (cap_contour(draft, c) == old)
      return refuse("a cap goes where the field has it", {}, Element_kind::contour, old);
  Result<std::vector<double>> values = values_of(draft);
  if (!values) return values.error();
  Designed_field field = field_of(draft, std::move(*values));
  std::vector<int> followed; // in the trial
  const auto in_trial = [&](int e) {
    for (const auto& [fresh, origin] : trial.replaced)
      if (origin == e && !trial.network.is_removed(trial.network.edges[fresh])) return fresh;
    return e;
  };
  for (int e : held->critical) followed.push_back(in_trial(e));
  if (std::find(held->critical.begin(), held->critical.end(), old) == held->critical.end())
    followed.push_back(in_trial(old));
  Result<std::vector<double>> solved =
      constrained_field(draft.surface(), field, trial.network, followed, draft.field_solver());
  if (!solved) return refuse("the field cannot be solved", solved.error().message);
  field.values = std::move(*solved);
  Result<Reeb_layout> layout = layout_of(draft, field);
  if (!layout) return layout.error();
  Draft bare = draft; // without the rings
  for (const Ring& ring : held->rings) remove_edge(bare.network, ring.edge);
  if (Result<void> cut = bare.cut(); !cut) return cut;
  if (joined_ends(bare.atlas(), bare.network) != joined_ends(layout->atlas, layout->network))
    return refuse("the contour would change the topology of the field");
  std::vector<std::vector<Point>> places;
  for (const Ring& ring : held->rings) {
    places.emplace_back();
    for (int v : trial.network.edges[in_trial(ring.edge)].vertices)
      places.back().push_back(trial.position(v));
  }
  draft.adopt(std::move(*layout));
  for (std::size_t i = 0; i < held->rings.size(); ++i)
    if (Result<void> drawn = draw_ring(draft, held->rings[i], places[i]); !drawn) return drawn;
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
