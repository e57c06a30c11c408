// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Skeleton.h"

#include <algorithm>
#include <limits>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr int bands = 14;

double mean(const std::vector<double>& values, const Triangle& t) {
  return (values[t[0]] + values[t[1]] + values[t[2]]) / 3;
}

/// The centroids of triangles by bands of the field.
std::vector<Point> banded(const std::vector<Point>& points, const std::vector<const Triangle*>& triangles,
                          const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Triangle* t : triangles) {
    low = std::min(low, mean(values, *t));
    high = std::max(high, mean(values, *t));
  }
  std::vector<Point> sum(bands, Point::Zero());
  std::vector<double> area(bands, 0);
  for (const Triangle* t : triangles) {
    const Point &p = points[(*t)[0]], &q = points[(*t)[1]], &r = points[(*t)[2]];
    const double part = low < high ? (mean(values, *t) - low) / (high - low) : 0.5;
    const int band = std::clamp(int(bands * part), 0, bands - 1);
    const double weight = (q - p).cross(r - p).norm();
    sum[band] += weight * (p + q + r) / 3;
    area[band] += weight;
  }
  std::vector<Point> line;
  for (int band = 0; band < bands; ++band)
    if (area[band] > 0) line.push_back(sum[band] / area[band]);
  return line;
}

/// Of all charts.
std::vector<std::vector<Point>> measure(const Charted_surface& charted) {
  const Triangle_surface& surface = charted.embedding.surface;
  std::vector<std::vector<const Triangle*>> triangles(charted.graph.arcs.size());
  for (int f = 0; f < surface.number_of_faces(); ++f)
    if (const int chart = charted.chart_of_face[f]; chart >= 0)
      triangles[chart].push_back(&surface.triangles[f]);
  std::vector<std::vector<Point>> lines;
  for (const std::vector<const Triangle*>& chart : triangles)
    lines.push_back(banded(surface.points, chart, charted.values));
  return lines;
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

std::vector<Point> line_of_chart(const Triangle_surface& mesh, const std::vector<double>& values) {
  std::vector<const Triangle*> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) triangles.push_back(&t);
  return banded(mesh.points, triangles, values);
}

Skeleton skeleton(const Charted_surface& charted) {
  Skeleton result;
  const Reeb_graph& graph = charted.graph;
  result.nodes = node_positions(charted);
  const std::vector<std::vector<Point>> lines = charted.lines ? *charted.lines : measure(charted);
  for (std::size_t c = 0; c < lines.size(); ++c) {
    std::vector<Point> line = lines[c];
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
