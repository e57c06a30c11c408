// SPDX-License-Identifier: GPL-3.0-or-later
// Points that lie on each other, or a hair apart.
#ifndef REEBQUAD_BASE_EQUAL_POINTS_H
#define REEBQUAD_BASE_EQUAL_POINTS_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// For each point the first point with the same coordinates (-0 and 0 are the same; NaN is only itself).
std::vector<int> first_equal_points(const std::vector<Point>& points);

/// For each point a point before it that is nearer than `distance` and stands for itself, or the point itself
/// if there is none: no two points that stand for themselves are nearer to each other. With distance 0 the
/// same as `first_equal_points()`. O(n) where no place holds many points. \pre `distance` is finite and not
/// negative.
std::vector<int> first_near_points(const std::vector<Point>& points, double distance);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_EQUAL_POINTS_H
