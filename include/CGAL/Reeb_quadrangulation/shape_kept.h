// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SHAPE_KEPT_H
#define CGAL_REEB_QUADRANGULATION_SHAPE_KEPT_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <optional>
#include <string>
#include <vector>

/// \file
/// How much of a surface's shape a quad mesh keeps: numbers, a sentence, and warnings where they exceed
/// documented limits. `certify()` measures it.

namespace CGAL {
namespace Reeb_quadrangulation {

/// The distance from the area of one surface to another one: of all its points, not of its vertices only. As
/// fractions of the diagonal of the input's bounding box.
struct Area_distance {
  double maximum = 0;       ///< measured at a point: the distance is not less than this
  double bound = 0;         ///< proved for the whole area: the distance is not greater than this
  double mean = 0;          ///< over the area, from samples
  Point at = Point::Zero(); ///< where the maximum was measured, in the input's unit
};

/// What `certify()` measures of the shape. The input is the surface as it was read, where that was given.
/// Lengths are in its unit. A sharp edge has two faces whose normals differ by more than 45 degrees.
struct Shape_kept {
  double diagonal = 0;      ///< of the input's bounding box
  Area_distance from_quads; ///< each quad as two triangles
  Area_distance from_input; ///< to the quads
  double input_area = 0;
  double quad_area = 0;
  double lost_area = 0; ///< fraction of the input's area farther from the quads than their mean edge
  double undersampled_area =
      0;                ///< fraction of the input's area whose nearest quad is larger than 10 mean quads
  double box_shift = 0; ///< most that a side of the bounding box has moved, by the diagonal
  /// Vertices where at least three sharp lines of the input end, or two that turn by more than 45 degrees;
  /// sharp lines that are shorter than a mean edge of the quads do not count.
  int corners = 0;
  int missed_corners = 0; ///< corners that have no vertex of the quads within a tenth of the edges there
  Point missed_corner = Point::Zero(); ///< the first of them
  /// The part of the sharp lines' length that edges of quads run along; of lines of two mean edges of the
  /// quads or longer, since shorter ones are mostly noise. Absent without such a line.
  std::optional<double> covered_sharp_lines;
  std::optional<double> covered_sharp_edges; ///< of all sharp edges, see `Mesh_statistics`
  std::optional<double> folded_sharp_edges;
  int components = 0;      ///< of the input
  int lost_components = 0; ///< of these, that are farther from the quads than half their own diagonal
  int quads = 0;
  int quads_asked = 0; ///< 0: no number was asked for

  double distance() const; ///< the greater maximum of both directions
  double bound() const;    ///< the greater bound of both directions
};

/// What exceeds one of these is told as a warning. The report's schema documents the defaults.
struct Shape_limits {
  double distance = 0.03; ///< `Shape_kept::bound()`
  double lost_area = 0.002;
  double undersampled_area = 0.01;
  double box_shift = 0.01;
  int missed_corners = 0;
  double missed_sharp_edges = 0.25; ///< 1 - `covered_sharp_edges`
  int lost_components = 0;
  double missed_count = 0.1; ///< difference to the quads asked for, by that number
};

/// One limit that is exceeded.
struct Shape_warning {
  std::string name;    ///< that of the member of `Shape_limits`
  double measured = 0; ///< in the unit of that member
  double limit = 0;
  std::string text; ///< a sentence for people, without a full stop
};

/// The warnings, in the order of `Shape_limits`. O(1).
std::vector<Shape_warning> shape_warnings(const Shape_kept& shape, const Shape_limits& limits = {});

/// "distance at most 1.2 % of the diagonal, 31 of 32 corners, 94 % of sharp edges". O(1).
std::string shape_summary(const Shape_kept& shape);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SHAPE_KEPT_H
