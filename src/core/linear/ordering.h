// SPDX-License-Identifier: GPL-3.0-or-later
// Orderings of the unknowns that keep the factor sparse.
#ifndef REEBQUAD_LINEAR_ORDERING_H
#define REEBQUAD_LINEAR_ORDERING_H

#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Rows of the matrix in elimination order by approximate minimum degree (Amestoy, Davis and Duff 1996).
Result<std::vector<int>> minimum_degree_order(const Symmetric_matrix& pattern);

/// Rows of the matrix in elimination order by nested dissection (George 1973), meant for the graphs of
/// surfaces: the graph is coarsened by matchings once, regions are bisected on the coarse graph along the
/// levels of a breadth-first search, cuts are refined (Fiduccia and Mattheyses 1982) on both graphs, and a
/// smallest vertex cover of the cut edges separates. Small regions are ordered by minimum degree. Nearly
/// linear, deterministic.
Result<std::vector<int>> dissection_order(const Symmetric_matrix& pattern);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_LINEAR_ORDERING_H
