// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a shape, as an engineer calls them: what sharp edges bound.
#ifndef REEBQUAD_SURFACE_SHARP_PATCHES_H
#define REEBQUAD_SURFACE_SHARP_PATCHES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A closed line of edges around a patch.
struct Sharp_loop {
  std::vector<int> halfedges; ///< in order, from the smallest on, with the patch on the left
  /// Whether it passes each vertex once, and the surface goes on behind each edge.
  bool is_simple = true;
};

/// A connected part of a surface that no sharp edge divides.
struct Sharp_patch {
  std::vector<int> faces;        ///< in increasing order
  std::vector<Sharp_loop> loops; ///< ordered by their smallest halfedges
};

/// The patches between the edges whose faces meet at more than `angle` degrees, ordered by their smallest
/// faces. Sharp edges with one patch on both sides bound none. O(F).
std::vector<Sharp_patch> sharp_patches(const Triangle_surface& surface, double angle);

/// The vertices of a simple loop where it turns, seen along the patch, by more than `turn` degrees, as
/// positions in the loop: only where the patch has less than a half turn inside if they are `inward`.
std::vector<int> turns_of(const Triangle_surface& surface, const Sharp_loop& loop, double turn, bool inward);

/// Four positions in a loop that divide it like the corners of a rectangle: where it turns inward, the four
/// with the largest area between them; where it turns so less often, also the middles of its longest parts.
/// None if it turns nowhere.
std::vector<int> rectangle_in(const Triangle_surface& surface, const Sharp_loop& loop);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SURFACE_SHARP_PATCHES_H
