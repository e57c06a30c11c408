// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/guide_lines.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Directions are noted so often for each edge of the quads, but not more often than the second number.
constexpr double directions_per_edge = 2, most_directions = 1e5;

// The direction in which a field rises in a face, or zero.
Point rise(const Triangle_surface& s, int face, const std::vector<double>& values) {
  const Triangle& t = s.triangles[std::size_t(face)];
  const Point &a = s.points[std::size_t(t[0])], &b = s.points[std::size_t(t[1])],
              &c = s.points[std::size_t(t[2])];
  const Point n = (b - a).cross(c - a);
  const double x = values[std::size_t(t[0])], y = values[std::size_t(t[1])], z = values[std::size_t(t[2])];
  return n.cross(x * (c - b) + y * (a - c) + z * (b - a)).stableNormalized();
}

int segment_of(const Surface_curve& curve, double t) {
  const auto after = std::upper_bound(curve.arc.begin() + 1, curve.arc.end() - 1, t);
  return int(after - curve.arc.begin()) - 1;
}

} // namespace

double level_part(const Triangle_surface& surface, const Stroke& stroke, const std::vector<double>& values) {
  double level = 0;
  for (std::size_t i = 0; i < stroke.faces.size(); ++i) {
    const Point way = stroke.curve.points[i + 1] - stroke.curve.points[i];
    const double length = stroke.curve.arc[i + 1] - stroke.curve.arc[i];
    const double along = std::abs(way.dot(rise(surface, stroke.faces[i], values)));
    if (2 * along * along < length * length) level += length;
  }
  return level / stroke.curve.length();
}

std::vector<Guide_line> guide_lines(const Surface_projector& projector, const Design& design) {
  std::vector<Guide_line> lines;
  for (const Design_guide& guide : design.guides) {
    lines.push_back({guide.guide, {}});
    if (guide.guide.way == Guide_way::nearer || !design.field) continue;
    const Result<Stroke> stroke = trace_stroke(projector, guide.guide);
    if (!stroke) continue; // it is said where the quads are finished
    const double length = stroke->curve.length();
    const int n = int(std::clamp(directions_per_edge * length / design.edge_length, 8.0, most_directions));
    for (int i = 0; i <= n; ++i) {
      const int segment = segment_of(stroke->curve, length * i / n);
      lines.back().flow.push_back(
          rise(projector.surface(), stroke->faces[std::size_t(segment)], design.field->values));
    }
  }
  return lines;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
