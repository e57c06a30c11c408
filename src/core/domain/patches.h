// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_DOMAIN_PATCHES_H
#define REEBQUAD_DOMAIN_PATCHES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Patches that share no vertex, each turned as its first quad and as its neighbours.
struct Oriented_patches {
  Quad_mesh mesh;                 ///< quads as they were, but for their direction
  std::vector<int> vertex_origin; ///< per vertex: that of the mesh before
  std::vector<int> patch_of_quad;
  std::vector<char> turned; ///< per quad: 1 if it was turned around
  int patches = 0;
};

/// Takes a mesh apart into patches and turns them so that rims that lie beside each other run against each
/// other. Fails as `stitch_patches()`.
Result<Oriented_patches> orient_patches(const Quad_mesh& mesh);

/// A boundary edge of a patch.
struct Rim_edge {
  int a, b; ///< vertices, in the direction of its quad
  int patch;
};

/// The boundary edges, by their quads.
std::vector<Rim_edge> rim_edges(const Oriented_patches& patches);

/// A quad with the same first corner that is turned around.
inline Quad turned_around(const Quad& q) {
  return {q[0], q[3], q[2], q[1]};
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DOMAIN_PATCHES_H
