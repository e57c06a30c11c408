// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUADRANGULATE_H
#define CGAL_REEB_QUADRANGULATION_QUADRANGULATE_H

#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/adapt_quads.h>
#include <CGAL/Reeb_quadrangulation/finish_quads.h>
#include <CGAL/Reeb_quadrangulation/layout_sampling.h>
#include <CGAL/Reeb_quadrangulation/prepare_surface.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// An extremum that the user places: the vertex nearest to `point` is taken.
struct Placed_extremum {
  Point point;
  bool is_maximum = false;
};

/// What the automatic pipeline is asked for. Every option has a default that suits organic shapes.
struct Quadrangulation_options {
  int quads =
      3000; ///< number of quads asked for, met within 5 % if the layout permits; ignored if `edge_length > 0`
  double edge_length = 0; ///< length of the quads' edges in the units of the surface; 0 = use `quads`
  std::vector<Placed_extremum>
      extrema; ///< if not empty, these replace the suggestion (not the boundary loops' constants)
  Suggestion_options suggestion;                ///< of the automatic extrema
  Weight_kind weights = Weight_kind::cotangent; ///< of the field; charts always use positive weights
  Constraint_method constraints = Constraint_method::elimination;
  bool prepare =
      true; ///< refine and mend a working copy where the surface is coarse or its triangles are needles
  bool collapse_thin = true; ///< align the saddles of charts that are thinner than half a quad
  /// The weights of a chart's map, and how charts are filled; empty: clamped cotangents, regular grids. Called from several
  /// threads at once.
  std::function<Edge_weights(const Chart&)> chart_weights;
  Texture_maker textures;
  double sample_blend = 0.5; ///< samples by arc length (0) to samples by flux (1)
  bool relax = true;         ///< relax the quads on the surface
  Relax_options relaxation;
  bool keep_features = true; ///< move vertices onto sharp edges and corners; needs `relax`
  Snap_options features;
  /// With a ratio above 1: quads are subdivided where the surface bends, or where a size field asks for it, after they were
  /// relaxed, and relaxed again. `quads` is then still their number in the end, about; `edge_length` that of the coarsest.
  Adaptive_options adaptive{1};
  int threads = 0; ///< charts solved at once; 0 = as many as the machine has. Results do not depend on it
};

/// One stage of a run, as it was measured.
struct Stage_time {
  std::string name;
  double seconds = 0;        ///< wall time
  double cpu_seconds = 0;    ///< of all threads
  double peak_megabytes = 0; ///< resident, of the process so far
};

/// A quad mesh of a connected surface and how it came about.
struct Quadrangulation {
  Quad_mesh mesh;
  std::map<int, int>
      valences; ///< predicted from the layout alone: valence -> number of vertices not on the boundary
  std::vector<int> chart_of_quad;
  Reeb_layout layout; ///< on `working_surface`
  Triangle_surface working_surface;
  Designed_field field; ///< as solved, before the cleanup
  Sampling sampling;
  Relax_report relaxation;
  Snap_report features;
  int subdivided_quads = 0; ///< by `Quadrangulation_options::adaptive`
  int t_junctions = 0;      ///< between these and the others, all resolved
  Prepare_report preparation;
  int collapsed_charts = 0;         ///< thin charts that were removed by aligning their saddles
  std::vector<double> chart_height; ///< mean, per chart; 0 for discs
  int flipped_triangles = 0;        ///< of all charts' maps, 0 but for rounding
  int genus = 0;
  std::vector<Stage_time> stages;
};

/// Turns a connected surface, closed or with boundary loops, into an all-quad mesh whose extraordinary vertices are those
/// that the Reeb layout predicts.
///
/// Errors: `not_a_surface` (empty, or several components), `impossible_request` (options out of range, placed extrema without a minimum
/// or a maximum), `solver_failure`, `infeasible_sampling`, `cancelled`; `internal_error` never, unless we have a defect.
/// \pre `surface` is connected by `connect()`.
Result<Quadrangulation> quadrangulate(const Triangle_surface& surface,
                                      const Quadrangulation_options& options = {},
                                      Observer* observer = nullptr);

/// The extrema that the options ask for, in increasing order, and whether each boundary loop is a maximum; `values` is left empty.
Result<Designed_field> choose_extrema(const Triangle_surface& surface,
                                      const Quadrangulation_options& options = {},
                                      Observer* observer = nullptr);

/// Fills in `field.values`: harmonic, with `extremal_values`, else 0 at minima and 1 at maxima. Fails with `solver_failure`.
Result<void> solve_field(const Triangle_surface& surface, const Quadrangulation_options& options,
                         Designed_field& field);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUADRANGULATE_H
