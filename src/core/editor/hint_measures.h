// SPDX-License-Identifier: GPL-3.0-or-later
// What hints measure on a design.
#ifndef REEBQUAD_EDITOR_HINT_MEASURES_H
#define REEBQUAD_EDITOR_HINT_MEASURES_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The quads of a chart's texture where they lie on the surface. O(quads).
Quad_mesh quads_of(const Design_chart& chart);

/// Charts of `design` that `other` does not have, or has with other quads: those that an edit touches.
std::vector<const Design_chart*> charts_not_in(const Design& design, const Design& other);

/// The mean over all quads of the charts of the longest edge over the shortest one.
double mean_aspect(const std::vector<const Design_chart*>& charts);

/// The mean over all quads of the charts; see `certify()`.
double mean_scaled_jacobian(const std::vector<const Design_chart*>& charts);

/// The distance from a point to the nearest vertex of the quads of the charts.
double distance_to_quads(const Point& point, const std::vector<const Design_chart*>& charts);

using Segments = std::vector<std::array<Point, 2>>;

/// The mean distance from a list of points to the nearest of some segments. O(points x segments)
double mean_distance(const std::vector<Point>& points, const Segments& segments);

/// The points of a contour edge.
std::vector<Point> contour_points(const Triangle_surface& surface, const Contour_network& network, int edge);

Segments segments_of(const std::vector<Point>& polyline);

/// Whether a contour edge is there and is a loop without saddles.
bool is_free_loop(const Contour_network& network, int edge);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_EDITOR_HINT_MEASURES_H
