// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_FEATURES_SNAP_TO_CHAINS_H
#define REEBQUAD_FEATURES_SNAP_TO_CHAINS_H

#include "features/feature_lines.h"

#include <CGAL/Reeb_quadrangulation/finish_on_features.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Features of which some chains are left out.
struct Chosen_features {
  const Given_features* features = nullptr;
  std::vector<char> is_refused; ///< one entry a chain

  explicit Chosen_features(const Given_features& all)
      : features(&all), is_refused(all.edges.chains.size(), 0) {}
};

/// As `snap_to_features()`, without the chains that are refused and without the corners on these alone;
/// `chain_of_curve` becomes the chain of each curve that is added to `constraints`.
Snap_report snap_to_chains(Quad_mesh& mesh, const Surface_projector& projector,
                           const Chosen_features& features, const Snap_options& options,
                           const Line_way& lines, Vertex_constraints& constraints,
                           std::vector<int>& chain_of_curve);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_FEATURES_SNAP_TO_CHAINS_H
