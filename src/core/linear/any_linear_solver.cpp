// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Any_linear_solver.h>

#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

namespace CGAL {
namespace Reeb_quadrangulation {

Any_linear_solver::Any_linear_solver() : Any_linear_solver(Multifrontal_solver()) {}

Any_linear_solver::Interface::~Interface() = default;

const std::vector<int>& Any_linear_solver::Interface::no_order() {
  static const std::vector<int> none;
  return none;
}

Result<void> Any_linear_solver::Interface::no_updates() {
  return make_error(Error_code::solver_failure, "The linear solver cannot update its factor.");
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
