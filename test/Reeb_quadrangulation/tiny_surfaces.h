// SPDX-License-Identifier: GPL-3.0-or-later
// Tiny named surfaces that tests reason about by hand.
#ifndef REEBQUAD_TEST_TINY_SURFACES_H
#define REEBQUAD_TEST_TINY_SURFACES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace tiny {

using CGAL::Reeb_quadrangulation::Point;
using CGAL::Reeb_quadrangulation::Triangle_surface;

inline Triangle_surface connected(Triangle_surface s) {
  const auto result = s.connect();
  REQUIRE(bool(result));
  return s;
}

inline Triangle_surface tetrahedron() {
  return connected({{Point(1, 1, 1), Point(-1, -1, 1), Point(-1, 1, -1), Point(1, -1, -1)},
                    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
                    {},
                    {}});
}

inline Triangle_surface octahedron() {
  return connected(
      {{Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(0, -1, 0), Point(0, 0, 1), Point(0, 0, -1)},
       {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
       {},
       {}});
}

/// An m x n grid on a torus of revolution (m around the axis, n around the tube); m, n >= 3.
inline Triangle_surface torus(int m, int n, double r = 0.4) {
  Triangle_surface s;
  const double tau = 2 * std::acos(-1.0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = tau * i / m, b = tau * j / n;
      s.points.emplace_back((1 + r * std::cos(b)) * std::cos(a), (1 + r * std::cos(b)) * std::sin(a),
                            r * std::sin(b));
    }
  const auto id = [&](int i, int j) { return (i % m) * n + j % n; };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      s.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return connected(std::move(s));
}

/// A cylinder with two open ends: m vertices around, n + 1 rings.
inline Triangle_surface open_cylinder(int m, int n, double height = 2) {
  Triangle_surface s;
  const double tau = 2 * std::acos(-1.0);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i < m; ++i)
      s.points.emplace_back(std::cos(tau * i / m), std::sin(tau * i / m), height * j / n);
  const auto id = [&](int i, int j) { return j * m + i % m; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      s.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return connected(std::move(s));
}

} // namespace tiny

#endif // REEBQUAD_TEST_TINY_SURFACES_H
