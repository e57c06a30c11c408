// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_TEXTURE_EDIT_H
#define CGAL_REEB_QUADRANGULATION_TEXTURE_EDIT_H

/// \file
/// Edits of a connectivity texture, as values, and their application: texture in, texture out.
///
/// The operators are those of section 7.1 of the paper; polychord and quadrilateral collapse are defined by
/// Daniels, Silva, Shepherd and Cohen, "Quadrilateral Mesh Simplification" (2008); edge and vertex rotation,
/// doublets and singlets by Tarini, Pietroni, Cignoni, Panozzo and Puppo, "Practical Quad Mesh
/// Simplification" (2010).

#include <CGAL/Reeb_quadrangulation/Texture_place.h>

#include <variant>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Splits every quad into four at the middles of its edges. Every side gets twice as many vertices.
struct Subdivide_texture {};

/// The reverse: joins fours of quads again where the texture has the connectivity of a subdivided one. Which
/// vertices stay is decided by entry 0 of the first side: it does.
struct Coarsen_texture {};

/// Splits the strip of quads that opposite edges make with `edge`, each cross edge at the fraction `at` in
/// (0, 1) from the first end of `edge`. Where the strip ends on a side, the side gets a vertex. A quad that
/// the strip crosses twice becomes four.
struct Insert_polychord {
  Texture_place edge;
  double at = 0.5;
};

/// Collapses the strip: the ends of each cross edge become one vertex at the fraction `at` in [0, 1] between
/// them. A side vertex keeps its place; of two side vertices the one stays that is kept (see
/// `Texture_limits`), else the one nearer to `at`.
struct Delete_polychord {
  Texture_place edge;
  double at = 0.5;
};

/// Cube subdivision: insets a region of quads as one face of a cube, surrounded by a ring of new quads. Each
/// edge of the region's border moves inward by `at` in (0, 1) of the way to the middle of its quad. The sides
/// do not change. Undone by `Delete_polychord` of the ring.
struct Inset_quads {
  std::vector<Texture_place> quads;
  double at = 0.5;
};

/// Opens a new quad along two edges that meet in a vertex: the vertex becomes two, which move apart by up to
/// `at` in (0, 1) of the way to the middle of their quads, less if quads would invert. A side vertex stays
/// where it is. Undone by `Close_quad`.
struct Open_quad {
  Texture_place first, second;
  double at = 0.5;
};

/// Collapses a quad along the diagonal from `corner`: its two ends become one vertex at the fraction `at` in
/// [0, 1], or where the one is that lies on a side. Where that would leave a singlet, a vertex of one edge
/// with a quad folded around it, both are removed, here and in `Delete_polychord`: no texture ever has one.
struct Close_quad {
  Texture_place corner;
  double at = 0.5;
};

/// Turns an inner edge by one corner in the hexagon of its two quads. Undone by the other direction.
struct Rotate_edge {
  Texture_place edge;
  bool counterclockwise = true;
};

/// Turns the fan of an inner vertex: its edges go to the opposite corners of its quads instead of the
/// neighbours. Undone by itself.
struct Rotate_vertex {
  Texture_place vertex;
};

/// Splits a quad by a path over a new vertex in the middle of the diagonal from `corner`. Undone by
/// `Remove_doublet`.
struct Insert_doublet {
  Texture_place corner;
};

/// Removes an inner vertex of two quads, which become one.
struct Remove_doublet {
  Texture_place vertex;
};

/// Makes holes: the quads stay in the texture, but not in the mesh. Refused where that would leave a vertex
/// whose quads are not one fan.
struct Delete_quads {
  std::vector<Texture_place> quads;
};

/// The reverse of `Delete_quads`.
struct Restore_quads {
  std::vector<Texture_place> quads;
};

/// How the displacement fades from the moved vertices to the brush's radius.
enum class Falloff { constant, linear, smooth };

/// Moves inner vertices by (dv, du), those within the brush's `radius` of them by less, then relaxes. No quad
/// is inverted: a vertex goes as far as it can. Side vertices and anchors stay.
struct Move_vertices {
  std::vector<Texture_place> vertices;
  double dv = 0, du = 0;
  double radius = 0; ///< in units of U; 0 moves the vertices alone
  double aspect = 1; ///< the length of a unit of V in units of U, for the brush
  Falloff falloff = Falloff::smooth;
  int rings = 2; ///< the neighbours relaxed: within so many edges of the vertices moved
  int steps = 0; ///< of relaxation
  std::vector<Texture_place> anchors;
};

/// Relaxes inner vertices towards even spacing and parallel opposite edges; an empty region stands for all.
struct Relax_vertices {
  std::vector<Texture_place> vertices;
  int steps = 10;
  std::vector<Texture_place> anchors;
};

using Texture_edit =
    std::variant<Subdivide_texture, Coarsen_texture, Insert_polychord, Delete_polychord, Inset_quads,
                 Open_quad, Close_quad, Rotate_edge, Rotate_vertex, Insert_doublet, Remove_doublet,
                 Delete_quads, Restore_quads, Move_vertices, Relax_vertices>;

/// The name of an edit, as recipes and messages have it: "insert_polychord".
const char* name(const Texture_edit& edit);

/// What an edit must not take away.
struct Texture_limits {
  /// Per side, the entries whose vertices must stay: the contours' nodes. Entry 0 of an annulus' sides, and
  /// the four corners of a disc's rectangle, always stay.
  std::vector<std::vector<int>> kept;
};

/// The texture after an edit.
struct Edited_texture {
  Quad_texture texture;
  /// Per side, where each of its vertices was in steps of the side before: i for what was its entry i, i +
  /// 0.5 for a new vertex in the middle between entries i and i + 1. Increasing.
  std::vector<std::vector<double>> side_steps;
};

/// Applies an edit to a texture, and leaves it alone: deterministic, O(Q). Fails with `refused_edit`, the
/// reason and the element (a vertex or a face of `texture`) where the edit does not apply, would take away a
/// side vertex that must stay, would give an annulus an edge from side to side, or would invert a quad in the
/// plane (see `check_texture_plane()`).
Result<Edited_texture> edit_texture(const Quad_texture& texture, const Texture_edit& edit,
                                    const Texture_limits& limits = {});

/// Where a polychord ends on a side: between entries `step` and `step` + 1, at `fraction` of the way.
struct Polychord_end {
  int side = 0, step = 0;
  double fraction = 0.5;
};

/// Where the strip through `edge` leaves the texture: two ends, or none if it closes. The first is the one
/// that lies to the left of `edge`, from its first vertex to its second. To carry an insertion into the
/// neighbour, insert there from `side_edge()` at the same place of the contour.
Result<std::vector<Polychord_end>> polychord_ends(const Quad_texture& texture, const Insert_polychord& edit);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_TEXTURE_EDIT_H
