// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_EDIT_H
#define CGAL_REEB_QUADRANGULATION_EDIT_H

#include <CGAL/Reeb_quadrangulation/Guide.h>
#include <CGAL/Reeb_quadrangulation/Pole_kind.h>
#include <CGAL/Reeb_quadrangulation/Surface_point.h>
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

/// \file
/// The edits of a design, as values. They name contours, charts and saddles by points on the surface, so that
/// a list of them (a recipe) also runs on another triangulation of the same shape.

namespace CGAL {
namespace Reeb_quadrangulation {

/// How far an edit of extrema reaches.
enum class Edit_scope : signed char {
  chart,  ///< only the charts around the extremum are designed anew; all other contours stay
  surface ///< the field is solved on the whole surface; edits of contours are lost
};

/// How a saddle becomes vertices.
enum class Saddle_kind : signed char {
  half,   ///< two vertices of valence 6, joined by a segment
  quarter ///< four vertices of valence 5 around a rectangle
};

/// What a closed line of sharp edges is for the field, which is constant on it.
enum class Sharp_curve_kind : signed char {
  minimum,        ///< the field rises on both sides
  maximum,        ///< it falls on both sides
  cap_of_minimum, ///< it falls through the line to a minimum in the middle of a face that the line bounds
                  ///< alone
  cap_of_maximum  ///< it rises to a maximum there
};

/// A side of an annulus: where the field is lower, where it is higher.
enum class Chart_side : signed char { both, low, high };

/// What makes the field follow a contour that the user has moved.
enum class Enforcement : signed char {
  contour, ///< the contour is cut into the surface; the charts beside it are mapped anew (default)
  field ///< the field is solved again on the whole surface with values around all contours of saddles (paper,
        ///< section 6.1)
};

/// \name Extrema
/// Points of extrema mean the nearest vertex, except those that name an existing extremum: the nearest one.
/// @{

/// What the field is on a boundary loop.
struct Boundary_value {
  Surface_point at;        ///< means the nearest loop
  bool is_maximum = false; ///< the field falls from the loop, or rises
  double value = -1;       ///< in [0, 1]; negative: 0 for a minimum, 1 for a maximum
};

/// Places extrema automatically and designs the whole field anew; see `suggest_extrema()`. Suggested extrema
/// that the field turns out not to have are left out.
struct Suggest {
  static constexpr const char* edit_name = "suggest";
  double persistence = 0.08;
  Eigen::Vector3d axis = Eigen::Vector3d(0, 0, 1);
  bool collapse_thin = false; ///< then does what `Collapse_thin_charts` does, before any count is chosen
  std::vector<Boundary_value> boundary{}; ///< of loops that are not as their height suggests
};
/// Places all extrema by hand and designs the whole field anew.
struct Set_extrema {
  static constexpr const char* edit_name = "set_extrema";
  struct Extremum {
    Surface_point at;
    bool is_maximum = false;
    double value = -1; ///< in [0, 1]; negative: 0 for a minimum, 1 for a maximum
  };
  std::vector<Extremum> extrema;
  /// A closed line of sharp edges that becomes a contour as it is: a loop around a face, a part of the
  /// surface that sharp edges bound. With `cap_of_minimum` or `cap_of_maximum` the face has no other loop;
  /// where the loop turns, the face itself becomes the cap of the extremum in its middle, with four corners
  /// there. Lines have no vertex in common.
  struct Sharp_curve {
    Surface_point face; ///< a point of the face
    Surface_point at;   ///< the loop of the face that is nearest to it
    Sharp_curve_kind kind = Sharp_curve_kind::maximum;
    double feature_angle = 45; ///< degrees
  };
  std::vector<Sharp_curve> curves{};
  /// Boundary loops are minima or maxima as in the design before, else as `Suggest` makes them with this
  /// axis.
  Eigen::Vector3d axis = Eigen::Vector3d(0, 0, 1);
  bool collapse_thin = false;             ///< see `Suggest`
  std::vector<Boundary_value> boundary{}; ///< of loops that are to change
};
/// Designs the whole surface by a function that is given, in place of a harmonic field: its extrema and its
/// critical contours are those of the design, see `design_function()`. Regular contours are the charts' own.
/// Edits that reach as far as `Edit_scope::surface` give a harmonic field again.
struct Set_field {
  static constexpr const char* edit_name = "set_field";
  /// One for each vertex of the surface that the session was begun with, `Editor::input()`: this edit alone
  /// belongs to a triangulation, and is refused on one with another number of vertices.
  std::vector<double> values;
  double persistence = 0;     ///< see `design_function()`
  bool collapse_thin = false; ///< see `Suggest`
};
/// Adds an extremum. In a chart its value is `strength`, in (0, 1), of the way to where it would break a
/// contour around it; if there is no room for it and its saddle at the vertex, it takes the nearest of some
/// vertices that are at most the length of a quad's edge away.
struct Add_extremum {
  static constexpr const char* edit_name = "add_extremum";
  Surface_point at;
  bool is_maximum = false;
  Edit_scope scope = Edit_scope::chart;
  double strength = 0.9;
};
/// In its charts: those around it, and as many more as the field needs to have a minimum and a maximum there.
struct Remove_extremum {
  static constexpr const char* edit_name = "remove_extremum";
  Surface_point at;
  Edit_scope scope = Edit_scope::chart;
};
struct Move_extremum {
  static constexpr const char* edit_name = "move_extremum";
  Surface_point from, to;
  Edit_scope scope = Edit_scope::chart;
};
/// Changes the value that the field has at an extremum, in [0, 1], and solves it again on the whole surface.
/// At a vertex on the boundary, of its loop: 0 makes it a minimum, 1 a maximum, and between it stays what it
/// is.
struct Change_value {
  static constexpr const char* edit_name = "change_value";
  Surface_point at;
  double value = 0;
};
/// @}

/// \name Contours
/// Points of contours mean the nearest contour.
/// @{

/// Moves a contour to the intersection of the surface with a plane. A loop at a saddle keeps its saddle: the
/// plane is shifted to go through it. With two `anchors` on the contour only the part between them that is
/// nearest to `at` moves, in the plane through both whose normal is nearest to the one given. Where the
/// plane's curve would meet other contours, the contour follows it as far as these and the extrema allow, or
/// other loops of the saddle and loops around the charts beside it give way; `Edit_report::followed` has the
/// share of its length that lies in the plane, and less than a fifth is refused. Enforced by the field, the
/// contour comes near the plane only, and all charts are new; caps go where the field has them.
struct Move_contour {
  static constexpr const char* edit_name = "move_contour";
  Surface_point at;
  Point plane_point = Point::Zero();
  Eigen::Vector3d plane_normal = Eigen::Vector3d(0, 0, 1);
  std::vector<Surface_point> anchors; ///< none or two
  Enforcement enforcement = Enforcement::contour;
};
/// Moves a saddle with all its contours at once: the saddle to a vertex in the charts around it, the contours
/// to the intersection of the surface with a plane through that vertex. It is the nearest one to `to`, at
/// most the length of a quad's edge away, where the plane meets the surface in as many curves as the saddle
/// has contours, as the touching plane does where the surface is a saddle itself. Contours to other saddles
/// end there as before, each in the plane through both whose normal is nearest. Where no such plane does, the
/// saddle goes to the vertex itself, if all its contours are loops: they follow a plane that is given as far
/// as others allow, else they are dragged along.
struct Move_saddle {
  static constexpr const char* edit_name = "move_saddle";
  Surface_point at, to;                                   ///< the saddle; where it goes, also the same point
  Eigen::Vector3d plane_normal = Eigen::Vector3d::Zero(); ///< zero: of the surface at `to`
};
/// Moves a contour without saddles to the level line through a vertex.
struct Drag_contour {
  static constexpr const char* edit_name = "drag_contour";
  Surface_point at, to;
};
/// Pulls a contour, or a loop of a saddle, as short as its charts allow; or a contour onto sharp edges near
/// it.
struct Straighten_contour {
  static constexpr const char* edit_name = "straighten_contour";
  Surface_point at;
};
struct Snap_contour {
  static constexpr const char* edit_name = "snap_contour";
  Surface_point at;
  double feature_angle = 45; ///< degrees
};
/// Draws the level line of a chart through a vertex as a new contour.
struct Subdivide_chart {
  static constexpr const char* edit_name = "subdivide_chart";
  Surface_point at;
};
/// Removes a contour without saddles; its two charts become one.
struct Remove_contour {
  static constexpr const char* edit_name = "remove_contour";
  Surface_point at;
};
/// Joins the saddles on both sides of a chart on one contour: the chart vanishes.
struct Align_saddles {
  static constexpr const char* edit_name = "align_saddles";
  Surface_point first, second; ///< two saddles on the two sides of one chart
};
struct Collapse_chart {
  static constexpr const char* edit_name = "collapse_chart";
  Surface_point at;
};
/// Collapses the annuli between saddles that are thinner than half a quad, the thinnest first, as long as
/// charts result.
struct Collapse_thin_charts {
  static constexpr const char* edit_name = "collapse_thin_charts";
};
/// @}

/// \name Fractional poles and saddles
/// @{

/// Splits the pole of an extremum. A half-pole's segment runs between `ends`; without ends, across the cap.
struct Split_pole {
  static constexpr const char* edit_name = "split_pole";
  Surface_point at;
  Pole_kind kind = Pole_kind::quarter;
  std::vector<Surface_point> ends; ///< none or two, for half-poles
};
/// Moves the corner of a cap that is nearest to `at` along its contour to the sample nearest to `to`; the
/// other three follow.
struct Move_corner {
  static constexpr const char* edit_name = "move_corner";
  Surface_point at, to;
};
/// Splits a saddle, also one that shares its contour with others. `points`, if given, are the new vertices of
/// half-saddles, one in each sector of one side of the contour; or the four corners of quarter-saddles on the
/// contours of a simple saddle that has its contour to itself. Degenerate saddles become simple ones first: a
/// monkey saddle becomes four vertices of valence 6 or eight of valence 5.
struct Split_saddle {
  static constexpr const char* edit_name = "split_saddle";
  Surface_point at;
  Saddle_kind kind = Saddle_kind::half;
  std::vector<Surface_point> points;
  double size =
      0; ///< without points: distance of the new vertices from the saddle; 0 = the length of a quad's edge
};
/// Makes the disc that passes half-saddles four times a rectangle with its corners there: the saddles become
/// regular.
struct Pin_corners {
  static constexpr const char* edit_name = "pin_corners";
  Surface_point at; ///< in the disc, or its extremum
};
/// @}

/// \name Counts and alignment
/// @{

/// Sets the size of all quads: by their number or their edges' length, whichever is positive.
struct Set_target {
  static constexpr const char* edit_name = "set_target";
  int quads = 0;
  double edge_length = 0;
};
/// Sets the number of columns around an annulus, or of rows across it; 0 = free. With a side, that side of
/// the annulus gets the columns while the other keeps what it has: dislocations make up the difference, and
/// those that are there already make way for others; 0 takes them all away.
struct Set_columns {
  static constexpr const char* edit_name = "set_columns";
  Surface_point at;
  int columns = 0;
  Chart_side side = Chart_side::both;
};
struct Set_rows {
  static constexpr const char* edit_name = "set_rows";
  Surface_point at;
  int rows = 0;
};
/// Ends columns of an annulus near a point, seen from its low side, or begins some: a pair of a vertex of
/// valence 3 and one of valence 5 for two columns or, in a row, for four or six; see dislocations.h. Where it
/// meets one of the opposite kind, at most two edges away, the two take away from each other what they have
/// in common.
struct Add_dislocation {
  static constexpr const char* edit_name = "add_dislocation";
  Surface_point at;
  int columns = -2; ///< more above than below: even, not 0, from -6 to 6
};
/// Takes away the dislocation of a chart that is nearest to a point.
struct Remove_dislocation {
  static constexpr const char* edit_name = "remove_dislocation";
  Surface_point at;
};
/// Chooses all counts anew, each contour as its length asks for, and lets dislocations make up the
/// difference where that pays: in annuli whose counts nobody has set and which have none yet.
struct Balance_columns {
  static constexpr const char* edit_name = "balance_columns";
  int most = 8;     ///< dislocations; where more would pay, columns that end or begin become dearer
  double price = 8; ///< of a column, see `Sampling_options::column_price`
};
/// Turns the upper contour of an annulus by columns eastward, beyond the best fit.
struct Set_shift {
  static constexpr const char* edit_name = "set_shift";
  Surface_point at;
  int shift = 0;
};
/// Makes the rows of an annulus denser at one end: the height of the uppermost over that of the lowest.
struct Set_grading {
  static constexpr const char* edit_name = "set_grading";
  Surface_point at;
  double ratio = 1;
};
/// A locked chart keeps its contours, counts and texture; edits that would change it are refused.
struct Lock_chart {
  static constexpr const char* edit_name = "lock_chart";
  Surface_point at;
  bool locked = true;
};
/// Brings extraordinary vertices in line, so that the base complex has few patches: chooses the shifts of
/// annuli, the corners of caps and the counts of contour edges anew, as long as that pays. Halving the number
/// of patches pays as much as a mean scaled Jacobian that is lower by `0.7 strength` costs, as it is told
/// from the shear of columns, the corners of caps and the counts that are not wished for. What locked charts
/// have stays; so do all counts where `counts` is 1.
struct Align_layout {
  static constexpr const char* edit_name = "align_layout";
  double strength = 0.002; ///< positive, at most 1
  double counts = 1.25;    ///< how far a count may go from what it was: the larger over the smaller, 1 to 4
  int tries = 40000;       ///< layouts that are tried; the same number gives the same design
};
/// @}

/// \name Guides
/// Strokes on the surface that quads follow, see `Guide`. Points of guides mean the nearest guide. Charts
/// keep their contours, counts and textures, but where a closed guide becomes a contour.
/// @{

/// Adds a guide. A closed one of strength 1 that is not to run along the flow becomes a contour of its own
/// where it goes around one chart, or takes the place of the contour without saddles that it would come too
/// near to; where it cannot, and along all other guides, lines of quads' edges are brought onto the stroke
/// when the quads are finished. `Edit_report::remark` says what it will do, and that a stroke is too short
/// to matter.
struct Add_guide {
  static constexpr const char* edit_name = "add_guide";
  Guide guide;
};
/// Gives a guide another stroke, open or closed as it is, or another strength.
struct Move_guide {
  static constexpr const char* edit_name = "move_guide";
  Surface_point at;
  std::vector<Point> points; ///< none: the stroke stays
  double strength = 0;       ///< 0: it stays
};
/// Removes a guide, and the contour that was drawn along it, if that is there still and may go.
struct Remove_guide {
  static constexpr const char* edit_name = "remove_guide";
  Surface_point at;
};
/// @}

/// \name Connectivity textures
/// Points mean the quad of a chart's texture that contains them, its edge or its vertex that is nearest in
/// the chart's map; all points of an edit lie in one chart. An edited texture stays as it is as long as the
/// chart's contours stay or are moved, whatever counts change around it: where charts then do not meet vertex
/// by vertex, `stitch_textures()` joins them. With `Edit_scope::surface` an edit of whole textures takes all
/// charts, and a polychord goes on through all charts until it closes.
/// @{

/// The operators of Texture_edit.h on the edges, quads or vertices at `points`.
enum class Texture_operator : signed char {
  subdivide,        ///< any point of the chart
  coarsen,          ///< any point of the chart
  insert_polychord, ///< an edge; `fraction`
  delete_polychord, ///< an edge; `fraction`
  inset_quads,      ///< quads: cube subdivision; `fraction`
  open_quad,        ///< two edges that meet; `fraction`
  close_quad,       ///< a corner of a quad, by a point of the quad near it; `fraction`
  rotate_edge,      ///< an edge, counterclockwise
  rotate_edge_back, ///< an edge, clockwise
  rotate_vertex,    ///< a vertex
  insert_doublet,   ///< a corner of a quad
  remove_doublet,   ///< a vertex
  delete_quads,     ///< quads
  restore_quads     ///< quads
};
struct Edit_texture {
  static constexpr const char* edit_name = "edit_texture";
  Texture_operator operation = Texture_operator::subdivide;
  std::vector<Surface_point> points;
  double fraction = 0.5;                ///< `at` of the operator; other operators have none
  Edit_scope scope = Edit_scope::chart; ///< of the first four operators
};
/// Moves inner vertices of a texture by the way from the first to `to`, on the surface, and those within a
/// brush's `radius` by less; then relaxes around them. See `Move_vertices`.
struct Drag_vertices {
  static constexpr const char* edit_name = "drag_vertices";
  std::vector<Surface_point> points;
  Surface_point to;
  double radius = 0; ///< on the surface; 0 moves the vertices alone
  Falloff falloff = Falloff::smooth;
  int rings = 2, steps = 0;
  std::vector<Surface_point> anchors{}; ///< vertices that stay
};
/// Relaxes the inner vertices within `radius` of a point, or of a whole texture if that is 0. See
/// `Relax_vertices`.
struct Relax_texture {
  static constexpr const char* edit_name = "relax_texture";
  Surface_point at;
  int steps = 10;
  double radius = 0;
  std::vector<Surface_point> anchors{};
  Edit_scope scope = Edit_scope::chart;
};
/// Moves each of the vertices onto the sharp edges: to the nearest corner of them that is at most half as far
/// as the next vertex, else to the nearest point.
struct Snap_vertices {
  static constexpr const char* edit_name = "snap_vertices";
  std::vector<Surface_point> points;
  double feature_angle = 45; ///< degrees
};
/// Gives a chart's texture edges on the sharp edges inside the chart: lines of edges that run along them,
/// then vertices near their corners and near them, and relaxes around these; see fit_texture.h. What lies on
/// sharp edges then stays there in the final relaxation.
struct Fit_texture {
  static constexpr const char* edit_name = "fit_texture";
  Surface_point at;
  double feature_angle = 45; ///< degrees
  Edit_scope scope = Edit_scope::chart;
};
/// Gives a chart a regular texture again.
struct Reset_texture {
  static constexpr const char* edit_name = "reset_texture";
  Surface_point at;
  Edit_scope scope = Edit_scope::chart;
};
/// @}

using Edit =
    std::variant<Suggest, Set_extrema, Set_field, Add_extremum, Remove_extremum, Move_extremum, Change_value,
                 Move_contour, Move_saddle, Drag_contour, Straighten_contour, Snap_contour, Subdivide_chart,
                 Remove_contour, Align_saddles, Collapse_chart, Collapse_thin_charts, Split_pole, Move_corner,
                 Split_saddle, Pin_corners, Set_target, Set_columns, Set_rows, Set_shift, Set_grading,
                 Add_dislocation, Remove_dislocation, Balance_columns, Lock_chart, Align_layout, Edit_texture,
                 Drag_vertices, Relax_texture, Snap_vertices, Reset_texture, Fit_texture, Add_guide,
                 Move_guide, Remove_guide>;

/// The name of an edit in recipes and messages: "subdivide_chart".
const char* name(const Edit& edit);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_EDIT_H
