// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/corners.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

Disjoint_sets::Disjoint_sets(int size) : m_parent(std::size_t(size)) {
  std::iota(m_parent.begin(), m_parent.end(), 0);
}

Corner_mesh corner_mesh(const Polygon_soup& soup, const std::vector<char>& taken) {
  Corner_mesh mesh;
  mesh.source = soup.corner;
  mesh.next.resize(soup.corner.size());
  mesh.face.resize(soup.corner.size());
  for (int p = 0; p < soup.number_of_polygons(); ++p)
    for (int c = soup.begin[p]; c < soup.begin[p + 1]; ++c) {
      mesh.next[c] = c + 1 < soup.begin[p + 1] ? c + 1 : soup.begin[p];
      mesh.face[c] = taken[p] ? p : -1;
    }
  return mesh;
}

Corner_mesh corner_mesh(const std::vector<Triangle>& triangles) {
  Corner_mesh mesh;
  const std::size_t n = 3 * triangles.size();
  mesh.source.resize(n);
  mesh.next.resize(n);
  mesh.face.resize(n);
  for (std::size_t c = 0; c < n; ++c) {
    mesh.source[c] = triangles[c / 3][c % 3];
    mesh.next[c] = Triangle_surface::next(int(c));
    mesh.face[c] = int(c / 3);
  }
  return mesh;
}

Edge_groups group_edges(const Corner_mesh& mesh, int number_of_points) {
  const int n = mesh.number_of_corners();
  const auto low = [&](int c) { return std::min(mesh.source[c], mesh.target(c)); };
  const auto high = [&](int c) { return std::max(mesh.source[c], mesh.target(c)); };
  std::vector<int> begin(std::size_t(number_of_points) + 1, 0);
  for (int c = 0; c < n; ++c)
    if (mesh.face[c] >= 0) ++begin[low(c) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Edge_groups edges;
  edges.side.resize(std::size_t(begin.back()));
  std::vector<int> end(begin.begin(), begin.end() - 1);
  for (int c = 0; c < n; ++c)
    if (mesh.face[c] >= 0) edges.side[end[low(c)]++] = c;

  edges.begin.reserve(edges.side.size() / 2 + 2);
  for (int v = 0; v < number_of_points; ++v) {
    const auto first = edges.side.begin() + begin[v], last = edges.side.begin() + begin[v + 1];
    std::sort(first, last, [&](int c, int d) { return high(c) != high(d) ? high(c) < high(d) : c < d; });
    for (auto it = first; it != last; ++it)
      if (it + 1 == last || high(*it) != high(it[1])) edges.begin.push_back(int(it - edges.side.begin()) + 1);
  }
  return edges;
}

bool are_collinear(const Point& a, const Point& b, const Point& c) {
  // A component of the cross product that is far above its rounding error decides nearly always.
  const Point u = b - a, v = c - a;
  const double bound = 16 * std::numeric_limits<double>::epsilon();
  for (int k = 0; k < 3; ++k) {
    const double p = u[k] * v[(k + 1) % 3], q = u[(k + 1) % 3] * v[k];
    if (std::abs(p - q) > bound * (std::abs(p) + std::abs(q)) && std::abs(p - q) > 1e-280) return false;
  }
  using Exact_point = Exact_predicates_inexact_constructions_kernel::Point_3;
  return collinear(Exact_point(a[0], a[1], a[2]), Exact_point(b[0], b[1], b[2]),
                   Exact_point(c[0], c[1], c[2]));
}

bool is_flat(const Polygon_soup& soup, int polygon) {
  const int first = soup.begin[polygon], last = soup.begin[polygon + 1];
  const auto point = [&](int c) -> const Point& { return soup.points[soup.corner[c]]; };
  for (int c = first; c < last; ++c)
    if (!point(c).allFinite()) return false;
  int other = first;
  while (other < last && point(other) == point(first)) ++other;
  for (int c = other + 1; c < last; ++c)
    if (!are_collinear(point(first), point(other), point(c))) return false;
  return true;
}

std::string text_of(const Point& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p[0], p[1], p[2]);
  return text;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
