// SPDX-License-Identifier: GPL-3.0-or-later
// Undo, redo and recipes: a design is the list of its edits, and runs on a denser mesh of the same shape.
#include "edit_session.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <iostream>
#include <string>

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("torus", 2000, at(-1.4, 0, 0), at(1.4, 0, 0));

  apply(editor, RQ::Split_saddle{at(-0.6, 0, 0), RQ::Saddle_kind::half, {}});
  apply(editor, RQ::Set_target{1000, 0});
  while (editor.can_undo()) editor.undo();
  while (editor.can_redo()) editor.redo();

  const std::string text = RQ::to_json(RQ::recipe_of(editor));
  std::cout << text;
  const RQ::Result<RQ::Recipe> recipe = RQ::recipe_from_json(text);
  if (!recipe) {
    std::cerr << recipe.error().message << '\n';
    return 1;
  }
  RQ::Editor denser = std::move(*RQ::Editor::create(*RQ::make_shape("torus", 8000), recipe->options));
  for (const RQ::Edit& edit : recipe->edits) apply(denser, edit);
}
