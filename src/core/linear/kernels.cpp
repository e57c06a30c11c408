// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/kernels.h"

#include "linear/symbolic.h"

#include <cmath>
#include <type_traits>

// Each kernel is written once, over vectors of four numbers, and compiled once for each vector unit by being
// inlined into a function of that target; the compiler splits the vectors where the unit's are shorter.
#define REEBQUAD_ALWAYS_INLINE inline __attribute__((always_inline))

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// Unaligned, and allowed to alias the numbers it is loaded from.
typedef double Vector __attribute__((vector_size(32), aligned(8), may_alias));
constexpr int width = 4;
constexpr int group = 8;            // rows of a packed group
constexpr int smallest_packed = 48; // rows from which packing pays

struct Target {
  double* place;
  long stride;
};

REEBQUAD_ALWAYS_INLINE const Vector& vector_at(const double* p) {
  return *reinterpret_cast<const Vector*>(p);
}
REEBQUAD_ALWAYS_INLINE Vector& vector_at(double* p) {
  return *reinterpret_cast<Vector*>(p);
}

// The odd columns come first, so that every later block has rows in packs of four.
REEBQUAD_ALWAYS_INLINE int first_block(int columns) {
  return columns % width == 0 ? width : columns % width;
}

// target (Vectors * 4 rows, 4 columns) -= rows * pivots', over `depth` columns of the panel.
template <int Vectors>
REEBQUAD_ALWAYS_INLINE void update_tile(double* target, long target_stride, const double* rows,
                                        const double* pivots, long stride, int depth, bool is_zero) {
  Vector sum[4][Vectors];
  for (int q = 0; q < 4; ++q)
    for (int v = 0; v < Vectors; ++v) {
      if (is_zero)
        sum[q][v] = Vector{0, 0, 0, 0};
      else
        sum[q][v] = vector_at(target + q * target_stride + v * width);
    }
  for (int k = 0; k < depth; ++k) {
    Vector l[Vectors];
    for (int v = 0; v < Vectors; ++v) l[v] = vector_at(rows + v * width);
    for (int q = 0; q < 4; ++q) {
      const double p = pivots[q];
      for (int v = 0; v < Vectors; ++v) sum[q][v] -= l[v] * p;
    }
    rows += stride;
    pivots += stride;
  }
  for (int q = 0; q < 4; ++q)
    for (int v = 0; v < Vectors; ++v) vector_at(target + q * target_stride + v * width) = sum[q][v];
}

// A block of four columns and `count` rows (a multiple of four).
template <int Vectors>
REEBQUAD_ALWAYS_INLINE void update_block(double* target, long target_stride, const double* rows,
                                         const double* pivots, long stride, int depth, int count,
                                         bool is_zero) {
  int i = 0;
  for (; i + Vectors * width <= count; i += Vectors * width)
    update_tile<Vectors>(target + i, target_stride, rows + i, pivots, stride, depth, is_zero);
  for (; Vectors > 1 && i < count; i += width)
    update_tile<1>(target + i, target_stride, rows + i, pivots, stride, depth, is_zero);
}

// Copies `count` rows (a multiple of four) of `depth` columns so that groups of eight rows lie together,
// column after column: then the products of large fronts run through memory in order.
REEBQUAD_ALWAYS_INLINE void pack_rows(const double* rows, long stride, int depth, int count, double* packed) {
  for (int i = 0; i < count; i += group) {
    const bool whole = i + group <= count;
    for (int k = 0; k < depth; ++k, packed += group) {
      vector_at(packed) = vector_at(rows + k * stride + i);
      if (whole) vector_at(packed + width) = vector_at(rows + k * stride + i + width);
    }
  }
}

REEBQUAD_ALWAYS_INLINE const double* packed_row(const double* packed, int depth, int row) {
  return packed + long(row / group) * group * depth + row % group;
}

