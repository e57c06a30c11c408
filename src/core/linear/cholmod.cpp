// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>

#include <CGAL/assertions.h>

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr double smallest_pivot_ratio = 1e-13; // as in Multifrontal_solver

// The squared diagonal of a supernodal factor L L', in the factor's order.
std::vector<double> pivots(const cholmod_factor& l) {
  const int* super = static_cast<const int*>(l.super);
  const int* rows_begin = static_cast<const int*>(l.pi);
  const int* panel_begin = static_cast<const int*>(l.px);
  const double* x = static_cast<const double*>(l.x);
  std::vector<double> pivot(l.n);
  for (std::size_t s = 0; s < l.nsuper; ++s) {
    const std::size_t rows = std::size_t(rows_begin[s + 1] - rows_begin[s]);
    for (int j = super[s]; j < super[s + 1]; ++j) {
      const std::size_t k = std::size_t(j - super[s]);
      const double diagonal = x[std::size_t(panel_begin[s]) + k * rows + k];
      pivot[j] = diagonal * diagonal;
    }
  }
  return pivot;
}

Error not_definite(int row) {
  return make_error(Error_code::solver_failure,
                    "The matrix is not positive definite: elimination fails at row " + std::to_string(row) +
                        ".",
                    Element_kind::none, row);
}

// CHOLMOD reads these through pointers that are not const; it does not write.
cholmod_sparse view(const Symmetric_matrix& m) {
  cholmod_sparse a{};
  a.nrow = a.ncol = std::size_t(m.size);
  a.nzmax = m.row.size();
  a.p = const_cast<int*>(m.column_begin.data());
  a.i = const_cast<int*>(m.row.data());
  a.x = const_cast<double*>(m.value.data());
  a.stype = -1; // the lower triangle is stored
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  return a;
}

cholmod_dense view(double* x, int rows, int columns) {
  cholmod_dense d{};
  d.nrow = d.d = std::size_t(rows);
  d.ncol = std::size_t(columns);
  d.nzmax = d.nrow * d.ncol;
  d.x = x;
  d.xtype = CHOLMOD_REAL;
  d.dtype = CHOLMOD_DOUBLE;
  return d;
}

// A sparse column with rows in increasing order, as the update routines take it.
struct Column {
  std::vector<int> begin, row;
  std::vector<double> value;

  cholmod_sparse view(int size) {
    cholmod_sparse a{};
    a.nrow = std::size_t(size);
    a.ncol = begin.size() - 1;
    a.nzmax = row.size();
    a.p = begin.data();
    a.i = row.data();
    a.x = value.data();
    a.itype = CHOLMOD_INT;
    a.xtype = CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = a.packed = 1;
    return a;
  }
};

} // namespace

struct Cholmod_solver::Implementation {
  explicit Implementation(Ordering o) : ordering(o) {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = ordering == Ordering::minimum_degree ? CHOLMOD_AMD : CHOLMOD_METIS;
    common.postorder = 1;
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;
  ~Implementation() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_factor(&symbolic, &common);
    cholmod_finish(&common);
  }

  Ordering ordering;
  Symmetric_matrix pattern;
  cholmod_common common;
  cholmod_factor* symbolic = nullptr; // kept, for updates change the form of the numeric one
  cholmod_factor* factor = nullptr;
  bool is_analyzed = false, is_factorized = false;

