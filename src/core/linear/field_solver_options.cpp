// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Field_solver_options.h>

#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

namespace CGAL {
namespace Reeb_quadrangulation {

Linear_solver_factory::Linear_solver_factory()
    : Linear_solver_factory(sparse_linear_solver<Multifrontal_solver>()) {}

namespace {

const char* solver_names() {
#ifndef REEBQUAD_WITHOUT_CHOLMOD
  return "multifrontal, cholmod, eigen";
#else
  return "multifrontal, eigen";
#endif
}

} // namespace

Result<Linear_solver_factory> linear_solver_named(const std::string& name) {
  if (name == "multifrontal") return Linear_solver_factory();
#ifndef REEBQUAD_WITHOUT_CHOLMOD
  if (name == "cholmod") return sparse_linear_solver<Cholmod_solver>();
#else
  if (name == "cholmod")
    return make_error(Error_code::impossible_request,
                      "The linear solver 'cholmod' was left out when the library was built; there are " +
                          std::string(solver_names()) + ".");
#endif
  if (name == "eigen") return sparse_linear_solver<Eigen_solver>();
  return make_error(Error_code::impossible_request,
                    "There is no linear solver '" + name + "'; there are " + solver_names() + ".");
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
