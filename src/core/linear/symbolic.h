// SPDX-License-Identifier: GPL-3.0-or-later
// The symbolic half of the multifrontal factorization: everything that depends on the matrix's pattern only.
#ifndef REEBQUAD_LINEAR_SYMBOLIC_H
#define REEBQUAD_LINEAR_SYMBOLIC_H

#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Fronts are dense and their rows come in packs of four, so that kernels have no remainders.
constexpr int pack = 4;
inline int padded(int count) {
  return (count + pack - 1) / pack * pack;
}

/// A dense front: `columns` unknowns eliminated together, and the `rows` later unknowns that they touch.
///
/// Its factor is a column-major panel of `leading_dimension()` rows: first the eliminated unknowns, then the
/// touched ones, then zeros. Its update matrix is the lower triangle over the touched rows, in blocks of four
/// columns: block b holds the rows from 4 b on.
struct Front {
  int first = 0; ///< of the eliminated unknowns, which are consecutive in elimination order
  int columns = 0;
  int rows = 0;
  int parent = -1;
  std::size_t rows_begin = 0;  ///< in `Assembly_tree::row` and `row_in_parent`
  std::size_t panel_begin = 0; ///< in the factor

  int leading_dimension() const { return columns + padded(rows); }
  std::size_t panel_size() const { return std::size_t(leading_dimension()) * columns; }
  std::size_t update_size() const {
    const std::size_t blocks = padded(rows) / pack;
    return pack * pack * (blocks * (blocks + 1) / 2);
  }
};

/// The fronts of a matrix, children before parents, and where each entry of the matrix goes.
struct Assembly_tree {
  std::vector<int> original;    ///< in elimination order: the row of the matrix
  std::vector<int> front_of;    ///< in elimination order
  std::vector<Front> fronts;    ///< in postorder
  std::vector<int> child_begin; ///< for each front, in `child`
  std::vector<int> child;
  std::vector<int> row;           ///< touched rows of the fronts, increasing, in elimination order
  std::vector<int> row_in_parent; ///< their places in the parent's front
  std::vector<int> entry_begin;   ///< for each front, in the next two
  std::vector<int> entry;         ///< index in `Symmetric_matrix::value`
  std::vector<int> entry_target;  ///< offset in the front's panel
  std::size_t factor_size = 0;
  double operations = 0; ///< multiplications and additions of a factorization
};

/// Orders the unknowns (solver_ordering.h), finds the elimination tree (Liu 1990)
/// and the column counts (Gilbert, Ng and Peyton 1994) in nearly linear time, and merges columns into fronts
/// where that is estimated to save time. \pre The pattern is checked.
Result<Assembly_tree> analyze_pattern(const Symmetric_matrix& pattern,
                                      Multifrontal_solver::Ordering ordering);

/// The same with the unknowns in an order that is given. Siblings may change places: the fill does not.
Assembly_tree analyze_pattern(const Symmetric_matrix& pattern, const std::vector<int>& order);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_LINEAR_SYMBOLIC_H
