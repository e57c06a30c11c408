// SPDX-License-Identifier: GPL-3.0-or-later
#include "Skeleton.h"

#include <algorithm>
#include <limits>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr int bands = 14;

/// The area of triangles and the sum of their centroids by bands of the field, chart by chart.
struct Bands {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::vector<Point> sum = std::vector<Point>(bands, Point::Zero());
  std::vector<double> area = std::vector<double>(bands, 0);
};

std::vector<Bands> measure(const Charted_surface& charted) {
  const Triangle_surface& surface = charted.embedding.surface;
  const std::vector<double>& values = charted.values;
  std::vector<Bands> charts(charted.graph.arcs.size());
  const auto mean = [&](const Triangle& t) { return (values[t[0]] + values[t[1]] + values[t[2]]) / 3; };
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const int chart = charted.chart_of_face[f];
    if (chart < 0) continue;
    const double value = mean(surface.triangles[f]);
    charts[chart].low = std::min(charts[chart].low, value);
    charts[chart].high = std::max(charts[chart].high, value);
  }
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const int chart = charted.chart_of_face[f];
    if (chart < 0) continue;
    Bands& b = charts[chart];
    const Triangle& t = surface.triangles[f];
    const Point &p = surface.points[t[0]], &q = surface.points[t[1]], &r = surface.points[t[2]];
    const double part = b.low < b.high ? (mean(t) - b.low) / (b.high - b.low) : 0.5;
    const int band = std::clamp(int(bands * part), 0, bands - 1);
    const double weight = (q - p).cross(r - p).norm();
    b.sum[band] += weight * (p + q + r) / 3;
    b.area[band] += weight;
  }
  return charts;
}

/// Each inner point moves to the mean of itself and its neighbours, a few times.
void smooth(std::vector<Point>& line) {
  for (int round = 0; round < 3; ++round) {
    const std::vector<Point> old = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) line[i] = (old[i - 1] + old[i] + old[i + 1]) / 3;
  }
}

std::vector<Point> node_positions(const Charted_surface& charted) {
  const std::vector<Point>& points = charted.embedding.surface.points;
  const Contour_network& network = charted.network;
  const Reeb_graph& graph = charted.graph;
  std::vector<Point> position(graph.number_of_nodes(), Point::Zero());
  std::vector<int> number(graph.number_of_nodes(), 0);
  for (std::size_t e = 0; e < network.edges.size(); ++e)
    for (const int v : network.edges[e].vertices) {
      position[graph.contour_of_edge[e]] += points[v];
      ++number[graph.contour_of_edge[e]];
    }
  for (int n = 0; n < graph.number_of_nodes(); ++n) {
    if (graph.extremum[n] >= 0)
      position[n] = points[graph.extremum[n]];
    else
      position[n] /=
          number[n]; // not a number for the inside of a rectangle, which has neither contour nor extremum
  }
  return position;
}

} // namespace

Skeleton skeleton(const Charted_surface& charted) {
  Skeleton result;
  const Reeb_graph& graph = charted.graph;
  result.nodes = node_positions(charted);
  const std::vector<Bands> charts = measure(charted);
  for (std::size_t c = 0; c < charts.size(); ++c) {
    std::vector<Point> line;
    for (int band = 0; band < bands; ++band)
      if (charts[c].area[band] > 0) line.push_back(charts[c].sum[band] / charts[c].area[band]);
    Point &low = result.nodes[graph.arcs[c].low], &high = result.nodes[graph.arcs[c].high];
    if (!line.empty() && !low.allFinite()) low = line.front();
    if (!line.empty() && !high.allFinite()) high = line.back();
    line.insert(line.begin(), low);
    line.push_back(high);
    smooth(line);
    result.arcs.push_back(std::move(line));
  }
  return result;
}

} // namespace studio
} // namespace reebquad