  // What CHOLMOD's status means; `factor` tells the row of a failed pivot.
  Result<void> status(bool succeeded) const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      return make_error(Error_code::solver_failure, "CHOLMOD ran out of memory.");
    if (common.status == CHOLMOD_TOO_LARGE)
      return make_error(Error_code::solver_failure, "The matrix is too large for CHOLMOD's integers.");
    if (common.status == CHOLMOD_NOT_POSDEF) {
      const int step = factor && factor->minor < factor->n ? int(factor->minor) : -1;
      const int row = step < 0 || !factor->Perm ? step : static_cast<const int*>(factor->Perm)[step];
      return not_definite(row);
    }
    if (!succeeded || common.status < CHOLMOD_OK)
      return make_error(Error_code::solver_failure,
                        "CHOLMOD failed with status " + std::to_string(common.status) + ".");
    return {};
  }

  // After an update: the status, and whether the factor is usable.
  Result<void> finish(bool succeeded) {
    Result<void> result = status(succeeded);
    if (result) {
      // An LDL' factor may have lost its sign without CHOLMOD's minding.
      const int* begin = static_cast<const int*>(factor->p);
      const double* x = static_cast<const double*>(factor->x);
      for (std::size_t j = 0; j < factor->n && result; ++j)
        if (!(x[begin[j]] > 0)) result = not_definite(static_cast<const int*>(factor->Perm)[j]);
    }
    is_factorized = bool(result);
    return result;
  }

  // CHOLMOD takes a pivot that is only what rounding leaves of zero.
  Result<void> check_pivots(const Symmetric_matrix& m) const {
    const std::vector<double> pivot = pivots(*factor);
    const int* original = static_cast<const int*>(factor->Perm);
    for (int j = 0; j < m.size; ++j)
      if (!(pivot[j] > smallest_pivot_ratio * m.value[m.column_begin[original[j]]]))
        return not_definite(original[j]);
    return {};
  }

  Result<void> need_factor() const {
    if (is_factorized) return {};
    return make_error(Error_code::solver_failure,
                      "A factor was asked for before a successful factorization.");
  }

  // Rank-one terms: rows[k] * roots[k]. The update routines want the factor's own order.
  Result<void> update(bool adds, const std::vector<int>& rows, const std::vector<double>& roots);
  Column in_factor_order(const Symmetric_matrix& matrix, int row) const;
  std::vector<int> places() const;
};

std::vector<int> Cholmod_solver::Implementation::places() const {
  std::vector<int> place(pattern.size);
  const int* original = static_cast<const int*>(factor->Perm);
  for (int i = 0; i < pattern.size; ++i) place[original[i]] = i;
  return place;
}

Result<void> Cholmod_solver::Implementation::update(bool adds, const std::vector<int>& rows,
                                                    const std::vector<double>& roots) {
  if (rows.empty()) return {};
  const std::vector<int> place = places();
  Column terms;
  terms.begin.push_back(0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    terms.row.push_back(place[rows[k]]);
    terms.value.push_back(roots[k]);
    terms.begin.push_back(int(k) + 1);
  }
  cholmod_sparse c = terms.view(pattern.size);
  return finish(cholmod_updown(adds, &c, factor, &common));
}

Cholmod_solver::Cholmod_solver(Ordering ordering)
    : m_implementation(std::make_unique<Implementation>(ordering)) {}
Cholmod_solver::~Cholmod_solver() = default;
Cholmod_solver::Cholmod_solver(Cholmod_solver&&) noexcept = default;
Cholmod_solver& Cholmod_solver::operator=(Cholmod_solver&&) noexcept = default;

int Cholmod_solver::size() const {
  return m_implementation->pattern.size;
}

Result<void> Cholmod_solver::analyze(const Symmetric_matrix& pattern) {
  Implementation& impl = *m_implementation;
  impl.is_analyzed = impl.is_factorized = false;
  const Result<void> checked = check_pattern(pattern);
  if (!checked) return checked;
  impl.pattern = pattern;
  cholmod_free_factor(&impl.factor, &impl.common);
  cholmod_free_factor(&impl.symbolic, &impl.common);
  impl.is_analyzed = pattern.size == 0; // CHOLMOD refuses the empty matrix
  if (impl.is_analyzed) return {};
  cholmod_sparse a = view(impl.pattern);
  impl.symbolic = cholmod_analyze(&a, &impl.common);
  const Result<void> result = impl.status(impl.symbolic != nullptr);
  impl.is_analyzed = bool(result);
  return result;
}

