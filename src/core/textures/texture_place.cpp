// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Texture_place.h>

#include "textures/texture_plane.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

using internal::Plane_point;
using internal::Plane_quad;
using internal::Texture_plane;

namespace {

Texture_plane plane_of(const Quad_texture& texture) {
  return Texture_plane(texture.sides.size() == 2);
}

bool unroll(const Quad_texture& texture, int quad, Plane_quad& p) {
  return plane_of(texture).unroll(texture.v, texture.u, texture.quads[quad], p);
}

// A quad, and the point as it lies among the quad's unrolled corners.
struct Hit {
  Quad_corner corner;
  Plane_quad quad;
  Plane_point point;
};

Result<Hit> hit(const Quad_texture& texture, const Texture_place& place) {
  const Texture_plane plane = plane_of(texture);
  if (!std::isfinite(place.v) || !std::isfinite(place.u))
    return make_error(Error_code::refused_edit, "a place is not finite");
  for (int f = 0; f < int(texture.quads.size()); ++f) {
    const Quad& q = texture.quads[f];
    if (place.u < std::min({texture.u[q[0]], texture.u[q[1]], texture.u[q[2]], texture.u[q[3]]}) ||
        place.u > std::max({texture.u[q[0]], texture.u[q[1]], texture.u[q[2]], texture.u[q[3]]}))
      continue;
    Hit found{{f, 0}, {}, {}};
    if (!plane.unroll(texture.v, texture.u, q, found.quad) || !is_simple_counterclockwise(found.quad))
      continue;
    for (int turn = plane.is_periodic() ? -1 : 0; turn <= (plane.is_periodic() ? 1 : 0); ++turn) {
      found.point = {plane.wrapped(place.v) + turn, place.u};
      if (contains(found.quad, found.point)) return found;
    }
  }
  return make_error(Error_code::refused_edit, "no quad of the texture contains the point (" +
                                                  std::to_string(place.v) + ", " + std::to_string(place.u) +
                                                  ")");
}

double area(const Plane_point& a, const Plane_point& b, const Plane_point& c) {
  return (b.v - a.v) * (c.u - a.u) - (b.u - a.u) * (c.v - a.v);
}

// The areas of the triangles of the point and the quad's edges.
std::array<double, 4> areas(const Hit& h) {
  std::array<double, 4> out;
  for (int i = 0; i < 4; ++i) out[i] = area(h.quad[i], h.quad[(i + 1) % 4], h.point);
  return out;
}

// The corner of a quad that is straight or reflex, or -1. There is at most one, since the quad is simple.
int reflex_corner(const Plane_quad& q) {
  for (int i = 0; i < 4; ++i)
    if (internal::orientation(q[(i + 3) % 4], q[i], q[(i + 1) % 4]) <= 0) return i;
  return -1;
}

// The triangle with the point that the diagonal from a reflex corner cuts off: its corners, counterclockwise
// from the one whose two edges are the quad's.
std::array<int, 3> half_of(const Hit& h, int reflex) {
  const int across = (reflex + 2) % 4;
  return internal::orientation(h.quad[reflex], h.quad[across], h.point) > 0
             ? std::array<int, 3>{(reflex + 3) % 4, reflex, across}
             : std::array<int, 3>{(reflex + 1) % 4, across, reflex};
}

int nearest_edge(const Hit& h) {
  const std::array<double, 4> a = areas(h);
  if (const int reflex = reflex_corner(h.quad); reflex >= 0) {
    const int leaving = half_of(h, reflex)[0], arriving = (leaving + 3) % 4;
    return a[arriving] < a[leaving] ? arriving : leaving;
  }
  return int(std::min_element(a.begin(), a.end()) - a.begin());
}

int nearest_corner(const Hit& h) {
  if (const int reflex = reflex_corner(h.quad); reflex >= 0) {
    const std::array<int, 3> t = half_of(h, reflex);
    int best = 0;
    double most = -1;
    for (int i = 0; i < 3; ++i)
      if (const double w = area(h.quad[t[(i + 1) % 3]], h.quad[t[(i + 2) % 3]], h.point); w > most) {
        most = w;
        best = t[i];
      }
    return best;
  }
  const std::array<double, 4> a = areas(h);
  std::array<double, 4> sum;
  for (int i = 0; i < 4; ++i) sum[i] = a[i] + a[(i + 3) % 4];
  return int(std::min_element(sum.begin(), sum.end()) - sum.begin());
}

Result<Quad_corner> find(const Quad_texture& texture, const Texture_place& place,
                         int (*nearest)(const Hit&)) {
  if (place.quad >= 0) {
    if (place.quad >= int(texture.quads.size()) || place.corner < 0 || place.corner > 3)
      return make_error(Error_code::refused_edit, "a place names a quad or a corner that does not exist",
                        Element_kind::face, place.quad);
    return Quad_corner{place.quad, place.corner};
  }
  const Result<Hit> found = hit(texture, place);
  if (!found) return found.error();
  return Quad_corner{found->corner.quad, nearest ? nearest(*found) : 0};
}

// A point in the quad, on the way from `target` to the quad's inside, that `nearest` takes for the corner.
// Points near the quad's corners and edges are tried with the middle of a triangle of the quad as the inside.
Texture_place point_place(const Quad_texture& texture, const Quad_corner& c, double along,
                          int (*nearest)(const Hit&)) {
  const Texture_plane plane = plane_of(texture);
  Plane_quad q;
  const bool valid = unroll(texture, c.quad, q) && is_simple_counterclockwise(q);
  CGAL_precondition(valid);
  if (!valid) return {0, 0, c.quad, c.corner};
  const bool first =
      internal::orientation(q[0], q[1], q[2]) > 0 && internal::orientation(q[0], q[2], q[3]) > 0;
  const Plane_point &a = q[c.corner], &b = q[(c.corner + 1) % 4];
  // The least ones are for corners that are nearly straight.
  for (double depth : {1.0 / 32, 0.125, 0.25, 0.5, 0.75, 0x1p-7, 0x1p-10, 0x1p-14, 0x1p-18, 0x1p-22, 0x1p-26})
    for (int inside = 0; inside < 3; ++inside) {
      Plane_point m; // the middle of the quad's corners, or of one of its two triangles
      for (int i = 0; i < 4; ++i) {
        const bool left_out = inside > 0 && i == (first ? (inside == 1 ? 3 : 1) : (inside == 1 ? 0 : 2));
        if (left_out) continue;
        m.v += q[i].v / (inside > 0 ? 3 : 4);
        m.u += q[i].u / (inside > 0 ? 3 : 4);
      }
      const Plane_point on{a.v + along * (b.v - a.v), a.u + along * (b.u - a.u)};
      const double weight = nearest ? depth : 1;
      const Texture_place place{plane.wrapped(on.v + weight * (m.v - on.v)), on.u + weight * (m.u - on.u)};
      const Result<Quad_corner> found = find(texture, place, nearest);
      if (found && found->quad == c.quad && (!nearest || found->corner == c.corner)) return place;
    }
  return {0, 0, c.quad, c.corner}; // too thin for a point inside to be a number
}

} // namespace

