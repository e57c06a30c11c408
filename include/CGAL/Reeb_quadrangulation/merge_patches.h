// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MERGE_PATCHES_H
#define CGAL_REEB_QUADRANGULATION_MERGE_PATCHES_H

#include <CGAL/Reeb_quadrangulation/t_junctions.h>

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
};

/// Joins quad meshes that were made separately and share no samples, all in one `mesh`, along boundaries that
/// lie close together: the greedy stitching of section 7.2 of the paper. Two boundary vertices merge, the
/// nearest pair first, if their distance is less than `alpha` times the distance of each to its nearer
/// neighbour on the boundary, and no edge would get a third quad. Between two vertices that have merged, the
/// stretches of boundary of the two patches are joined if no vertex is further from the other stretch than an
/// edge is long: each vertex of the one with fewer merges with the nearest of the other, the rest become
/// T-junctions. Vertices that merge go to their middle.
///
/// Charts of one layout share samples and are joined better by `stitch_textures()`. Fails with
/// `impossible_request` if `mesh` is not an oriented quad mesh whose boundary passes each vertex once, or
/// `alpha` is not in (0, 0.5]. O(Q + B log B) for B boundary vertices that are spread evenly; deterministic.
Result<Merged_patches> merge_patches(const Quad_mesh& mesh, double alpha = 0.25);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MERGE_PATCHES_H
