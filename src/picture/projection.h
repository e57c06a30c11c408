// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to the renderer: from the model's space to samples of the picture.
#ifndef REEBQUAD_PICTURE_PROJECTION_H
#define REEBQUAD_PICTURE_PROJECTION_H

#include <CGAL/Reeb_quadrangulation/render.h>

#include <Eigen/Geometry>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A place on the picture. `x`, `y` in samples from the upper left corner, `z` in samples away from the eye;
/// `q`, the inverse of the homogeneous coordinate, is 1 in an orthographic view. All of `z`, `q`, and
/// anything times `q` is affine on the picture.
struct Screen_point {
  double x = 0, y = 0, z = 0, q = 1;
  bool valid = false;
};

/// The rectangle, in samples, into which the scene is fitted.
struct Viewport {
  double left = 0, top = 0, width = 0, height = 0;
};

/// Maps points so that the scene just fits the viewport.
class Projection {
public:
  Projection(const Scene& scene, const Camera& camera, const Viewport& viewport);

  /// False if the scene has no point to show.
  bool sees_something() const { return m_sees_something; }
  Screen_point operator()(const Point& p) const;
  /// A normal in the eye's frame: x to the right, y up, z towards the eye.
  Eigen::Vector3f turned(const Eigen::Vector3f& normal) const;

private:
  Screen_point before_fit(const Point& p) const;

  Eigen::Matrix3d m_frame; // rows: right, up, away from the eye
  Point m_centre = Point::Zero();
  double m_size = 1;     // half the diagonal of the bounding box; lengths are divided by it
  double m_distance = 0; // of the eye, in units of m_size; 0 is infinity
  double m_scale = 1, m_shift_x = 0, m_shift_y = 0;
  bool m_sees_something = false;
};

/// True if the point can be shown: finite, and small enough that its square is finite too.
inline bool is_drawable(const Point& p) {
  return p.allFinite() && p.lpNorm<Eigen::Infinity>() < 1e150;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_PICTURE_PROJECTION_H