Result<Quad_corner> find_quad(const Quad_texture& texture, const Texture_place& place) {
  return find(texture, place, nullptr);
}

Result<Quad_corner> find_edge(const Quad_texture& texture, const Texture_place& place) {
  return find(texture, place, nearest_edge);
}

Result<Quad_corner> find_vertex(const Quad_texture& texture, const Texture_place& place) {
  return find(texture, place, nearest_corner);
}

Quad_corner side_edge(const Quad_texture& texture, int side, int step) {
  const std::vector<int>& s = texture.sides[side];
  const int a = s[step], b = s[(step + 1) % s.size()];
  for (int f = 0; f < int(texture.quads.size()); ++f)
    for (int i = 0; i < 4; ++i) {
      const int from = texture.quads[f][i], to = texture.quads[f][(i + 1) % 4];
      if ((from == a && to == b) || (from == b && to == a)) return {f, i};
    }
  CGAL_precondition(false);
  return {};
}

Texture_place quad_place(const Quad_texture& texture, int quad) {
  return point_place(texture, {quad, 0}, 0, nullptr);
}

Texture_place edge_place(const Quad_texture& texture, const Quad_corner& edge) {
  return point_place(texture, edge, 0.5, nearest_edge);
}

Texture_place vertex_place(const Quad_texture& texture, const Quad_corner& vertex) {
  return point_place(texture, vertex, 0, nearest_corner);
}

Result<void> check_texture_plane(const Quad_texture& texture) {
  const Texture_plane plane = plane_of(texture);
  for (int f = 0; f < int(texture.quads.size()); ++f) {
    Plane_quad p;
    if (!plane.unroll(texture.v, texture.u, texture.quads[f], p))
      return make_error(Error_code::refused_edit,
                        "a quad of the texture has an edge of half a turn, or goes around the annulus",
                        Element_kind::face, f);
    if (!is_simple_counterclockwise(p))
      return make_error(Error_code::refused_edit, "a quad of the texture is inverted in the plane",
                        Element_kind::face, f);
  }
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
