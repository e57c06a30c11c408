// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUADRANGULATE_H
#define CGAL_REEB_QUADRANGULATION_QUADRANGULATE_H

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/given_features.h>
#include <CGAL/Reeb_quadrangulation/mirror_quads.h>
#include <CGAL/Reeb_quadrangulation/search_extrema.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// An extremum that the user places: the vertex nearest to `point` is taken.
struct Placed_extremum {
  Point point;
  bool is_maximum = false;
};

/// How much an automatic run does for a good design.
enum class Effort : signed char {
  fast,   ///< takes the suggested extrema
  normal, ///< searches better ones among a few dozen designs
  best    ///< searches longer
};

/// What an automatic run is asked for. Every option has a default that suits organic shapes.
struct Quadrangulation_options {
  /// Number of quads asked for, met within 5 % if the layout permits; not read if `edge_length > 0`.
  int quads = 3000;
  /// Length of the quads' edges in the units of the surface; 0 = use `quads`.
  double edge_length = 0;
  /// If not empty: the lengths that edges shall have at the vertices of the surface, of which only the ratios
  /// count; see `Editor_options::sizes`.
  std::vector<double> sizes = {};
  /// Whether extrema are searched, see `search_extrema()`; those that are placed stay as they are.
  Effort effort = Effort::fast;
  /// Seconds for the search, in place of the number of designs that `effort` stands for; 0: that number. With
  /// seconds the outcome depends on the machine; its recipe does not. Excludes the effort `fast`.
  double budget = 0;
  /// What the search looks for.
  Energy_weights energy;
  /// The search takes at most so many extraordinary vertices more than the suggestion has; negative: no limit
  /// but their price.
  int extra_vertices = -1;
  /// Columns may end or begin inside of charts, in at most so many dislocations, where contours then get
  /// counts nearer to their lengths and quads sizes that are more alike; see `Balance_columns`. Extraordinary
  /// vertices are then not brought in line.
  int dislocations = 0;
  /// If not empty, these replace the suggestion (not the boundary loops' constants).
  std::vector<Placed_extremum> extrema;
  /// If not empty: a function of the user's own, a value for each vertex of the surface, whose extrema and
  /// critical contours become those of the design; `extrema` and `suggestion` are then not read, and nothing
  /// is searched. Extrema of at most `field_persistence` are left out; see `design_function()`. Excludes a
  /// mirror.
  std::vector<double> field = {};
  double field_persistence = 0;
  /// Of the automatic extrema.
  Suggestion_options suggestion;
  /// Of the field; charts always use positive weights.
  Weight_kind weights = Weight_kind::cotangent;
  /// What the field is on boundary loops that are not as their height suggests; not read with a `field`.
  std::vector<Boundary_value> boundary_values = {};
  /// Whether boundary loops are contours, or are filled; `fill` excludes a mirror.
  Boundaries boundaries = Boundaries::keep;
  /// How the field meets its values.
  Constraint_method constraints = Constraint_method::elimination;
  /// What solves the systems of fields and of charts' maps.
  Linear_solver_factory solver = {};
  /// Refine and mend a working copy where the surface is coarse or its triangles are needles.
  bool prepare = true;
  /// Align the saddles of charts that are thinner than half a quad.
  bool collapse_thin = true;
  /// Bring extraordinary vertices in line, so that the base complex has few patches, where quads keep their
  /// shape; see `Align_layout`.
  bool align = true;
  /// The weights of a chart's map, and how charts are filled; empty: clamped cotangents, regular grids.
  /// Called from several threads at once.
  std::function<Edge_weights(const Chart&)> chart_weights;
  Texture_maker textures;
  /// Samples by arc length (0) to samples by flux (1).
  double sample_blend = 0.5;
  /// Relax the quads on the surface.
  bool relax = true;
  Relax_options relaxation;
  /// Move vertices onto sharp edges and corners; needs `relax`.
  bool keep_features = true;
  Snap_options features;
  /// Edges that the user sets, beside the sharp ones; need `relax`. A recipe keeps them.
  Marks marks;
  /// Strokes that quads follow; need `relax`. See `Add_guide`.
  std::vector<Guide> guides{};
  /// The user's own features of the surface, which count instead of its sharp edges; need `relax`. \sa
  /// finish_on_features.h
  std::optional<Given_features> given_features;
  /// With a ratio above 1: quads are subdivided where the surface bends, or where a size field asks for it,
  /// after they were relaxed, and relaxed again. `quads` is then still their number in the end, about;
  /// `edge_length` that of the coarsest.
  Adaptive_options adaptive{1};
  /// If given: the surface is cut along its plane of symmetry, one half is meshed and reflected. `quads` and
  /// placed extrema are then those of the whole: extrema on the other side count where their images lie.
  /// Excludes `given_features`.
  std::optional<Mirror_request> mirror{};
  /// Charts solved at once; 0 = as many as the machine has. Results do not depend on it.
  int threads = 0;
};

