// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/shape_measure.h"

#include "certificate/area_distance.h"
#include "certificate/sharp_lines.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

using Box = Eigen::AlignedBox3d;

constexpr double lost = 1; // by the mean edge of the quads: how far area is that is lost

double area(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles)
    sum += 0.5 * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
  return sum;
}

Box box_of(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  Box box;
  for (const Triangle& t : triangles)
    for (int v : t) box.extend(points[v]);
  return box;
}

class Shape_measure {
public:
  Shape_measure(const Quad_mesh& mesh, const std::vector<char>& usable, const Split_quads& split,
                const Triangle_tree& tree, const Input_surface& input, const Certificate_options& options)
      : m_mesh(mesh), m_split(split), m_tree(tree), m_input(input), m_options(options), m_usable(usable) {
    double sum = 0;
    const auto edges = edges_of(mesh, usable);
    for (const auto& [v, w] : edges) sum += (mesh.points[w] - mesh.points[v]).norm();
    m_mean_edge = edges.empty() ? 0 : sum / double(edges.size());
  }

  std::optional<Shape_kept> run() {
    measure_boxes();
    if (!measure_distances()) return std::nullopt;
    measure_areas();
    count_components();
    measure_sharp_lines();
    return m_result;
  }

private:
  void measure_boxes() {
    m_box = box_of(m_input.points(), m_input.triangles);
    const Box quads = box_of(m_mesh.points, m_split.triangles);
    m_result.diagonal = m_box.diagonal().stableNorm();
    const double shift = std::max((quads.min() - m_box.min()).cwiseAbs().maxCoeff(),
                                  (quads.max() - m_box.max()).cwiseAbs().maxCoeff());
    m_result.box_shift = shift / m_result.diagonal;
  }

  // In the input's unit; turned into fractions of the diagonal at the end.
  bool measure_distances() {
    const Distance_precision precision{m_options.distance_error, 1e-4 * m_result.diagonal,
                                       m_options.distance_queries};
    m_samples = area_samples(m_input.points(), m_input.triangles, m_options.area_samples);
    const auto from_input =
        area_distance(m_input.points(), m_input.triangles, m_tree, precision, m_samples, m_options.observer);
    if (!from_input) return false;
    const Triangle_tree input_tree(m_input.points(), m_input.triangles);
    std::vector<Area_sample> samples =
        area_samples(m_mesh.points, m_split.triangles, m_options.area_samples / 2);
    const auto from_quads =
        area_distance(m_mesh.points, m_split.triangles, input_tree, precision, samples, m_options.observer);
    if (!from_quads) return false;
    m_result.from_input = by_diagonal(*from_input);
    m_result.from_quads = by_diagonal(*from_quads);
    return true;
  }

  Area_distance by_diagonal(Area_distance d) const {
    for (double* x : {&d.maximum, &d.bound, &d.mean}) *x /= m_result.diagonal;
    return d;
  }

  void measure_areas() {
    m_result.input_area = area(m_input.points(), m_input.triangles);
    m_result.quad_area = area(m_mesh.points, m_split.triangles);
    if (m_samples.empty()) return;
    double quads = 0, vector_areas = 0;
    for (std::size_t q = 0; q < m_mesh.quads.size(); ++q)
      if (m_usable[q]) {
        ++quads;
        vector_areas += vector_area(corners(m_mesh, int(q))).norm();
      }
    const double large = 10 * vector_areas / quads;
    std::size_t far = 0, undersampled = 0;
    for (const Area_sample& sample : m_samples) {
      far += sample.distance > lost * m_mean_edge;
      undersampled += vector_area(corners(m_mesh, m_split.quad[sample.nearest])).norm() > large;
    }
    m_result.lost_area = double(far) / double(m_samples.size());
    m_result.undersampled_area = double(undersampled) / double(m_samples.size());
  }

  // A component is lost if the quads come nowhere near to it, as measured by its own size.
  void count_components() {
    const std::vector<int>& component = m_input.topology.component;
    const std::size_t n = m_input.topology.components.size();
    std::vector<Box> boxes(n);
    std::vector<double> nearest(n, std::numeric_limits<double>::infinity());
    for (const Area_sample& sample : m_samples) {
      double& least = nearest[component[m_input.triangles[sample.triangle][0]]];
      least = std::min(least, sample.distance);
    }
    for (const Triangle& t : m_input.triangles) {
      const int c = component[t[0]];
      for (int v : t) boxes[c].extend(m_input.points()[v]);
      if (std::isinf(nearest[c])) // too small for a sample
        nearest[c] = std::sqrt(m_tree.nearest(m_input.points()[t[0]]).squared_distance);
    }
    for (std::size_t c = 0; c < n; ++c) {
      const double diagonal = boxes[c].isEmpty() ? 0 : boxes[c].diagonal().norm();
      if (diagonal <= 1e-6 * m_result.diagonal) continue; // a point or a speck of rounding
      ++m_result.components;
      m_result.lost_components += nearest[c] > 0.5 * diagonal;
    }
  }

  void measure_sharp_lines() {
    const auto sharp = sharp_edges(m_input, Sharp_limits::angle);
    Nearest_quad nearest(m_mesh, m_split, m_tree);
    const auto lines = long_lines(m_input.points(), sharp, Sharp_limits::long_line * m_mean_edge);
    if (const auto covered = covered_sharp_edges(nearest, m_input.points(), lines, m_mean_edge))
      m_result.covered_sharp_lines = covered->by_edges;
    if (const auto covered = covered_sharp_edges(nearest, m_input.points(), sharp, m_mean_edge)) {
      m_result.covered_sharp_edges = covered->by_edges;
      m_result.folded_sharp_edges = covered->by_triangles;
    }
    for (int v : corners_of(sharp)) {
      ++m_result.corners;
      if (has_vertex_at(nearest(m_input.points()[v]), m_input.points()[v])) continue;
      if (m_result.missed_corners++ == 0) m_result.missed_corner = m_input.points()[v];
    }
  }

  std::vector<int> corners_of(const std::vector<std::pair<int, int>>& sharp) const {
    return certification::corners(m_input.points(), sharp, Sharp_limits::angle,
                                  Sharp_limits::corner_line * m_mean_edge);
  }

  const Quad_mesh& m_mesh;
  const Split_quads& m_split;
  const Triangle_tree& m_tree;
  const Input_surface& m_input;
  const Certificate_options& m_options;
  const std::vector<char>& m_usable;
  double m_mean_edge = 0;
  Box m_box;
  std::vector<Area_sample> m_samples; // of the input
  Shape_kept m_result;
};

} // namespace

std::optional<Shape_kept> measure_shape(const Quad_mesh& mesh, const std::vector<char>& usable,
                                        const Split_quads& split, const Triangle_tree& tree,
                                        const Input_surface& input, const Certificate_options& options) {
  return Shape_measure(mesh, usable, split, tree, input, options).run();
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
