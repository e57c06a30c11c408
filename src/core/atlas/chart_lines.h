// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that were drawn in a chart, as contours of the original surface.
#ifndef REEBQUAD_ATLAS_CHART_LINES_H
#define REEBQUAD_ATLAS_CHART_LINES_H

#include <CGAL/Reeb_quadrangulation/Atlas.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Where a line crosses an edge of the original surface.
struct Line_crossing {
  int edge;
  double t;
  int next_face; ///< the face of the original surface that the line enters
};

/// Where a vertex of a chart lies on an edge of the original surface, from its representative's source (0) to
/// target (1).
std::optional<double> position_on_edge(const Triangle_surface& surface, const Chart& chart,
                                       const Contour_network& network, int vertex, int edge);

/// The crossing with the original surface of a line that crosses halfedge `h` of a chart at `t`, from its
/// source (0) to its target (1), and enters a face of the chart; none where only the chart has that edge.
std::optional<Line_crossing> surface_crossing(const Triangle_surface& surface, const Chart& chart,
                                              const Contour_network& network, int h, double t,
                                              int next_local_face);

/// Adds crossings to the network and to the polyline of a contour edge.
void append_crossings(const std::vector<Line_crossing>& crossings, Contour_network& network,
                      Contour_edge& edge);

/// A loop that crosses an edge and comes back over it at once can be pulled back: nothing lies between.
void pull_loop_tight(std::vector<Line_crossing>& crossings);

/// A line that leaves a face of the original surface by the edge it came through, or begins or ends by
/// crossing an edge at its own end, can be pulled back over it: nothing lies between. `start` and `end` are
/// network vertices.
void pull_tight(const Triangle_surface& surface, const Contour_network& network, int start, int end,
                int& first_face, std::vector<Line_crossing>& crossings);

/// Whether two network vertices lie on one edge of the surface (or are its ends): the line between them runs
/// along it.
bool are_on_one_edge(const Triangle_surface& surface, const Contour_network& network, int a, int b);

/// Adds contours that were built on a chart's mesh (edges `which` of `local`, each a loop) to the network,
/// with their nodes. Crossings of edges that only the chart has are left out. Returns the new contour edges.
/// Fails with `refused_edit` if a node falls on a vertex that the surface does not have, or a loop shrinks to
/// nothing; then the network must be thrown away.
Result<std::vector<int>> transfer_contours(const Triangle_surface& surface, const Chart& chart,
                                           const Contour_network& local, const std::vector<int>& which,
                                           Contour_network& network);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_ATLAS_CHART_LINES_H
