// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Design_field.h"

#include <limits>
#include <queue>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// Lengths of shortest paths along edges from the sources (Dijkstra).
std::vector<double> edge_distances(const Triangle_surface& mesh, const std::vector<int>& sources) {
  std::vector<double> distance(mesh.points.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const int v : sources) queue.push({distance[v] = 0, v});
  const auto relax = [&](int from, int to) {
    const double d = distance[from] + (mesh.points[to] - mesh.points[from]).norm();
    if (d < distance[to]) queue.push({distance[to] = d, to});
  };
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v] || mesh.outgoing[v] < 0) continue;
    int h = mesh.outgoing[v];
    // The edge of a halfedge, and at a boundary also the last one around.
    for (int first = h;;) {
      relax(v, mesh.target(h));
      const int last = Triangle_surface::previous(h);
      if (mesh.is_boundary(last)) relax(v, mesh.source(last));
      h = mesh.rotate_ccw(h);
      if (h < 0 || h == first) break;
    }
  }
  return distance;
}

double value_of(const Design& design, const Walk& walk) {
  double sum = 0;
  for (const Walk_edge& e : walk.edges) sum += design.network.edges[e.edge].value;
  return walk.edges.empty() ? 0.5 : sum / double(walk.edges.size());
}

std::vector<double> disc_field(const Chart& chart, const Chart_levels& levels) {
  std::vector<double> values(chart.mesh.points.size(), levels.first);
  if (chart.walks.empty() || chart.extremum < 0) return values; // a rectangle between fractional saddles
  const std::vector<double> to_tip = edge_distances(chart.mesh, {chart.extremum});
  const std::vector<double> to_rim = edge_distances(chart.mesh, chart.walks[0].vertices);
  for (std::size_t v = 0; v < to_tip.size(); ++v) {
    const double sum = to_tip[v] + to_rim[v];
    if (sum > 0 && sum < std::numeric_limits<double>::infinity())
      values[v] = levels.last + to_tip[v] / sum * (levels.first - levels.last);
  }
  return values;
}

} // namespace

Chart_levels chart_levels(const Design& design, const Chart& chart) {
  if (chart.walks.empty()) return {0.5, 0.5};
  if (chart.kind == Chart_kind::annulus)
    return {value_of(design, chart.walk(Side::low)), value_of(design, chart.walk(Side::high))};
  const double rim = value_of(design, chart.walks[0]);
  if (chart.extremum < 0) return {rim, rim};
  double tip = chart.walks[0].side == Side::low ? 1 : 0;
  for (const Design_extremum& e : design.extrema)
    if (e.vertex == chart.vertex_origin[chart.extremum]) tip = e.value;
  return {rim, tip};
}

std::vector<double> chart_field(const Design_chart& chart, const Chart_levels& levels) {
  if (chart.chart->kind != Chart_kind::annulus || !chart.map) return disc_field(*chart.chart, levels);
  std::vector<double> values = chart.map->u();
  for (double& value : values) value = levels.first + value * (levels.last - levels.first);
  return values;
}

} // namespace studio
} // namespace reebquad
