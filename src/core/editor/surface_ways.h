// SPDX-License-Identifier: GPL-3.0-or-later
// Ways along the edges of a surface, for edits that go a part of the way or somewhere beside.
#ifndef REEBQUAD_EDITOR_SURFACE_WAYS_H
#define REEBQUAD_EDITOR_SURFACE_WAYS_H

#include <CGAL/Reeb_quadrangulation/Surface_point.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The vertex that a point means: the one it names, if it lies there, else the nearest one. O(V).
int nearest_vertex(const Triangle_surface& surface, const Surface_point& at);

/// The vertices within a distance of a vertex along edges, the nearest first, with their distances; those
/// beyond `until`, once that is reached, are left out. O(n log n) for n vertices.
std::vector<std::pair<double, int>> vertices_within(const Triangle_surface& surface, int vertex,
                                                    double distance, int until = -1);

/// Vertices on a shortest way along edges: for each part of its length the one that is nearest to it, without
/// repetition and without both ends. A part has its place in the list of parts, -1 where it has no vertex of
/// its own.
std::vector<int> vertices_on_way(const Triangle_surface& surface, int from, int to,
                                 const std::vector<double>& parts);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_EDITOR_SURFACE_WAYS_H
