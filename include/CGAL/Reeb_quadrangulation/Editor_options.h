// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_EDITOR_OPTIONS_H
#define CGAL_REEB_QUADRANGULATION_EDITOR_OPTIONS_H

#include <CGAL/Reeb_quadrangulation/Atlas.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Quad_texture.h>

#include <functional>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What a design does with the boundary loops of its surface.
enum class Boundaries : signed char {
  keep, ///< each loop is a contour
  fill  ///< loops are filled, the design goes across, and the quads of fillings are left out in the end
};

/// Options of the engine that designs are made by: of an editing session, and of an automatic run, which is
/// one. A recipe keeps them, but for functions and for what changes no result.
struct Editor_options {
  /// Of the first design; later `Set_target` edits change it.
  int quads = 3000;
  /// The length of the quads' edges, in units of the surface; used instead of `quads` if positive.
  double edge_length = 0;
  /// If not empty, the lengths that edges shall have at the vertices of the surface that the session is begun
  /// with, linear in triangles, as far as counts, rows and dislocations can give them: `quads` and
  /// `edge_length` are then met in the mean, so that only the ratios of these lengths count.
  std::vector<double> sizes = {};
  /// Work on a refined copy where the surface is coarse or its triangles are needles; see
  /// `prepare_surface()`.
  bool prepare = true;
  /// Samples of contours by arc length (0) to samples by flux (1).
  double sample_blend = 0.5;
  /// Of the field on the whole surface; charts always use positive weights.
  Weight_kind weights = Weight_kind::cotangent;
  /// What solves the systems of fields and of charts' maps. A recipe keeps its name.
  Linear_solver_factory solver = {};
  /// With `fill` the design lives on a closed surface, whose extrema and contours may lie in fillings. The
  /// result's boundary lies on the loops all the same, see `Editor::open_quads()`.
  Boundaries boundaries = Boundaries::keep;
  /// How fields and charts' maps meet the values that are given.
  Constraint_method constraints = Constraint_method::elimination;
  /// The weights of a chart's map; empty: clamped cotangents. Called from several threads at once. A recipe
  /// does not keep them.
  std::function<Edge_weights(const Chart&)> chart_weights = {};
  /// How charts are filled that no edit has given a texture; empty: regular grids. Called from several
  /// threads at once. A recipe does not keep it.
  Texture_maker textures = {};
  /// Whether the first field's factorization is kept, so that the next field on the whole surface is solved
  /// in less time, for twice the memory. Results do not depend on it.
  bool keep_factorization = true;
  /// Charts solved at once; 0 = as many as the machine has. Results do not depend on it.
  int threads = 0;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_EDITOR_OPTIONS_H
