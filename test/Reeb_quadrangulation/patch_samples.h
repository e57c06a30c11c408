// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of quads made separately, as of other programs, that together are a closed surface.
#ifndef REEBQUAD_TEST_PATCH_SAMPLES_H
#define REEBQUAD_TEST_PATCH_SAMPLES_H

#include "tiny_quads.h"

#include <functional>

namespace tiny {

/// `columns` x `rows` quads, vertex (i, j) at `at(i / columns, j / rows)`. With `around` columns close.
inline Quad_mesh quad_grid(int columns, int rows, bool around,
                           const std::function<Point(double, double)>& at) {
  Quad_mesh mesh;
  const int n = around ? columns : columns + 1;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < n; ++i) mesh.points.push_back(at(double(i) / columns, double(j) / rows));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      mesh.quads.push_back({j * n + i, j * n + (i + 1) % n, (j + 1) * n + (i + 1) % n, (j + 1) * n + i});
  return mesh;
}

/// The part of a torus from one angle around its axis to another, with `tube` quads around the tube, the
/// first vertex `offset` quads further.
inline Quad_mesh torus_part(double from, double to, int along, int tube, double offset = 0) {
  return quad_grid(tube, along, true, [&](double s, double t) {
    const double a = from + t * (to - from), b = -2 * std::acos(-1.0) * (s + offset / tube);
    return Point((1 + 0.4 * std::cos(b)) * std::cos(a), (1 + 0.4 * std::cos(b)) * std::sin(a),
                 0.4 * std::sin(b));
  });
}

/// Both halves of it, of `along` quads from rim to rim each.
inline Quad_mesh torus_halves(int tube, int other_tube, double offset = 0, double gap = 0) {
  const double pi = std::acos(-1.0);
  return together(torus_part(gap, pi - gap, 8, tube), torus_part(pi, 2 * pi, 8, other_tube, offset));
}

/// A face of the unit cube as n x m quads, turned outward.
inline Quad_mesh cube_face(int axis, bool upper, int n, int m) {
  return quad_grid(n, m, false, [&](double s, double t) {
    Point p;
    p[axis] = upper;
    p[(axis + 1) % 3] = upper ? s : t;
    p[(axis + 2) % 3] = upper ? t : s;
    return p;
  });
}

inline Quad_mesh turned_around(Quad_mesh mesh) {
  for (Quad& q : mesh.quads) std::swap(q[1], q[3]);
  return mesh;
}

} // namespace tiny

#endif // REEBQUAD_TEST_PATCH_SAMPLES_H
