// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FINISH_ON_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_FINISH_ON_FEATURES_H

#include <CGAL/Reeb_quadrangulation/finish_quads.h>
#include <CGAL/Reeb_quadrangulation/given_features.h>

#include <vector>

/// \file
/// Quads are laid onto features that a user gives, instead of the surface's sharp edges.

namespace CGAL {
namespace Reeb_quadrangulation {

/// As `snap_to_features()` with sharp edges; `options.feature_angle` and `options.shortest_chain` are not
/// read.
Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector,
                             const Given_features& features, const Snap_options& options,
                             Vertex_constraints& constraints);

/// As `finish_quads()` with sharp edges; `options.feature_angle` and `options.shortest_chain` are not read.
/// Given features are worth any loss of the quads' quality that leaves no more of them inverted and no more
/// that intersect; where a way onto the features does not, a gentler one is tried, which keeps fewer. The
/// report counts what is kept and what is not. \pre the features are those of the projector's surface.
Result<Finished_quads> finish_quads(Quad_mesh mesh, const Surface_projector& projector,
                                    const Given_features& features, const Relax_options& relaxation,
                                    const Snap_options& options, Observer* observer = nullptr,
                                    const std::vector<int>& held = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FINISH_ON_FEATURES_H
