// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_KEPT_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_KEPT_FEATURES_H

#include <CGAL/Reeb_quadrangulation/feature_edges.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How far the edges of quads run along a chain of features.
struct Kept_chain {
  double length = 0;
  double on = 0;   ///< the length of the chain that edges of quads lie on: within a tenth of their own length
  double near = 0; ///< and what else they run beside: within half of their own length
  double missed = 0;               ///< the longest stretch that they do not lie on
  Point missed_at = Point::Zero(); ///< its middle

  /// What no edge of quads runs along.
  double lost() const { return std::max(0.0, length - on - near); }
};

/// Measures how the edges of a mesh keep chains of features of a surface, one entry a chain. An edge runs
/// along them if its ends and its middle are near enough to them. O((E + S) log S) for E edges of the mesh
/// and S of the chains. \pre the chains are those of `surface`
std::vector<Kept_chain> kept_chains(const Quad_mesh& mesh, const Triangle_surface& surface,
                                    const Feature_edges& features);

/// The part of the chains' length that edges lie on, 1 where the chains have no length.
double kept_part(const std::vector<Kept_chain>& chains);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_KEPT_FEATURES_H