/// The recipe of the automatic run that these options ask for before anything is searched: its first edit
/// places the extrema, suggested or given, its second, if any, brings extraordinary vertices in line. A run
/// leaves the second out where it does not pay. Fails with `impossible_request`, naming the option, where one
/// is out of range.
Result<Recipe> automatic_recipe(const Quadrangulation_options& options = {});

/// A quad mesh of a connected surface and how it came about. With a mirror, `mesh`, `valences`,
/// `chart_of_quad`, `subdivided_quads`, `t_junctions` and `genus` are those of the whole; the editor, the
/// recipe and the rest are those of the half.
struct Quadrangulation {
  Quad_mesh mesh;
  /// Predicted from the layout alone: valence -> number of vertices not on the boundary.
  std::map<int, int> valences;
  std::vector<int> chart_of_quad; ///< index into `Design::charts`
  /// The session that made the design, ready for more edits.
  Editor editor;
  /// What `editor` has done, and how its quads were finished. Replayed on the same surface it gives the same
  /// bytes, unless the options have functions or given features: a recipe keeps neither.
  Recipe recipe;
  Relax_report relaxation;
  Snap_report features;
  std::vector<Guide_outcome> guides; ///< what became of `Quadrangulation_options::guides`, in their order
  int subdivided_quads = 0;          ///< by `Quadrangulation_options::adaptive`
  int t_junctions = 0;               ///< between these and the others, all resolved
  int collapsed_charts = 0;          ///< thin charts that were removed by aligning their saddles
  int flipped_triangles = 0;         ///< of all charts' maps, 0 but for rounding
  int genus = 0;
  /// Patches of the base complex before and after extraordinary vertices were brought in line, as told from
  /// the layout; 0 where they were not. See `base_domain()`.
  std::array<int, 2> base_patches{{0, 0}};
  /// What the search has changed, if there was one, and at last what bringing extraordinary vertices in line
  /// has; the energy of that step is the one before less what was gained.
  std::vector<Search_step> search;
  std::vector<Stage_time> stages;
  std::optional<Mirror_report> mirror{}; ///< if one was asked for
};

/// Turns a connected surface, closed or with boundary loops, into an all-quad mesh whose extraordinary
/// vertices are those that the Reeb layout predicts: replays `automatic_recipe()` and finishes its design.
///
/// Errors: `not_a_surface` (empty, or several components), `impossible_request` (options out of range, placed
/// extrema without a minimum or a maximum, a mirror that the surface does not have), `refused_edit` (placed
/// extrema that the field cannot have), `infeasible_sampling`, `cancelled`; `internal_error` never, unless we
/// have a defect. \pre `surface` is connected by `connect()`.
Result<Quadrangulation> quadrangulate(const Triangle_surface& surface,
                                      const Quadrangulation_options& options = {},
                                      Observer* observer = nullptr);

/// The extrema that the options ask for, in increasing order, and whether each boundary loop is a maximum;
/// `values` is left empty.
Result<Designed_field> choose_extrema(const Triangle_surface& surface,
                                      const Quadrangulation_options& options = {},
                                      Observer* observer = nullptr);

/// Fills in `field.values`: harmonic, with `extremal_values`, else 0 at minima and 1 at maxima. Fails with
/// `solver_failure`.
Result<void> solve_field(const Triangle_surface& surface, const Quadrangulation_options& options,
                         Designed_field& field);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUADRANGULATE_H
