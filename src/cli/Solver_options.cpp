// SPDX-License-Identifier: GPL-3.0-or-later
#include "Solver_options.h"

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

void declare_solver(Command_line& line, const char* otherwise) {
  const std::string by_default = std::string("; by default ") + otherwise,
                    solver = "of the fields and the maps: multifrontal, cholmod or eigen" + by_default,
                    method = "how fields meet given values: elimination or penalty" + by_default;
  line.options.add_options() //
      ("solver", po::value<std::string>()->value_name("NAME"),
       solver.c_str())("constraints", po::value<std::string>()->value_name("METHOD"), method.c_str());
}

Solver_options solver_options(const Command_line& line) {
  Solver_options options;
  if (line.has("solver")) {
    const std::string name = line.text("solver");
    Result<Linear_solver_factory> found = linear_solver_named(name);
    if (!found) throw Usage_error("--solver: " + found.error().message);
    options.solver = std::move(*found);
  }
  if (line.has("constraints")) {
    const std::string method = line.text("constraints");
    if (method != "elimination" && method != "penalty")
      throw Usage_error("--constraints is one of elimination, penalty; it got '" + method + "'");
    options.constraints = method == "penalty" ? Constraint_method::penalty : Constraint_method::elimination;
  }
  return options;
}

} // namespace reebquad
