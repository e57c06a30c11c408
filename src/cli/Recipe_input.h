// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_RECIPE_INPUT_H
#define REEBQUAD_CLI_RECIPE_INPUT_H

#include "Terminal_observer.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/halve_surface.h>

#include <optional>
#include <string>

namespace reebquad {

/// Reads a recipe; a `Failure` names the file and what is wrong.
CGAL::Reeb_quadrangulation::Recipe read_recipe(const std::string& file);

/// A design and the surface that it is of. The editor of a recipe with a mirror works on the half.
struct Replayed_recipe {
  CGAL::Reeb_quadrangulation::Editor editor;
  std::optional<CGAL::Reeb_quadrangulation::Surface_half> half;
  CGAL::Reeb_quadrangulation::Triangle_surface whole; ///< empty without a mirror
  /// As it was read.
  const CGAL::Reeb_quadrangulation::Triangle_surface& input() const { return half ? whole : editor.input(); }
};

/// Designs the surface in a file by the edits of a recipe. A `Failure` says which edit of `recipe_name` does
/// not apply, that the surface is not one that can be mirrored so, or that the user interrupted.
Replayed_recipe replay_recipe(const std::string& input, const CGAL::Reeb_quadrangulation::Recipe& recipe,
                              const std::string& recipe_name, Terminal_observer& observer);

} // namespace reebquad

#endif // REEBQUAD_CLI_RECIPE_INPUT_H
