// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_GEOMETRY_H
#define REEBQUAD_CERTIFICATE_GEOMETRY_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <Eigen/Geometry>

#include <vector>

/// \file
/// The geometry of one quad as the certificate and the statistics define it.

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

using Quad_corners = std::array<Point, 4>;

inline Quad_corners corners(const Quad_mesh& mesh, int q) {
  const Quad& quad = mesh.quads[q];
  return {mesh.points[quad[0]], mesh.points[quad[1]], mesh.points[quad[2]], mesh.points[quad[3]]};
}

/// The vector area: half the cross product of the diagonals. It is parallel to the cross product of the
/// principal axes.
inline Point vector_area(const Quad_corners& p) {
  return 0.5 * (p[2] - p[0]).cross(p[3] - p[1]);
}

/// See `certify()`. Lengths are taken out before products are formed, so that the scale cannot matter.
inline double scaled_jacobian(const Quad_corners& p) {
  Point side[4];
  for (int i = 0; i < 4; ++i) {
    side[i] = p[(i + 1) % 4] - p[i];
    const double length = side[i].stableNorm();
    if (!(length > 0)) return 0;
    side[i] /= length;
  }
  const Point first = p[2] - p[0], second = p[3] - p[1];
  const double first_length = first.stableNorm(), second_length = second.stableNorm();
  if (!(first_length > 0) || !(second_length > 0)) return 0;
  Point normal = (first / first_length).cross(second / second_length);
  const double length = normal.norm();
  if (!(length > 0)) return 0;
  normal /= length;
  double least = 1;
  for (int i = 0; i < 4; ++i) least = std::min(least, normal.dot(side[(i + 3) % 4].cross(side[i])));
  return least;
}

/// Whether no coordinate of the quad is infinite or not a number.
inline bool is_finite(const Quad_corners& p) {
  return p[0].allFinite() && p[1].allFinite() && p[2].allFinite() && p[3].allFinite();
}

/// Triangles of the quads that are usable and finite, and the quad of each.
struct Split_quads {
  std::vector<Triangle> triangles;
  std::vector<int> quad;
};

/// Splits at the shorter diagonal, or at equal lengths at the one that has the smallest index of the four.
Split_quads split_quads(const Quad_mesh& mesh, const std::vector<char>& usable);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_GEOMETRY_H
