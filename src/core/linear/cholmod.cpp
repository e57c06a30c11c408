// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>

#include "linear/smallest_pivot.h"

#include <CGAL/assertions.h>

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::smallest_pivot_ratio;

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
    common.postorder = 1;
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;
  ~Implementation() {
    cholmod_free_factor(&updated, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_free_factor(&symbolic, &common);
    cholmod_finish(&common);
  }

  Ordering ordering;
  Symmetric_matrix pattern;
  cholmod_common common;
  std::vector<double> factorized_values; // of the matrix, while the factor can be gone back to
  std::vector<int> order;
  cholmod_factor* symbolic = nullptr; // kept, for updates change the form of the numeric one
  cholmod_factor* factor = nullptr;   // as it was factorized; updates change it unless it is kept
  cholmod_factor* updated = nullptr;  // a copy of it with updates, if there were any and it is kept
  bool is_analyzed = false, is_factorized = false, is_incremental = false;

  cholmod_factor* current() const { return updated ? updated : factor; }

  // What CHOLMOD's status means; `factor` tells the row of a failed pivot.
  Result<void> status(bool succeeded) const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      return make_error(Error_code::solver_failure, "CHOLMOD ran out of memory.");
    if (common.status == CHOLMOD_TOO_LARGE)
      return make_error(Error_code::solver_failure, "The matrix is too large for CHOLMOD's integers.");
    if (common.status == CHOLMOD_NOT_POSDEF) {
      const cholmod_factor* l = current();
      return not_definite(l && l->minor < l->n ? order[l->minor] : -1);
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
      const int* begin = static_cast<const int*>(current()->p);
      const double* x = static_cast<const double*>(current()->x);
      for (std::size_t j = 0; j < order.size() && result; ++j)
        if (!(x[begin[j]] > 0)) result = not_definite(order[j]);
    }
    is_factorized = bool(result);
    return result;
  }

  // CHOLMOD takes a pivot that is only what rounding leaves of zero.
  Result<void> check_pivots(const Symmetric_matrix& m) const {
    const std::vector<double> pivot = pivots(*factor);
    for (int j = 0; j < m.size; ++j)
      if (!(pivot[j] > smallest_pivot_ratio * m.value[m.column_begin[order[j]]]))
        return not_definite(order[j]);
    return {};
  }

  Result<void> need_factor() const {
    if (is_factorized) return {};
    return make_error(Error_code::solver_failure,
                      "A factor was asked for before a successful factorization.");
  }

  Result<void> analyze(const Symmetric_matrix& new_pattern, int method, const std::vector<int>* given);
  void free_updates() { cholmod_free_factor(&updated, &common); }
  // Rank-one terms: rows[k] * roots[k]. The update routines want the factor's own order.
  Result<void> update(bool adds, const std::vector<int>& rows, const std::vector<double>& roots);
};

Result<void> Cholmod_solver::Implementation::update(bool adds, const std::vector<int>& rows,
                                                    const std::vector<double>& roots) {
  if (rows.empty()) return {};
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = int(i);
  Column terms;
  terms.begin.push_back(0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    terms.row.push_back(place[rows[k]]);
    terms.value.push_back(roots[k]);
    terms.begin.push_back(int(k) + 1);
  }
  cholmod_sparse c = terms.view(pattern.size);
  return finish(cholmod_updown(adds, &c, current(), &common));
}

Cholmod_solver::Cholmod_solver(Ordering ordering)
    : m_implementation(std::make_unique<Implementation>(ordering)) {}
Cholmod_solver::~Cholmod_solver() = default;
Cholmod_solver::Cholmod_solver(Cholmod_solver&&) noexcept = default;
Cholmod_solver& Cholmod_solver::operator=(Cholmod_solver&&) noexcept = default;

int Cholmod_solver::size() const {
  return m_implementation->pattern.size;
}

const std::vector<int>& Cholmod_solver::elimination_order() const {
  return m_implementation->order;
}

void Cholmod_solver::set_incremental(bool incremental) {
  Implementation& impl = *m_implementation;
  impl.is_incremental = incremental;
  if (incremental) return;
  // What stays is the factor in use.
  if (impl.updated) std::swap(impl.factor, impl.updated);
  impl.free_updates();
  impl.factorized_values.clear();
}

