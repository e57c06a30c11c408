// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FINISH_DESIGN_H
#define CGAL_REEB_QUADRANGULATION_FINISH_DESIGN_H

#include <CGAL/Reeb_quadrangulation/adapt_quads.h>
#include <CGAL/Reeb_quadrangulation/finish_quads.h>
#include <CGAL/Reeb_quadrangulation/marks.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How the stitched quads of a design become the result.
struct Finish_options {
  /// Relax the quads on the input; without it, nothing is moved, also not onto sharp edges.
  bool relax = true;
  Relax_options relaxation = {};
  /// Vertices move onto sharp edges and corners; with a `feature_angle` of 0 they do not.
  Snap_options features = {};
  /// With a ratio above 1, quads are subdivided where the surface bends, or where a size field asks for it,
  /// after they were relaxed, and relaxed again.
  Adaptive_options adaptive{1};
  /// With marks, these and the edges that are sharp by the angle of `features` are features that the user
  /// gives, see finish_on_features.h: they are worth any loss of quality that leaves quads without defects.
  Marks marks{};
};

/// The quads of a design in the end, and what was done to them.
struct Finished_design {
  Stitched_mesh quads;
  Relax_report relaxation;
  Snap_report features;
  std::vector<Guide_outcome> guides; ///< in the order of the design's guides
  int subdivided_quads = 0;          ///< by `Finish_options::adaptive`
  int t_junctions = 0;               ///< between these and the others, all resolved
};

/// Finishes quads on the surface of the projector, which may serve several meshes. Where adaptive quads would
/// be inverted, other lines between fine and coarse ones are tried, then a lower ratio; the best of all is
/// taken. Fails with `impossible_request` where an option is out of range, as in `marked_features()`, and
/// with `cancelled`.
Result<Finished_design> finish_design(Stitched_mesh quads, const Surface_projector& projector,
                                      const Finish_options& options = {}, Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FINISH_DESIGN_H
