// SPDX-License-Identifier: GPL-3.0-or-later
// Contours are moved by planes, as a whole and between two anchors, and snapped onto sharp edges.
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
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("l-shape", 2000));
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;

  RQ::Set_extrema poles;
  poles.extrema.push_back({at(2, 0.5, 0.5), false, -1});
  poles.extrema.push_back({at(0.5, 0.5, 2), true, -1});
  apply(editor, poles);

  // The caps end at the edges of the two end faces.
  apply(editor, RQ::Snap_contour{at(2, 0.1, 0.5)});
  apply(editor, RQ::Snap_contour{at(0.5, 0.1, 2)});

  // A contour in the bend goes through the inner and the outer edge.
  apply(editor, RQ::Subdivide_chart{at(0.5, 0, 0.5)});
  apply(editor, RQ::Move_contour{at(0.5, 0, 0.5), RQ::Point(1, 0.5, 1), Eigen::Vector3d(1, 0, -1), {}});

  // Anchors at the ends of the inner edge: what lies between them moves alone, and has its own count of quads.
  apply(editor,
        RQ::Move_contour{
            at(1, 0.5, 1), RQ::Point(1, 0.5, 1), Eigen::Vector3d(1, 0, -1), {at(1, 0, 1), at(1, 1, 1)}});
}
