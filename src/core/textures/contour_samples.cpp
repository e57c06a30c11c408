// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Placed_texture.h>

#include "base/strictly_increasing.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

using internal::strictly_increasing;

namespace {

void normalise(std::vector<double>& x) {
  const double first = x.front(), range = x.back() - first;
  for (double& value : x) value = range > 0 ? (value - first) / range : 0;
  x.back() = 1;
}

std::vector<double> arc_lengths(const std::vector<Point>& points, const std::vector<double>& density,
                                const Contour_edge& edge) {
  std::vector<double> s{0.0};
  for (std::size_t i = 1; i < edge.vertices.size(); ++i) {
    const int a = edge.vertices[i - 1], b = edge.vertices[i];
    const double times = density.empty() ? 1 : 0.5 * (density[a] + density[b]);
    s.push_back(s.back() + times * (points[b] - points[a]).norm());
  }
  if (!(s.back() > 0) || !strictly_increasing(s))
    for (std::size_t i = 0; i < s.size(); ++i)
      s[i] = double(i); // all points coincide: only the order is left
  normalise(s);
  return s;
}

int end_of(const Walk& walk, std::size_t i) {
  return i + 1 < walk.edges.size() ? walk.edges[i + 1].begin : int(walk.vertices.size());
}

} // namespace

std::vector<std::vector<double>> contour_parameters(const std::vector<Point>& points,
                                                    const Contour_network& network, const Atlas& atlas,
                                                    const std::vector<const Chart_parameterization*>& maps,
                                                    double blend, std::vector<std::vector<double>> known,
                                                    const std::vector<double>& density) {
  const std::size_t n = network.edges.size();
  std::vector<std::vector<double>> parameter = std::move(known), natural(n);
  parameter.resize(n);
  std::vector<int> sides(n, 0);
  for (std::size_t c = 0; c < atlas.charts.size(); ++c) {
    const Chart& chart = *atlas.charts[c];
    if (chart.kind != Chart_kind::annulus) continue;
    for (const Walk& walk : chart.walks) {
      const std::vector<double>& v = maps[c]->natural(walk.side);
      for (std::size_t i = 0; i < walk.edges.size(); ++i) {
        const int e = walk.edges[i].edge;
        if (!parameter[e].empty()) continue;
        std::vector<double> part(v.begin() + walk.edges[i].begin, v.begin() + end_of(walk, i) + 1);
        if (!walk.edges[i].forward) {
          std::reverse(part.begin(), part.end());
          for (double& x : part) x = -x;
        }
        normalise(part);
        if (natural[e].empty()) natural[e].assign(part.size(), 0.0);
        for (std::size_t k = 0; k < part.size(); ++k) natural[e][k] += part[k];
        ++sides[e];
      }
    }
  }
  for (std::size_t e = 0; e < n; ++e) {
    if (network.is_removed(network.edges[e])) parameter[e].clear();
    if (network.is_removed(network.edges[e]) || !parameter[e].empty()) continue;
    parameter[e] = arc_lengths(points, density, network.edges[e]);
    if (sides[e] == 0) continue;
    std::vector<double> blended(parameter[e].size());
    for (std::size_t k = 0; k < blended.size(); ++k)
      blended[k] = (1 - blend) * parameter[e][k] + blend * natural[e][k] / sides[e];
    if (strictly_increasing(blended)) parameter[e] = std::move(blended);
    parameter[e].back() = 1;
  }
  return parameter;
}

std::vector<double> walk_coordinates(const Walk& walk, const Contour_samples& samples) {
  std::vector<double> x;
  x.reserve(walk.vertices.size() + 1);
  int before = 0;
  for (const Walk_edge& we : walk.edges) {
    const std::vector<double>& p = samples.parameter[we.edge];
    const int n = samples.counts[we.edge], last = int(p.size()) - 1;
    for (int k = 0; k < last; ++k) x.push_back(before + n * (we.forward ? p[k] : 1 - p[last - k]));
    before += n;
  }
  x.push_back(before);
  return x;
}

std::vector<int> anchored_vertices(const Placed_texture& placed) {
  std::vector<std::pair<double, double>> anchors;
  for (const Eigen::Vector2d& p : placed.anchors) anchors.emplace_back(p.x(), p.y());
  std::sort(anchors.begin(), anchors.end());
  std::vector<int> found;
  for (std::size_t v = 0; v < placed.texture.v.size(); ++v)
    if (std::binary_search(anchors.begin(), anchors.end(),
                           std::make_pair(placed.texture.v[v], placed.texture.u[v])))
      found.push_back(int(v));
  return found;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
