// SPDX-License-Identifier: GPL-3.0-or-later
// A shape for tests and benchmarks.
#ifndef REEBQUAD_TEST_GLOBE_H
#define REEBQUAD_TEST_GLOBE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <cmath>
#include <vector>

namespace globe {

using namespace CGAL::Reeb_quadrangulation;

constexpr double pi = 3.14159265358979323846;

/// A ball with lobes around its equator: maxima at their tips and a minimum at the south pole, the last
/// vertex, make one saddle of as many loops at the north pole, the first. Not connected yet.
inline Triangle_surface ball(int lobes) {
  const int around = 8 * lobes, rings = 24;
  Triangle_surface s;
  s.points.push_back(Point(0, 0, 1));
  for (int ring = 1; ring < rings; ++ring)
    for (int i = 0; i < around; ++i) {
      const double theta = pi * ring / rings, phi = 2 * pi * i / around;
      const double r = 1 + 0.5 * std::pow(std::sin(theta), 2) * std::cos(lobes * phi);
      s.points.push_back(
          Point(r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi), std::cos(theta)));
    }
  s.points.push_back(Point(0, 0, -1));
  const auto index = [&](int ring, int i) { return 1 + (ring - 1) * around + i % around; };
  for (int i = 0; i < around; ++i) s.triangles.push_back({0, index(1, i), index(1, i + 1)});
  for (int ring = 1; ring + 1 < rings; ++ring)
    for (int i = 0; i < around; ++i) {
      s.triangles.push_back({index(ring, i), index(ring + 1, i), index(ring + 1, i + 1)});
      s.triangles.push_back({index(ring, i), index(ring + 1, i + 1), index(ring, i + 1)});
    }
  const int south = int(s.points.size()) - 1;
  for (int i = 0; i < around; ++i)
    s.triangles.push_back({index(rings - 1, i), south, index(rings - 1, i + 1)});
  return s;
}

inline std::vector<Point> tips(int lobes) {
  std::vector<Point> points;
  for (int k = 0; k < lobes; ++k)
    points.push_back(Point(1.5 * std::cos(2 * pi * k / lobes), 1.5 * std::sin(2 * pi * k / lobes), 0));
  return points;
}

} // namespace globe

#endif // REEBQUAD_TEST_GLOBE_H
