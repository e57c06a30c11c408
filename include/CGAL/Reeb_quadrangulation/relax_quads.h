// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_RELAX_QUADS_H
#define CGAL_REEB_QUADRANGULATION_RELAX_QUADS_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/Vertex_constraints.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How `relax_quads()` works; the defaults are for meshes that come from a quad layout.
struct Relax_options {
  int iterations = 60;  ///< sweeps over all vertices; 0 leaves the smooth part out
  bool untangle = true; ///< afterwards mend the surroundings of inverted and of intersecting quads
  int attempts = 17; ///< of `untangle`, from gentle and local to drastic and wide: at most so many of all 17
  /// Quads with a smaller scaled Jacobian are improved last, by moves that make none inverted and none meet;
  /// 0 to 1, 0: none. More than 0.7 is rarely reached at extraordinary vertices.
  double wanted = 0.7;
  int threads = 1; ///< the result does not depend on it
  /// Further sweeps where the mean scaled Jacobian is then between 0.87 and 0.92.
  int more_iterations = 80;
};

/// What `relax_quads()` did. Scaled Jacobians as in `scaled_jacobian()`.
struct Relax_report {
  double worst_before = 0, worst_after = 0; ///< least scaled Jacobian
  double mean_before = 0, mean_after = 0;
  int inverted_before = 0, inverted_after = 0; ///< quads with a scaled Jacobian of 0 or less
  int intersections_after = 0; ///< pairs of quads that meet beyond what they share; counted by `untangle`
  int boundary_vertices = 0;   ///< vertices that slide on a boundary loop of the input, or are held there
  int moved_vertices = 0;      ///< vertices whose position changed
  std::vector<int>
      off_surface;           ///< vertices, not fixed, and yet off the input, so that quads do not intersect
  double largest_offset = 0; ///< distance of the farthest of these
};

/// The least, over the four corners, of `N . (a x b) / (|a| |b|)`, where a arrives at and b leaves the corner
/// and N is the normalised cross product of the quad's principal axes. 1 for a rectangle; at most 0 if the
/// quad is inverted or has a straight or collapsed corner. Definition: the Verdict library's quality metrics,
/// "scaled Jacobian" of a quad.
double scaled_jacobian(const Point& p0, const Point& p1, const Point& p2, const Point& p3);

/// Moves the vertices of a quad mesh over the input surface so that the quads come closer to rectangles.
///
/// Each vertex steps towards the place where its quads would be rectangles, and back to the surface by a walk
/// over neighbouring faces, so that it cannot jump to another sheet. Vertices on the mesh's boundary slide on
/// the input's boundary loops, and those nearest to a loop's corners are held there. A step is taken only if
/// it does not make the worst quad around the vertex worse than it was, or than good enough. Vertices on tips
/// and ridges take shorter steps, so that quads do not slide off the ends of limbs.
///
/// With `untangle`, the vertices around inverted quads are then optimised for their worst corners by a
/// pattern search; regions that still have inverted or intersecting quads (exact predicates) are relaxed anew
/// with other weights, and single vertices are moved apart. Each such attempt is kept, region by region, only
/// if it leaves fewer defects. Where nothing on the surface helps, vertices may leave it: by up to half of
/// the edges around them, or so that the quads cut off a fold of the surface that is narrower than they are.
/// The report counts them. At last the quads that are worse than `wanted` are optimised in the same way, and
/// taken back where that would make quads meet. The quality never gets worse than it is with the vertices put
/// on the surface: in the end no more quads are inverted, and if as many are, the mean scaled Jacobian is not
/// lower, and if none is, neither is the least. Else the vertices are only put on the surface, or left as
/// they were if that inverts quads.
///
/// \param mesh       an oriented manifold quad mesh that lies on or near the projector's surface
/// \param projector  of the input surface
/// \param constraints  vertices that do not move or that slide along curves; a vertex on the mesh's boundary
/// slides there, whatever
///                   its place on another curve
/// \return a report, or `not_a_surface` if a quad names a vertex that does not exist or twice,
/// `impossible_request` if
///         the constraints do not fit the mesh or an option is out of range, `cancelled` with the mesh as it
///         was.
/// Time linear in quads x iterations, each vertex a closest-point query. Same bytes for any number of
/// threads.
Result<Relax_report> relax_quads(Quad_mesh& mesh, const Surface_projector& projector,
                                 const Vertex_constraints& constraints = {},
                                 const Relax_options& options = {}, Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_RELAX_QUADS_H
