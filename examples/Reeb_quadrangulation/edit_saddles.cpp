// SPDX-License-Identifier: GPL-3.0-or-later
// Fractional saddles: the torus with saddles of valence 8, 5, 6, and with no extraordinary vertex at all.
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
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("torus", 3000));
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;

  RQ::Set_extrema poles;
  poles.extrema.push_back({at(-1.4, 0, 0), false, -1});
  poles.extrema.push_back({at(1.4, 0, 0), true, -1});
  apply(editor, poles);

  // A quarter-saddle: four vertices of valence 5 around a rectangle.
  apply(editor, RQ::Split_saddle{at(-0.6, 0, 0), RQ::Saddle_kind::quarter, {}, 0.25});
  editor.undo();

  // Half-saddles: two vertices of valence 6 each, joined by a segment.
  apply(editor, RQ::Split_saddle{at(-0.6, 0, 0), RQ::Saddle_kind::half, {}});
  apply(editor, RQ::Split_saddle{at(0.6, 0, 0), RQ::Saddle_kind::half, {}});

  // The discs around the extrema become rectangles with their corners at the half-saddles, which so become regular.
  apply(editor, RQ::Pin_corners{at(-1.4, 0, 0)});
  apply(editor, RQ::Pin_corners{at(1.4, 0, 0)});
}
