// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

// Whether a segment runs along a point of a sharp edge with this direction.
bool runs_along(const Point& p, const Point& q, const Point& at, const Point& direction) {
  static const double cosine = std::cos(std::acos(-1.0) / 9);
  const Point way = q - p;
  const double length = way.norm();
  if (!(length > 0) || std::abs(way.dot(direction)) < cosine * length) return false;
  const double t = std::min(1.0, std::max(0.0, way.dot(at - p) / (length * length)));
  return (p + t * way - at).norm() <= 0.05 * length;
}

} // namespace

std::optional<Covered_edges> covered_sharp_edges(Nearest_quad& nearest, const std::vector<Point>& points,
                                                 const std::vector<std::pair<int, int>>& sharp,
                                                 double mean_edge) {
  double all = 0;
  Covered_edges covered;
  for (const auto& [v, w] : sharp) {
    const Point p = points[v], way = points[w] - p;
    const double length = way.norm();
    if (!(length > 0)) continue;
    // Pieces of at most a quarter of a quad's edge.
    const int pieces = int(std::min(1000.0, 1 + std::floor(4 * length / mean_edge)));
    for (int i = 0; i < pieces; ++i) {
      const Point at = p + (i + 0.5) / pieces * way;
      all += length / pieces;
      const Quad_corners quad = nearest(at);
      const auto along = [&](int j, int k) { return runs_along(quad[j], quad[k], at, way / length); };
      const bool by_edge = along(0, 1) || along(1, 2) || along(2, 3) || along(3, 0);
      if (by_edge) covered.by_edges += length / pieces;
      if (by_edge || along(0, 2)) covered.by_triangles += length / pieces;
    }
  }
  if (!(all > 0)) return std::nullopt;
  return Covered_edges{covered.by_edges / all, covered.by_triangles / all};
}

bool has_vertex_at(const Quad_corners& quad, const Point& at) {
  constexpr double near_corner = 0.1;
  double edge = 0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i) {
    edge += 0.25 * (quad[(i + 1) % 4] - quad[i]).norm();
    least = std::min(least, (quad[i] - at).norm());
  }
  return least <= near_corner * edge;
}

std::vector<std::pair<int, int>> edges_of(const Quad_mesh& mesh, const std::vector<char>& usable) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(4 * mesh.quads.size());
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    for (int i = 0; usable[q] && i < 4; ++i)
      edges.push_back(std::minmax({mesh.quads[q][i], mesh.quads[q][(i + 1) % 4]}));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
