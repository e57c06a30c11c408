// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_STUDIO_SKELETON_H
#define REEBQUAD_STUDIO_SKELETON_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <vector>

namespace reebquad {
namespace studio {

/// The Reeb graph drawn in space: nodes in the middle of their contours, arcs through the middles of their charts' levels.
struct Skeleton {
  std::vector<CGAL::Reeb_quadrangulation::Point> nodes;
  std::vector<std::vector<CGAL::Reeb_quadrangulation::Point>> arcs; ///< one for each chart, from node to node
};

/// `values` is the field on the embedded surface. O(size of the charts).
Skeleton skeleton(const CGAL::Reeb_quadrangulation::Embedded_design& embedded,
                  const CGAL::Reeb_quadrangulation::Contour_network& network,
                  const CGAL::Reeb_quadrangulation::Reeb_graph& graph, const std::vector<double>& values);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_STUDIO_SKELETON_H
