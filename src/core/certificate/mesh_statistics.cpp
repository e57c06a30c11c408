// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include "certificate/distance.h"
#include "certificate/geometry.h"
#include "certificate/topology.h"
#include "certificate/tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using namespace certification;

class Range_of {
public:
  void add(double x) {
    m_minimum = std::min(m_minimum, x);
    m_maximum = std::max(m_maximum, x);
    m_sum += x;
    ++m_count;
  }
  Value_range range() const {
    return m_count == 0 ? Value_range{} : Value_range{m_minimum, m_sum / double(m_count), m_maximum};
  }

private:
  double m_minimum = std::numeric_limits<double>::infinity();
  double m_maximum = -std::numeric_limits<double>::infinity();
  double m_sum = 0;
  std::int64_t m_count = 0;
};

template <std::size_t N> void count_in(std::array<int, N>& histogram, double x, double low, double high) {
  const double place = std::floor(double(N) * (x - low) / (high - low));
  ++histogram[std::size_t(std::min(double(N - 1), std::max(0.0, place)))];
}

// The mesh without the quads that cannot be measured.
Quad_mesh measurable(const Quad_mesh& mesh) {
  const Soup_topology topology = analyse(mesh.quads, int(mesh.points.size()), Fans::single);
  Quad_mesh sound{mesh.points, {}};
  sound.quads.reserve(mesh.quads.size());
  for (int q = 0; q < int(mesh.quads.size()); ++q)
    if (topology.usable[q] && is_finite(corners(mesh, q))) sound.quads.push_back(mesh.quads[q]);
  return sound;
}

void count_valences(const Soup_topology& topology, Mesh_statistics& result) {
  result.edges = topology.edges;
  for (std::size_t v = 0; v < topology.valence.size(); ++v) {
    const int valence = topology.valence[v];
    if (valence == 0) continue;
    const bool boundary = topology.on_boundary[v];
    const int difference = std::abs(valence - (boundary ? 3 : 4));
    ++result.vertices;
    ++(boundary ? result.boundary_valences : result.interior_valences)[valence];
    if (difference > 0) ++result.extraordinary_vertices;
    result.largest_valence_difference = std::max(result.largest_valence_difference, difference);
  }
}

void measure_angles(const Quad_mesh& mesh, Mesh_statistics& result) {
  const double degrees = 180 / std::acos(-1.0);
  Range_of angles, deviations;
  for (int q = 0; q < int(mesh.quads.size()); ++q) {
    const Quad_corners p = corners(mesh, q);
    for (int i = 0; i < 4; ++i) {
      const Point a = p[(i + 1) % 4] - p[i], b = p[(i + 3) % 4] - p[i];
      const double la = a.stableNorm(), lb = b.stableNorm();
      if (!(la > 0) || !(lb > 0)) continue;
      const double angle = degrees * std::atan2((a / la).cross(b / lb).norm(), (a / la).dot(b / lb));
      angles.add(angle);
      deviations.add(std::abs(angle - 90));
      count_in(result.angle_histogram, angle, 0, 180);
    }
  }
  result.angle = angles.range();
  result.angle_deviation = deviations.range();
}

void measure_quads(const Quad_mesh& mesh, Mesh_statistics& result) {
  Range_of jacobians, areas;
  for (int q = 0; q < int(mesh.quads.size()); ++q) {
    const Quad_corners p = corners(mesh, q);
    const double jacobian = scaled_jacobian(p);
    jacobians.add(jacobian);
    count_in(result.scaled_jacobian_histogram, jacobian, -1, 1);
    if (!(jacobian > 0)) ++result.inverted_quads;
    areas.add(vector_area(p).norm());
  }
  result.scaled_jacobian = jacobians.range();
  result.quad_area = areas.range();
  if (!mesh.quads.empty()) result.quad_area_ratio = result.quad_area.maximum / result.quad_area.minimum;
}

void measure_edges(const Quad_mesh& mesh, Mesh_statistics& result) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(4 * mesh.quads.size());
  for (const Quad& quad : mesh.quads)
    for (int i = 0; i < 4; ++i) edges.push_back(std::minmax({quad[i], quad[(i + 1) % 4]}));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Range_of lengths;
  for (const auto& [v, w] : edges) lengths.add((mesh.points[w] - mesh.points[v]).norm());
  result.edge_length = lengths.range();
}

// Which quad is nearest to a point; from one point to the next near it is quickest.
class Nearest_quad {
public:
  explicit Nearest_quad(const Quad_mesh& mesh)
      : m_mesh(mesh), m_split(split_quads(mesh, std::vector<char>(mesh.quads.size(), 1))),
        m_tree(mesh.points, m_split.triangles) {}

  Nearest_quad(const Nearest_quad&) = delete; // the tree refers to the split

