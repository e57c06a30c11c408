// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_SHARP_LINES_H
#define REEBQUAD_CERTIFICATE_SHARP_LINES_H

#include "certificate/input_surface.h"

#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// What counts as sharp. Lengths are by the mean edge of the quads: of a line that quads should follow, and
/// of one that makes a corner where it ends.
struct Sharp_limits {
  static constexpr double angle = 45; // degrees
  static constexpr double long_line = 2, corner_line = 1;
};

/// The edges of the input whose two faces meet at more than `angle` degrees, as pairs of vertices, ascending.
/// Faces that run along the edge in the same direction are compared as if one of them were turned. O(n log
/// d).
std::vector<std::pair<int, int>> sharp_edges(const Input_surface& input, double angle);

/// Those of the sharp edges whose line is `shortest` long or longer. A line goes on through vertices of two
/// sharp edges.
std::vector<std::pair<int, int>> long_lines(const std::vector<Point>& points,
                                            const std::vector<std::pair<int, int>>& sharp, double shortest);

/// The vertices where at least three lines of sharp edges end that are `shortest` long or longer, or two that
/// turn by more than `angle` degrees; ascending.
std::vector<int> corners(const std::vector<Point>& points, const std::vector<std::pair<int, int>>& sharp,
                         double angle, double shortest);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_SHARP_LINES_H
