// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Edit.h>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

struct Namer {
  const char* operator()(const Suggest&) const { return "suggest"; }
  const char* operator()(const Set_extrema&) const { return "set_extrema"; }
  const char* operator()(const Add_extremum&) const { return "add_extremum"; }
  const char* operator()(const Remove_extremum&) const { return "remove_extremum"; }
  const char* operator()(const Move_extremum&) const { return "move_extremum"; }
  const char* operator()(const Change_value&) const { return "change_value"; }
  const char* operator()(const Move_contour&) const { return "move_contour"; }
  const char* operator()(const Move_saddle&) const { return "move_saddle"; }
  const char* operator()(const Drag_contour&) const { return "drag_contour"; }
  const char* operator()(const Straighten_contour&) const { return "straighten_contour"; }
  const char* operator()(const Snap_contour&) const { return "snap_contour"; }
  const char* operator()(const Subdivide_chart&) const { return "subdivide_chart"; }
  const char* operator()(const Remove_contour&) const { return "remove_contour"; }
  const char* operator()(const Align_saddles&) const { return "align_saddles"; }
  const char* operator()(const Collapse_chart&) const { return "collapse_chart"; }
  const char* operator()(const Collapse_thin_charts&) const { return "collapse_thin_charts"; }
  const char* operator()(const Split_pole&) const { return "split_pole"; }
  const char* operator()(const Move_corner&) const { return "move_corner"; }
  const char* operator()(const Split_saddle&) const { return "split_saddle"; }
  const char* operator()(const Pin_corners&) const { return "pin_corners"; }
  const char* operator()(const Set_target&) const { return "set_target"; }
  const char* operator()(const Set_columns&) const { return "set_columns"; }
  const char* operator()(const Set_rows&) const { return "set_rows"; }
  const char* operator()(const Set_shift&) const { return "set_shift"; }
  const char* operator()(const Set_grading&) const { return "set_grading"; }
  const char* operator()(const Lock_chart&) const { return "lock_chart"; }
  const char* operator()(const Align_layout&) const { return "align_layout"; }
  const char* operator()(const Edit_texture&) const { return "edit_texture"; }
  const char* operator()(const Drag_vertices&) const { return "drag_vertices"; }
  const char* operator()(const Relax_texture&) const { return "relax_texture"; }
  const char* operator()(const Snap_vertices&) const { return "snap_vertices"; }
  const char* operator()(const Fit_texture&) const { return "fit_texture"; }
  const char* operator()(const Reset_texture&) const { return "reset_texture"; }
};

} // namespace

const char* name(const Edit& edit) {
  return std::visit(Namer(), edit);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