// The same as update_block for the rows from `first` to `count` of packed rows.
template <int Vectors>
REEBQUAD_ALWAYS_INLINE void update_packed_block(double* target, long target_stride, const double* packed,
                                                int depth, int first, int count, bool is_zero) {
  const double* pivots = packed_row(packed, depth, first);
  int i = first;
  if (Vectors > 1 && i % group != 0) {
    update_tile<1>(target, target_stride, pivots, pivots, group, depth, is_zero);
    i += width;
  }
  for (; i + Vectors * width <= count; i += Vectors * width)
    update_tile<Vectors>(target + i - first, target_stride, packed_row(packed, depth, i), pivots, group,
                         depth, is_zero);
  for (; Vectors > 1 && i < count; i += width)
    update_tile<1>(target + i - first, target_stride, packed_row(packed, depth, i), pivots, group, depth,
                   is_zero);
}

// A triangle of blocks -= rows * rows': `target_of(b)` gives the place and the stride of block b, whose rows
// begin at 4 b. Deep products go in slices, which leaves the order of the operations on an entry as it is.
template <int Vectors, class Target_of>
REEBQUAD_ALWAYS_INLINE void update_triangle(const double* rows, long stride, int depth, int count, int from,
                                            int to, bool is_zero, double* scratch, Target_of target_of) {
  if (count - width * from < smallest_packed || depth < width) {
    for (int b = from; b < to; ++b) {
      const Target target = target_of(b);
      const double* first = rows + width * b;
      update_block<Vectors>(target.place, target.stride, first, first, stride, depth, count - width * b,
                            is_zero);
    }
    return;
  }
  for (int k = 0; k < depth; k += panel_slice) {
    const int columns = depth - k < panel_slice ? depth - k : panel_slice;
    const int skipped = width * from;
    pack_rows(rows + k * stride + skipped, stride, columns, count - skipped, scratch);
    for (int b = from; b < to; ++b) {
      const Target target = target_of(b);
      update_packed_block<Vectors>(target.place, target.stride, scratch, columns, width * b - skipped,
                                   count - skipped, is_zero && k == 0);
    }
  }
}

// Factorizes the `Block` columns at `corner`, already updated by the columns before, and the `below` rows.
template <int Block>
REEBQUAD_ALWAYS_INLINE int factorize_block(double* corner, long stride, int below, const double* threshold) {
  for (int q = 0; q < Block; ++q) {
    double* column = corner + q * stride;
    for (int i = q; i < Block; ++i)
      for (int t = 0; t < q; ++t) column[i] -= corner[t * stride + i] * corner[t * stride + q];
    if (!(column[q] > threshold[q]) || !std::isfinite(column[q])) return q;
    const double reciprocal = 1 / std::sqrt(column[q]);
    column[q] = reciprocal;
    for (int i = q + 1; i < Block; ++i) column[i] *= reciprocal;
  }
  for (int i = Block; i < Block + below; i += width) {
    Vector l[Block];
    for (int q = 0; q < Block; ++q) {
      l[q] = vector_at(corner + q * stride + i);
      for (int t = 0; t < q; ++t) l[q] -= l[t] * corner[t * stride + q];
      l[q] *= corner[q * stride + q];
      vector_at(corner + q * stride + i) = l[q];
    }
  }
  return -1;
}

REEBQUAD_ALWAYS_INLINE int factorize_block(double* corner, long stride, int block, int below,
                                           const double* threshold) {
  switch (block) {
  case 1: return factorize_block<1>(corner, stride, below, threshold);
  case 2: return factorize_block<2>(corner, stride, below, threshold);
  case 3: return factorize_block<3>(corner, stride, below, threshold);
  default: return factorize_block<4>(corner, stride, below, threshold);
  }
}

