// SPDX-License-Identifier: GPL-3.0-or-later
// Counts, shifts, gradings and locks: the texture of a chart changes, its contours do not.
#include "edit_session.h"

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("sphere", 2000, at(0, 0, -1), at(0, 0, 1));

  const RQ::Surface_point belt = at(1, 0, 0);
  apply(editor, RQ::Set_target{1500, 0});
  apply(editor, RQ::Set_columns{belt, 40});
  apply(editor, RQ::Set_rows{belt, 12});
  apply(editor, RQ::Set_shift{belt, 2});
  apply(editor, RQ::Set_grading{belt, 3});

  // Fewer columns above than below: a 3-5 pair ends two, others make up the difference between the sides.
  apply(editor, RQ::Add_dislocation{belt, -2});
  apply(editor, RQ::Set_columns{belt, 32, RQ::Chart_side::high});
  apply(editor, RQ::Move_corner{at(0, 0, 1), at(0.3, 0, 0.95)});

  // A locked chart keeps its quads, whatever is edited elsewhere.
  apply(editor, RQ::Lock_chart{belt});
  if (const RQ::Result<RQ::Edit_report> done = editor.apply(RQ::Subdivide_chart{belt}); !done)
    std::cout << "refused: " << done.error().message << '\n';
}
