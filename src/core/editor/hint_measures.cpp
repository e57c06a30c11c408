// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hint_measures.h"

#include "base/segments.h"
#include "certificate/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {

Quad_mesh quads_of(const Design_chart& chart) {
  Quad_mesh mesh;
  for (const Chart_location& location : chart.texture.location)
    mesh.points.push_back(position(*chart.chart, location));
  const Quad_texture& texture = chart.texture.texture;
  for (std::size_t q = 0; q < texture.quads.size(); ++q)
    if (!texture.is_hole(int(q))) mesh.quads.push_back(texture.quads[q]);
  return mesh;
}

std::vector<const Design_chart*> charts_not_in(const Design& design, const Design& other) {
  std::set<const Design_chart*> theirs;
  for (const auto& chart : other.charts) theirs.insert(chart.get());
  std::vector<const Design_chart*> rest;
  for (const auto& chart : design.charts)
    if (!theirs.count(chart.get())) rest.push_back(chart.get());
  return rest;
}

namespace {

double aspect(const certification::Quad_corners& p) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (int i = 0; i < 4; ++i) {
    const double length = (p[(i + 1) % 4] - p[i]).norm();
    least = std::min(least, length);
    most = std::max(most, length);
  }
  return least > 0 ? std::min(most / least, 1e6) : 1e6; // a quad without a width counts, but not alone
}

template <class Measure>
double mean_over_quads(const std::vector<const Design_chart*>& charts, const Measure& measure) {
  double sum = 0;
  std::size_t count = 0;
  for (const Design_chart* chart : charts) {
    const Quad_mesh mesh = quads_of(*chart);
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) sum += measure(certification::corners(mesh, int(q)));
    count += mesh.quads.size();
  }
  return count > 0 ? sum / double(count) : 0;
}

} // namespace

double mean_aspect(const std::vector<const Design_chart*>& charts) {
  return mean_over_quads(charts, aspect);
}

double mean_scaled_jacobian(const std::vector<const Design_chart*>& charts) {
  return mean_over_quads(charts, certification::scaled_jacobian);
}

double distance_to_quads(const Point& point, const std::vector<const Design_chart*>& charts) {
  double least = std::numeric_limits<double>::infinity();
  for (const Design_chart* chart : charts)
    for (const Chart_location& location : chart->texture.location)
      least = std::min(least, (position(*chart->chart, location) - point).squaredNorm());
  return std::sqrt(least);
}

double mean_distance(const std::vector<Point>& points, const Segments& segments) {
  double sum = 0;
  for (const Point& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::array<Point, 2>& segment : segments)
      least = std::min(least, squared_distance_to_segment(p, segment[0], segment[1]));
    sum += std::sqrt(least);
  }
  return points.empty() ? 0 : sum / double(points.size());
}

std::vector<Point> contour_points(const Triangle_surface& surface, const Contour_network& network, int edge) {
  std::vector<Point> points;
  for (int v : network.edges[edge].vertices) points.push_back(network.position(surface, v));
  return points;
}

Segments segments_of(const std::vector<Point>& polyline) {
  Segments segments;
  for (std::size_t i = 1; i < polyline.size(); ++i) segments.push_back({polyline[i - 1], polyline[i]});
  return segments;
}

bool is_free_loop(const Contour_network& network, int edge) {
  const Contour_edge& e = network.edges[std::size_t(edge)];
  return !network.is_removed(e) && e.from == e.to &&
         network.nodes[std::size_t(e.from)].kind == Node_kind::regular;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
