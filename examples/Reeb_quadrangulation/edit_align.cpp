// SPDX-License-Identifier: GPL-3.0-or-later
// Saddles are joined on one contour: the thin chart between them vanishes.
#include "edit_session.h"

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("bitorus", 3000, at(-1.35, 0, 0), at(3.35, 0, 0));

  // The inner saddles of the two holes; both keep their valence 8.
  apply(editor, RQ::Align_saddles{at(0.65, 0, 0), at(1.35, 0, 0)});

  // The same by naming the chart, and of all charts that are thinner than half a quad.
  editor.undo();
  apply(editor, RQ::Collapse_chart{at(1, 0.4, 0.3)});
  if (const RQ::Result<RQ::Edit_report> done = editor.apply(RQ::Collapse_thin_charts{}); !done)
    std::cout << "refused: " << done.error().message << '\n';
}
