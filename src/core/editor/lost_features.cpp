// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lost_features.h"

#include "base/equal_points.h"
#include "editor/hint_measures.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

std::vector<Lost_line> lost_lines(const Deviation& deviation) {
  const auto& edges = deviation.lost_sharp_edges;
  std::vector<Point> ends; // two of each edge
  for (const auto& [a, b] : edges) ends.insert(ends.end(), {a, b});
  const std::vector<int> same = first_equal_points(ends);
  std::vector<int> piece(ends.size());
  std::iota(piece.begin(), piece.end(), 0);
  const auto root = [&](int v) {
    while (piece[std::size_t(v)] != v) v = piece[std::size_t(v)] = piece[std::size_t(piece[std::size_t(v)])];
    return v;
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int a = root(same[2 * i]), b = root(same[2 * i + 1]);
    piece[std::size_t(std::max(a, b))] = std::min(a, b);
  }
  std::map<int, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < edges.size(); ++i) members[root(same[2 * i])].push_back(i);
  std::vector<Lost_line> lines;
  for (const auto& [first, all] : members) {
    Lost_line line;
    Point mean = Point::Zero();
    const auto middle = [&](std::size_t i) { return Point(0.5 * (edges[i][0] + edges[i][1])); };
    for (std::size_t i : all) {
      line.length += (edges[i][1] - edges[i][0]).norm();
      mean += middle(i) / double(all.size());
    }
    line.middle = middle(*std::min_element(all.begin(), all.end(), [&](std::size_t i, std::size_t j) {
      return (middle(i) - mean).squaredNorm() < (middle(j) - mean).squaredNorm();
    }));
    lines.push_back(line);
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Lost_line& a, const Lost_line& b) { return a.length > b.length; });
  return lines;
}

Result<Deviation> deviation_of(const Design& design, const Triangle_surface& surface,
                               const Observer* observer) {
  Quad_mesh all;
  for (const auto& chart : design.charts) {
    const Quad_mesh quads = quads_of(*chart);
    const int first = int(all.points.size());
    all.points.insert(all.points.end(), quads.points.begin(), quads.points.end());
    for (const Quad& q : quads.quads)
      all.quads.push_back({first + q[0], first + q[1], first + q[2], first + q[3]});
  }
  Deviation_options options;
  options.observer = observer;
  return measure_deviation(all, surface, options);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
