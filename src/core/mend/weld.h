// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_MEND_WELD_H
#define REEBQUAD_MEND_WELD_H

#include "mend/corners.h"
#include "mend/loose_triangles.h"

namespace CGAL {
namespace Reeb_quadrangulation {

/// The distance below which points are welded: that of the options, or by default a millionth of the
/// diagonal of the finite points that a corner uses (an STL file keeps 24 bits of a coordinate).
double weld_distance(const std::vector<Point>& points, const std::vector<int>& corners, double asked);

/// The points that lie on edges with other than two faces.
std::vector<char> border_points(const Corner_mesh& mesh, const Edge_groups& edges, int number_of_points);

/// For each border point the one that stands for all that are nearer than `distance` to it, where joining
/// them closes an edge with one face and gives none more than two; the others stand for themselves.
std::vector<int> near_border_points(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                                    double distance);

/// Merges equal border points; then border points nearer than `distance`, see `near_border_points()`; then
/// all points of components that consist of faces which lie on each other in pairs, so that these can be
/// dropped. `merged` gets a mark for each point that is no corner any more because of it.
void weld(Loose_triangles& soup, double distance, std::vector<char>& merged, std::vector<Mend>& mends);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_WELD_H
