// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SUGGEST_EXTREMA_H
#define CGAL_REEB_QUADRANGULATION_SUGGEST_EXTREMA_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How extrema are suggested.
struct Suggestion_options {
  /// A protrusion counts if it rises above the pass that joins it to a higher one by at least this fraction
  /// of the range of the integral geodesic function; in (0, 1]. A smaller value only ever adds extrema.
  double persistence = 0.08;
  /// The height axis: what lies below the middle of the surface's extent along it becomes a minimum, the rest
  /// maxima.
  Eigen::Vector3d axis = Eigen::Vector3d(0, 0, 1);
  /// The radius within which there is at most one extremum and none near a boundary loop, and with which
  /// sources cover the surface, is `sqrt(relative_area * A)`, `A` the area of the surface; in (0, 1].
  double relative_area = 0.005;
  /// The size (in faces) of the copy on which geodesic distances are measured; at least 200.
  int working_faces = 5000;
};

/// One suggested extremum.
struct Suggested_extremum {
  int vertex = -1;
  bool is_maximum = false;
  /// Persistence of the protrusion as a fraction of the range; 1 for the highest one, 0 for the point that is
  /// added as far away as possible when there is only one.
  double prominence = 0;
};

/// The constraints of the initial field.
struct Suggestion {
  std::vector<Suggested_extremum> extrema; ///< by decreasing prominence
  std::vector<bool> boundary_is_maximum;   ///< for each of `boundary_loops(surface)`: its constant, 1 or 0
  std::vector<double> spectrum; ///< the prominences of all protrusions, decreasing: see where the gap is
};

/// Suggests where the field should have its extrema: at the ends of prominent features.
///
/// Features are the maxima of the integral geodesic function (Hilaga, Shinagawa, Kohmura and Kunii 2001): the
/// area-weighted sum of the distances to sources that cover the surface. Maxima are kept by persistence (the
/// pairs of components of its superlevel sets), then thinned by distance, and split into minima and maxima by
/// height. Every boundary loop becomes one constant by its mean height. There is always at least one minimum
/// and one maximum (loops count): if the heights put all on one side they are split at their median, and if
/// there is only one feature the point farthest from it is added.
///
/// Extrema are interior vertices, never adjacent to one another or to the boundary if the mesh has room for
/// that. Errors: `impossible_request` (an option out of range), `not_a_surface` (empty, more than one
/// component, no area, no interior vertex left), `cancelled`. O(V) plus about 130 searches in a graph of
/// `working_faces / 2` nodes. \pre `surface` is connected by `connect()`.
Result<Suggestion> suggest_extrema(const Triangle_surface& surface, const Suggestion_options& options = {},
                                   Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SUGGEST_EXTREMA_H