// Blocks look left for their updates inside a slice of the panel; whole slices update what follows them.
template <int Vectors>
REEBQUAD_ALWAYS_INLINE int factorize_panel(double* panel, int columns, int leading_dimension,
                                           const double* threshold, double* scratch) {
  const long stride = leading_dimension;
  for (int begin = 0, block = first_block(columns); begin < columns;) {
    const int end = columns - begin <= panel_slice + width ? columns : begin + block + panel_slice - width;
    for (int j = begin; j < end; j += block, block = width) {
      double* corner = panel + j * stride + j;
      const double* rows = panel + begin * stride + j;
      if (j > begin) // before that, the rows need not come in packs
        update_block<Vectors>(corner, stride, rows, rows, stride, j - begin, leading_dimension - j, false);
      const int failed = factorize_block(corner, stride, block, leading_dimension - j - block, threshold + j);
      if (failed >= 0) return j + failed;
    }
    if (end == columns) break;
    const auto target_of = [&](int b) __attribute__((always_inline)) {
      return Target{panel + (end + width * b) * (stride + 1), stride};
    };
    update_triangle<Vectors>(panel + begin * stride + end, stride, end - begin, leading_dimension - end, 0,
                             (columns - end) / width, false, scratch, target_of);
    begin = end;
  }
  return -1;
}

template <int Vectors>
REEBQUAD_ALWAYS_INLINE void update_rows(const double* panel, int columns, int padded_rows, double* update,
                                        int from, int to, bool is_zero, double* scratch) {
  const auto target_of = [&](int b) __attribute__((always_inline)) {
    // The blocks before hold 4 (padded_rows + (padded_rows - 4) + ...) numbers.
    return Target{update + long(width) * b * padded_rows - long(width) * width * b * (b - 1) / 2,
                  padded_rows - width * b};
  };
  update_triangle<Vectors>(panel + columns, columns + padded_rows, columns, padded_rows, from, to, is_zero,
                           scratch, target_of);
}

template <int Sides>
REEBQUAD_ALWAYS_INLINE void forward_block(const double* corner, long stride, int block, int below,
                                          double* x) {
  double y[Sides][width];
  for (int s = 0; s < Sides; ++s)
    for (int q = 0; q < block; ++q) {
      double sum = x[s * stride + q];
      for (int t = 0; t < q; ++t) sum -= corner[t * stride + q] * y[s][t];
      x[s * stride + q] = y[s][q] = sum * corner[q * stride + q];
    }
  const auto subtract = [&](auto columns) __attribute__((always_inline)) {
    constexpr int count = decltype(columns)::value;
    for (int i = block; i < block + below; i += width) {
      Vector l[count];
      for (int q = 0; q < count; ++q) l[q] = vector_at(corner + q * stride + i);
      for (int s = 0; s < Sides; ++s) {
        Vector sum = vector_at(x + s * stride + i);
        for (int q = 0; q < count; ++q) sum -= l[q] * y[s][q];
        vector_at(x + s * stride + i) = sum;
      }
    }
  };
  switch (block) {
  case 1: subtract(std::integral_constant<int, 1>()); break;
  case 2: subtract(std::integral_constant<int, 2>()); break;
  case 3: subtract(std::integral_constant<int, 3>()); break;
  default: subtract(std::integral_constant<int, 4>()); break;
  }
}

// Every product with the rows below is summed in four parts, whatever the vector unit.
template <int Sides>
REEBQUAD_ALWAYS_INLINE void backward_block(const double* corner, long stride, int block, int below,
                                           double* x) {
  Vector part[Sides][width];
  for (int s = 0; s < Sides; ++s)
    for (int q = 0; q < width; ++q) part[s][q] = Vector{0, 0, 0, 0};
  const auto add = [&](auto columns) __attribute__((always_inline)) {
    constexpr int count = decltype(columns)::value;
    for (int i = block; i < block + below; i += width)
      for (int s = 0; s < Sides; ++s) {
        const Vector known = vector_at(x + s * stride + i);
        for (int q = 0; q < count; ++q) part[s][q] += vector_at(corner + q * stride + i) * known;
      }
  };
  switch (block) {
  case 1: add(std::integral_constant<int, 1>()); break;
  case 2: add(std::integral_constant<int, 2>()); break;
  case 3: add(std::integral_constant<int, 3>()); break;
  default: add(std::integral_constant<int, 4>()); break;
  }
  for (int s = 0; s < Sides; ++s)
    for (int q = block - 1; q >= 0; --q) {
      const Vector& p = part[s][q];
      double sum = x[s * stride + q] - ((p[0] + p[1]) + (p[2] + p[3]));
      for (int i = q + 1; i < block; ++i) sum -= corner[q * stride + i] * x[s * stride + i];
      x[s * stride + q] = sum * corner[q * stride + q];
    }
}

