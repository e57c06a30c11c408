// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_REEB_LAYOUT_H
#define CGAL_REEB_QUADRANGULATION_REEB_LAYOUT_H

#include <CGAL/Reeb_quadrangulation/Atlas.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>

#include <map>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A field on a surface with the extrema that it is allowed to have.
struct Designed_field {
  std::vector<double> values;            ///< per vertex
  std::vector<int> minima, maxima;       ///< interior vertices
  std::vector<bool> boundary_is_maximum; ///< per loop of `boundary_loops()`: the field is constant on each
  /// The vertices as `Harmonic_field::elimination_order()` gives them, or none. The charts' systems take it
  /// over.
  std::vector<int> elimination_order = {};
  std::map<int, double> extremal_values = {}; ///< of the extrema whose value is not 0 (minima) or 1 (maxima)
  std::map<int, double> boundary_values = {}; ///< of the loops whose value is not 0 (minima) or 1 (maxima)
  std::map<int, double> curve_values =
      {}; ///< given at further vertices, of curves on which the field is constant
};

/// What a function of the user's own, a value for each vertex, is as a field to design with. Values are
/// scaled to 0 .. 1. Wanted are the function's extrema, but for those that `Order_graph::pairs` joins with a
/// saddle whose value differs by at most `persistence`, a share of the range: noise, and at 0 the extrema of
/// plateaus, which only the order of the vertices makes. Equal values count as ordered by their vertices.
///
/// Quads have no place for contours that end on the boundary, so that the function must be constant on each
/// boundary loop, up to 1e-6 of its range, and either a minimum or a maximum there; \sa `order_graph()` for
/// other functions. Fails with `impossible_request`, naming the vertex, where it is not, where a value is not
/// finite or all are equal, and where the number of values or the persistence is wrong. O(F + C log C) for C
/// crossings of edges with critical contours. \pre `surface` is connected by `connect()`.
Result<Designed_field> design_function(const Triangle_surface& surface, const std::vector<double>& values,
                                       double persistence = 0);

/// The Reeb atlas of a field: the surface cut along its critical contours and its caps.
struct Reeb_layout {
  Critical_points critical;      ///< of the cleaned field; the apexes over boundary loops are left out
  int cleanup_rounds = 0;        ///< of `remove_extrema()`
  std::vector<double> values;    ///< the cleaned field
  std::vector<int> lost_extrema; ///< wanted ones that the field does not have
  Contour_network network;
  Embedding embedding;
  Atlas atlas;
  Reeb_graph graph;
};

/// A cap: the contour between two ranks that separates an extremum from the rest of its disc.
///
/// In the disc between an extremum and the first critical point that its level sets meet, of 48 level lines
/// the outermost is taken whose inside has at most twice the area of the flat square with its length around
/// (a flat disc has 1.27 times), and whose mean distance from the extremum is at most 0.6 of the distance to
/// the disc's end, so that the annulus that is left is not thin. A tip that is too thin for that is cut where
/// its length around is a quarter of the longest.
Traced_contour trace_cap(const Closed_surface& closed, const Vertex_order& order,
                         const std::vector<double>& values, const Critical_points& critical, int extremum,
                         bool is_maximum);

/// Orders the field, removes extrema that are not wanted, traces every saddle's contours and a cap around
/// every extremum, embeds them, and cuts the charts. Fails with `impossible_request` if the field has no
/// minimum or no maximum, or if a saddle falls on a boundary vertex, which is possible only where an interior
/// edge joins two of them (`prepare_surface()` splits such edges); and with `internal_error` if a region is
/// not a chart. The contour edges are numbered from `first_edge` on; those before are removed ones, so that
/// an editor's contours keep different numbers for life.
Result<Reeb_layout> make_layout(const Triangle_surface& surface, const Designed_field& field,
                                int first_edge = 0);

/// Fills in `field.values` by a field on this surface that keeps its factorization; its constraints are
/// replaced: harmonic, with `extremal_values`, else 0 at minima and 1 at maxima, and with `curve_values`.
/// Fails with `solver_failure`.
Result<void> solve_field(const Triangle_surface& surface, Harmonic_field& harmonic, Designed_field& field);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_REEB_LAYOUT_H
