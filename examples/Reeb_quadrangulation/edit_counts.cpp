// SPDX-License-Identifier: GPL-3.0-or-later
// Counts, shifts, gradings and locks: the texture of a chart changes, its contours do not.
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
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("sphere", 2000));
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;

  RQ::Set_extrema poles;
  poles.extrema.push_back({at(0, 0, -1), false, -1});
  poles.extrema.push_back({at(0, 0, 1), true, -1});
  apply(editor, poles);

  const RQ::Surface_point belt = at(1, 0, 0);
  apply(editor, RQ::Set_target{1500, 0});
  apply(editor, RQ::Set_columns{belt, 40});
  apply(editor, RQ::Set_rows{belt, 12});
  apply(editor, RQ::Set_shift{belt, 2});
  apply(editor, RQ::Set_grading{belt, 3});
  apply(editor, RQ::Move_corner{at(0, 0, 1), at(0.3, 0, 0.95)});

  // A locked chart keeps its quads, whatever is edited elsewhere.
  apply(editor, RQ::Lock_chart{belt});
  if (const RQ::Result<RQ::Edit_report> done = editor.apply(RQ::Subdivide_chart{belt}); !done)
    std::cout << "refused: " << done.error().message << '\n';
}
