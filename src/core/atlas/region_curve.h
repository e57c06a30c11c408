// SPDX-License-Identifier: GPL-3.0-or-later
// A contour that is drawn anew in the region that its charts make up: the line between the vertices that
// shall lie on its left and those that shall lie on its right.
#ifndef REEBQUAD_ATLAS_REGION_CURVE_H
#define REEBQUAD_ATLAS_REGION_CURVE_H

#include <CGAL/Reeb_quadrangulation/Atlas.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The contour edge along which a region's border runs, and the side of it (0: left, 1: right) that the
/// region is on.
struct Region_wall {
  int edge = -1, side = 0;
};

/// A region between contours, of any topology; its chart has no walks.
struct Open_region {
  Chart chart; ///< of kind `region`; a contour's vertex has one local vertex for each visit
  std::vector<Region_wall>
      walls; ///< of the border's vertices, which are the first ones: that which begins there
  bool is_on_border(int v) const { return v < int(walls.size()); }
};

/// The region around a face of the embedding. O(F). Fails with `internal_error` if it ends where no contour
/// is.
Result<Open_region> open_region(const Embedding& embedding, const Contour_network& network, int face);

/// Two sides of a region that a curve from one local vertex to another, or back to the same, or a closed one
/// (-1, -1), shall part.
struct Region_sides {
  /// Per vertex: positive where it shall be on the left, negative on the right; the amount says how much.
  std::vector<double> wish;
  /// Per vertex: 1 on the left, -1 on the right of a curve that is there before, whose vertices on the border
  /// keep their sides. Each side is connected.
  std::vector<signed char> home;
  int from = -1, to = -1;
  std::vector<int> held = {}; ///< vertices inside that keep their home, too
};

/// The side of each vertex (1 or -1; 0 of the ends) such that both sides are connected, the border keeps its
/// home, and as little as possible is against the wish: around the ends the best of all orders that a curve
/// can have, elsewhere by flooding both sides from the border, where they go against the wish by the least
/// amount first. So the curve between the sides is one simple curve, which meets no contour, whatever the
/// wish. Fails with `refused_edit` if a side cannot be connected.
Result<std::vector<signed char>> part_region(const Open_region& region, const Region_sides& asked);

/// Where a line between two points crosses an edge, from its source (0) to its target (1), when the faces
/// between are unfolded.
double straight_crossing(const Point& source, const Point& target, const Point& before, const Point& after);

/// A curve on a region's mesh: the halfedges that it crosses, each from the face that it leaves, and where,
/// from their sources.
struct Region_curve {
  std::vector<int> exits;
  std::vector<double> t;
};

/// The curve between the sides, the left ones on its left, where the wish is zero. Fails with `refused_edit`
/// if it is not one curve.
Result<Region_curve> curve_between(const Open_region& region, const std::vector<signed char>& sides,
                                   const Region_sides& asked);

/// The curve as a contour edge of the surface; its nodes and sides are not set. `from` and `to` are network
/// vertices, or -1 of a closed one. Adds its crossings between those of the network. Fails with
/// `refused_edit` if nothing is left of it when it is pulled tight.
Result<Contour_edge> contour_of_curve(const Triangle_surface& surface, const Open_region& region,
                                      const Region_curve& curve, int from, int to, Contour_network& network);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_ATLAS_REGION_CURVE_H
