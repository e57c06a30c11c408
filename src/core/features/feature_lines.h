// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_FEATURES_FEATURE_LINES_H
#define REEBQUAD_FEATURES_FEATURE_LINES_H

#include <CGAL/Reeb_quadrangulation/Guide.h>
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/snap_to_features.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A vertex near a curve, nearest at an arc length.
struct Feature_seed {
  int vertex, curve;
  double t;
};

/// What else there is to say about lines.
struct Line_way {
  bool first = false; ///< they are laid also before vertices move onto corners
  std::optional<double> worst =
      {}; ///< `Snap_options::worst_jacobian` of the quads around a line, if it differs
};

/// Which edges begin lines, and how these are drawn.
struct Line_choice {
  double least_cosine = 0.8; ///< of an edge with the curve
  /// With `level` or `flow`, only edges that go across or along `flow` begin lines.
  Guide_way way = Guide_way::nearer;
  std::vector<Point> flow = {}; ///< directions at equal distances along every curve, or none
  /// Where the vertices were when the family of an edge was its own; null: where they are.
  const std::vector<Point>* unbent = nullptr;
  bool joins = false; ///< a line may begin at a vertex where another ends
  /// The last vertex of a line goes to the end of a curve that is nearer than so many edges.
  double end_reach = 0.5;
  double step = 0; ///< lines come onto their curves by steps of so many edges; 0: in one
};

/// Moves lines of edges onto the curves that they run along, and the vertices around them by less and less. A
/// line takes a part of a curve along which it stays nearer than `options.line_reach` edges and goes straight
/// through the quads, and has a vertex among `seeds`; the best ones are taken first. A line is taken only if
/// no quad becomes worse than `worst`, or than it was; else without its vertices at such quads. Vertices that
/// are `held` stay; those of lines become so, and their places are added. Returns the number of these.
int lay_lines_on_features(Quad_mesh& mesh, const Surface_projector& projector,
                          const std::vector<Surface_curve>& curves, const std::vector<Feature_seed>& seeds,
                          const Snap_options& options, double worst, std::vector<char>& held,
                          std::vector<Vertex_constraints::Place>& places, const Line_choice& choice = {});

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_FEATURES_FEATURE_LINES_H
