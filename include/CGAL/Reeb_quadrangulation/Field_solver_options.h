// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FIELD_SOLVER_OPTIONS_H
#define CGAL_REEB_QUADRANGULATION_FIELD_SOLVER_OPTIONS_H

#include <CGAL/Reeb_quadrangulation/Any_linear_solver.h>

#include <functional>
#include <string>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Makes linear solvers of one kind, each system its own: a solver cannot be copied, the options that choose
/// it can.
class Linear_solver_factory {
public:
  /// Makes `Multifrontal_solver`s.
  Linear_solver_factory();
  /// `make()` returns a new solver, from several threads at once. Recipes and reports call the kind by its
  /// `name`.
  Linear_solver_factory(std::string name, std::function<Any_linear_solver()> make)
      : m_name(std::move(name)), m_make(std::move(make)) {}

  Any_linear_solver operator()() const { return m_make(); }
  const std::string& name() const { return m_name; }

private:
  std::string m_name;
  std::function<Any_linear_solver()> m_make;
};

class Multifrontal_solver;
class Cholmod_solver;
class Eigen_solver;

/// What recipes and reports call a type of solvers that is given no other name.
template <class Solver> inline constexpr const char* linear_solver_name = "custom";
template <> inline constexpr const char* linear_solver_name<Multifrontal_solver> = "multifrontal";
template <> inline constexpr const char* linear_solver_name<Cholmod_solver> = "cholmod";
template <> inline constexpr const char* linear_solver_name<Eigen_solver> = "eigen";

/// A factory of solvers of a type, a model of `LinearSolver`, as its default constructor makes them.
template <class Solver>
Linear_solver_factory sparse_linear_solver(std::string name = linear_solver_name<Solver>) {
  return Linear_solver_factory(std::move(name), [] { return Any_linear_solver(Solver()); });
}

/// A factory of one of the package's own models by its name: `multifrontal`, `cholmod` or `eigen`. Fails with
/// `impossible_request`, naming these, where it is another.
Result<Linear_solver_factory> linear_solver_named(const std::string& name);

/// How given values enter the system of a harmonic function.
enum class Constraint_method {
  /// Exactly: the vertices are left out of the system.
  elimination,
  /// By a weight of 1e8 times the largest diagonal entry, after the paper's Eq. 3. The values are met to
  /// about 1e-8 of
  /// their range, and a solver that updates its factor need not factorize again where they come and go.
  penalty
};

/// With what the systems of the fields and of the charts' maps are solved, and how. All choices give the same
/// field up to rounding, or up to what penalties leave, but not the same bits.
struct Field_solver_options {
  Linear_solver_factory solver;
  Constraint_method constraints = Constraint_method::elimination;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FIELD_SOLVER_OPTIONS_H
