// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/followed_guide.h>

#include "base/pi.h"
#include "base/quad_connectivity.h"
#include "base/segment_tree.h"
#include "base/segments.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A stroke is measured at so many points for each edge of the quads, but not at more than the second number.
constexpr double strokes_points_per_edge = 8, most_points_of_a_stroke = 1e5;

// How near an edge lies that a stroke is on, in its own length.
constexpr double on_a_stroke = 0.1;

class Stroke_measure {
public:
  explicit Stroke_measure(const Quad_mesh& mesh) : m_mesh(mesh) {
    internal::connect_quads(mesh.quads, int(mesh.points.size()), m_opposite);
    double sum = 0;
    for (int h = 0; h < int(m_opposite.size()); ++h) {
      if (m_opposite[std::size_t(h)] >= 0 && m_opposite[std::size_t(h)] < h) continue;
      const auto [a, b] = ends(h);
      if (a == b) continue;
      m_edges.add(a, b);
      m_halfedges.push_back(h);
      sum += (b - a).norm();
    }
    m_edges.build();
    m_mean = sum / double(m_halfedges.size());
  }

  Followed_guide of(const Surface_curve& stroke) const {
    Followed_guide result;
    result.length = stroke.length();
    const int n =
        int(std::clamp(strokes_points_per_edge * result.length / m_mean, 8.0, most_points_of_a_stroke));
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n * result.length;
      const std::array<double, 2> found = at(stroke.at(t), stroke.tangent(t));
      result.angle += found[0] / n;
      result.distance += found[1] / n;
      result.on += (found[1] <= on_a_stroke) / double(n);
    }
    return result;
  }

private:
  std::array<Point, 2> ends(int h) const {
    return {m_mesh.points[std::size_t(internal::source(m_mesh.quads, h))],
            m_mesh.points[std::size_t(internal::target(m_mesh.quads, h))]};
  }

  // The angle with the edge that runs along here, and its distance.
  std::array<double, 2> at(const Point& p, const Point& tangent) const {
    const int nearest = m_halfedges[m_edges.nearest(p).segment];
    std::array<double, 2> best{180, 0};
    const auto try_edge = [&](int h) {
      const auto [a, b] = ends(h);
      const Point d = b - a;
      const double angle = std::atan2(d.cross(tangent).norm(), std::abs(d.dot(tangent))) * 180 / pi;
      const double distance = std::sqrt(squared_distance_to_segment(p, a, b)) / d.norm();
      const bool runs = angle <= 45, ran = best[0] <= 45;
      if (runs != ran ? runs : runs ? distance < best[1] : angle < best[0]) best = {angle, distance};
    };
    for (const int side : {nearest, m_opposite[std::size_t(nearest)]})
      for (int i = 0, h = side; i < 4 && h >= 0; ++i, h = internal::next(h))
        if (const auto [a, b] = ends(h); a != b) try_edge(h);
    return best;
  }

  const Quad_mesh& m_mesh;
  std::vector<int> m_opposite, m_halfedges; // the second of the edges of the tree
  internal::Segment_tree m_edges;
  double m_mean = 0;
};

} // namespace

Followed_guide followed_guide(const Quad_mesh& mesh, const Surface_curve& stroke) {
  return Stroke_measure(mesh).of(stroke);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
