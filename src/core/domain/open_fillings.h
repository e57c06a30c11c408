// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_DOMAIN_OPEN_FILLINGS_H
#define REEBQUAD_DOMAIN_OPEN_FILLINGS_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Leaves out the quads of fillings: of a closed surface whose first faces are those of `surface`, and whose
/// other faces fill its boundary loops. The quads' boundary becomes one loop on each of the surface's loops.
///
/// For each filling a disc of quads is chosen that has most of the filling and little else, and whose border
/// turns seldom; discs have no vertex in common. Its border comes to lie on the loop. Where the border turns
/// though the loop does not, a ring of quads is laid between the two, so that two quads meet at each vertex
/// of the boundary. So the result is all-quad and manifold whatever the loop is; relaxation on `surface` is
/// due.
///
/// The predicted valences change by those of the vertices that are concerned. Fails with `impossible_request`
/// where a filling has no quad, because it is thinner than the quads, or where two fillings are too close.
/// \pre `filled` is connected, and each of its faces but the first ones is of a filling.
Result<Stitched_mesh> open_fillings(const Stitched_mesh& quads, const Surface_projector& filled,
                                    const Triangle_surface& surface);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DOMAIN_OPEN_FILLINGS_H
