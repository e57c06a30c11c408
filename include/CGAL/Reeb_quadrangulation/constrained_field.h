// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CONSTRAINED_FIELD_H
#define CGAL_REEB_QUADRANGULATION_CONSTRAINED_FIELD_H

#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>

#include <map>
#include <vector>

/// \file
/// Contours enforced by the field alone, as in Tierny et al., "Interactive Quadrangulation with Reeb Atlases
/// and Connectivity Textures", section 6.1: the triangles that a contour crosses get values that make the
/// field take the contour's value there.

namespace CGAL {
namespace Reeb_quadrangulation {

/// The values that some contour edges ask of the vertices around them.
///
/// Where a contour of value c runs through a triangle from p to q, and s' is what `values` have at the point
/// of pq nearest to a corner with value s, the corner is asked for c + (s - s'): the slope that the field has
/// there, but through c on pq. A corner gets the mean over the triangles that ask it, and a vertex that
/// contours go through the mean of their values. O(contour vertices), times log. \pre `values` has one entry
/// for each vertex; the edges are contour edges that are not removed.
std::map<int, double> contour_constraints(const Triangle_surface& surface, const std::vector<double>& values,
                                          const Contour_network& network, const std::vector<int>& edges);

/// Solves a field anew on the whole surface, harmonic except at its extrema and boundary loops, which keep
/// their values, and at the `contour_constraints()` of some contour edges. Weights are clamped cotangents, so
/// that extrema that are not the field's own can only lie at constrained vertices; `make_layout()` removes
/// them. Uses `field.elimination_order` if it is there. Fails with `solver_failure`. Costs a factorization of
/// the whole surface.
Result<std::vector<double>> constrained_field(const Triangle_surface& surface, const Designed_field& field,
                                              const Contour_network& network, const std::vector<int>& edges,
                                              const Field_solver_options& options = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CONSTRAINED_FIELD_H
