// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

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
};

/// What was done.
struct Snap_report {
  int corners = 0;        ///< feature corners that are vertices now
  int missed_corners = 0; ///< feature corners without a vertex near enough
  int vertices = 0;       ///< other vertices that lie on sharp edges now
};

/// Moves vertices of a quad mesh near `input` onto its corners and sharp edges, nearest first, each vertex at most once and only
/// if no quad becomes bad. `fixed` gets one entry a vertex, 1 where it was moved: hand it to `relax_quads()`.
/// O((V + S) log S) for S sharp edges. \pre `options.feature_angle > 0`; `input` is connected by `connect()`.
Snap_report snap_to_features(Quad_mesh& mesh, const Triangle_surface& input, const Snap_options& options,
                             std::vector<char>& fixed);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SNAP_TO_FEATURES_H
