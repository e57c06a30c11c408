// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_RELAX_REACH_H
#define REEBQUAD_RELAX_REACH_H

#include <CGAL/Reeb_quadrangulation/relax_quads.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

/// Moves vertices of relaxed quads to where the surface is farther from them than half an edge, or they from
/// the surface: into the ends of limbs, onto ridges, into folds. Their neighbours give way. A move is kept if
/// the fourth powers of the distances around the vertex fall, and if no quad becomes poor for it; those
/// around quads that got inverted or meet others are taken back. The report's figures of the quads afterwards
/// are brought up to date. Vertices that constraints bind, and those that have left the surface for a reason,
/// which the report names, are not moved there.
/// \pre `constraints` fit the mesh, as `relax_quads()` has it.
void reach(Quad_mesh& mesh, const Surface_projector& projector, Vertex_constraints constraints,
           const Relax_options& options, Relax_report& report, Observer* observer);

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_RELAX_REACH_H
