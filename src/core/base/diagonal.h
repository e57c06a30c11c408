// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_DIAGONAL_H
#define REEBQUAD_BASE_DIAGONAL_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <Eigen/Geometry>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The diagonal of the points' bounding box; 0 without points.
inline double diagonal_of(const std::vector<Point>& points) {
  Eigen::AlignedBox3d box;
  for (const Point& p : points) box.extend(p);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_DIAGONAL_H
