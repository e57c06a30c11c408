// SPDX-License-Identifier: GPL-3.0-or-later
// Tiny named surfaces that tests reason about by hand.
#ifndef REEBQUAD_TEST_TINY_SURFACES_H
#define REEBQUAD_TEST_TINY_SURFACES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tiny {

using CGAL::Reeb_quadrangulation::Point;
using CGAL::Reeb_quadrangulation::Triangle;
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

/// Two apexes, vertices 0 (top) and 1 (bottom), over a ring of n vertices 2 .. n + 1.
inline Triangle_surface bipyramid(int n) {
  Triangle_surface s;
  const double tau = 2 * std::acos(-1.0);
  s.points = {Point(0, 0, 1), Point(0, 0, -1)};
  for (int i = 0; i < n; ++i) s.points.emplace_back(std::cos(tau * i / n), std::sin(tau * i / n), 0);
  for (int i = 0; i < n; ++i) {
    s.triangles.push_back({2 + i, 2 + (i + 1) % n, 0});
    s.triangles.push_back({2 + (i + 1) % n, 2 + i, 1});
  }
  return connected(std::move(s));
}

/// An m x n grid on a torus of revolution (m around the axis, n around the tube); m, n >= 3. The last column
/// of the grid is glued to the first one `twist` vertices further.
inline Triangle_surface torus(int m, int n, double r = 0.4, int twist = 0) {
  Triangle_surface s;
  const double tau = 2 * std::acos(-1.0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = tau * i / m, b = tau * j / n;
      s.points.emplace_back((1 + r * std::cos(b)) * std::cos(a), (1 + r * std::cos(b)) * std::sin(a),
                            r * std::sin(b));
    }
  const auto id = [&](int i, int j) { return (i % m) * n + (i == m ? j + twist : j) % n; };
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

/// A disc: a centre, vertex 0, and `rings` rings of m vertices around it, the last one the boundary.
inline Triangle_surface disc(int m, int rings) {
  Triangle_surface s;
  const double tau = 2 * std::acos(-1.0);
  s.points.emplace_back(0, 0, 0);
  for (int j = 1; j <= rings; ++j)
    for (int i = 0; i < m; ++i)
      s.points.emplace_back(j * std::cos(tau * i / m), j * std::sin(tau * i / m), 0);
  const auto id = [&](int i, int j) { return 1 + (j - 1) * m + i % m; };
  for (int i = 0; i < m; ++i) s.triangles.push_back({0, id(i, 1), id(i + 1, 1)});
  for (int j = 1; j < rings; ++j)
    for (int i = 0; i < m; ++i) {
      s.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
      s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
    }
  return connected(std::move(s));
}

/// Collects triangles by the integer coordinates of their corners.
struct Lattice_draft {
  std::map<std::array<int, 3>, int> index;
  Triangle_surface surface;

  int vertex(const std::array<int, 3>& p) {
    const auto [found, is_new] = index.emplace(p, int(surface.points.size()));
    if (is_new) surface.points.emplace_back(p[0], p[1], p[2]);
    return found->second;
  }
  void square(const std::array<int, 3>& a, const std::array<int, 3>& b, const std::array<int, 3>& c,
              const std::array<int, 3>& d) {
    const int i = vertex(a), j = vertex(b), k = vertex(c), l = vertex(d);
    surface.triangles.push_back({i, j, k});
    surface.triangles.push_back({i, k, l});
  }
};

inline bool is_filled(const std::vector<std::string>& map, int x, int y) {
  return y >= 0 && y < int(map.size()) && x >= 0 && x < int(map[y].size()) && map[y][x] == '#';
}

/// The surface of unit cubes laid on the plane where the map has a '#': each '.' inside is a handle. Cubes
/// must not touch in an edge alone.
inline Triangle_surface boxes(const std::vector<std::string>& map) {
  Lattice_draft draft;
  for (int y = 0; y < int(map.size()); ++y)
    for (int x = 0; x < int(map[y].size()); ++x) {
      if (!is_filled(map, x, y)) continue;
      draft.square({x, y, 1}, {x + 1, y, 1}, {x + 1, y + 1, 1}, {x, y + 1, 1});
      draft.square({x, y, 0}, {x, y + 1, 0}, {x + 1, y + 1, 0}, {x + 1, y, 0});
      if (!is_filled(map, x - 1, y)) draft.square({x, y, 0}, {x, y, 1}, {x, y + 1, 1}, {x, y + 1, 0});
      if (!is_filled(map, x + 1, y))
        draft.square({x + 1, y, 0}, {x + 1, y + 1, 0}, {x + 1, y + 1, 1}, {x + 1, y, 1});
      if (!is_filled(map, x, y - 1)) draft.square({x, y, 0}, {x + 1, y, 0}, {x + 1, y, 1}, {x, y, 1});
      if (!is_filled(map, x, y + 1))
        draft.square({x, y + 1, 0}, {x, y + 1, 1}, {x + 1, y + 1, 1}, {x + 1, y + 1, 0});
    }
  return connected(std::move(draft.surface));
}

/// A flat sheet of unit squares where the map has a '#': each '.' inside is a hole.
inline Triangle_surface sheet(const std::vector<std::string>& map) {
  Lattice_draft draft;
  for (int y = 0; y < int(map.size()); ++y)
    for (int x = 0; x < int(map[y].size()); ++x)
      if (is_filled(map, x, y)) draft.square({x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0});
  return connected(std::move(draft.surface));
}

inline Triangle_surface cube() {
  return boxes({"#"});
}

/// A disc with two holes.
inline Triangle_surface pair_of_pants() {
  return sheet({"##########", "##########", "##..##..##", "##..##..##", "##########", "##########"});
}

/// The connected sum: both surfaces lose a face and are joined along its border, which keeps the first one's
/// points.
inline Triangle_surface connected_sum(const Triangle_surface& a, int face_a, const Triangle_surface& b,
                                      int face_b) {
  Triangle_surface s{a.points, a.triangles, {}, {}};
  s.triangles.erase(s.triangles.begin() + face_a);
  const Triangle &ta = a.triangles[face_a], &tb = b.triangles[face_b];
  std::vector<int> index(b.points.size(), -1);
  index[tb[0]] = ta[0];
  index[tb[1]] = ta[2];
  index[tb[2]] = ta[1];
  for (std::size_t v = 0; v < b.points.size(); ++v)
    if (index[v] < 0) {
      index[v] = int(s.points.size());
      s.points.push_back(b.points[v]);
    }
  for (int f = 0; f < b.number_of_faces(); ++f)
    if (f != face_b) {
      const Triangle& t = b.triangles[f];
      s.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
    }
  return connected(std::move(s));
}

/// Two tori side by side, joined along one triangle.
inline Triangle_surface double_torus(int m, int n) {
  const Triangle_surface left = torus(m, n);
  Triangle_surface right = left;
  for (Point& p : right.points) p = Point(2.8 - p.x(), -p.y(), p.z());
  return connected_sum(left, 0, right, 1);
}

/// Each triangle cut into four at the middles of its edges.
inline Triangle_surface subdivided(const Triangle_surface& s) {
  Triangle_surface fine{s.points, {}, {}, {}};
  std::vector<int> middle(s.number_of_halfedges(), -1);
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    const int e = s.edge(h);
    if (middle[e] < 0) {
      middle[e] = int(fine.points.size());
      fine.points.push_back(0.5 * (s.points[s.source(h)] + s.points[s.target(h)]));
    }
    middle[h] = middle[e];
  }
  for (int f = 0; f < s.number_of_faces(); ++f) {
    const Triangle& t = s.triangles[f];
    const int a = middle[3 * f], b = middle[3 * f + 1], c = middle[3 * f + 2];
    for (const Triangle& piece :
         {Triangle{t[0], a, c}, Triangle{a, t[1], b}, Triangle{c, b, t[2]}, Triangle{a, b, c}})
      fine.triangles.push_back(piece);
  }
  return connected(std::move(fine));
}

/// A generator of pseudo-random numbers whose results are the same everywhere (splitmix64; Steele, Lea, Flood
/// 2014).
class Random {
public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}
  std::uint64_t next() {
    m_state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = m_state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  int below(int n) { return int(next() % std::uint64_t(n)); }
  double unit() { return double(next() >> 11) * 0x1p-53; }

private:
  std::uint64_t m_state;
};

} // namespace tiny

#endif // REEBQUAD_TEST_TINY_SURFACES_H
