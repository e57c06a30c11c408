// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/Vertex_constraints.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Which sharp edges a quad mesh has to keep, and how far its vertices may be moved for them.
struct Snap_options {
  double feature_angle = 45; ///< degrees between the normals of the faces of a sharp edge
  double reach = 0.5;        ///< a vertex moves at most this part of its shortest edge onto a sharp edge
  double corner_reach = 1;   ///< and at most this part of the mean length of its edges onto a corner
  double shortest_chain = 2; ///< chains of sharp edges shorter than so many mean quad edges are noise
  double worst_jacobian =
      0.3; ///< no move may make the scaled Jacobian of a quad worse than this, or than it was
  /// Where an edge of quads then still crosses a sharp edge between its ends, one of them comes to lie there,
  /// up to a whole edge away: the sharp edge runs along edges and diagonals of quads.
  bool crossings = true;
  /// First lay whole lines of edges onto the sharp edges that they run along, so that more of these run along
  /// edges of quads and less along diagonals.
  bool lines = false;
  double line_reach = 0.8; ///< how far from a sharp edge such a line may run, in edges
};

/// What was done.
struct Snap_report {
  int corners = 0;        ///< feature corners that are vertices now
  int missed_corners = 0; ///< feature corners without a vertex near enough
  int vertices = 0;       ///< other vertices that lie on sharp edges now
  int on_lines = 0;       ///< of these, on lines that were laid
  int missed_crossings =
      0; ///< edges of quads that cross a sharp edge and neither of whose ends could be moved there
};

/// Moves vertices of a quad mesh near a surface onto its corners and sharp edges, each vertex at most once
/// and only if no quad becomes bad or faces away: first the nearest to corners; then, with `options.lines`,
/// lines of edges that run along sharp edges, to which the quads around them give way; then single vertices,
/// nearest first; then ends of edges that cross. `constraints.fixed` has one entry a vertex, or none: these
/// vertices stay. Those on corners are added to them; the sharp edges are added to `constraints.curves`, and
/// the vertices on them to `constraints.places`, also those that stay; hand it to `relax_quads()`, which lets
/// the others slide. O((V + S) log S) for S sharp edges, and O(F) to find them. \pre `options.feature_angle >
/// 0`; `constraints` has no curves; the projector's surface is connected by `connect()`.
Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector, const Snap_options& options,
                             Vertex_constraints& constraints);

/// The same with the sharp edges at hand, whatever `options.feature_angle` is.
Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector,
                             const Feature_edges& features, const Snap_options& options,
                             Vertex_constraints& constraints);

/// Turns quads so that they begin at a corner whose diagonal lies on a curve of `constraints`, where they
/// have one. Most programs cut a quad into the triangles 0 1 2 and 0 2 3: so cut, the surface is folded
/// there, and not across. Linear in the quads. Returns the number of quads that have such a diagonal.
int turn_to_features(Quad_mesh& mesh, const Vertex_constraints& constraints);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H
