// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a segment nearest to another point.
#ifndef REEBQUAD_BASE_SEGMENTS_H
#define REEBQUAD_BASE_SEGMENTS_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The coordinate t in [0, 1] of the point of segment ab nearest to p; 0 if a = b.
inline double nearest_coordinate(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double square = d.squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(d) / square, 0.0, 1.0) : 0;
}

inline Point nearest_on_segment(const Point& p, const Point& a, const Point& b) {
  return a + nearest_coordinate(p, a, b) * (b - a);
}

inline double squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  return (nearest_on_segment(p, a, b) - p).squaredNorm();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_SEGMENTS_H
