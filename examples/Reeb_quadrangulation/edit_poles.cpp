// SPDX-License-Identifier: GPL-3.0-or-later
// Fractional poles: a sphere with four vertices of valence 2 and no other extraordinary one.
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>
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
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("sphere", 3000));
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;

  RQ::Set_extrema poles;
  poles.extrema.push_back({at(0, 0, -1), false, -1});
  poles.extrema.push_back({at(0, 0, 1), true, -1});
  apply(editor, poles);

  // The ends of the segments are chosen; without them the segment goes across the cap.
  apply(editor, RQ::Split_pole{at(0, 0, -1), RQ::Pole_kind::half, {at(0.8, 0, -0.6), at(-0.8, 0, -0.6)}});
  apply(editor, RQ::Split_pole{at(0, 0, 1), RQ::Pole_kind::half, {at(0, 0.8, 0.6), at(0, -0.8, 0.6)}});

  // Back to quarter-poles, four vertices of valence 3 each.
  apply(editor, RQ::Split_pole{at(0, 0, 1), RQ::Pole_kind::quarter, {}});

  // A whole pole: the quads leave a hole, which a fan of triangles fills.
  apply(editor, RQ::Split_pole{at(0, 0, 1), RQ::Pole_kind::whole, {}});
  std::cout << RQ::fan_sentence(RQ::pole_fans(editor.design(), editor.quads())) << '\n';
}
