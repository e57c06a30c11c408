// SPDX-License-Identifier: GPL-3.0-or-later
// What each edit does to a draft. A failure leaves the draft in any state: it must be thrown away.
#ifndef REEBQUAD_EDITS_STEPS_H
#define REEBQUAD_EDITS_STEPS_H

#include "design/draft.h"

#include <CGAL/Reeb_quadrangulation/Edit.h>

#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {

Result<void> apply_edit(Draft& draft, const Suggest& edit);
Result<void> apply_edit(Draft& draft, const Set_extrema& edit);
Result<void> apply_edit(Draft& draft, const Set_field& edit); ///< \pre the draft has `given_field`
Result<void> apply_edit(Draft& draft, const Add_extremum& edit);
Result<void> apply_edit(Draft& draft, const Remove_extremum& edit);
Result<void> apply_edit(Draft& draft, const Move_extremum& edit);
Result<void> apply_edit(Draft& draft, const Change_value& edit);
Result<void> apply_edit(Draft& draft, const Move_contour& edit);
Result<void> apply_edit(Draft& draft, const Move_saddle& edit);
Result<void> apply_edit(Draft& draft, const Drag_contour& edit);
Result<void> apply_edit(Draft& draft, const Straighten_contour& edit);
Result<void> apply_edit(Draft& draft, const Snap_contour& edit);
Result<void> apply_edit(Draft& draft, const Subdivide_chart& edit);
Result<void> apply_edit(Draft& draft, const Remove_contour& edit);
Result<void> apply_edit(Draft& draft, const Align_saddles& edit);
Result<void> apply_edit(Draft& draft, const Collapse_chart& edit);
Result<void> apply_edit(Draft& draft, const Collapse_thin_charts& edit);
Result<void> apply_edit(Draft& draft, const Split_pole& edit);
Result<void> apply_edit(Draft& draft, const Move_corner& edit);
Result<void> apply_edit(Draft& draft, const Split_saddle& edit);
Result<void> apply_edit(Draft& draft, const Pin_corners& edit);
Result<void> apply_edit(Draft& draft, const Set_target& edit);
Result<void> apply_edit(Draft& draft, const Set_columns& edit);
Result<void> apply_edit(Draft& draft, const Set_rows& edit);
Result<void> apply_edit(Draft& draft, const Set_shift& edit);
Result<void> apply_edit(Draft& draft, const Set_grading& edit);
Result<void> apply_edit(Draft& draft, const Add_dislocation& edit);
Result<void> apply_edit(Draft& draft, const Remove_dislocation& edit);
Result<void> apply_edit(Draft& draft, const Balance_columns& edit);
Result<void> apply_edit(Draft& draft, const Lock_chart& edit);
Result<void> apply_edit(Draft& draft, const Align_layout& edit);
Result<void> apply_edit(Draft& draft, const Reset_texture& edit);
Result<void> apply_edit(Draft& draft, const Add_guide& edit);
Result<void> apply_edit(Draft& draft, const Move_guide& edit);
Result<void> apply_edit(Draft& draft, const Remove_guide& edit);

/// \name Textures
/// The design with other textures: contours and counts stay.
/// @{
Result<Design> with_texture(const Draft& draft, const Edit_texture& edit);
Result<Design> with_texture(const Draft& draft, const Drag_vertices& edit);
Result<Design> with_texture(const Draft& draft, const Relax_texture& edit);
Result<Design> with_texture(const Draft& draft, const Snap_vertices& edit);
Result<Design> with_texture(const Draft& draft, const Fit_texture& edit);
/// @}

/// \name Parts of edits
/// @{

/// The annulus at a point, if an edit may change its counts: it is not locked, and its texture the design's.
Result<int> free_annulus_at(const Draft& draft, const Surface_point& at);

/// Gives one side of an annulus its columns, and the chart dislocations for the difference. \pre The number
/// is one of columns, or 0, and the edit has a side.
Result<void> set_columns_of_side(Draft& draft, const Set_columns& edit);

/// One contour edge of two: a ends where b begins.
Contour_edge joined(Contour_edge a, const Contour_edge& b);

