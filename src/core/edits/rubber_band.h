// SPDX-License-Identifier: GPL-3.0-or-later
// A curve on a mesh that is pulled tight like a rubber band: it slides over the edges and hops over vertices.
#ifndef REEBQUAD_EDITS_RUBBER_BAND_H
#define REEBQUAD_EDITS_RUBBER_BAND_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A curve over the edges of a mesh: it crosses `exit[i]`, a halfedge of the face that it leaves, at `t[i]`
/// from its source. It is closed, or begins and ends at two vertices (or one).
struct Band {
  std::vector<int> exit;
  std::vector<double> t;
  int from = -1, to = -1;
};

/// How near to a vertex a band comes before it hops, as a share of the edge.
constexpr double band_margin = 0.02;

/// Pulls a band for some rounds. It hops over no vertex on the boundary, and over none of `is_wall` (per
/// vertex; may be empty), from which it stays a fifth of an edge away. O(rounds * crossings).
Band tightened(const Triangle_surface& mesh, Band band, int rounds, const std::vector<char>& is_wall = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_EDITS_RUBBER_BAND_H
