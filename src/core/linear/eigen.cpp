// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>

#include "linear/smallest_pivot.h"

#include <CGAL/assertions.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::smallest_pivot_ratio;

Eigen::Map<const Eigen::SparseMatrix<double>> lower_triangle(const Symmetric_matrix& m) {
  return {m.size, m.size, Eigen::Index(m.row.size()), m.column_begin.data(), m.row.data(), m.value.data()};
}

} // namespace

struct Eigen_solver::Implementation {
  Symmetric_matrix pattern;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor;
  bool is_analyzed = false, is_factorized = false;
};

Eigen_solver::Eigen_solver() : m_implementation(std::make_unique<Implementation>()) {}
Eigen_solver::~Eigen_solver() = default;
Eigen_solver::Eigen_solver(Eigen_solver&&) noexcept = default;
Eigen_solver& Eigen_solver::operator=(Eigen_solver&&) noexcept = default;

int Eigen_solver::size() const {
  return m_implementation->pattern.size;
}

Result<void> Eigen_solver::analyze(const Symmetric_matrix& pattern) {
  Implementation& impl = *m_implementation;
  impl.is_analyzed = impl.is_factorized = false;
  const Result<void> checked = check_pattern(pattern);
  if (!checked) return checked;
  impl.pattern = pattern;
  if (pattern.size > 0) impl.factor.analyzePattern(lower_triangle(pattern));
  impl.is_analyzed = true;
  return {};
}

Result<void> Eigen_solver::factorize(const Symmetric_matrix& matrix) {
  Implementation& impl = *m_implementation;
  if (!impl.is_analyzed || !same_pattern(matrix, impl.pattern)) {
    const Result<void> analyzed = analyze(matrix);
    if (!analyzed) return analyzed;
  }
  impl.is_factorized = matrix.size == 0;
  if (impl.is_factorized) return {};
  impl.factor.factorize(lower_triangle(matrix));
  const bool succeeded = impl.factor.info() == Eigen::Success;
  const Eigen::VectorXd pivots = succeeded ? Eigen::VectorXd(impl.factor.vectorD()) : Eigen::VectorXd();
  const auto& place = impl.factor.permutationP().indices();
  for (int i = 0; i < matrix.size; ++i) {
    const double pivot = succeeded ? pivots[place.size() == 0 ? i : place[i]] : 0;
    if (std::isfinite(pivot) && pivot > smallest_pivot_ratio * matrix.value[matrix.column_begin[i]]) continue;
    return make_error(Error_code::solver_failure,
                      "The matrix is not positive definite: elimination fails at row " + std::to_string(i) +
                          ".",
                      Element_kind::none, i);
  }
  impl.is_factorized = true;
  return {};
}

Result<void> Eigen_solver::solve(double* x, int right_hand_sides) const {
  if (!m_implementation->is_factorized)
    return make_error(Error_code::solver_failure, "Solve was called before a successful factorization.");
  CGAL_precondition(right_hand_sides >= 0);
  if (size() == 0) return {};
  for (int q = 0; q < right_hand_sides; ++q) {
    Eigen::Map<Eigen::VectorXd> column(x + std::size_t(q) * size(), size());
    column = m_implementation->factor.solve(Eigen::VectorXd(column));
  }
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
