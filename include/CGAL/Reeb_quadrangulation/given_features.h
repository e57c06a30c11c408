// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_GIVEN_FEATURES_H
#define CGAL_REEB_QUADRANGULATION_GIVEN_FEATURES_H

#include <CGAL/Reeb_quadrangulation/feature_edges.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Features of a surface that a user gives, whatever angle the faces there make.
struct Given_features {
  Feature_edges edges;     ///< none of its chains is noise, however short; chains end at `points`
  std::vector<int> points; ///< vertices where a vertex of quads shall lie, ascending; also corners of `edges`
};

/// The features along the halfedges marked in `sharp`, which has an entry a halfedge, the same for both of an
/// edge, and at the vertices `points`. Corners besides as for `feature_edges()`. Linear time. \pre `surface`
/// is connected by `connect()`; `points` are its vertices.
Given_features given_features(const Triangle_surface& surface, std::vector<char> sharp,
                              std::vector<int> points, double corner_angle = 50);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_GIVEN_FEATURES_H