  bool empty() const { return m_tree.empty(); }
  Quad_corners operator()(const Point& p) {
    m_last = m_tree.nearest(p, m_last).triangle;
    return corners(m_mesh, m_split.quad[m_last]);
  }

private:
  const Quad_mesh& m_mesh;
  Split_quads m_split;
  Triangle_tree m_tree;
  int m_last = -1;
};

std::optional<double> undersampled_area(Nearest_quad& nearest, const Input_surface& input, double mean_area,
                                        int samples) {
  double all = 0, undersampled = 0;
  for (const Input_sample& sample : sample_triangles(input, samples)) {
    const double area = sample.vector_area.norm();
    all += area;
    if (vector_area(nearest(sample.centre)).norm() > 10 * mean_area) undersampled += area;
  }
  if (!(all > 0)) return std::nullopt;
  return undersampled / all;
}

// The edges of the input whose two faces meet at more than an angle, as pairs of vertices.
std::vector<std::pair<int, int>> sharp_edges(const Input_surface& input, double angle) {
  const std::vector<Point>& points = input.surface.points;
  const int n = int(input.triangles.size());
  const auto normal = [&](int t) {
    const Triangle& v = input.triangles[t];
    return Point((points[v[1]] - points[v[0]]).cross(points[v[2]] - points[v[0]]).stableNormalized());
  };
  // The sides of the triangles by their smaller vertex: the other vertex and the triangle.
  std::vector<int> begin(points.size() + 1, 0);
  std::vector<std::pair<int, int>> sides(3 * std::size_t(n));
  const auto smaller = [&](int t, int i) {
    return std::min(input.triangles[t][i], input.triangles[t][(i + 1) % 3]);
  };
  for (int t = 0; t < n; ++t)
    for (int i = 0; i < 3; ++i) ++begin[smaller(t, i) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> end(begin.begin(), begin.end() - 1);
  for (int t = 0; t < n; ++t)
    for (int i = 0; i < 3; ++i)
      sides[end[smaller(t, i)]++] = {std::max(input.triangles[t][i], input.triangles[t][(i + 1) % 3]), t};
  const double cosine = std::cos(angle * std::acos(-1.0) / 180);
  std::vector<std::pair<int, int>> sharp;
  for (int v = 0; v < int(points.size()); ++v) {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1]);
    for (int i = begin[v], j = i; i < begin[v + 1]; i = j) {
      while (j < begin[v + 1] && sides[j].first == sides[i].first) ++j;
      if (j == i + 2 && normal(sides[i].second).dot(normal(sides[i + 1].second)) < cosine)
        sharp.push_back({v, sides[i].first});
    }
  }
  return sharp;
}

// Whether a segment runs along a point of a sharp edge with this direction.
bool runs_along(const Point& p, const Point& q, const Point& at, const Point& direction) {
  const double cosine = std::cos(std::acos(-1.0) / 9);
  const Point way = q - p;
  const double length = way.norm();
  if (!(length > 0) || std::abs(way.dot(direction)) < cosine * length) return false;
  const double t = std::min(1.0, std::max(0.0, way.dot(at - p) / (length * length)));
  return (p + t * way - at).norm() <= 0.05 * length;
}

// The parts of the sharp edges' length that edges of quads run along, and edges or first diagonals.
struct Covered {
  double by_edges, by_triangles;
};

std::optional<Covered> covered_sharp_edges(Nearest_quad& nearest, const Input_surface& input,
                                           double mean_edge, double angle) {
  double all = 0;
  Covered covered{0, 0};
  for (const auto& [v, w] : sharp_edges(input, angle)) {
    const Point p = input.surface.points[v], way = input.surface.points[w] - p;
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
  return Covered{covered.by_edges / all, covered.by_triangles / all};
}

} // namespace

Mesh_statistics quad_statistics(const Quad_mesh& mesh, const Triangle_surface* input,
                                const Statistics_options& options) {
  const Quad_mesh sound = measurable(mesh);
  Mesh_statistics result;
  result.quads = int(sound.quads.size());
  result.skipped_quads = int(mesh.quads.size() - sound.quads.size());
  count_valences(analyse(sound.quads, int(sound.points.size()), Fans::single), result);
  measure_angles(sound, result);
  measure_quads(sound, result);
  measure_edges(sound, result);
  if (!input) return result;
  Nearest_quad nearest(sound);
  if (nearest.empty()) return result;
  const Input_surface surface = read_input(*input);
  result.undersampled_area =
      undersampled_area(nearest, surface, result.quad_area.mean, options.input_samples);
  if (const auto covered =
          covered_sharp_edges(nearest, surface, result.edge_length.mean, options.feature_angle)) {
    result.covered_sharp_edges = covered->by_edges;
    result.folded_sharp_edges = covered->by_triangles;
  }
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
