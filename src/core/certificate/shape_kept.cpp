// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/shape_kept.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Three digits: small parts of a whole must not look like nothing.
std::string three_digits(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

std::string percent(double fraction) {
  return three_digits(100 * fraction) + " %";
}

std::string place(const Point& p) {
  return "(" + three_digits(p.x()) + ", " + three_digits(p.y()) + ", " + three_digits(p.z()) + ")";
}

std::string distance_text(const Shape_kept& shape) {
  const bool outward = shape.from_quads.bound > shape.from_input.bound;
  const Area_distance& far = outward ? shape.from_quads : shape.from_input;
  return std::string(outward ? "the quads leave the input" : "the input lies away from the quads") +
         " by up to " + percent(far.bound) + " of the diagonal, near " + place(far.at);
}

std::string corners_text(const Shape_kept& shape) {
  return std::to_string(shape.missed_corners) + " of " + std::to_string(shape.corners) +
         " corners have no vertex of the quads, the first at " + place(shape.missed_corner);
}

std::string count_text(const Shape_kept& shape) {
  return std::to_string(shape.quads) + " quads, " + std::to_string(shape.quads_asked) + " were asked for";
}

} // namespace

double Shape_kept::distance() const {
  return std::max(from_quads.maximum, from_input.maximum);
}

double Shape_kept::bound() const {
  return std::max(from_quads.bound, from_input.bound);
}

std::vector<Shape_warning> shape_warnings(const Shape_kept& shape, const Shape_limits& limits) {
  std::vector<Shape_warning> warnings;
  const auto compare = [&](const char* name, double measured, double limit, const auto& text) {
    if (measured > limit) warnings.push_back({name, measured, limit, text()});
  };
  compare("distance", shape.bound(), limits.distance, [&] { return distance_text(shape); });
  compare("lost_area", shape.lost_area, limits.lost_area, [&] {
    return percent(shape.lost_area) +
           " of the input's area is farther from the quads than their edges are long";
  });
  compare("undersampled_area", shape.undersampled_area, limits.undersampled_area, [&] {
    return percent(shape.undersampled_area) +
           " of the input's area has quads of more than ten times the mean size";
  });
  compare("box_shift", shape.box_shift, limits.box_shift, [&] {
    return "a side of the bounding box has moved by " + percent(shape.box_shift) + " of the diagonal";
  });
  compare("missed_corners", shape.missed_corners, limits.missed_corners, [&] { return corners_text(shape); });
  if (const auto& covered = shape.covered_sharp_lines)
    compare("missed_sharp_edges", 1 - *covered, limits.missed_sharp_edges, [&] {
      return "edges of quads run along " + percent(*covered) + " only of the length of the sharp lines";
    });
  compare("lost_components", shape.lost_components, limits.lost_components, [&] {
    return std::to_string(shape.lost_components) + " of " + std::to_string(shape.components) +
           " components of the input have no quads";
  });
  if (shape.quads_asked > 0)
    compare("missed_count", std::abs(double(shape.quads) / shape.quads_asked - 1), limits.missed_count,
            [&] { return count_text(shape); });
  return warnings;
}

std::string shape_summary(const Shape_kept& shape) {
  std::string text = "distance at most " + percent(shape.bound()) + " of the diagonal";
  if (shape.corners > 0)
    text += ", " + std::to_string(shape.corners - shape.missed_corners) + " of " +
            std::to_string(shape.corners) + (shape.corners == 1 ? " corner" : " corners");
  if (shape.covered_sharp_lines) text += ", " + percent(*shape.covered_sharp_lines) + " of sharp edges";
  if (shape.lost_area > 0) text += ", " + percent(shape.lost_area) + " of the area lost";
  if (shape.lost_components > 0)
    text += ", " + std::to_string(shape.components - shape.lost_components) + " of " +
            std::to_string(shape.components) + " components";
  return text;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
