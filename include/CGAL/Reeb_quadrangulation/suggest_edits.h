// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SUGGEST_EDITS_H
#define CGAL_REEB_QUADRANGULATION_SUGGEST_EDITS_H

#include <CGAL/Reeb_quadrangulation/Editor.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What a hint is about, in the order in which hints are listed.
enum class Hint_kind : signed char {
  uncovered_limb, ///< a protrusion that the quads do not reach: an extremum at its tip
  thin_chart,     ///< a chart of flat quads between saddles: the saddles on one contour
  sharp_edge,     ///< a contour beside a closed chain of sharp edges: the contour on the chain
  saddle,         ///< a vertex of valence 8 with room around it: half- or quarter-saddles
  lost_place,     ///< a part of the surface that the finished quads cut off: an extremum there
  lost_edge,      ///< sharp edges that no quads run along: a contour on them, or a texture fitted to them
  lost_corner     ///< a corner without a vertex of the quads: the nearest vertex on it
};

/// The name of a kind in lists: "uncovered_limb".
const char* name(Hint_kind kind);

/// An edit that is worth while. It has been tried: the editor that it was suggested for applies it.
struct Hint {
  Hint_kind kind = Hint_kind::uncovered_limb;
  Edit edit;
  Point place = Point::Zero(); ///< on the surface
  std::string reason;          ///< a sentence with the numbers below
  /// What the edit improves, without a unit, smaller is better: the distance of the limb's tip, or of the
  /// contour from the sharp edges, in edge lengths of the quads; how many times longer than wide the chart's
  /// quads are, in the mean; the difference of the saddle's valence from 4; the distance of the place from
  /// the quads, and the length of all lost sharp edges, in edge lengths; the number of lost corners. The last
  /// three are those of the quads as the design's charts have them, not yet relaxed.
  double before = 0, after = 0;
};

/// What is worth a hint. Lengths are in edge lengths of the quads (`Design::edge_length`).
struct Hint_options {
  bool limbs = true, thin_charts = true, sharp_edges = true, saddles = true;
  double limb = 1.5;         ///< a tip farther than this from all vertices of the quads is uncovered
  double persistence = 0.02; ///< of the protrusions; see `Suggestion_options`
  double thin = 0.5;         ///< charts lower than this are thin
  double snap = 1;           ///< contours no farther than this from sharp edges, in the mean, are beside them
  double feature_angle = 45; ///< of sharp edges, degrees
  double room = 2;           ///< height of the charts that the parts of a saddle must leave
  /// The quads that the design was finished to, or null: what they do not keep of the working surface
  /// (deviation.h) is worth hints, four of a kind at most. `apply_hints()` has none of these: each of its
  /// steps would need other quads.
  const Quad_mesh* finished = nullptr;
  double lost = 0.5; ///< farther from the finished quads, or longer, than this is lost
};

/// Proposes edits of a design, with a reason each. An edit is proposed if, tried on the design, it applies
/// and improves the measure of its kind (a limb's or a contour's distance by half an edge length, or to less
/// than a tenth of it); saddles are split only if the mean scaled Jacobian of the quads around them grows by
/// a thousandth at least and no chart gets low. No hint costs a texture that the user has edited.
///
/// The order is that of the kinds, then the worst measure first, then by place. An empty design has no hints.
/// Fails with `impossible_request` (an option out of range) and `cancelled`. Costs `suggest_extrema()` and a
/// preview for each place in question.
Result<std::vector<Hint>> suggest_edits(const Editor& editor, const Hint_options& options = {},
                                        Observer* observer = nullptr);

/// Takes hints until there are none: applies the first, looks again, and so on. Ends, since every hint leaves
/// fewer uncovered tips, or as many and fewer simple saddles, or thin charts, or contours beside sharp edges.
/// Returns the hints in the order in which they were taken, each an edit of the editor's history. If it is
/// cancelled, those taken so far stay applied.
Result<std::vector<Hint>> apply_hints(Editor& editor, const Hint_options& options = {},
                                      Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SUGGEST_EDITS_H
