// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_FEATURES_FINISH_GUIDES_H
#define REEBQUAD_FEATURES_FINISH_GUIDES_H

#include <CGAL/Reeb_quadrangulation/finish_quads.h>
#include <CGAL/Reeb_quadrangulation/given_features.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Brings lines of edges of finished quads onto guides, the strongest first: the line that runs nearest along
/// a stroke, and more where it ends or leaves, with the quads around it, which are then relaxed while its
/// vertices slide on the stroke; all others stay where they are. Of several reaches that which brings edges
/// nearest to the stroke's direction is taken. A guide is kept only if no more quads are inverted,
/// intersect or have an edge shorter than a tenth of another, and if the mean scaled Jacobian of the quads
/// that do not touch it is not lower by more than 2
/// %. For a guide of less than full strength, every vertex goes that part of its way. `constraints` are what
/// holds the quads besides; `quads.relaxation` is brought up to date. Fails with `cancelled`.
Result<void> finish_on_guides(Finished_quads& quads, const Surface_projector& projector,
                              const std::vector<Guide_line>& guides, const Vertex_constraints& constraints,
                              const Relax_options& relaxation, Observer* observer);

/// As `finish_quads()`, with features that a user gives if there are some, and then on guides.
Result<Finished_quads> finish_quads(Quad_mesh mesh, const Surface_projector& projector,
                                    const Given_features* features, const Relax_options& relaxation,
                                    const Snap_options& options, Observer* observer,
                                    const std::vector<int>& held, const std::vector<Guide_line>& guides);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_FEATURES_FINISH_GUIDES_H
