// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FIT_TEXTURE_H
#define CGAL_REEB_QUADRANGULATION_FIT_TEXTURE_H

#include <CGAL/Reeb_quadrangulation/snap_to_features.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The edges of a surface inside a chart whose two faces meet at more than `angle` degrees, with the boundary
/// of the chart's mesh; corners on that boundary are left out. A contour that runs along a sharp edge does
/// not belong to the inside. Edges that only the cutting of the chart made are none, whatever rounding did to
/// their triangles. O(F). `surface` is the one that `Chart::face_origin` refers to.
Feature_edges features_inside(const Chart& chart, const Triangle_surface& surface, double angle);

/// A texture with vertices on sharp edges.
struct Fitted_texture {
  Placed_texture texture;
  int corners = 0;  ///< vertices put onto the sharp edges' corners
  int vertices = 0; ///< vertices put onto sharp edges otherwise
};

/// Moves inner vertices of a chart's texture so that its edges lie on the sharp edges inside the chart, as
/// `snap_to_features()` does: lines of edges onto the sharp edges that they run along, single vertices onto
/// corners and onto what is near; then relaxes the vertices within four edges of these on the surface. The
/// sides' vertices and those at anchors stay; what lies on sharp edges in the end becomes an anchor.
///
/// The quads are those of the chart in space; where they have come to goes back to (V, U) by the chart's map.
/// A quad that would be inverted in the plane (exact), or come to face away from the surface, or whose scaled
/// Jacobian would be below 0.2 and lower than it was, keeps its vertices where they were. The number and
/// connectivity of the quads do not change. O((V + S) log (V + S) + F log F) for V vertices, and S sharp
/// edges and F faces of the chart. \pre `features` are of the chart's mesh.
Fitted_texture fit_texture(const Placed_texture& placed, const Chart& chart,
                           const Chart_parameterization& map, const Feature_edges& features);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FIT_TEXTURE_H
