// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_LAPLACIAN_H
#define CGAL_REEB_QUADRANGULATION_LAPLACIAN_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Symmetric edge weights of a surface: `of_halfedge[h]` is the weight of the whole edge of `h`, so both
/// halfedges of an edge hold the same number. Weights have no unit and do not depend on the surface's scale.
struct Edge_weights {
  std::vector<double> of_halfedge;
};

/// Half the sum of the cotangents of the one or two angles opposite each edge: the linear finite elements'
/// weights (Pinkall and Polthier 1993). They are negative where the angles sum to more than pi. An angle
/// whose triangle is thinner than 1e-8 of its edges counts as one of that thinness, so that weights are
/// finite. O(F).
Edge_weights cotangent_weights(const Triangle_surface& surface);

/// Cotangent weights moved into [low, high]. Positive weights give the discrete maximum principle: a harmonic
/// function has no extremum outside the constraints. O(F). \pre 0 < low <= high
Edge_weights clamped_cotangent_weights(const Triangle_surface& surface, double low = 1e-2, double high = 1e2);

/// All weights one. O(F).
Edge_weights uniform_weights(const Triangle_surface& surface);

/// The Laplacian of a surface with some vertices eliminated, and where its unknowns and edges went.
struct Laplace_system {
  Symmetric_matrix matrix;            ///< positive definite if every component has an eliminated vertex
  std::vector<int> unknown_of_vertex; ///< -1 for the eliminated vertices
  std::vector<int> vertex_of_unknown; ///< in increasing order
  std::vector<int> entry_of_halfedge; ///< index in `matrix.value`; -1 if an end of the edge is eliminated
};

/// Assembles sum_j w_ij (x_i - x_j) over the vertices with `is_fixed[v] == 0`. Entries are bucketed by
/// vertex, never sorted: O(V + F). \pre `is_fixed` has V entries.
Laplace_system assemble(const Triangle_surface& surface, const Edge_weights& weights,
                        const std::vector<char>& is_fixed);

/// The same without eliminating any vertex: singular, but the pattern that all its eliminations share.
Laplace_system assemble(const Triangle_surface& surface, const Edge_weights& weights);

/// What the eliminated vertices' `values` (V entries; only those of eliminated vertices are read) contribute
/// to the right-hand side: b_i = sum over fixed neighbours j of w_ij value_j. O(F).
std::vector<double> right_hand_side(const Triangle_surface& surface, const Edge_weights& weights,
                                    const Laplace_system& system, const std::vector<double>& values);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_LAPLACIAN_H
