// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FINISH_QUADS_H
#define CGAL_REEB_QUADRANGULATION_FINISH_QUADS_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/followed_guide.h>
#include <CGAL/Reeb_quadrangulation/relax_quads.h>
#include <CGAL/Reeb_quadrangulation/snap_to_features.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Quads after the last stage, and what it did.
struct Finished_quads {
  Quad_mesh mesh;
  Relax_report relaxation;
  Snap_report features;
  std::vector<Guide_outcome> guides; ///< in the order of the guides, if there are some
};

/// The last stage: relaxes quads on the surface, where `features.feature_angle > 0` again on sharp edges; at
/// last, with `untangle`, vertices go to places far from all quads. Those in `held` stay where they are.
Result<Finished_quads> finish_quads(Quad_mesh mesh, const Triangle_surface& input,
                                    const Relax_options& relaxation = {}, const Snap_options& features = {},
                                    Observer* observer = nullptr, const std::vector<int>& held = {});
/// The same on the surface of a projector, which may serve several meshes.
Result<Finished_quads> finish_quads(Quad_mesh mesh, const Surface_projector& projector,
                                    const Relax_options& relaxation = {}, const Snap_options& features = {},
                                    Observer* observer = nullptr, const std::vector<int>& held = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FINISH_QUADS_H
