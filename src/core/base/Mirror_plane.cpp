// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Mirror_plane.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

// A normal of length 1 stays as it is, to the bit.
Eigen::Vector3d unit(const Eigen::Vector3d& normal) {
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  const Eigen::Vector3d scaled = normal / normal.cwiseAbs().maxCoeff();
  if (std::abs(normal.squaredNorm() - 1) <= rounding) return normal;
  return scaled.normalized();
}

double last_digit(double x) {
  return std::ldexp(1.0, std::ilogb(x) - 52);
}

} // namespace

int Mirror_plane::axis() const {
  int found = -1;
  for (int k = 0; k < 3; ++k) {
    if (normal[k] == 0) continue;
    if (found >= 0) return -1;
    found = k;
  }
  return found;
}

Point Mirror_plane::reflected(const Point& p) const {
  const int k = axis();
  if (k < 0) return p - 2 * signed_distance(p) * normal;
  Point image = p;
  image[k] = (point[k] - p[k]) + point[k];
  return image;
}

Point Mirror_plane::projected(const Point& p) const {
  const int k = axis();
  if (k < 0) return p - signed_distance(p) * normal;
  Point foot = p;
  foot[k] = point[k];
  return foot;
}

std::string to_text(const Mirror_plane& plane) {
  const int k = plane.axis();
  if (k >= 0) return std::string(1, "xyz"[k]) + " = " + number(plane.point[k]);
  return "(" + number(plane.normal.x()) + ", " + number(plane.normal.y()) + ", " + number(plane.normal.z()) +
         ") . p = " + number(plane.normal.dot(plane.point));
}

bool are_exact_images(const Mirror_plane& plane, const Point& p, const Point& q) {
  const int k = plane.axis();
  if (k < 0) return false;
  for (int i = 0; i < 3; ++i)
    if (i != k && p[i] != q[i]) return false;
  // What a sum of two numbers loses by rounding is a floating point number itself.
  const double sum = p[k] + q[k], part = sum - p[k];
  const double lost = (p[k] - (sum - part)) + (q[k] - part);
  return lost == 0 && sum == 2 * plane.point[k];
}

Mirror_grid::Mirror_grid(const Mirror_plane& plane, const std::vector<Point>& points) : m_plane(plane) {
  m_plane.normal = unit(plane.normal);
  const int k = m_plane.axis();
  if (k < 0) return;
  const double sign = m_plane.normal[k] > 0 ? 1 : -1;
  m_plane.normal = Eigen::Vector3d::Zero();
  m_plane.normal[k] = sign;
  double& c = m_plane.point[k];
  if (c == 0) c = 0; // not -0
  // Rounding may bring the plane past a power of two, which makes the step another one; then once more.
  for (double before = 0; c != before;) {
    double reach = std::abs(c);
    for (const Point& p : points) reach = std::max(reach, std::abs(c) + std::abs(p[k] - c));
    m_step = last_digit(2 * reach); // quads may leave the box a little
    before = c;
    c = std::nearbyint(c / m_step) * m_step;
  }
  if (c == 0) m_step = 0;
}

Point Mirror_grid::rounded(const Point& p) const {
  Point result = p;
  const int k = m_plane.axis();
  if (k >= 0 && m_step > 0) result[k] = std::nearbyint(p[k] / m_step) * m_step;
  if (k >= 0 && result[k] == 0) result[k] = 0; // not -0
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
