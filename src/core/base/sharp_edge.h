// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_SHARP_EDGE_H
#define REEBQUAD_BASE_SHARP_EDGE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <Eigen/Geometry>

#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The normal of a face, as long as twice its area.
inline Point area_normal(const Triangle_surface& s, int f) {
  const Triangle& t = s.triangles[f];
  return (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
}

/// The cosine of an angle in degrees.
inline double cosine_of(double degrees) {
  return std::cos(degrees * (std::acos(-1.0) / 180));
}

/// Whether faces with these area normals meet at more than the angle of that cosine.
inline bool is_sharp(const Point& m, const Point& n, double cosine) {
  return m.dot(n) < cosine * std::sqrt(m.squaredNorm() * n.squaredNorm());
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_SHARP_EDGE_H
