// SPDX-License-Identifier: GPL-3.0-or-later
// Undo, redo and recipes: a design is the list of its edits, and runs on a denser mesh of the same shape.
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace RQ = CGAL::Reeb_quadrangulation;

namespace {

// Applies an edit and says what it changed.
void apply(RQ::Editor& editor, const RQ::Edit& edit) {
  const RQ::Result<RQ::Edit_report> done = editor.apply(edit);
  if (!done) {
    std::cerr << RQ::name(edit) << ": " << done.error().message << '\n';
    std::exit(1);
  }
  std::cout << RQ::name(edit) << ": " << done->new_charts.size() << " new charts, "
            << done->remeshed_charts.size() << " others with new quads;";
  for (const auto& [valence, number] : editor.quads().valences)
    std::cout << "  " << number << " of valence " << valence;
  std::cout << '\n';
}

RQ::Surface_point at(double x, double y, double z) {
  return {RQ::Point(x, y, z), -1};
}

} // namespace

int main() {
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("torus", 2000));
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;

  RQ::Set_extrema poles;
  poles.extrema.push_back({at(-1.4, 0, 0), false, -1});
  poles.extrema.push_back({at(1.4, 0, 0), true, -1});
  apply(editor, poles);

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
