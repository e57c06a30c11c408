// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_SKELETON_H
#define REEBQUAD_VIEW_SKELETON_H

#include "view/Layers.h"

namespace reebquad {
namespace studio {

/// The Reeb graph drawn in space: nodes in the middle of their contours, arcs through the middles of their
/// charts' levels.
struct Skeleton {
  std::vector<CGAL::Reeb_quadrangulation::Point> nodes;
  std::vector<std::vector<CGAL::Reeb_quadrangulation::Point>> arcs; ///< one for each chart, from node to node
};

/// The middles of the field's levels between the ends of a chart, of its triangles. O(their number)
std::vector<CGAL::Reeb_quadrangulation::Point>
line_of_chart(const CGAL::Reeb_quadrangulation::Triangle_surface& mesh, const std::vector<double>& values);

/// O(size of the charts).
Skeleton skeleton(const Charted_surface& charted);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_SKELETON_H
