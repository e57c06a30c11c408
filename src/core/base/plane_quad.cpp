// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/plane_quad.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

int orientation(const Plane_point& a, const Plane_point& b, const Plane_point& c) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  const Kernel::Point_2 p(a.v, a.u), q(b.v, b.u), r(c.v, c.u);
  return int(Kernel().orientation_2_object()(p, q, r));
}

bool is_simple_counterclockwise(const Plane_quad& q) {
  return (orientation(q[0], q[1], q[2]) > 0 && orientation(q[0], q[2], q[3]) > 0) ||
         (orientation(q[1], q[2], q[3]) > 0 && orientation(q[1], q[3], q[0]) > 0);
}

namespace {

bool triangle_contains(const Plane_point& a, const Plane_point& b, const Plane_point& c,
                       const Plane_point& p) {
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

} // namespace

bool contains(const Plane_quad& q, const Plane_point& p) {
  if (orientation(q[0], q[1], q[2]) > 0 && orientation(q[0], q[2], q[3]) > 0)
    return triangle_contains(q[0], q[1], q[2], p) || triangle_contains(q[0], q[2], q[3], p);
  return triangle_contains(q[1], q[2], q[3], p) || triangle_contains(q[1], q[3], q[0], p);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
