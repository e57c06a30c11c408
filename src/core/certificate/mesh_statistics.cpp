// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include "certificate/coverage.h"
#include "certificate/sharp_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

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
  Range_of lengths;
  for (const auto& [v, w] : edges_of(mesh, std::vector<char>(mesh.quads.size(), 1)))
    lengths.add((mesh.points[w] - mesh.points[v]).norm());
  result.edge_length = lengths.range();
}

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
  const Split_quads split = split_quads(sound, std::vector<char>(sound.quads.size(), 1));
  const Triangle_tree tree(sound.points, split.triangles);
  Nearest_quad nearest(sound, split, tree);
  if (nearest.empty()) return result;
  const Input_surface surface = read_input(*input);
  result.undersampled_area =
      undersampled_area(nearest, surface, result.quad_area.mean, options.input_samples);
  if (const auto covered = covered_sharp_edges(
          nearest, input->points, sharp_edges(surface, options.feature_angle), result.edge_length.mean)) {
    result.covered_sharp_edges = covered->by_edges;
    result.folded_sharp_edges = covered->by_triangles;
  }
  return result;
}

void add_shape(Mesh_statistics& statistics, const Shape_kept& shape) {
  statistics.undersampled_area = shape.undersampled_area;
  statistics.covered_sharp_edges = shape.covered_sharp_edges;
  statistics.folded_sharp_edges = shape.folded_sharp_edges;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
