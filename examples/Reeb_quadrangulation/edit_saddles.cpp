// SPDX-License-Identifier: GPL-3.0-or-later
// Saddles: one moves with its contours; fractional ones, the torus with valences 8, 5, 6 and with no
// extraordinary vertex at all.
#include "edit_session.h"

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("torus", 3000, at(-1.4, 0, 0), at(1.4, 0, 0));

  // The saddle moves along the hole, and its figure eight with it into the plane that touches the torus
  // there.
  apply(editor, RQ::Move_saddle{at(-0.6, 0, 0), at(-0.55, 0.23, 0)});
  editor.undo();

  // A quarter-saddle: four vertices of valence 5 around a rectangle.
  apply(editor, RQ::Split_saddle{at(-0.6, 0, 0), RQ::Saddle_kind::quarter, {}, 0.25});
  editor.undo();

  // Half-saddles: two vertices of valence 6 each, joined by a segment.
  apply(editor, RQ::Split_saddle{at(-0.6, 0, 0), RQ::Saddle_kind::half, {}});
  apply(editor, RQ::Split_saddle{at(0.6, 0, 0), RQ::Saddle_kind::half, {}});

  // The discs around the extrema become rectangles with their corners at the half-saddles, which so become
  // regular.
  apply(editor, RQ::Pin_corners{at(-1.4, 0, 0)});
  apply(editor, RQ::Pin_corners{at(1.4, 0, 0)});
}