/// Designs some charts, which form one region around the vertex `inside`, anew with the extrema that lie in
/// it; the contours around the region stay. With `added`, that extremum gets the value at `strength` of the
/// way to where it breaks something.
Result<void> redesign_region(Draft& draft, const std::set<int>& charts, int inside, int added,
                             double strength);

/// Designs the whole surface anew with these extrema, and with the field constant on curves, which become
/// contours as they are. Minima and maxima of the caps of curves are added. Whether boundary loops are
/// maxima: an entry a loop.
Result<void> design_on_curves(Draft& draft, std::vector<Design_extremum> extrema,
                              const std::vector<Set_extrema::Sharp_curve>& curves,
                              const std::vector<bool>& boundary_is_maximum);

/// Whether each of the boundary loops is a maximum of the design as it is; empty where it has no charts.
std::vector<bool> present_boundary_kinds(const Draft& draft);

/// The order in which designs keep their extrema; no two share a vertex.
void sort_by_vertex(std::vector<Design_extremum>& extrema);

/// The charts that a field on the whole surface cuts it into; refused if it lacks one of its extrema.
Result<Reeb_layout> layout_of(const Draft& draft, const Designed_field& field);

/// A field on a chart whose level lines go around it, from 0 to 1: U of an annulus; between the walk and the
/// extremum of a disc.
Result<std::vector<double>> level_field(Draft& draft, int chart);

/// The design's field at the two ends of a chart.
std::array<double, 2> value_range(const Draft& draft, const Chart& chart);

/// Lets the field follow contours that have taken the place of edge `old`, and perhaps of others, in a trial
/// of the draft, on the whole surface: the new contours are level lines near them.
Result<void> enforce_by_field(Draft& draft, int old, const Draft& trial);

/// Splits a saddle of any multiplicity, also one that shares its contour with others.
Result<void> split_saddle_by_sectors(Draft& draft, int node, const Split_saddle& edit);

/// Moves a contour edge towards a plane where the plane itself cannot be the contour: it follows the plane as
/// far as its charts allow; if that is not far, other loops of its saddle and free loops beside its charts
/// give way. Refused if it would hardly follow the plane, with the contour that is in the way.
Result<void> move_towards_plane(Draft& draft, int edge, const Point& point, const Eigen::Vector3d& normal);

/// Moves a saddle all of whose contours are loops to a vertex in the charts around it; its loops go to planes
/// of their own, whose normals are those of the loops, or the one given.
Result<void> move_saddle_with_loops(Draft& draft, Node_id node, Vertex_index vertex,
                                    const Eigen::Vector3d& normal);

/// Draws the level line of a chart through a vertex of the surface inside it; returns the contour edge. The
/// draft is not cut.
Result<int> draw_level_line(Draft& draft, Chart_index chart, Vertex_index vertex);

/// The contour edge at a point, which an edit may remove: a free loop inside the surface.
Result<int> free_loop_at(const Draft& draft, const Surface_point& at);

/// What bounds a chart: its contour edges, in increasing order, and its extremum, or -1.
struct Chart_signature {
  std::vector<int> edges;
  int extremum = -1;
  bool operator==(const Chart_signature& o) const { return edges == o.edges && extremum == o.extremum; }
};

/// The signature of the chart on the left (0) or right (1) of a contour edge; edges in `names` go by these.
Chart_signature chart_beside(const Draft& draft, int edge, int side, const std::map<int, int>& names);

/// Puts a new polyline in the place of contour edge `old`, in the sense in which the same charts stay on its
/// left.
Result<void> replace_edge(Draft& draft, int old, Contour_edge fresh);

/// The sum of the normals of the triangles at a vertex, each as long as twice its area.
Eigen::Vector3d normal_at(const Triangle_surface& surface, int vertex);

/// The vertices of the surface around one that are within a distance of it, the nearest first.
std::vector<int> vertices_around(const Triangle_surface& surface, int vertex, double distance);

/// Fails unless every extremum has a cap: a contour of its own (a disc's corners would fall on saddles).
Result<void> check_caps(const Draft& draft);

/// The contour edge that passes a chart's extremum side and is a free loop: its cap; -1 if there is none.
int cap_contour(const Draft& draft, int chart);

/// @}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_EDITS_STEPS_H
