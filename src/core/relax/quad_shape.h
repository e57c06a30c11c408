// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_RELAX_QUAD_SHAPE_H
#define REEBQUAD_RELAX_QUAD_SHAPE_H

#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The scaled Jacobian of a quad, or less if its shortest edge is shorter than a fiftieth of its longest. The
/// scaled Jacobian alone looks at angles, and corners that nearly meet may have good ones.
inline double quad_shape(const Point& p0, const Point& p1, const Point& p2, const Point& p3) {
  constexpr double thinnest = 1.0 / 50;
  const auto [least, most] = std::minmax(
      {(p1 - p0).squaredNorm(), (p2 - p1).squaredNorm(), (p3 - p2).squaredNorm(), (p0 - p3).squaredNorm()});
  const double jacobian = scaled_jacobian(p0, p1, p2, p3);
  return least < thinnest * thinnest * most ? std::min(jacobian, std::sqrt(least / most) / thinnest)
                                            : jacobian;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_RELAX_QUAD_SHAPE_H
