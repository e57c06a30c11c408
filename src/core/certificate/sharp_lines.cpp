// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/sharp_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

double cosine_of(double degrees) {
  return std::cos(degrees * std::acos(-1.0) / 180);
}

// A side of a triangle, filed under its smaller vertex.
struct Filed_side {
  int other;
  int triangle;
  bool downwards; // it runs from the greater vertex to the smaller
};

// The sides in the order of their smaller vertices, and where those of each begin.
std::pair<std::vector<Filed_side>, std::vector<int>> sides_by_vertex(const Input_surface& input) {
  const int n = int(input.triangles.size());
  std::vector<int> begin(input.points().size() + 1, 0);
  const auto corner = [&](int t, int i) { return input.triangles[t][i % 3]; };
  for (int t = 0; t < n; ++t)
    for (int i = 0; i < 3; ++i) ++begin[std::min(corner(t, i), corner(t, i + 1)) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> end(begin.begin(), begin.end() - 1);
  std::vector<Filed_side> sides(3 * std::size_t(n));
  for (int t = 0; t < n; ++t)
    for (int i = 0; i < 3; ++i) {
      const int v = corner(t, i), w = corner(t, i + 1);
      sides[end[std::min(v, w)]++] = {std::max(v, w), t, v > w};
    }
  return {std::move(sides), std::move(begin)};
}

// The sharp edges at each vertex that has some.
class Lines {
public:
  Lines(const std::vector<Point>& points, const std::vector<std::pair<int, int>>& sharp) : m_points(points) {
    for (const auto& [v, w] : sharp) {
      m_ends.push_back({v, w});
      m_ends.push_back({w, v});
    }
    std::sort(m_ends.begin(), m_ends.end());
  }

  template <class Visit> void for_vertices(const Visit& visit) const {
    for (auto first = m_ends.begin(), last = first; first != m_ends.end(); first = last) {
      while (last != m_ends.end() && last->first == first->first) ++last;
      visit(first->first, first, last);
    }
  }

  // How long the line is that leaves v to w, until it ends, branches or is `enough`.
  double length_from(int v, int w, double enough) const {
    const int start = v;
    double length = (m_points[w] - m_points[v]).norm();
    while (length < enough && w != start) {
      const auto [first, last] =
          std::equal_range(m_ends.begin(), m_ends.end(), std::pair<int, int>(w, -1),
                           [](const auto& a, const auto& b) { return a.first < b.first; });
      if (last - first != 2) break;
      const int next = first->second == v ? (last - 1)->second : first->second;
      length += (m_points[next] - m_points[w]).norm();
      v = w;
      w = next;
    }
    return length;
  }

private:
  const std::vector<Point>& m_points;
  std::vector<std::pair<int, int>> m_ends; // from each end of an edge to the other
};

} // namespace

std::vector<std::pair<int, int>> sharp_edges(const Input_surface& input, double angle) {
  const std::vector<Point>& points = input.points();
  std::vector<Point> normals(input.triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const Triangle& v = input.triangles[t];
    normals[t] = (points[v[1]] - points[v[0]]).cross(points[v[2]] - points[v[0]]).stableNormalized();
  }
  auto [sides, begin] = sides_by_vertex(input);
  const double cosine = cosine_of(angle);
  std::vector<std::pair<int, int>> sharp;
  for (int v = 0; v < int(points.size()); ++v) {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1],
              [](const Filed_side& a, const Filed_side& b) { return a.other < b.other; });
    for (int i = begin[v], j = i; i < begin[v + 1]; i = j) {
      while (j < begin[v + 1] && sides[j].other == sides[i].other) ++j;
      if (j != i + 2) continue;
      const double turn = normals[sides[i].triangle].dot(normals[sides[i + 1].triangle]);
      if ((sides[i].downwards == sides[i + 1].downwards ? -turn : turn) < cosine)
        sharp.push_back({v, sides[i].other});
    }
  }
  return sharp;
}

std::vector<std::pair<int, int>> long_lines(const std::vector<Point>& points,
                                            const std::vector<std::pair<int, int>>& sharp, double shortest) {
  const Lines lines(points, sharp);
  std::vector<std::pair<int, int>> result;
  for (const auto& [v, w] : sharp) {
    const double both = lines.length_from(v, w, shortest) + lines.length_from(w, v, shortest);
    if (both - (points[w] - points[v]).norm() >= shortest) result.push_back({v, w});
  }
  return result;
}

std::vector<int> corners(const std::vector<Point>& points, const std::vector<std::pair<int, int>>& sharp,
                         double angle, double shortest) {
  const Lines lines(points, sharp);
  const double cosine = cosine_of(angle);
  std::vector<int> found;
  lines.for_vertices([&](int v, auto first, auto last) {
    std::vector<Point> ways;
    for (auto end = first; end != last; ++end)
      if (last - first > 1 && lines.length_from(v, end->second, shortest) >= shortest)
        ways.push_back((points[end->second] - points[v]).stableNormalized());
    if (ways.size() > 2 || (ways.size() == 2 && -ways[0].dot(ways[1]) < cosine)) found.push_back(v);
  });
  return found;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
