// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_ATLAS_H
#define CGAL_REEB_QUADRANGULATION_ATLAS_H

#include <CGAL/Reeb_quadrangulation/Embedding.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

enum class Chart_kind : signed char {
  annulus, ///< one LOW walk, one HIGH walk
  disc,    ///< one walk around one extremum, or a rectangle between four fractional saddles
  region   ///< anything else, see `cut_region()`
};

/// A contour edge as a walk passes it.
struct Walk_edge {
  int edge = -1;       ///< contour edge
  bool forward = true; ///< in its direction, seen in the walk's direction (false only on one pass of a ridge)
  int begin = 0;       ///< index in `Walk::vertices` where it begins
};

/// A boundary of a chart as a closed list of its local vertices, beginning at a node. Both walks of an
/// annulus run "east", in the direction of their contours: the chart is on the left of a LOW walk and on the
/// right of a HIGH walk.
struct Walk {
  Side side = Side::low;
  std::vector<int> vertices;    ///< vertex i + 1 follows vertex i, the first follows the last
  std::vector<Walk_edge> edges; ///< in order; `edges[0].begin == 0`
};

/// One arc of the Reeb graph: a piece of the embedded surface without contours in its interior, as a mesh of
/// its own. A contour vertex has one local vertex for each of the chart's visits, so a pinched walk is an
/// ordinary polygon here.
struct Chart {
  Chart_kind kind = Chart_kind::annulus;
  Triangle_surface mesh;
  std::vector<int> vertex_origin; ///< vertex of the embedding, or -1 for a vertex that split a chord
  std::vector<int> face_origin;   ///< face of the original surface
  /// The ends of the chords that were split, for the vertices without origin, which are the last ones.
  std::vector<std::array<int, 2>> split_chords;
  std::vector<Walk> walks; ///< LOW then HIGH, or the only one
  int extremum = -1;       ///< the local vertex of a disc's extremum; -1 in a rectangle without one

  const Walk& walk(Side side) const { return walks.size() > 1 && side == Side::high ? walks[1] : walks[0]; }
};

/// The charts, ordered by their smallest original face (then by their contours). They are values that never
/// change, so that states of a design share them.
struct Atlas {
  std::vector<std::shared_ptr<const Chart>> charts;
  std::vector<int> chart_of_face; ///< of the embedding; empty after `update_atlas()`
  std::vector<std::array<int, 2>>
      charts_of_edge; ///< per contour edge: left and right chart; -1 outside the surface
};

/// The atlas after contours have changed: the charts of `previous` in `changed` (indices) are cut anew, the
/// others stay. Costs what these charts cost, and gives what `build_atlas()` gives. Fails like it, and like
/// `embed()`. \pre Contours were removed and added only where both sides are among `changed`.
Result<Atlas> update_atlas(const Triangle_surface& surface, const Contour_network& network,
                           const std::vector<int>& extrema, const Atlas& previous,
                           const std::vector<int>& changed, std::vector<int>* reused = nullptr);

/// The chart on the other side of a contour edge, or -1 outside the surface.
int chart_across(const Atlas& atlas, Contour_id edge, Chart_index chart);

/// The contour edges on a chart's walks, in increasing order; one that is passed twice, twice.
std::vector<int> contour_edges(const Chart& chart);

/// The faces of the surface that some charts have a part of, in increasing order. O(F) bits and O(faces of
/// the charts).
std::vector<int> faces_of_charts(const Triangle_surface& surface, const Atlas& atlas,
                                 const std::vector<int>& charts);

/// The union of the faces that can be reached from `face` (of the embedding) without crossing a contour, as a
/// mesh of its own, of any topology. O(F). Fails with `internal_error` if a border runs along both sides of
/// contours.
Result<Chart> cut_region(const Embedding& embedding, const Contour_network& network,
                         const std::vector<int>& extrema, int face);

/// The walks of a disc that is a rectangle begin their sides where they pass a half- or quarter-saddle, or a
/// corner: the indices of those four edges, or nothing if it is not a rectangle.
std::vector<int> rectangle_corners(const Contour_network& network, const Chart& chart);

/// The Reeb graph of the field that the contours belong to: an arc for each chart, a node for each contour (a
/// connected part of the network) and each extremum. Regular vertices of an arc are the interior vertices of
/// its chart.
struct Reeb_graph {
  struct Arc {
    int low, high; ///< nodes
  };
  std::vector<Arc> arcs;            ///< parallel to `Atlas::charts`
  std::vector<int> contour_of_edge; ///< node of each contour edge
  std::vector<int> extremum;        ///< per node: embedded vertex of the extremum, or -1 for a contour
  int number_of_nodes() const { return int(extremum.size()); }
  /// Number of independent cycles; equals the genus if every saddle is simple.
  int loops() const;
};

/// Floods the faces between contours and boundaries, O(F), and checks each region: an annulus with one LOW
/// and one HIGH walk, or a disc with one walk and one vertex of `extrema` inside (none if its walk passes
/// half- or quarter-saddles, or corners, four times). Fails with `internal_error`, naming the chart. A chart
/// depends on the contours around it alone: the others change no bit of it. A chart of `previous` with the
/// same contour edges on its walks is shared; `reused`, if given, gets its index there for each new chart, or
/// -1. \pre Since then contour edges were only removed and added, and no crossing was moved.
Result<Atlas> build_atlas(const Embedding& embedding, const Contour_network& network,
                          const std::vector<int>& extrema, const Atlas* previous = nullptr,
                          std::vector<int>* reused = nullptr);

Reeb_graph reeb_graph(const Atlas& atlas, const Contour_network& network);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_ATLAS_H
