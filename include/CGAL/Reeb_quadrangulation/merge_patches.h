// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MERGE_PATCHES_H
#define CGAL_REEB_QUADRANGULATION_MERGE_PATCHES_H

#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Patches joined at their boundaries, before T-junctions are resolved.
struct Merged_patches {
  Quad_mesh mesh;
  std::vector<Hanging_edge> hanging; ///< for `resolve_t_junctions()`
  std::vector<int> vertex;           ///< per vertex before: the vertex that it has become
  int greedy_merges = 0;             ///< by distance
  int later_merges = 0;              ///< between two that had merged, to leave T-junctions on one side only
  /// The boundary edges, by their vertices before, that lie beside no other: what is left of the rims.
  std::vector<std::array<int, 2>> open;
};

/// Joins quad meshes that were made separately and share no samples, all in one `mesh`, along boundaries that
/// lie close together: the greedy stitching of section 7.2 of the paper. Two boundary vertices merge, the
/// nearest pair first, if their distance is less than `alpha` times the distance of each to its nearer
/// neighbour on the boundary, and no edge would get a third quad.
///
/// What is left are slits: the boundary runs from one merged vertex to another and back beside itself. They
/// are closed if no vertex of one side is further from the other than the longest edge there is long: each
/// vertex of the side with fewer merges with one of the other, in order and so that the sum of their
/// distances is least, and the rest become T-junctions. Where rims share too few merged vertices to be slits,
/// as rims whose samples are offset by half an edge, the nearest two vertices merge first that are at most
/// three quarters of an edge apart. Vertices that merge go to their middle.
///
/// Charts of one layout share samples and are joined better by `stitch_textures()`. Fails with
/// `impossible_request` if `mesh` is not an oriented quad mesh whose boundary passes each vertex once, or
/// `alpha` is not in (0, 0.5]. For B boundary vertices that are spread evenly O(Q + B log B), and for each
/// slit the product of the numbers of vertices of its sides; deterministic.
Result<Merged_patches> merge_patches(const Quad_mesh& mesh, double alpha = 0.25);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MERGE_PATCHES_H
