// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

#include <Eigen/SparseCholesky>

namespace CGAL {
namespace Reeb_quadrangulation {

struct Multifrontal_solver::Implementation {
  using Matrix = Eigen::SparseMatrix<double>;
  Symmetric_matrix pattern;
  Eigen::SimplicialLLT<Matrix> cholesky;
  bool factorized = false;
};

Multifrontal_solver::Multifrontal_solver() : m_implementation(std::make_unique<Implementation>()) {}
Multifrontal_solver::~Multifrontal_solver() = default;
Multifrontal_solver::Multifrontal_solver(Multifrontal_solver&&) noexcept = default;
Multifrontal_solver& Multifrontal_solver::operator=(Multifrontal_solver&&) noexcept = default;

namespace {
Eigen::Map<const Eigen::SparseMatrix<double>> map(const Symmetric_matrix& m) {
  return {m.size, m.size, Eigen::Index(m.row.size()), m.column_begin.data(), m.row.data(), m.value.data()};
}
} // namespace

Result<void> Multifrontal_solver::analyze(const Symmetric_matrix& pattern) {
  const Result<void> checked = check_pattern(pattern);
  if (!checked) return checked;
  m_implementation->pattern = pattern;
  m_implementation->factorized = false;
  m_implementation->cholesky.analyzePattern(map(pattern));
  return {};
}

Result<void> Multifrontal_solver::factorize(const Symmetric_matrix& matrix) {
  if (!same_pattern(matrix, m_implementation->pattern)) {
    const Result<void> analyzed = analyze(matrix);
    if (!analyzed) return analyzed;
  }
  m_implementation->cholesky.factorize(map(matrix));
  m_implementation->factorized = m_implementation->cholesky.info() == Eigen::Success;
  if (!m_implementation->factorized)
    return make_error(Error_code::solver_failure, "The matrix is not positive definite.");
  return {};
}

Result<void> Multifrontal_solver::solve(double* x, int right_hand_sides) const {
  if (!m_implementation->factorized)
    return make_error(Error_code::solver_failure, "Solve was called before a successful factorization.");
  if (size() == 0) return {};
  Eigen::Map<Eigen::MatrixXd> columns(x, size(), right_hand_sides);
  columns = m_implementation->cholesky.solve(columns).eval();
  return {};
}

int Multifrontal_solver::size() const {
  return m_implementation->pattern.size;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
