// SPDX-License-Identifier: GPL-3.0-or-later
#include "textures/texture_plane.h"

#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

double Texture_plane::wrapped(double v) const {
  if (!m_periodic) return v;
  const double w = snapped(v - std::floor(v));
  return w >= 1 ? 0 : w;
}

Plane_point Texture_plane::between(const Plane_point& a, const Plane_point& b, double fraction) const {
  // Ends and equal coordinates are kept exactly, so that points of a side stay on it.
  if (fraction <= 0) return a;
  if (fraction >= 1) return b;
  const double dv = step(a.v, b.v), du = b.u - a.u;
  return {wrapped(dv == 0 ? a.v : a.v + fraction * dv), du == 0 ? a.u : a.u + fraction * du};
}

bool Texture_plane::unroll(const std::vector<double>& v, const std::vector<double>& u, const Quad& q,
                           Plane_quad& out) const {
  double turns = 0;
  for (int i = 0; i < 4; ++i) {
    const int a = q[i], b = q[(i + 1) % 4];
    out[i] = {snapped(v[a]) + turns, u[a]};
    if (!m_periodic) continue;
    if (std::abs(snapped(v[b]) - snapped(v[a])) == 0.5) return false;
    turns += turn(v[a], v[b]);
  }
  return turns == 0;
}

bool Texture_plane::is_valid(const std::vector<double>& v, const std::vector<double>& u,
                             const Quad& q) const {
  Plane_quad p;
  return unroll(v, u, q, p) && is_simple_counterclockwise(p);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
