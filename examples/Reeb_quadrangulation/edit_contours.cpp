// SPDX-License-Identifier: GPL-3.0-or-later
// Contours are moved by planes, as a whole and between two anchors, and snapped onto sharp edges.
#include "edit_session.h"

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;
using edit_session::begin;

int main() {
  RQ::Editor editor = begin("l-shape", 2000, at(2, 0.5, 0.5), at(0.5, 0.5, 2));

  // The caps end at the edges of the two end faces.
  apply(editor, RQ::Snap_contour{at(2, 0.1, 0.5)});
  apply(editor, RQ::Snap_contour{at(0.5, 0.1, 2)});

  // A contour in the bend goes through the inner and the outer edge.
  apply(editor, RQ::Subdivide_chart{at(0.5, 0, 0.5)});
  apply(editor, RQ::Move_contour{at(0.5, 0, 0.5), RQ::Point(1, 0.5, 1), Eigen::Vector3d(1, 0, -1), {}});

  // Anchors at the ends of the inner edge: what lies between them moves alone, and has its own count of
  // quads.
  apply(editor,
        RQ::Move_contour{
            at(1, 0.5, 1), RQ::Point(1, 0.5, 1), Eigen::Vector3d(1, 0, -1), {at(1, 0, 1), at(1, 1, 1)}});
}
