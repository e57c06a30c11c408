// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_SOLVER_OPTIONS_H
#define REEBQUAD_CLI_SOLVER_OPTIONS_H

#include "Command.h"

#include <CGAL/Reeb_quadrangulation/Field_solver_options.h>

#include <optional>

namespace reebquad {

/// What --solver and --constraints say, where they are given.
struct Solver_options {
  std::optional<CGAL::Reeb_quadrangulation::Linear_solver_factory> solver;
  std::optional<CGAL::Reeb_quadrangulation::Constraint_method> constraints;

  /// Replaces what is given in the options of a run, of an editor or of a recipe.
  template <class Options> void apply_to(Options& options) const {
    if (solver) options.solver = *solver;
    if (constraints) options.constraints = *constraints;
  }
};

/// Declares both options; `otherwise` tells what holds where they are not given.
void declare_solver(Command_line& line, const char* otherwise);

/// Throws `Usage_error` where a name is none.
Solver_options solver_options(const Command_line& line);

} // namespace reebquad

#endif // REEBQUAD_CLI_SOLVER_OPTIONS_H