Result<void> Cholmod_solver::factorize(const Symmetric_matrix& matrix) {
  Implementation& impl = *m_implementation;
  if (!impl.is_analyzed || !same_pattern(matrix, impl.pattern)) {
    const Result<void> analyzed = analyze(matrix);
    if (!analyzed) return analyzed;
  }
  impl.is_factorized = matrix.size == 0;
  if (impl.is_factorized) return {};
  // CHOLMOD takes an infinite pivot.
  for (int j = 0; j < matrix.size; ++j)
    if (!std::isfinite(matrix.value[matrix.column_begin[j]]))
      return make_error(Error_code::solver_failure,
                        "The diagonal entry of row " + std::to_string(j) + " is not a finite number.",
                        Element_kind::none, j);
  // A supernodal factor is overwritten in place; an updated one, or one that failed, starts from the analysis again.
  if (!impl.factor || !impl.factor->is_super || impl.factor->minor < impl.factor->n) {
    cholmod_free_factor(&impl.factor, &impl.common);
    impl.factor = cholmod_copy_factor(impl.symbolic, &impl.common);
    if (!impl.factor) return impl.status(false);
  }
  cholmod_sparse a = view(matrix);
  Result<void> result = impl.status(cholmod_factorize(&a, impl.factor, &impl.common));
  if (result) result = impl.check_pivots(matrix);
  impl.is_factorized = bool(result);
  return result;
}

Result<void> Cholmod_solver::solve(double* x, int right_hand_sides) const {
  Implementation& impl = *m_implementation;
  const Result<void> ready = impl.need_factor();
  if (!ready) return ready;
  CGAL_precondition(right_hand_sides >= 0);
  if (size() == 0 || right_hand_sides == 0) return {};
  cholmod_dense b = view(x, size(), right_hand_sides);
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, impl.factor, &b, &impl.common);
  const Result<void> result = impl.status(solution != nullptr);
  if (result) std::copy_n(static_cast<const double*>(solution->x), b.nzmax, x);
  cholmod_free_dense(&solution, &impl.common);
  return result;
}

Result<void> Cholmod_solver::add_to_diagonal(const std::vector<int>& rows,
                                             const std::vector<double>& amounts) {
  CGAL_precondition(rows.size() == amounts.size());
  Implementation& impl = *m_implementation;
  const Result<void> ready = impl.need_factor();
  if (!ready) return ready;
  for (const bool adds : {true, false}) {
    std::vector<int> chosen;
    std::vector<double> roots;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (amounts[k] != 0 && (amounts[k] > 0) == adds) {
        chosen.push_back(rows[k]);
        roots.push_back(std::sqrt(std::abs(amounts[k])));
      }
    const Result<void> updated = impl.update(adds, chosen, roots);
    if (!updated) return updated;
  }
  return {};
}

// Row and column `row` of the matrix, which the rows deleted so far do not enter.
Column Cholmod_solver::Implementation::in_factor_order(const Symmetric_matrix& m, int row) const {
  const std::vector<int> place = places();
  std::vector<std::pair<int, double>> entries;
  for (int k = m.column_begin[row]; k < m.column_begin[row + 1]; ++k)
    entries.push_back({place[m.row[k]], m.value[k]});
  for (int j = 0; j < row; ++j) {
    const auto begin = m.row.begin() + m.column_begin[j], end = m.row.begin() + m.column_begin[j + 1];
    const auto found = std::lower_bound(begin, end, row);
    if (found != end && *found == row) entries.push_back({place[j], m.value[found - m.row.begin()]});
  }
  std::sort(entries.begin(), entries.end());
  Column column;
  for (const auto& [i, value] : entries) {
    column.row.push_back(i);
    column.value.push_back(value);
  }
  column.begin = {0, int(column.row.size())};
  return column;
}

Result<void> Cholmod_solver::delete_row(int row) {
  Implementation& impl = *m_implementation;
  CGAL_precondition(0 <= row && row < size());
  const Result<void> ready = impl.need_factor();
  if (!ready) return ready;
  return impl.finish(cholmod_rowdel(std::size_t(impl.places()[row]), nullptr, impl.factor, &impl.common));
}

Result<void> Cholmod_solver::add_row(int row, const Symmetric_matrix& matrix) {
  Implementation& impl = *m_implementation;
  CGAL_precondition(0 <= row && row < size() && matrix.size == size());
  const Result<void> ready = impl.need_factor();
  if (!ready) return ready;
  Column column = impl.in_factor_order(matrix, row);
  cholmod_sparse r = column.view(size());
  return impl.finish(cholmod_rowadd(std::size_t(impl.places()[row]), &r, impl.factor, &impl.common));
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
