// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Which sharp edges a quad mesh has to keep, and how far its vertices may be moved for them.
struct Snap_options {
  double feature_angle = 45; ///< degrees between the normals of the faces of a sharp edge
  double reach = 0.5;        ///< a vertex moves at most this part of its shortest edge onto a sharp edge
  double shortest_chain = 4; ///< chains of sharp edges shorter than so many mean quad edges are noise
  double worst_jacobian =
      0.3; ///< no move may make the scaled Jacobian of a quad worse than this, or than it was
  /// First lay whole lines of edges onto the sharp edges that they run along: about twice as much of the sharp edges is then covered
  /// by edges of quads, whose scaled Jacobian is lower by about 0.01 in the mean.
  bool lines = false;
  double line_reach = 0.8; ///< how far from a sharp edge such a line may run, in edges
};

/// What was done.
struct Snap_report {
  int corners = 0;        ///< feature corners that are vertices now
  int missed_corners = 0; ///< feature corners without a vertex near enough
  int vertices = 0;       ///< other vertices that lie on sharp edges now
  int on_lines = 0;       ///< of these, on lines that were laid
};

/// Moves vertices of a quad mesh near a surface onto its corners and sharp edges, each vertex at most once and only
/// if no quad becomes bad: first the nearest to corners; then, with `options.lines`, lines of edges that run along sharp edges, to which
/// the quads around them give way; then single vertices, nearest first. `fixed` has one entry a vertex, or none: vertices
/// that are nonzero stay, those that are moved become so; hand it to `relax_quads()`.
/// O((V + S) log S) for S sharp edges, and O(F) to find them. \pre `options.feature_angle > 0`; the projector's surface is connected by `connect()`.
Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector, const Snap_options& options,
                             std::vector<char>& fixed);

/// The same with the sharp edges at hand, whatever `options.feature_angle` is.
Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector,
                             const Feature_edges& features, const Snap_options& options,
                             std::vector<char>& fixed);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H
