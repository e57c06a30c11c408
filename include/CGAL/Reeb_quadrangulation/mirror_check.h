// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MIRROR_CHECK_H
#define CGAL_REEB_QUADRANGULATION_MIRROR_CHECK_H

#include <CGAL/Reeb_quadrangulation/Mirror_plane.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What `check_mirror()` finds.
struct Mirror_check {
  /// The images pair vertices, and the images of a quad's corners are those of a quad, in the opposite order.
  bool is_symmetric = false;
  /// The same, and positions are each other's images exactly: in real arithmetic, nothing is rounded. Never
  /// so for planes that are not across an axis, whose reflections no floating point numbers hold.
  bool is_exact = false;
  int on_plane = 0; ///< vertices that are their own images
  /// The greatest distance of a vertex from the image of its mirror vertex, by the diagonal of the quads'
  /// box.
  double deviation = 0;
  int vertex = -1;     ///< where
  std::string message; ///< the first thing that is wrong; empty if nothing is
};

/// Whether quads equal their mirror image, if `image` has the mirror vertex of each vertex. Any arrays are
/// accepted. Shares no code with what makes mirrored quads but the reflection itself. O(m log m) for m quads.
Mirror_check check_mirror(const Quad_mesh& quads, const Mirror_plane& plane, const std::vector<int>& image);

/// "equals its mirror image in x = 0 to the bit", or what else there is to say.
std::string to_text(const Mirror_check& check, const Mirror_plane& plane);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MIRROR_CHECK_H
