// SPDX-License-Identifier: GPL-3.0-or-later
// Extrema are added, moved and removed inside their charts; all other charts stay as they are.
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

  // A third extremum brings a saddle with it.
  apply(editor, RQ::Add_extremum{at(1, 0, 0), true});
  apply(editor, RQ::Move_extremum{at(1, 0, 0), at(0.98, 0.2, 0)});
  apply(editor, RQ::Remove_extremum{at(0.98, 0.2, 0)});

  // On the whole surface the field is solved anew.
  apply(editor, RQ::Add_extremum{at(1, 0, 0), true, RQ::Edit_scope::surface});
  apply(editor, RQ::Change_value{at(1, 0, 0), 0.8});

  // Or all extrema are placed automatically, the height axis turned.
  apply(editor, RQ::Suggest{0.08, Eigen::Vector3d(1, 0, 0)});
}
