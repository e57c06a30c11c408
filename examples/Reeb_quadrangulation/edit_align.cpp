// SPDX-License-Identifier: GPL-3.0-or-later
// Saddles are joined on one contour: the thin chart between them vanishes.
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cstdlib>
#include <iostream>

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
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("bitorus", 3000));
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;

  RQ::Set_extrema poles;
  poles.extrema.push_back({at(-1.35, 0, 0), false, -1});
  poles.extrema.push_back({at(3.35, 0, 0), true, -1});
  apply(editor, poles);

  // The inner saddles of the two holes; both keep their valence 8.
  apply(editor, RQ::Align_saddles{at(0.65, 0, 0), at(1.35, 0, 0)});

  // The same by naming the chart, and of all charts that are thinner than half a quad.
  editor.undo();
  apply(editor, RQ::Collapse_chart{at(1, 0.4, 0.3)});
  if (const RQ::Result<RQ::Edit_report> done = editor.apply(RQ::Collapse_thin_charts{}); !done)
    std::cout << "refused: " << done.error().message << '\n';
}
