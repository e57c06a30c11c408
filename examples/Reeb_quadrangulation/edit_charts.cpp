// SPDX-License-Identifier: GPL-3.0-or-later
// Charts are divided by level lines, which can be dragged, straightened and removed again.
#include "edit_session.h"

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("twisted-bar", 2000, at(0, 0, 0), at(0, 0, 4));

  apply(editor, RQ::Subdivide_chart{at(0.5, 0, 1)});
  apply(editor, RQ::Subdivide_chart{at(0.5, 0, 3)});
  apply(editor, RQ::Drag_contour{at(0.5, 0, 1), at(-0.5, 0, 2)});
  apply(editor, RQ::Straighten_contour{at(-0.5, 0, 2)});
  apply(editor, RQ::Remove_contour{at(0.5, 0, 3)});
}
