// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/distance.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

// Measures sample points one after the other; neighbours in order are mostly neighbours in space.
class Distance_to {
public:
  Distance_to(const Triangle_tree& tree, double diagonal, const Observer* observer)
      : m_tree(tree), m_diagonal(diagonal), m_observer(observer) {}

  void add(const Point& p, std::int64_t sample) {
    if (m_count % 1024 == 0 && m_observer && m_observer->cancelled()) m_cancelled = true;
    if (m_cancelled || !p.allFinite()) return;
    const Triangle_tree::Nearest nearest = m_tree.nearest(p, m_last);
    m_last = nearest.triangle;
    const double distance = std::sqrt(nearest.squared_distance) / m_diagonal;
    ++m_count;
    m_sum += distance;
    if (m_summary.farthest >= 0 && !(distance > m_summary.maximum)) return;
    m_summary.maximum = distance;
    m_summary.farthest = sample;
  }

  bool cancelled() const { return m_cancelled; }
  Distance_summary summary() const {
    Distance_summary result = m_summary;
    result.mean = m_count > 0 ? m_sum / double(m_count) : 0;
    return result;
  }

private:
  const Triangle_tree& m_tree;
  double m_diagonal;
  const Observer* m_observer;
  Distance_summary m_summary;
  double m_sum = 0;
  std::int64_t m_count = 0;
  int m_last = -1;
  bool m_cancelled = false;
};

} // namespace

Input_surface read_input(const Triangle_surface& surface) {
  Input_surface input{surface, analyse(surface.triangles, int(surface.points.size()), Fans::single), {}};
  input.triangles.reserve(surface.triangles.size());
  std::vector<char> finite(surface.points.size());
  for (std::size_t v = 0; v < finite.size(); ++v) finite[v] = surface.points[v].allFinite();
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    if (input.topology.usable[f] && finite[t[0]] && finite[t[1]] && finite[t[2]])
      input.triangles.push_back(t);
  }
  return input;
}

std::vector<Input_sample> sample_triangles(const Input_surface& input, int per_component) {
  const std::vector<Point>& points = input.surface.points;
  std::vector<int> seen(input.topology.components.size(), 0);
  std::vector<Input_sample> samples;
  for (const Triangle& t : input.triangles) {
    const int component = input.topology.component[t[0]];
    const int faces = input.topology.components[component].faces;
    const int stride = per_component > 0 ? (faces + per_component - 1) / per_component : 1;
    if (seen[component]++ % stride != 0) continue;
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    samples.push_back({(a + b + c) / 3, 0.5 * stride * (b - a).cross(c - a)});
  }
  return samples;
}

std::optional<Certificate_distance> measure_distance(const Quad_mesh& mesh, const std::vector<char>& usable,
                                                     const Triangle_tree& quad_tree,
                                                     const Input_surface& input,
                                                     const Certificate_options& options) {
  Eigen::AlignedBox3d box;
  std::vector<char> used(input.surface.points.size(), 0);
  for (const Triangle& t : input.triangles)
    for (int v : t) {
      box.extend(input.surface.points[v]);
      used[v] = 1;
    }
  Certificate_distance result;
  result.diagonal = box.diagonal().stableNorm();

  const Triangle_tree input_tree(input.surface.points, input.triangles);
  Distance_to from_vertices(input_tree, result.diagonal, options.observer),
      from_centres = from_vertices, from_input(quad_tree, result.diagonal, options.observer);
  std::vector<char> quad_vertex(mesh.points.size(), 0);
  for (int q = 0; q < int(mesh.quads.size()); ++q) {
    if (!usable[q]) continue;
    const Quad_corners p = corners(mesh, q);
    from_centres.add((p[0] + p[1] + p[2] + p[3]) / 4, q);
    for (int i = 0; i < 4; ++i)
      if (!std::exchange(quad_vertex[mesh.quads[q][i]], 1)) from_vertices.add(p[i], mesh.quads[q][i]);
  }
  const auto count = std::count(used.begin(), used.end(), 1);
  const auto wanted = options.distance_samples > 0 ? options.distance_samples : count;
  const auto stride = std::max<std::int64_t>(1, (count + wanted - 1) / std::max<std::int64_t>(1, wanted));
  std::int64_t seen = 0;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] && seen++ % stride == 0) from_input.add(input.surface.points[v], std::int64_t(v));

  if (from_vertices.cancelled() || from_centres.cancelled() || from_input.cancelled()) return std::nullopt;
  result.vertices = from_vertices.summary();
  result.centres = from_centres.summary();
  result.input_vertices = from_input.summary();
  return result;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