// `method` is one of CHOLMOD's orderings.
Result<void> Cholmod_solver::Implementation::analyze(const Symmetric_matrix& new_pattern, int method,
                                                     const std::vector<int>* given) {
  is_analyzed = is_factorized = false;
  factorized_values.clear();
  if (const Result<void> checked = check_pattern(new_pattern); !checked) return checked;
  pattern = new_pattern;
  order.clear();
  free_updates();
  cholmod_free_factor(&factor, &common);
  cholmod_free_factor(&symbolic, &common);
  is_analyzed = pattern.size == 0; // CHOLMOD refuses the empty matrix
  if (is_analyzed) return {};
  cholmod_sparse a = view(pattern);
  common.method[0].ordering = method;
  // CHOLMOD reads the order through a pointer that is not const; it does not write.
  int* const asked = given ? const_cast<int*>(given->data()) : nullptr;
  symbolic = cholmod_analyze_p(&a, asked, nullptr, 0, &common);
  const Result<void> result = status(symbolic != nullptr);
  is_analyzed = bool(result);
  if (!result) return result;
  const int* original = static_cast<const int*>(symbolic->Perm);
  order.assign(original, original + pattern.size);
  return {};
}

Result<void> Cholmod_solver::analyze(const Symmetric_matrix& pattern) {
  const bool by_degree = m_implementation->ordering == Ordering::minimum_degree;
  return m_implementation->analyze(pattern, by_degree ? CHOLMOD_AMD : CHOLMOD_METIS, nullptr);
}

Result<void> Cholmod_solver::analyze(const Symmetric_matrix& pattern, const std::vector<int>& order) {
  CGAL_precondition(int(order.size()) == pattern.size);
  return m_implementation->analyze(pattern, CHOLMOD_GIVEN, &order);
}

Result<void> Cholmod_solver::factorize(const Symmetric_matrix& matrix) {
  Implementation& impl = *m_implementation;
  if (!impl.is_analyzed || !same_pattern(matrix, impl.pattern)) {
    const Result<void> analyzed = analyze(matrix);
    if (!analyzed) return analyzed;
  }
  if (!impl.factorized_values.empty() && impl.factorized_values == matrix.value) {
    impl.free_updates();
    impl.is_factorized = true;
    return {};
  }
  impl.factorized_values.clear();
  impl.free_updates();
  impl.is_factorized = matrix.size == 0;
  if (impl.is_factorized) return {};
  // CHOLMOD takes an infinite pivot.
  for (int j = 0; j < matrix.size; ++j)
    if (!std::isfinite(matrix.value[matrix.column_begin[j]]))
      return make_error(Error_code::solver_failure,
                        "The diagonal entry of row " + std::to_string(j) + " is not a finite number.",
                        Element_kind::none, j);
  // A supernodal factor is overwritten in place; an updated one, or one that failed, starts from the analysis
  // again.
  if (!impl.factor || !impl.factor->is_super || impl.factor->minor < impl.factor->n) {
    cholmod_free_factor(&impl.factor, &impl.common);
    impl.factor = cholmod_copy_factor(impl.symbolic, &impl.common);
    if (!impl.factor) return impl.status(false);
  }
  cholmod_sparse a = view(matrix);
  Result<void> result = impl.status(cholmod_factorize(&a, impl.factor, &impl.common));
  if (result) result = impl.check_pivots(matrix);
  impl.is_factorized = bool(result);
  if (result && impl.is_incremental) impl.factorized_values = matrix.value;
  return result;
}

Result<void> Cholmod_solver::solve(double* x, int right_hand_sides) const {
  Implementation& impl = *m_implementation;
  const Result<void> ready = impl.need_factor();
  if (!ready) return ready;
  CGAL_precondition(right_hand_sides >= 0);
  if (size() == 0 || right_hand_sides == 0) return {};
  cholmod_dense b = view(x, size(), right_hand_sides);
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, impl.current(), &b, &impl.common);
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
  if (!ready || rows.empty()) return ready;
  if (impl.is_incremental && !impl.updated) {
    // The copy is of the simplicial form, so that only the first one converts.
    if (!cholmod_change_factor(CHOLMOD_REAL, 0, 0, 1, 1, impl.factor, &impl.common))
      return impl.status(false);
    impl.updated = cholmod_copy_factor(impl.factor, &impl.common);
    if (!impl.updated) return impl.status(false);
  }
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

} // namespace Reeb_quadrangulation
} // namespace CGAL
