// SPDX-License-Identifier: GPL-3.0-or-later
// Charts are divided by level lines, which can be dragged, straightened and removed again.
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
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("twisted-bar", 2000));
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;

  RQ::Set_extrema poles;
  poles.extrema.push_back({at(0, 0, 0), false, -1});
  poles.extrema.push_back({at(0, 0, 4), true, -1});
  apply(editor, poles);

  apply(editor, RQ::Subdivide_chart{at(0.5, 0, 1)});
  apply(editor, RQ::Subdivide_chart{at(0.5, 0, 3)});
  apply(editor, RQ::Drag_contour{at(0.5, 0, 1), at(-0.5, 0, 2)});
  apply(editor, RQ::Straighten_contour{at(-0.5, 0, 2)});
  apply(editor, RQ::Remove_contour{at(0.5, 0, 3)});
}
