// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MIRROR_QUADS_H
#define CGAL_REEB_QUADRANGULATION_MIRROR_QUADS_H

#include <CGAL/Reeb_quadrangulation/find_mirror_planes.h>
#include <CGAL/Reeb_quadrangulation/finish_design.h>
#include <CGAL/Reeb_quadrangulation/halve_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The quads of a whole surface, made of those of a half.
struct Mirrored_design {
  /// The quads of the half, then their images; of the vertices the same. The reports of relaxation and
  /// features are those of the half; `held_vertices`, `node_vertex` and `off_surface` name vertices of the
  /// half.
  Finished_design whole;
  std::vector<int> image; ///< the mirror vertex of each vertex; itself on the plane
  int on_plane = 0;       ///< vertices there
  int ring_quads =
      0; ///< of the half, laid along the plane so that the two sides meet in vertices and edges of their own
  double largest_shift = 0; ///< how far a vertex was moved by `Mirror_positions::projected`, by the diagonal
};

/// How a mirrored quad mesh came about.
struct Mirror_report {
  Mirror mirror;
  Mirror_deviation deviation; ///< of the surface from its own image
  std::vector<int> image;     ///< the next four as in `Mirrored_design`
  int on_plane = 0;
  int ring_quads = 0;
  double largest_shift = 0;
};

/// Reflects the finished quads of a half and welds both along the plane. Vertices there are on the plane
/// exactly; across an axis all positions are rounded to a `Mirror_grid`, so that with
/// `Mirror_positions::exact` the result equals its mirror image to the bit.
///
/// Where an edge inside the half joins two vertices on the plane, it would get four quads; where a quad has
/// two neighbouring edges there, its vertex would get two edges only. Then a ring of quads is laid along the
/// plane first, and the quads are finished anew. So they are where the plane's curve ends on a boundary of
/// the surface and no vertex of the quads lies there.
///
/// `whole` is the projector of the surface that the half is of. Fails with `internal_error` where the
/// boundary of the quads does not follow the plane, and as `finish_quads()` does. Deterministic; O(quads) but
/// for that.
Result<Mirrored_design> mirror_design(Finished_design half_design, const Surface_half& half,
                                      const Surface_projector& whole,
                                      Mirror_positions positions = Mirror_positions::exact,
                                      const Finish_options& options = {}, Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MIRROR_QUADS_H
