// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_THIN_CHARTS_H
#define CGAL_REEB_QUADRANGULATION_THIN_CHARTS_H

#include <CGAL/Reeb_quadrangulation/Chart_parameterization.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Traces the straight line in an annulus's plane from a LOW walk vertex to a HIGH walk vertex as a contour
/// edge of the network: sides are decided once for each vertex, crossings are reduced to those with edges of
/// the original surface, and it is pulled tight. `from` and `to` index `Walk::vertices`; `turns` is added to
/// the V of `to`. With `backwards` the line runs from the HIGH vertex to the LOW one. The map must have been
/// solved for V. New crossings are appended to the network, between the existing ones. Fails with
/// `impossible_request` if rounding in a very long chart leads the line astray.
Result<Contour_edge> trace_line(const Triangle_surface& surface, const Chart& chart,
                                const Chart_parameterization& map, int from, int to, double turns,
                                bool backwards, Contour_network& network);

/// The same between any two vertices of a chart (an annulus or a disc) that is solved for V: from `p` to `q`,
/// whose V is `end_v` as seen from p along the line.
Result<Contour_edge> trace_line(const Triangle_surface& surface, const Chart& chart,
                                const Chart_parameterization& map, int p, int q, double end_v,
                                Contour_network& network);

/// Aligns the saddles on the two contours of an annulus on one contour, so that the chart vanishes: the new
/// contour goes through all visits of both walks in the order of their natural V; pieces between neighbours
/// on one walk stay, the others are straight lines in the chart. Every node keeps its valence. The old pieces
/// are removed from the network. Fails with `impossible_request` if a node on the walks is not a saddle.
Result<void> collapse_chart(const Triangle_surface& surface, const Chart& chart,
                            const Chart_parameterization& map, Contour_network& network);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_THIN_CHARTS_H
