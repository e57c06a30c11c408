// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

namespace CGAL {
namespace Reeb_quadrangulation {

Recipe recipe_of(const Editor& editor) {
  Recipe recipe;
  recipe.options = editor.options();
  recipe.options.threads = 0;
  recipe.edits.assign(editor.edits().begin(), editor.edits().begin() + editor.position());
  return recipe;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
