// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/layout_sampling.h>

#include <algorithm>
#include <memory>
#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A segment that one walk passes on both sides may have any count; other edges have even ones (see
// sampling.h).
std::vector<char> passed_twice(const Contour_network& network, const Atlas& atlas) {
  std::vector<char> twice(network.edges.size(), 0);
  for (const std::shared_ptr<const Chart>& chart : atlas.charts)
    for (const Walk& walk : chart->walks) {
      std::set<int> seen;
      for (const Walk_edge& e : walk.edges)
        if (!seen.insert(e.edge).second) twice[e.edge] = 1;
    }
  return twice;
}

double length(const std::vector<Point>& points, const std::vector<double>& density,
              const Contour_edge& edge) {
  double sum = 0;
  for (std::size_t k = 1; k < edge.vertices.size(); ++k) {
    const int a = edge.vertices[k - 1], b = edge.vertices[k];
    sum += (density.empty() ? 1 : 0.5 * (density[a] + density[b])) * (points[b] - points[a]).norm();
  }
  return sum;
}

// Two discs of one quad each would have the same four vertices.
bool between_discs(const Atlas& atlas, int edge) {
  for (int c : atlas.charts_of_edge[edge])
    if (c < 0 || atlas.charts[c]->kind != Chart_kind::disc) return false;
  return true;
}

// The middle segment of a rectangle that closes on itself may be much shorter than the rectangle is in that
// direction: its wish is the mean of both.
void widen_middle_segments(const Chart& rectangle, const std::vector<char>& twice,
                           const std::vector<int>& index, Sampling_problem& problem) {
  double across = 0;
  int loops = 0;
  for (const Walk_edge& e : rectangle.walks[0].edges)
    if (!twice[e.edge]) {
      across += problem.edges[index[e.edge]].length;
      ++loops;
    }
  if (loops == 0 || !(across > 0)) return;
  const double along = area(rectangle.mesh) * loops / across;
  for (const Walk_edge& e : rectangle.walks[0].edges) {
    double& length = problem.edges[index[e.edge]].length;
    if (twice[e.edge] && e.forward && length < along) length = 0.5 * (length + along);
  }
}

} // namespace

Layout_sampling_problem sampling_problem(const std::vector<Point>& points, const Contour_network& network,
                                         const Atlas& atlas, const std::vector<double>& heights,
                                         const std::vector<double>& density) {
  Layout_sampling_problem result;
  std::vector<int> index(network.edges.size(), -1);
  const std::vector<char> twice = passed_twice(network, atlas);
  double longest = 0;
  for (std::size_t i = 0; i < network.edges.size(); ++i) {
    const Contour_edge& edge = network.edges[i];
    if (network.is_removed(edge)) continue;
    Sampling_edge e;
    e.length = length(points, density, edge);
    e.minimum = edge.from == edge.to ? 4 : 2;
    if (twice[i]) e.step = 1;
    if (between_discs(atlas, int(i))) e.minimum = 8;
    longest = std::max(longest, e.length);
    index[i] = int(result.edges.size());
    result.edges.push_back(int(i));
    result.problem.edges.push_back(e);
  }
  // A contour whose points all coincide still needs a positive wish.
  for (Sampling_edge& e : result.problem.edges) e.length = std::max(e.length, 1e-9 * longest);
  for (std::size_t c = 0; c < atlas.charts.size(); ++c) {
    const Chart& chart = *atlas.charts[c];
    Sampling_chart s;
    s.kind = chart.kind == Chart_kind::disc ? Sampling_chart::Kind::disc : Sampling_chart::Kind::annulus;
    s.height = heights[c];
    for (const Walk& walk : chart.walks)
      for (const Walk_edge& e : walk.edges)
        (walk.side == Side::low ? s.low : s.high).push_back(index[e.edge]);
    const std::vector<int> corners = rectangle_corners(network, chart);
    if (!corners.empty()) {
      std::copy(corners.begin(), corners.end(), s.corners.begin());
      widen_middle_segments(chart, twice, index, result.problem);
    }
    result.problem.charts.push_back(std::move(s));
  }
  return result;
}

Layout_sampling_problem sampling_problem(const Reeb_layout& layout, const std::vector<double>& heights) {
  return sampling_problem(layout.embedding.surface.points, layout.network, layout.atlas, heights);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
