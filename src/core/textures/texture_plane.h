// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_TEXTURES_TEXTURE_PLANE_H
#define REEBQUAD_TEXTURES_TEXTURE_PLANE_H

#include "base/plane_quad.h"

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The plane in which a texture's parameters live: the strip around a cylinder, or the plane itself.
class Texture_plane {
public:
  explicit Texture_plane(bool periodic) : m_periodic(periodic) {}

  bool is_periodic() const { return m_periodic; }
  /// V on the grid where a whole turn can be added exactly.
  double snapped(double v) const { return m_periodic ? (v + 1) - 1 : v; }
  /// V in [0, 1), snapped.
  double wrapped(double v) const;
  /// From V to V the shorter way.
  double step(double from, double to) const { return snapped(to) - snapped(from) + turn(from, to); }
  /// The whole turns to add to `to` so that it follows `from` the shorter way.
  double turn(double from, double to) const {
    const double d = snapped(to) - snapped(from);
    return !m_periodic ? 0 : d > 0.5 ? -1 : d < -0.5 ? 1 : 0;
  }
  /// The point at a fraction of the way from a to b.
  Plane_point between(const Plane_point& a, const Plane_point& b, double fraction) const;
  /// Unrolls a quad; false if it goes around the annulus, or has an edge of half a turn.
  bool unroll(const std::vector<double>& v, const std::vector<double>& u, const Quad& q,
              Plane_quad& out) const;
  /// Whether a quad is as `check_texture_plane()` wants it.
  bool is_valid(const std::vector<double>& v, const std::vector<double>& u, const Quad& q) const;

private:
  bool m_periodic;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_TEXTURES_TEXTURE_PLANE_H
