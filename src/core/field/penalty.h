// SPDX-License-Identifier: GPL-3.0-or-later
// Values given by penalties: what the systems of fields and of charts share.
#ifndef REEBQUAD_FIELD_PENALTY_H
#define REEBQUAD_FIELD_PENALTY_H

#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The paper's alpha, relative to the largest diagonal entry. At a vertex with a penalty the value is missed
/// by the flux that leaves there over the penalty: at most about twice the values' range over this.
constexpr double penalty_factor = 1e8;

/// What to add to the diagonal entries of the given values' rows.
double penalty_of(const Symmetric_matrix& laplacian);

/// `relative_residual()`, where the rows with a penalty count divided by `penalty_factor`. Undivided, their
/// size would hide whatever happens in the others.
double penalized_residual(const Symmetric_matrix& matrix, const std::vector<int>& penalized, const double* x,
                          const double* b);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_FIELD_PENALTY_H
