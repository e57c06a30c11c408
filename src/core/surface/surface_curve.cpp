// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Vertex_constraints.h>

#include "base/segments.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

double within(const Surface_curve& c, double t) {
  if (c.length() == 0) return 0;
  return c.closed ? t - c.length() * std::floor(t / c.length()) : std::min(c.length(), std::max(0.0, t));
}

// The segment at an arc length within the curve.
std::size_t segment_at(const Surface_curve& c, double t) {
  const auto after = std::upper_bound(c.arc.begin() + 1, c.arc.end() - 1, t);
  return std::size_t(after - c.arc.begin()) - 1;
}

} // namespace

Point Surface_curve::at(double t) const {
  t = within(*this, t);
  const std::size_t i = segment_at(*this, t);
  if (t == arc[i + 1]) return points[i + 1];
  return points[i] + (t - arc[i]) / (arc[i + 1] - arc[i]) * (points[i + 1] - points[i]);
}

Point Surface_curve::tangent(double t) const {
  const std::size_t i = segment_at(*this, within(*this, t));
  return (points[i + 1] - points[i]).normalized();
}

const Point& Surface_curve::normal(double t) const {
  CGAL_precondition(normals.size() + 1 == points.size());
  return normals[segment_at(*this, within(*this, t))];
}

double Surface_curve::nearest(const Point& p, double low, double high) const {
  if (!closed) {
    low = std::max(0.0, low);
    high = std::min(length(), high);
  }
  double best = low, least = (at(low) - p).squaredNorm();
  // By segments and not by arc lengths, whose rounding could stop it between two.
  const std::size_t segments = points.size() - 1;
  double turn =
      closed && length() > 0 ? length() * std::floor(low / length()) : 0; // arc length of the first point
  for (std::size_t i = segment_at(*this, low - turn); turn + arc[i] < high;) {
    const double along = nearest_coordinate(p, points[i], points[i + 1]);
    const double t = std::clamp(turn + arc[i] + along * (arc[i + 1] - arc[i]), low, high);
    if (const double d = (at(t) - p).squaredNorm(); d < least) {
      least = d;
      best = t;
    }
    if (++i < segments) continue;
    if (!closed || !(length() > 0)) break;
    i = 0;
    turn += length();
  }
  return best;
}

Surface_curve make_surface_curve(const std::vector<Point>& points, bool closed) {
  Surface_curve curve;
  curve.closed = closed;
  for (const Point& p : points) {
    if (!curve.points.empty() && curve.points.back() == p) continue;
    curve.arc.push_back(curve.points.empty() ? 0 : curve.arc.back() + (p - curve.points.back()).norm());
    curve.points.push_back(p);
  }
  CGAL_precondition(!curve.points.empty());
  if (curve.points.size() == 1) { // all equal
    curve.points.push_back(curve.points[0]);
    curve.arc.push_back(0);
  }
  return curve;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
