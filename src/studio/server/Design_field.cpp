// SPDX-License-Identifier: GPL-3.0-or-later
#include "Design_field.h"

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

class Field {
public:
  Field(const Design& design, const Embedding& embedding)
      : m_design(design), m_values(embedding.surface.points.size(), 0.5) {}

  std::vector<double> values() {
    for (const auto& chart : m_design.charts) {
      if (chart->chart->kind == Chart_kind::annulus && chart->map)
        annulus(*chart);
      else
        disc(*chart->chart);
    }
    return std::move(m_values);
  }

private:
  double value_of(const Walk& walk) const {
    double sum = 0;
    for (const Walk_edge& e : walk.edges) sum += m_design.network.edges[e.edge].value;
    return walk.edges.empty() ? 0.5 : sum / double(walk.edges.size());
  }

  void set(const Chart& chart, std::size_t v, double value) {
    if (chart.vertex_origin[v] >= 0) m_values[chart.vertex_origin[v]] = value;
  }

  void annulus(const Design_chart& made) {
    const Chart& chart = *made.chart;
    const double low = value_of(chart.walk(Side::low)), high = value_of(chart.walk(Side::high));
    const std::vector<double>& u = made.map->u();
    for (std::size_t v = 0; v < u.size(); ++v) set(chart, v, low + u[v] * (high - low));
  }

  void disc(const Chart& chart) {
    if (chart.walks.empty()) return;
    const double rim = value_of(chart.walks[0]);
    if (chart.extremum < 0) { // a rectangle between fractional saddles
      for (std::size_t v = 0; v < chart.mesh.points.size(); ++v) set(chart, v, rim);
      return;
    }
    double tip = chart.walks[0].side == Side::low ? 1 : 0;
    for (const Design_extremum& e : m_design.extrema)
      if (e.vertex == chart.vertex_origin[chart.extremum]) tip = e.value;
    const std::vector<double> to_tip = edge_distances(chart.mesh, {chart.extremum});
    const std::vector<double> to_rim = edge_distances(chart.mesh, chart.walks[0].vertices);
    for (std::size_t v = 0; v < to_tip.size(); ++v) {
      const double sum = to_tip[v] + to_rim[v];
      set(chart, v,
          sum > 0 && sum < std::numeric_limits<double>::infinity() ? tip + to_tip[v] / sum * (rim - tip)
                                                                   : rim);
    }
  }

  const Design& m_design;
  std::vector<double> m_values;
};

} // namespace

std::vector<double> design_field(const Design& design, const Embedding& embedding) {
  return Field(design, embedding).values();
}

} // namespace studio
} // namespace reebquad
