// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_STITCH_PATCHES_H
#define CGAL_REEB_QUADRANGULATION_STITCH_PATCHES_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/merge_patches.h>
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Which vertices are relaxed after patches were stitched.
enum class Stitch_relaxation {
  none,  ///< none: new vertices are interpolated in the quads that they split
  seams, ///< those near T-junctions and new vertices; all others keep their places
  all
};

struct Stitch_patches_options {
  double alpha = 0.25; ///< of `merge_patches()`
  /// Whether rims that meet no other are left as the boundary of the result; otherwise they are refused.
  bool may_stay_open = false;
  T_junction_options t_junctions{};
  Stitch_relaxation relaxation = Stitch_relaxation::seams;
  Relax_options relax{};
};

/// A mesh of quads made of patches, and what was done for it.
struct Stitched_patches {
  Quad_mesh mesh;
  std::vector<int> patch_of_quad; ///< patches are numbered by their smallest quad
  std::vector<int> parent;        ///< per quad: the quad of a patch that it is, or is a part of
  std::vector<char> turned;       ///< per patch: 1 if its quads were turned around
  int greedy_merges = 0;          ///< by distance, see `merge_patches()`
  int later_merges = 0;
  int t_junctions = 0;                         ///< vertices of one rim that met none of the other
  int lines = 0, templates = 0;                ///< that took them away, see `resolve_t_junctions()`
  int boundary_ends = 0;                       ///< lines that ended on a rim that stays open
  std::vector<int> extraordinary;              ///< vertices that became so, increasing
  double largest_step = 0;                     ///< how far a vertex of a rim was moved to another, at most
  std::vector<std::pair<int, int>> components; ///< of the result: Euler characteristic and boundary loops
  Relax_report relaxation;                     ///< if any vertex was relaxed
};

/// The patches of `mesh`: quads that share an edge are of one patch. Per quad, numbered by the smallest quad.
std::vector<int> patches_of_quads(const Quad_mesh& mesh);

/// Makes one mesh of patches that were made elsewhere, all in one `mesh`: turns them so that they agree,
/// merges their rims by `merge_patches()`, and takes the T-junctions away by `resolve_t_junctions()`, so that
/// all faces are quads and no two rims are left beside each other.
///
/// That always ends: every patch has an even number of boundary edges, since its quads have four sides each,
/// and so a closed result has an even number of T-junctions, of which each sends a line of new edges through
/// the patches to another. With rims that stay open a line may end there. Quads that no line crosses stay.
///
/// Patches that touch in one vertex are taken apart there first. Two patches agree if rims that lie beside
/// each other run against each other; each part of the result that is closed is turned outward, another as
/// most of its area was. With a surface, relaxed vertices lie on it; otherwise they lie on the quads as they
/// were stitched.
///
/// Fails with `not_a_surface` if a quad names a vertex that does not exist, or one twice, an edge has more
/// than two quads, a patch is one-sided, or patches cannot be turned so that they agree; with
/// `impossible_request` if rims meet no other, naming the place, how far the nearest rim is and how far it
/// may be, or if the result is not manifold; and as `relax_quads()`. The element of an error is a vertex or a
/// quad of `mesh`. Deterministic; costs what its parts cost.
Result<Stitched_patches> stitch_patches(const Quad_mesh& mesh, const Stitch_patches_options& options = {},
                                        const Surface_projector* surface = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_STITCH_PATCHES_H
