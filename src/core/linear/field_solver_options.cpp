// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Field_solver_options.h>

#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

namespace CGAL {
namespace Reeb_quadrangulation {

Linear_solver_factory::Linear_solver_factory()
    : Linear_solver_factory(sparse_linear_solver<Multifrontal_solver>()) {}

Result<Linear_solver_factory> linear_solver_named(const std::string& name) {
  if (name == "multifrontal") return Linear_solver_factory();
  if (name == "cholmod") return sparse_linear_solver<Cholmod_solver>();
  if (name == "eigen") return sparse_linear_solver<Eigen_solver>();
  return make_error(Error_code::impossible_request,
                    "There is no linear solver '" + name +
                        "'; the solvers are multifrontal, cholmod and eigen.");
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
