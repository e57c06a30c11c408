// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_T_JUNCTIONS_H
#define CGAL_REEB_QUADRANGULATION_T_JUNCTIONS_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// An edge of a coarse quad on which vertices of finer neighbours lie: T-junctions. The edge runs from corner
/// `corner` of the quad to the next; `vertices` are those strictly between, in this direction. On the other
/// side lie quads with the edges between consecutive vertices, and none with the whole edge.
struct Hanging_edge {
  int quad = -1, corner = 0;
  std::vector<int> vertices;
};

struct T_junction_options {
  /// How many quads of length a turn of a line is worth, which makes up to two extraordinary vertices. The
  /// larger, the fewer extraordinary vertices, and the further away from the T-junctions quads may be split.
  double turn_cost = 4;
  /// Whether a line may end on the boundary, which gets a new vertex there. Needed where a part of the mesh
  /// with boundary has an odd number of T-junctions.
  bool may_end_on_boundary = true;
  std::vector<char> fixed; ///< per quad: 1 if it must not be split; empty: none
};

/// An all-quad mesh without T-junctions, and what was done for it.
struct Resolved_mesh {
  Quad_mesh mesh;                 ///< all vertices before keep their numbers and places; new ones follow
  std::vector<int> parent;        ///< per quad: the quad before that it is, or is a part of
  std::vector<int> extraordinary; ///< the vertices that became extraordinary, increasing: inside not of four
                                  ///< quads, on the boundary not of two
  std::vector<int> boundary_vertices; ///< the new ones on the boundary
  std::vector<int> added_edges;       ///< per vertex: how many edges it got; all of a new vertex
  int lines = 0;                      ///< from a T-junction to another or to the boundary
  int templates = 0;                  ///< one quad split into four for two T-junctions of one edge
  int boundary_ends = 0;              ///< lines that ended on the boundary
};

/// Makes a watertight all-quad mesh of one with T-junctions.
///
/// A line of new edges goes on from each T-junction into the coarse quad and on through quads to another
/// T-junction. Where it crosses a quad it splits it in two; where it turns it splits it in three, and the
/// inner vertex has three edges and the far corner one more. An edge with an odd number of T-junctions sends
/// one line, along a path of least cost, to the nearest other such edge: neighbours in one row give the even
/// 2:4 template, opposite edges of a strip no extraordinary vertex. Two T-junctions of one edge are joined
/// inside its quad, the 1:3 template; more are nested, so that a whole edge makes at most two inner vertices
/// of three edges. This does what section 7.2 of the paper does by cutting along shortest paths, but without
/// quads of no area.
///
/// New positions are interpolated in the quads; project them on the surface if there is one. Fails with
/// `impossible_request` if the hanging edges do not fit the mesh, or a part has an odd number of T-junctions
/// and no boundary for a line to end, or the quads that are `fixed` separate them. Deterministic; O(Q), and a
/// search for each line, as large as its path.
Result<Resolved_mesh> resolve_t_junctions(const Quad_mesh& mesh, const std::vector<Hanging_edge>& hanging,
                                          const T_junction_options& options = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_T_JUNCTIONS_H
