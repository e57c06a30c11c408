// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

Error malformed(int column, const char* what) {
  return make_error(Error_code::solver_failure,
                    "The matrix is malformed at column " + std::to_string(column) + ": " + what + ".",
                    Element_kind::none, column);
}

} // namespace

Result<void> check_pattern(const Symmetric_matrix& m) {
  if (m.size < 0 || int(m.column_begin.size()) != m.size + 1 || m.column_begin.front() != 0 ||
      m.column_begin.back() < 0 || std::size_t(m.column_begin.back()) != m.row.size() ||
      m.value.size() != m.row.size())
    return make_error(Error_code::solver_failure, "The arrays of the matrix disagree about its size.");
  for (int j = 0; j < m.size; ++j) {
    const int begin = m.column_begin[j], end = m.column_begin[j + 1];
    if (end <= begin || std::size_t(end) > m.row.size() || m.row[begin] != j)
      return malformed(j, "it does not begin with the diagonal");
    for (int k = begin + 1; k < end; ++k)
      if (m.row[k] <= m.row[k - 1] || m.row[k] >= m.size) return malformed(j, "its rows do not increase");
  }
  return {};
}

bool same_pattern(const Symmetric_matrix& a, const Symmetric_matrix& b) {
  return a.size == b.size && a.column_begin == b.column_begin && a.row == b.row;
}

void multiply(const Symmetric_matrix& m, const double* x, double* y) {
  std::fill(y, y + m.size, 0.0);
  for (int j = 0; j < m.size; ++j) {
    double sum = m.value[m.column_begin[j]] * x[j];
    for (int k = m.column_begin[j] + 1; k < m.column_begin[j + 1]; ++k) {
      sum += m.value[k] * x[m.row[k]];
      y[m.row[k]] += m.value[k] * x[j];
    }
    y[j] += sum;
  }
}

double relative_residual(const Symmetric_matrix& m, const double* x, const double* b,
                         const std::vector<double>& row_scale) {
  std::vector<double> product(m.size), row_sum(m.size, 0.0);
  multiply(m, x, product.data());
  for (int j = 0; j < m.size; ++j)
    for (int k = m.column_begin[j]; k < m.column_begin[j + 1]; ++k) {
      row_sum[j] += std::abs(m.value[k]);
      if (m.row[k] != j) row_sum[m.row[k]] += std::abs(m.value[k]);
    }
  double residual = 0, norm_a = 0, norm_x = 0, norm_b = 0;
  for (int i = 0; i < m.size; ++i) {
    const double scale = row_scale.empty() ? 1 : row_scale[i], r = scale * std::abs(b[i] - product[i]);
    // A comparison with a not-a-number is false, so it would slip through a maximum.
    if (!std::isfinite(r)) return std::numeric_limits<double>::infinity();
    residual = std::max(residual, r);
    norm_a = std::max(norm_a, scale * row_sum[i]);
    norm_x = std::max(norm_x, std::abs(x[i]));
    norm_b = std::max(norm_b, scale * std::abs(b[i]));
  }
  return residual == 0 ? 0 : residual / (norm_a * norm_x + norm_b);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
