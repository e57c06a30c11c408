// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_RECIPE_INPUT_H
#define REEBQUAD_CLI_RECIPE_INPUT_H

#include "Terminal_observer.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <string>

namespace reebquad {

/// Reads a recipe; a `Failure` names the file and what is wrong.
CGAL::Reeb_quadrangulation::Recipe read_recipe(const std::string& file);

/// Designs the surface in a file by the edits of a recipe. A `Failure` says which edit of `recipe_name` does not apply, or that the user
/// interrupted.
CGAL::Reeb_quadrangulation::Editor replay_recipe(const std::string& input,
                                                 const CGAL::Reeb_quadrangulation::Recipe& recipe,
                                                 const std::string& recipe_name, Terminal_observer& observer);

} // namespace reebquad

#endif // REEBQUAD_CLI_RECIPE_INPUT_H
