// SPDX-License-Identifier: GPL-3.0-or-later
// Tiny named quad meshes, and the triangle surfaces that they stand for.
#ifndef REEBQUAD_TEST_TINY_QUADS_H
#define REEBQUAD_TEST_TINY_QUADS_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace tiny {

using CGAL::Reeb_quadrangulation::Point;
using CGAL::Reeb_quadrangulation::Quad;
using CGAL::Reeb_quadrangulation::Quad_mesh;
using CGAL::Reeb_quadrangulation::Triangle_surface;

/// The cube with corners at `at` and `at` + (1, 1, 1), turned outward; vertex i is at the binary digits of i.
inline Quad_mesh quad_cube(const Point& at = Point(0, 0, 0)) {
  Quad_mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back(at + Point(i & 1, i >> 1 & 1, i >> 2));
  mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

/// m x n quads on a torus of revolution (m around the axis, n around the tube); m, n >= 3.
inline Quad_mesh quad_torus(int m, int n, double r = 0.4) {
  Quad_mesh mesh;
  const double tau = 2 * std::acos(-1.0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = tau * i / m, b = tau * j / n;
      mesh.points.emplace_back((1 + r * std::cos(b)) * std::cos(a), (1 + r * std::cos(b)) * std::sin(a),
                               r * std::sin(b));
      const int k = (i + 1) % m, l = (j + 1) % n;
      mesh.quads.push_back({i * n + j, k * n + j, k * n + l, i * n + l});
    }
  return mesh;
}

/// A cylinder with two open ends: m quads around, n along; m >= 3.
inline Quad_mesh quad_cylinder(int m, int n) {
  Quad_mesh mesh;
  const double tau = 2 * std::acos(-1.0);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i < m; ++i)
      mesh.points.emplace_back(std::cos(tau * i / m), std::sin(tau * i / m), 2.0 * j / n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i)
      mesh.quads.push_back({j * m + i, j * m + (i + 1) % m, (j + 1) * m + (i + 1) % m, (j + 1) * m + i});
  return mesh;
}

/// A band of n quads with a half twist.
inline Quad_mesh quad_moebius(int n) {
  Quad_mesh mesh;
  const double tau = 2 * std::acos(-1.0);
  for (int i = 0; i < n; ++i)
    for (double s : {-0.3, 0.3}) {
      const double a = tau * i / n, r = 1 + s * std::cos(a / 2);
      mesh.points.emplace_back(r * std::cos(a), r * std::sin(a), s * std::sin(a / 2));
    }
  for (int i = 0; i + 1 < n; ++i) mesh.quads.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  mesh.quads.push_back({2 * n - 2, 1, 0, 2 * n - 1});
  return mesh;
}

inline Quad_mesh together(Quad_mesh a, const Quad_mesh& b) {
  const int shift = int(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Quad& q : b.quads) a.quads.push_back({q[0] + shift, q[1] + shift, q[2] + shift, q[3] + shift});
  return a;
}

inline Quad_mesh two_cubes() {
  return together(quad_cube(), quad_cube(Point(3, 0, 0)));
}

/// Every quad as two triangles.
inline Triangle_surface triangulated(const Quad_mesh& mesh) {
  Triangle_surface s;
  s.points = mesh.points;
  for (const Quad& q : mesh.quads) {
    s.triangles.push_back({q[0], q[1], q[2]});
    s.triangles.push_back({q[0], q[2], q[3]});
  }
  return s;
}

/// Every quad as four, with new points at the middles: twice as fine, the same surface if the quads are
/// planar.
inline Quad_mesh subdivided(const Quad_mesh& mesh) {
  Quad_mesh fine{mesh.points, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int v, int w) {
    const auto [place, added] = middles.insert({std::minmax(v, w), int(fine.points.size())});
    if (added) fine.points.push_back(0.5 * (mesh.points[v] + mesh.points[w]));
    return place->second;
  };
  for (const Quad& q : mesh.quads) {
    int m[4];
    for (int i = 0; i < 4; ++i) m[i] = middle(q[i], q[(i + 1) % 4]);
    const int centre = int(fine.points.size());
    fine.points.push_back((mesh.points[q[0]] + mesh.points[q[1]] + mesh.points[q[2]] + mesh.points[q[3]]) /
                          4);
    for (int i = 0; i < 4; ++i) fine.quads.push_back({q[i], m[i], centre, m[(i + 3) % 4]});
  }
  return fine;
}

/// The distance of a point to a triangle by way of its plane and its sides.
inline double distance_to_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const auto to_side = [&](const Point& s, const Point& e) {
    const double t = std::clamp((p - s).dot(e - s) / (e - s).squaredNorm(), 0.0, 1.0);
    return (s + t * (e - s) - p).norm();
  };
  const Point n = (b - a).cross(c - a).normalized(), foot = p - n.dot(p - a) * n;
  const auto left_of = [&](const Point& s, const Point& e) { return n.dot((e - s).cross(foot - s)) >= 0; };
  if (left_of(a, b) && left_of(b, c) && left_of(c, a)) return std::abs(n.dot(p - a));
  return std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
}

/// The distance of a point to the nearest quad, each cut along its shorter diagonal. O(quads)
inline double distance_to_quads(const Point& p, const Quad_mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const Quad& q : mesh.quads) {
    const Point &a = mesh.points[q[0]], &b = mesh.points[q[1]], &c = mesh.points[q[2]],
                &d = mesh.points[q[3]];
    const bool even = (c - a).squaredNorm() <= (d - b).squaredNorm();
    least = std::min({least, even ? distance_to_triangle(p, a, b, c) : distance_to_triangle(p, a, b, d),
                      even ? distance_to_triangle(p, a, c, d) : distance_to_triangle(p, b, c, d)});
  }
  return least;
}

} // namespace tiny

#endif // REEBQUAD_TEST_TINY_QUADS_H
