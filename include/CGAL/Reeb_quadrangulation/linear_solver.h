// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_LINEAR_SOLVER_H
#define CGAL_REEB_QUADRANGULATION_LINEAR_SOLVER_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The lower triangle, diagonal included, of a sparse symmetric matrix in compressed columns; row indices of a
/// column increase, so the diagonal comes first.
struct Symmetric_matrix {
  int size = 0;
  std::vector<int> column_begin; ///< size + 1 entries
  std::vector<int> row;
  std::vector<double> value;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_LINEAR_SOLVER_H
