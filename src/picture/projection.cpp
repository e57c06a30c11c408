// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {
namespace {

template <class Visitor> void for_each_shown_point(const Scene& scene, Visitor visit) {
  for (const Scene::Face& face : scene.faces) {
    bool drawable = true;
    for (const int v : face) drawable = drawable && (v < 0 || is_drawable(scene.points[v]));
    for (const int v : face)
      if (drawable && v >= 0) visit(scene.points[v]);
  }
  for (const Scene_line& line : scene.lines)
    if (is_drawable(line.a) && is_drawable(line.b)) visit(line.a), visit(line.b);
  for (const Scene_dot& dot : scene.dots)
    if (is_drawable(dot.centre)) visit(dot.centre);
}

Eigen::Matrix3d frame_of(const Camera& camera) {
  Point away = camera.direction.stableNormalized();
  if (!away.allFinite() || away.norm() < 0.5) away = Point(0, 0, -1);
  Point up = camera.up.stableNormalized();
  // An up direction within a tenth of a degree of the line of sight says nothing; the axis least along it
  // serves instead.
  if (!up.allFinite() || away.cross(up).norm() < 2e-3) {
    int axis = 0;
    away.cwiseAbs().minCoeff(&axis);
    up = Point::Unit(axis);
  }
  Eigen::Matrix3d frame;
  const Point right = away.cross(up).normalized();
  frame << right.transpose(), right.cross(away).transpose(), away.transpose();
  return frame;
}

struct Box {
  double low[3], high[3];
  Box() {
    std::fill(low, low + 3, std::numeric_limits<double>::infinity());
    std::fill(high, high + 3, -std::numeric_limits<double>::infinity());
  }
  void add(int i, double x) {
    low[i] = std::min(low[i], x);
    high[i] = std::max(high[i], x);
  }
  double middle(int i) const { return low[i] / 2 + high[i] / 2; }
  double extent(int i) const { return high[i] - low[i]; }
  bool empty() const { return low[0] > high[0]; }
};

} // namespace

Projection::Projection(const Scene& scene, const Camera& camera, const Viewport& viewport)
    : m_frame(frame_of(camera)) {
  Box box;
  for_each_shown_point(scene, [&](const Point& p) {
    for (int i = 0; i < 3; ++i) box.add(i, p[i]);
  });
  if (box.empty()) return;
  m_sees_something = true;
  m_centre = Point(box.middle(0), box.middle(1), box.middle(2));
  m_size = Point(box.extent(0), box.extent(1), box.extent(2)).stableNorm() / 2;
  if (!(m_size > 0)) m_size = 1;
  const double half_angle = std::min(std::max(camera.field_of_view, 0.0), 90.0) * std::acos(-1.0) / 360;
  m_distance = half_angle > 1e-3 ? 1.05 / std::sin(half_angle) : 0;

  Box seen;
  for_each_shown_point(scene, [&](const Point& p) {
    const Screen_point s = before_fit(p);
    seen.add(0, s.x);
    seen.add(1, s.y);
  });
  const double floor_size = 1e-9; // a single point is not magnified without end
  m_scale = std::min(viewport.width / std::max(seen.extent(0), floor_size),
                     viewport.height / std::max(seen.extent(1), floor_size));
  if (seen.extent(0) < floor_size && seen.extent(1) < floor_size) m_scale = viewport.height / 2;
  m_scale *= camera.zoom > 0 ? camera.zoom : 1;
  m_shift_x = viewport.left + viewport.width / 2 - m_scale * seen.middle(0);
  m_shift_y = viewport.top + viewport.height / 2 + m_scale * seen.middle(1);
}

Screen_point Projection::before_fit(const Point& p) const {
  Screen_point s;
  if (!is_drawable(p)) return s;
  const Point e = m_frame * ((p - m_centre) / m_size);
  s.q = m_distance > 0 ? m_distance / (m_distance + e[2]) : 1;
  s.x = e[0] * s.q;
  s.y = e[1] * s.q;
  s.z = e[2] * s.q;
  s.valid = true;
  return s;
}

Screen_point Projection::operator()(const Point& p) const {
  Screen_point s = before_fit(p);
  s.x = m_shift_x + m_scale * s.x;
  s.y = m_shift_y - m_scale * s.y;
  s.z *= m_scale;
  // Far outside, by zooming: beyond the range of the exact coordinates.
  s.valid = s.valid && std::abs(s.x) < 4e6 && std::abs(s.y) < 4e6;
  return s;
}

Eigen::Vector3f Projection::turned(const Eigen::Vector3f& normal) const {
  const Point e = m_frame * normal.cast<double>();
  return Eigen::Vector3f(float(e[0]), float(e[1]), float(-e[2]));
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
