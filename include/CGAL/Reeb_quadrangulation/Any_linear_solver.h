// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_ANY_LINEAR_SOLVER_H
#define CGAL_REEB_QUADRANGULATION_ANY_LINEAR_SOLVER_H

#include <CGAL/Reeb_quadrangulation/linear_solver.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A linear solver whose type is chosen at run time: it holds any model of the concept `LinearSolver`, and is
/// one.
///
/// What the model has of the concept's optional members is found when it is put in, and used; the calls below
/// say what they do where it has them not. An object that was moved from may only be assigned to.
class Any_linear_solver {
  template <class Solver> using Is_model = std::enable_if_t<!std::is_same_v<Solver, Any_linear_solver>, int>;

public:
  /// Holds a `Multifrontal_solver`.
  Any_linear_solver();
  template <class Solver, Is_model<Solver> = 0>
  explicit Any_linear_solver(Solver solver) : m_held(std::make_unique<Holder<Solver>>(std::move(solver))) {}

  Result<void> analyze(const Symmetric_matrix& pattern) { return m_held->analyze(pattern); }
  Result<void> factorize(const Symmetric_matrix& matrix) { return m_held->factorize(matrix); }
  Result<void> solve(double* x, int right_hand_sides = 1) const { return m_held->solve(x, right_hand_sides); }
  int size() const { return m_held->size(); }

  /// Where the model takes no order, it looks for one.
  Result<void> analyze(const Symmetric_matrix& pattern, const std::vector<int>& order) {
    return m_held->analyze(pattern, order);
  }
  /// Empty where the model does not tell, and before the first `analyze()`.
  const std::vector<int>& elimination_order() const { return m_held->elimination_order(); }
  /// Changes nothing where the model works in one thread.
  void set_threads(int threads) { m_held->set_threads(threads); }
  /// Changes nothing where the model begins anew with every factorization.
  void set_incremental(bool incremental) { m_held->set_incremental(incremental); }
  /// Whether the model has `add_to_diagonal()`.
  bool can_update() const { return m_held->can_update(); }
  /// Fails with `solver_failure` where the model has it not.
  Result<void> add_to_diagonal(const std::vector<int>& rows, const std::vector<double>& amounts) {
    return m_held->add_to_diagonal(rows, amounts);
  }

private:
  struct Interface {
    virtual ~Interface();
    virtual Result<void> analyze(const Symmetric_matrix& pattern) = 0;
    virtual Result<void> analyze(const Symmetric_matrix& pattern, const std::vector<int>& order) = 0;
    virtual Result<void> factorize(const Symmetric_matrix& matrix) = 0;
    virtual Result<void> solve(double* x, int right_hand_sides) const = 0;
    virtual int size() const = 0;
    virtual const std::vector<int>& elimination_order() const = 0;
    virtual void set_threads(int threads) = 0;
    virtual void set_incremental(bool incremental) = 0;
    virtual bool can_update() const = 0;
    virtual Result<void> add_to_diagonal(const std::vector<int>& rows,
                                         const std::vector<double>& amounts) = 0;

    static const std::vector<int>& no_order();
    static Result<void> no_updates();
  };
  template <class Solver> struct Holder;
  std::unique_ptr<Interface> m_held;
};

namespace internal {

// Whether a solver has an optional member: its call, as one of the types below, is well formed.
template <template <class> class Call, class Solver, class = void> struct Has : std::false_type {};
template <template <class> class Call, class Solver>
struct Has<Call, Solver, std::void_t<Call<Solver>>> : std::true_type {};

using Rows = std::vector<int>;
template <class S>
using Analyze_call = decltype(std::declval<S&>().analyze(std::declval<const Symmetric_matrix&>(), Rows()));
template <class S> using Order_call = decltype(std::declval<const S&>().elimination_order());
template <class S> using Threads_call = decltype(std::declval<S&>().set_threads(1));
template <class S> using Incremental_call = decltype(std::declval<S&>().set_incremental(true));
template <class S>
using Update_call = decltype(std::declval<S&>().add_to_diagonal(Rows(), std::vector<double>()));

} // namespace internal

template <class Solver> struct Any_linear_solver::Holder final : Interface {
  explicit Holder(Solver&& s) : solver(std::move(s)) {}

  Result<void> analyze(const Symmetric_matrix& pattern) override { return solver.analyze(pattern); }
  Result<void> analyze(const Symmetric_matrix& pattern, const std::vector<int>& order) override {
    if constexpr (internal::Has<internal::Analyze_call, Solver>::value)
      return solver.analyze(pattern, order);
    else
      return (void)order, solver.analyze(pattern);
  }
  Result<void> factorize(const Symmetric_matrix& matrix) override { return solver.factorize(matrix); }
  Result<void> solve(double* x, int sides) const override { return solver.solve(x, sides); }
  int size() const override { return solver.size(); }
  const std::vector<int>& elimination_order() const override {
    if constexpr (internal::Has<internal::Order_call, Solver>::value)
      return solver.elimination_order();
    else
      return no_order();
  }
  void set_threads([[maybe_unused]] int threads) override {
    if constexpr (internal::Has<internal::Threads_call, Solver>::value) solver.set_threads(threads);
  }
  void set_incremental([[maybe_unused]] bool incremental) override {
    if constexpr (internal::Has<internal::Incremental_call, Solver>::value)
      solver.set_incremental(incremental);
  }
  bool can_update() const override { return internal::Has<internal::Update_call, Solver>::value; }
  Result<void> add_to_diagonal([[maybe_unused]] const std::vector<int>& rows,
                               [[maybe_unused]] const std::vector<double>& amounts) override {
    if constexpr (internal::Has<internal::Update_call, Solver>::value)
      return solver.add_to_diagonal(rows, amounts);
    else
      return no_updates();
  }

  Solver solver;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_ANY_LINEAR_SOLVER_H
