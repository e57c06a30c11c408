// SPDX-License-Identifier: GPL-3.0-or-later
// What could be better about a design, with a reason each; then the hints are taken.
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/suggest_edits.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  RQ::Result<RQ::Editor> editor = RQ::Editor::create(*RQ::make_shape("hand", 6000));
  if (!editor) {
    std::cerr << editor.error().message << '\n';
    return 1;
  }

  // Two extrema are not enough for a hand: four fingers would be covered by a few long quads.
  RQ::Set_extrema poles;
  poles.extrema.push_back({{RQ::Point(0, 0, -1), -1}, false, -1});
  poles.extrema.push_back({{RQ::Point(0, 0, 2), -1}, true, -1});
  if (const auto done = editor->apply(poles); !done) {
    std::cerr << done.error().message << '\n';
    return 1;
  }

  const RQ::Result<std::vector<RQ::Hint>> hints = RQ::suggest_edits(*editor);
  if (!hints) {
    std::cerr << hints.error().message << '\n';
    return 1;
  }
  for (const RQ::Hint& hint : *hints) std::cout << RQ::name(hint.edit) << ": " << hint.reason << '\n';

  // One after the other: after each the others are looked for again.
  const RQ::Result<std::vector<RQ::Hint>> taken = RQ::apply_hints(*editor);
  if (!taken) {
    std::cerr << taken.error().message << '\n';
    return 1;
  }
  std::cout << taken->size() << " hints taken; " << editor->design().extrema.size() << " extrema, "
            << editor->design().charts.size() << " charts\n";
}
