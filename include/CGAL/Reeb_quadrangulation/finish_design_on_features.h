// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FINISH_DESIGN_ON_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_FINISH_DESIGN_ON_FEATURES_H

#include <CGAL/Reeb_quadrangulation/finish_design.h>
#include <CGAL/Reeb_quadrangulation/given_features.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// As `finish_design()`, with features that a user gives instead of the surface's sharp edges; see
/// finish_on_features.h.
/// \pre the features are those of the projector's surface.
Result<Finished_design> finish_design(Stitched_mesh quads, const Surface_projector& projector,
                                      const Given_features& features, const Finish_options& options = {},
                                      Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FINISH_DESIGN_ON_FEATURES_H
