// SPDX-License-Identifier: GPL-3.0-or-later
// The dense arithmetic of the multifrontal factorization, on fronts as solver_symbolic.h lays them out.
#ifndef REEBQUAD_LINEAR_KERNELS_H
#define REEBQUAD_LINEAR_KERNELS_H

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Large fronts are worked on in slices of this many columns.
constexpr int panel_slice = 64;

/// Numbers of scratch memory that the kernels need for a front.
inline int scratch_size(int leading_dimension) {
  return (leading_dimension + 8) * (panel_slice + 4);
}

/// One set of kernels for each vector unit. All give the same bits: every entry undergoes the same operations
/// in the same order, vectors run across independent entries, and nothing is fused.
struct Dense_kernels {
  /// Factorizes the panel's columns in place, reciprocals of the pivots on the diagonal. Returns the first
  /// column whose pivot is not greater than its threshold, or -1. `scratch`: see scratch_size().
  int (*factorize)(double* panel, int columns, int leading_dimension, const double* threshold,
                   double* scratch);

  /// update -= L L' for the rows below the diagonal block, blocks of four columns `from` to `to` - 1. Where
  /// `is_zero`, the update matrix counts as zero and is not read.
  void (*update)(const double* panel, int columns, int padded_rows, double* update, int from, int to,
                 bool is_zero, double* scratch);

  /// The panel's step of solving with L: `x` holds `leading_dimension` numbers for each of `sides` right-hand
  /// sides, first those of the columns, which become the solution, then those of the rows below, which are
  /// updated.
  void (*forward)(const double* panel, int columns, int leading_dimension, double* x, int sides);

  /// The same for L': the columns' numbers become the solution, given that of the rows below.
  void (*backward)(const double* panel, int columns, int leading_dimension, double* x, int sides);
};

/// Those for this machine's vector unit.
const Dense_kernels& dense_kernels();

/// Those that every machine has, for comparison.
const Dense_kernels& portable_dense_kernels();

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_LINEAR_KERNELS_H
