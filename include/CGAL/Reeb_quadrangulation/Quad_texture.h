// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_H
#define CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_H

#include <CGAL/Reeb_quadrangulation/Chart_parameterization.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A connectivity texture: a quad mesh of a chart's parameter domain.
///
/// On an annulus a vertex has V in [0, 1) around and U in [0, 1] up; a quad may step over V = 1. On a disc, V is in [0, a] and
/// U in [0, b]. Quads are counterclockwise in the (V, U) plane, hence on the surface seen from outside.
struct Quad_texture {
  std::vector<double> v, u; ///< per vertex
  std::vector<Quad> quads;
  /// The vertices on each walk of the chart, in the order of `Chart::walks` and eastward like them; entry 0 is V = 0 on an
  /// annulus, the corner (0, 0) on a disc.
  std::vector<std::vector<int>> sides;
};

/// `columns` x `levels.size() - 1` quads; `levels` are the rows' U from 0 to 1.
Quad_texture regular_annulus_texture(int columns, const std::vector<double>& levels);

/// a x b quads. The side runs counterclockwise, or clockwise if `clockwise` (the walk of a minimum's disc).
Quad_texture regular_disc_texture(int a, int b, bool clockwise);

/// A place on a chart: a face and barycentric coordinates in it.
struct Chart_location {
  int face = -1;
  std::array<double, 3> weights{{0, 0, 0}};
};

/// Finds the places with the given parameters, all at once: O(F + n) for evenly spread points by bucketing them. Every point of the
/// domain is found; one that rounding left between triangles takes the nearest of them.
std::vector<Chart_location> locate(const Chart& chart, const Chart_parameterization& map,
                                   const std::vector<double>& v, const std::vector<double>& u);

/// The point of a location.
Point position(const Chart& chart, const Chart_location& location);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_H