REEBQUAD_ALWAYS_INLINE void forward_panel(const double* panel, int columns, int leading_dimension, double* x,
                                          int sides) {
  const long stride = leading_dimension;
  for (int j = 0, block = first_block(columns); j < columns; j += block, block = width) {
    const double* corner = panel + j * stride + j;
    const int below = leading_dimension - j - block;
    int s = 0;
    for (; s + 2 <= sides; s += 2) forward_block<2>(corner, stride, block, below, x + s * stride + j);
    if (s < sides) forward_block<1>(corner, stride, block, below, x + s * stride + j);
  }
}

REEBQUAD_ALWAYS_INLINE void backward_panel(const double* panel, int columns, int leading_dimension, double* x,
                                           int sides) {
  const long stride = leading_dimension;
  const int first = first_block(columns);
  for (int end = columns; end > 0;) {
    const int block = end > first ? width : first;
    const int j = end - block;
    const double* corner = panel + j * stride + j;
    const int below = leading_dimension - end;
    int s = 0;
    for (; s + 2 <= sides; s += 2) backward_block<2>(corner, stride, block, below, x + s * stride + j);
    if (s < sides) backward_block<1>(corner, stride, block, below, x + s * stride + j);
    end = j;
  }
}

// The number of vectors in a tile leaves the unit's registers room for four columns of it.
int factorize_portable(double* panel, int columns, int leading_dimension, const double* threshold,
                       double* scratch) {
  return factorize_panel<1>(panel, columns, leading_dimension, threshold, scratch);
}
void update_portable(const double* panel, int columns, int padded_rows, double* update, int from, int to,
                     bool is_zero, double* scratch) {
  update_rows<1>(panel, columns, padded_rows, update, from, to, is_zero, scratch);
}
void forward_portable(const double* panel, int columns, int leading_dimension, double* x, int sides) {
  forward_panel(panel, columns, leading_dimension, x, sides);
}
void backward_portable(const double* panel, int columns, int leading_dimension, double* x, int sides) {
  backward_panel(panel, columns, leading_dimension, x, sides);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) int factorize_avx2(double* panel, int columns, int leading_dimension,
                                                   const double* threshold, double* scratch) {
  return factorize_panel<2>(panel, columns, leading_dimension, threshold, scratch);
}
__attribute__((target("avx2"))) void update_avx2(const double* panel, int columns, int padded_rows,
                                                 double* update, int from, int to, bool is_zero,
                                                 double* scratch) {
  update_rows<2>(panel, columns, padded_rows, update, from, to, is_zero, scratch);
}
__attribute__((target("avx2"))) void forward_avx2(const double* panel, int columns, int leading_dimension,
                                                  double* x, int sides) {
  forward_panel(panel, columns, leading_dimension, x, sides);
}
__attribute__((target("avx2"))) void backward_avx2(const double* panel, int columns, int leading_dimension,
                                                   double* x, int sides) {
  backward_panel(panel, columns, leading_dimension, x, sides);
}

#endif

} // namespace

const Dense_kernels& portable_dense_kernels() {
  static const Dense_kernels kernels{factorize_portable, update_portable, forward_portable,
                                     backward_portable};
  return kernels;
}

const Dense_kernels& dense_kernels() {
#if defined(__x86_64__)
  static const Dense_kernels avx2{factorize_avx2, update_avx2, forward_avx2, backward_avx2};
  if (__builtin_cpu_supports("avx2")) return avx2;
#endif
  return portable_dense_kernels();
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
