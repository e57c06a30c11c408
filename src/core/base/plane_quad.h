// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_PLANE_QUAD_H
#define REEBQUAD_BASE_PLANE_QUAD_H

#include <array>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A point (V, U) of a chart's map.
struct Plane_point {
  double v = 0, u = 0;
};

/// A quad in the plane: on an annulus its corners follow the first without a jump.
using Plane_quad = std::array<Plane_point, 4>;

/// The sign of the area of abc: 1 if counterclockwise. Exact.
int orientation(const Plane_point& a, const Plane_point& b, const Plane_point& c);

/// Whether a diagonal splits the quad into two counterclockwise triangles. Exact.
bool is_simple_counterclockwise(const Plane_quad& q);

/// Whether the point is in the closed quad. \pre `is_simple_counterclockwise(q)`
bool contains(const Plane_quad& q, const Plane_point& p);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_PLANE_QUAD_H
