// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MIRROR_PLANE_H
#define CGAL_REEB_QUADRANGULATION_MIRROR_PLANE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <string>

/// \file
/// Planes of symmetry, and which points are exactly each other's images.
///
/// The reflection in a plane across a coordinate axis, x = c, is x -> 2c - x. In floating point it rounds,
/// unless c is zero or c and x are multiples of one power of two that all sums keep: `Mirror_grid` has that
/// power for the points of a surface. A plane of any other normal has no reflection that floating point
/// numbers hold exactly: images are then equal up to rounding, which is measured and told.

namespace CGAL {
namespace Reeb_quadrangulation {

/// A plane, and which side of it the half surface lies on: where the normal points to.
struct Mirror_plane {
  Point point = Point::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d(1, 0, 0); ///< of length 1; along an axis exactly +1 or -1

  /// The axis that the plane lies across, 0 to 2; -1 if the normal has two coordinates that are not zero.
  int axis() const;
  double signed_distance(const Point& p) const { return normal.dot(p - point); }
  /// The image of a point. Exact where `Mirror_grid` says so.
  Point reflected(const Point& p) const;
  /// The nearest point of the plane; of a plane across an axis its coordinate is that of `point`, exactly.
  Point projected(const Point& p) const;
};

/// "x = 0.5", or "(0.577, 0.577, 0.577) . p = 1.2".
std::string to_text(const Mirror_plane& plane);

/// Whether two points are each other's images exactly, in real arithmetic, across a plane x = c, y = c or z =
/// c: their coordinates add up to 2c, without rounding, and the others are equal. Never true for other
/// planes.
bool are_exact_images(const Mirror_plane& plane, const Point& p, const Point& q);

/// Rounds the coordinate across a plane so that points and their images are exactly each other's reflections.
class Mirror_grid {
public:
  /// For points within the box of `points`, and their images. The step is the last binary digit of the
  /// largest coordinate: where the plane goes through 0, nothing is rounded.
  Mirror_grid(const Mirror_plane& plane, const std::vector<Point>& points);

  /// The plane with its normal scaled, and its coordinate rounded if it lies across an axis. Done twice it
  /// gives the same bits as once.
  const Mirror_plane& plane() const { return m_plane; }
  /// The point with its coordinate across the plane rounded.
  Point rounded(const Point& p) const;

private:
  Mirror_plane m_plane;
  double m_step = 0; ///< 0: nothing is rounded
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MIRROR_PLANE_H
