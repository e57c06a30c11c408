// SPDX-License-Identifier: GPL-3.0-or-later
// A loop at a saddle is moved to a plane in two ways: cut into the surface, and enforced by the field alone.
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  RQ::Result<RQ::Editor> editor = RQ::Editor::create(*RQ::make_shape("bitorus", 3000));
  if (!editor) {
    std::cerr << editor.error().message << '\n';
    return 1;
  }
  RQ::Set_extrema poles;
  poles.extrema.push_back({{RQ::Point(-1.35, 0, 0), -1}, false, -1});
  poles.extrema.push_back({{RQ::Point(3.35, 0, 0), -1}, true, -1});
  if (const auto done = editor->apply(poles); !done) {
    std::cerr << done.error().message << '\n';
    return 1;
  }

  // The loop goes around the tube on one side of the first hole; the plane goes through its saddle.
  const RQ::Surface_point loop{RQ::Point(-1.09, -0.79, 0.04), -1};
  const Eigen::Vector3d normal(0.85, -0.52, 0.2);
  for (RQ::Enforcement how : {RQ::Enforcement::contour, RQ::Enforcement::field}) {
    const auto done = editor->apply(RQ::Move_contour{loop, RQ::Point(-0.65, 0, 0), normal, {}, how});
    std::cout << (how == RQ::Enforcement::contour ? "cut into the surface: " : "by the field alone: ");
    if (!done) {
      std::cout << "refused: " << done.error().message << '\n';
      continue;
    }
    std::cout << done->new_charts.size() << " of " << editor->design().charts.size() << " charts are new\n";
    editor->undo();
  }
}
