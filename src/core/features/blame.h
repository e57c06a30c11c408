// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_FEATURES_BLAME_H
#define REEBQUAD_FEATURES_BLAME_H

#include <CGAL/Reeb_quadrangulation/Vertex_constraints.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// For each vertex near vertices on curves, the chain that it was moved for: that of the nearest of these,
/// counted in quads; -1 elsewhere. `chain_of_curve` tells the chains of the curves; vertices held at an end
/// of a curve count as on it.
std::vector<int> chains_around(const Quad_mesh& mesh, const Vertex_constraints& onto,
                               const std::vector<int>& chain_of_curve);

/// The chains around those quads, ascending.
std::vector<int> chains_at(const Quad_mesh& mesh, const std::vector<int>& quads,
                           const std::vector<int>& chain_of_vertex);

/// The fewest chains around which the scaled Jacobians have fallen by `sum` in all, chosen by what each
/// costs; ascending.
std::vector<int> costliest_chains(const Quad_mesh& before, const Quad_mesh& after,
                                  const std::vector<int>& chain_of_vertex, double sum);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_FEATURES_BLAME_H
