// SPDX-License-Identifier: GPL-3.0-or-later
// Fractional poles: a sphere with four vertices of valence 2 and no other extraordinary one.
#include "edit_session.h"

#include <CGAL/Reeb_quadrangulation/pole_fans.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("sphere", 3000, at(0, 0, -1), at(0, 0, 1));

  // The ends of the segments are chosen; without them the segment goes across the cap.
  apply(editor, RQ::Split_pole{at(0, 0, -1), RQ::Pole_kind::half, {at(0.8, 0, -0.6), at(-0.8, 0, -0.6)}});
  apply(editor, RQ::Split_pole{at(0, 0, 1), RQ::Pole_kind::half, {at(0, 0.8, 0.6), at(0, -0.8, 0.6)}});

  // Back to quarter-poles, four vertices of valence 3 each.
  apply(editor, RQ::Split_pole{at(0, 0, 1), RQ::Pole_kind::quarter, {}});

  // A whole pole: the quads leave a hole, which a fan of triangles fills.
  apply(editor, RQ::Split_pole{at(0, 0, 1), RQ::Pole_kind::whole, {}});
  std::cout << RQ::fan_sentence(RQ::pole_fans(editor.design(), editor.quads())) << '\n';
}
