// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SAMPLING_H
#define CGAL_REEB_QUADRANGULATION_SAMPLING_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <array>
#include <cstdint>
#include <vector>

/// \file
/// Sampling: how many quad edges lie on each contour edge, and how many rows of quads in each chart.
///
/// The problem is one of integers alone. Every contour edge `e` has one count `n_e`, shared by the charts on
/// its two sides; an annulus has as many columns on its low walk as on its high walk (conservation), but for
/// those that it is said to gain. Counts want to be `i_e = length / h`. A quad that is `r = n_e / i_e` times
/// too narrow costs `r + 1 / r - 2`: twice as many columns as wanted cost as much as half as many. The rows
/// of quads that go by a contour edge reach half across the charts beside it; with `w_e` of them (at least
/// one) the sum of `w_e (n_e - i_e)^2 / n_e` is minimised. When every count is carried from a chart to the
/// one above it, conservation says that counts are a flow on the Reeb graph, and the minimum is found exactly
/// by scaled successive shortest paths (Ahuja, Magnanti, Orlin, "Network Flows", 1993, sec. 14.5). Layouts
/// that are not a network (an edge with two different charts on the same level, equalities asked for by the
/// user) are solved in the lattice of integer solutions; feasibility is then decided by an exact linear
/// program.

namespace CGAL {
namespace Reeb_quadrangulation {

/// One contour edge.
struct Sampling_edge {
  double length = 0; ///< in the units of the surface, positive
  int minimum = 2;   ///< fewest steps: 4 for an edge that is a loop, else 2
  int step = 2;      ///< counts are multiples of it: 2, or 1 for a segment that one walk passes twice
  int locked = 0;    ///< a count to keep, or 0
};

/// One chart with the contour edges on its walks, in any order; an edge that a walk passes twice is listed
/// twice.
struct Sampling_chart {
  enum class Kind { annulus, disc };
  Kind kind = Kind::annulus;
  std::vector<int> low;   ///< edges of the lower walk; of a disc around a maximum, its boundary
  std::vector<int> high;  ///< edges of the upper walk; of a disc around a minimum, its boundary
  double height = 0;      ///< mean length across, from walk to walk (annuli only)
  int locked_rows = 0;    ///< rows to keep, or 0 (annuli only)
  int locked_columns = 0; ///< columns to keep at the low walk, or 0 (annuli only)
  int fewest_rows = 2;    ///< (annuli only)
  /// Columns that the high walk has more than the low one; even (annuli only).
  int columns_gained = 0;
  /// How far the sampling may go from that, in either direction; even (annuli only).
  int free_gain = 0;
  /// A disc that is a rectangle: the entries of its boundary where its four sides begin; opposite sides get
  /// equal sums.
  std::array<int, 4> corners{{-1, -1, -1, -1}};
};

/// Asks that the counts of two lists of edges have equal sums, as pinned corners do for opposite sides of a
/// chart.
struct Sampling_equality {
  std::vector<int> first, second;
  int chart = -1; ///< the chart that asks, for messages
};

/// The integer problem of a layout. An edge occurs at most twice in all walks, once for each of its sides; a
/// boundary loop of the surface occurs once.
struct Sampling_problem {
  std::vector<Sampling_edge> edges;
  std::vector<Sampling_chart> charts;
  std::vector<Sampling_equality> equalities;
};

/// A solution. An annulus has `grid = {columns at the low walk, rows}`, a disc `grid = {a, b}` with `2 (a +
/// b)` edges around it and `a - b` zero or one, or its first two sides if it is a rectangle; either has
/// `grid[0] * grid[1]` quads, if no columns are gained, else about half as many more as all columns gained
/// would have.
struct Sampling {
  std::vector<int> counts;              ///< one for each edge
  std::vector<std::array<int, 2>> grid; ///< one for each chart
  std::vector<int> gained;              ///< one for each chart: columns more at the high walk
  std::int64_t quads = 0;               ///< in all charts
  double edge_length = 0;               ///< the h that was used
  double worst_ratio = 1;               ///< largest of `n_e / (length / h)` and its inverse over all edges
  int worst_edge = -1;                  ///< where it occurs
  bool target_met = true;               ///< `sample_for_quads`: within 5 % of the target
  std::int64_t fewest = 0;              ///< if the target was not met: the fewest quads this layout can have
};

/// How to solve again after an edit: counts and rows stay where nothing demands a change.
struct Sampling_options {
  /// Counts (0 = none) and rows of the solution before, for the edges and charts of this problem; may be
  /// empty.
  std::vector<int> previous_counts;
  std::vector<int> previous_rows;
  double previous_edge_length = 0; ///< its `edge_length`: where `sample_for_quads` begins; 0 = none
  /// What a column costs that an annulus gains or loses beyond `columns_gained`, where `free_gain` permits:
  /// as much as so many rows of quads all of which are by the square root of their number too many or too
  /// few.
  double column_price = 8;
  /// A count is held until the unhindered optimum is about this many steps of the quad mesh away from it.
  double stability = 1;
};

/// Samples the layout for quad edges of length `h`. Every count is at least its minimum and a multiple of its
/// step, and every annulus conserves counts. A layout whose edges all lead from a chart (or boundary loop) to
/// one above it always has a solution; locked counts, equalities and unusual layouts may not: \returns
/// `infeasible_sampling`, naming the chart whose counts cannot be balanced, or `impossible_request` for an
/// `h` that is not positive and finite, or so small that counts exceed 10^8.
/// Complexity: for a network O(m log U) shortest paths, m edges, U the largest imbalance.
Result<Sampling> sample_layout(const Sampling_problem& problem, double h,
                               const Sampling_options& options = {});

/// The same as `sample_layout`, under the name that the program's option `--edge-length` has.
Result<Sampling> sample_for_edge_length(const Sampling_problem& problem, double edge_length,
                                        const Sampling_options& options = {});

/// Samples the layout for about `target` quads: within 1 % where rows and counts permit, `target_met` says
/// whether within 5 %. If even the fewest quads possible are more than `target`, returns the sampling with
/// the fewest.
Result<Sampling> sample_for_quads(const Sampling_problem& problem, std::int64_t target,
                                  const Sampling_options& options = {});

/// The sampling with the fewest quads that the minima and two rows in each annulus permit (exact for networks
/// whose discs have one boundary edge). `edge_length` is the h at which `sample_layout` has about as many
/// quads.
Result<Sampling> fewest_quads(const Sampling_problem& problem);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SAMPLING_H
