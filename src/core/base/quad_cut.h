// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_QUAD_CUT_H
#define REEBQUAD_BASE_QUAD_CUT_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The corner, 0 or 1, at which a quad is cut into two triangles: 0, since its first diagonal may lie on a
/// sharp edge, unless that leaves a half turned over and the other diagonal does not.
inline int first_corner_of_cut(const Point& p0, const Point& p1, const Point& p2, const Point& p3) {
  const Point mean = (p2 - p0).cross(p3 - p1);
  const auto outward = [&](const Point& a, const Point& b, const Point& c) {
    return (b - a).cross(c - a).dot(mean) > 0;
  };
  const bool first = outward(p0, p1, p2) && outward(p0, p2, p3);
  return first || !(outward(p1, p2, p3) && outward(p1, p3, p0)) ? 0 : 1;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_QUAD_CUT_H
