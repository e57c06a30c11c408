// SPDX-License-Identifier: GPL-3.0-or-later
// Extrema are added, moved and removed inside their charts; all other charts stay as they are.
#include "edit_session.h"

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("sphere", 2000, at(0, 0, -1), at(0, 0, 1));

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
