// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_DECIMATE_H
#define CGAL_REEB_QUADRANGULATION_DECIMATE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A coarse connected graph that stands for a surface wherever only distances and areas are asked for.
///
/// Each node is a patch of the surface: one vertex, its centre, and the vertices nearer to it than to other
/// centres. Arcs join patches that touch; their lengths are those of the straight segments between centres,
/// in the unit of the surface. The nodes of one connected surface are connected. The graph is stored in rows:
/// the neighbours of node `i` are `neighbor[begin[i] .. begin[i + 1])`, in increasing order.
struct Metric_graph {
  std::vector<int> vertex; ///< node -> the vertex at its centre (for a node inside an edge: the nearer end)
  std::vector<Point> position;     ///< node -> its place
  std::vector<double> area;        ///< node -> the area of its patch; they sum up to the area of the surface
  std::vector<int> begin;          ///< number of nodes + 1 entries
  std::vector<int> neighbor;       ///< both directions of every arc
  std::vector<double> length;      ///< as `neighbor`
  std::vector<int> node_of_vertex; ///< vertex -> the node whose patch it is in; -1 if the vertex has no face

  int size() const { return int(vertex.size()); }
};

/// Reduces a surface to a graph of about `nodes` nodes.
///
/// The centres are a Poisson-disc sample of the vertices (no two touching patches have centres nearer than a
/// radius that follows from area and `nodes`, every vertex is within that radius of a centre), grown over the
/// surface so that thin walls stay apart. It does not depend on the position or orientation of the surface in
/// space, only on the order of its vertices. Where the triangles are larger than the patches, nodes inside
/// the edges are added and joined across the faces (Lanthier, Maheshwari and Sack's subdivision for
/// approximate shortest paths), so that a coarse mesh measures distances as well as a fine one. O(V) time on
/// meshes of bounded degree. \pre `surface` is connected by `connect()`, and `nodes > 0`.
Metric_graph decimate(const Triangle_surface& surface, int nodes);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_DECIMATE_H
