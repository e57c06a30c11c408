// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_MEND_LOOSE_TRIANGLES_H
#define REEBQUAD_MEND_LOOSE_TRIANGLES_H

#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Triangles while they are mended: nothing is known about their connection.
struct Loose_triangles {
  std::vector<Point> points;
  std::vector<int> point_of; ///< per point: in the soup, or -1
  std::vector<Triangle> triangles;
  std::vector<int> face_of; ///< per triangle: its polygon of the soup

  int number_of_points() const { return int(points.size()); }
  int number_of_triangles() const { return int(triangles.size()); }

  /// Keeps the triangles for which `kept(f)`; the number of the others.
  template <class Predicate> std::int64_t keep(Predicate kept) {
    std::size_t n = 0;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      if (!kept(f)) continue;
      triangles[n] = triangles[f];
      face_of[n++] = face_of[f];
    }
    const std::int64_t dropped = std::int64_t(triangles.size() - n);
    triangles.resize(n);
    face_of.resize(n);
    return dropped;
  }

  std::int64_t drop_repeated_corners() {
    return keep([&](std::size_t f) {
      const Triangle& t = triangles[f];
      return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    });
  }
};

/// A face in parts, divided at points on its sides, in their order; each side is fanned from the corner
/// opposite to it, so that no part is without area.
std::vector<Triangle> divided(const Triangle& face, const std::array<std::vector<int>, 3>& on_side);

/// Appends the sentence about `count` elements, unless there are none.
void say(std::vector<Mend>& mends, std::int64_t count, const char* one, const char* many);

/// `count` and the word for it.
std::string text_of_count(std::int64_t count, const char* one, const char* many);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_LOOSE_TRIANGLES_H
