// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_TEXTURE_PLACE_H
#define CGAL_REEB_QUADRANGULATION_TEXTURE_PLACE_H

#include <CGAL/Reeb_quadrangulation/Quad_texture.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Names a vertex, an edge or a quad of a texture: by a point of the parameter domain, which is what recipes
/// keep since it survives other edits; or by a quad and a corner, if `quad` is not negative.
///
/// The quad is the one that contains the point. The edge is the one of the quad that spans the smallest
/// triangle with the point: it runs counterclockwise around the quad, from `corner` to the next. The vertex
/// is the corner whose two edges span the smallest triangles. In a quad with a straight or reflex corner
/// these are the edges and corners of the one of the two triangles with the point that the diagonal from
/// there cuts it into, so that they too can all be named. All of this is the same after an affine map of the
/// domain.
struct Texture_place {
  double v = 0, u = 0;
  int quad = -1, corner = 0;
};

/// An edge or a vertex of a texture: a quad, and the corner where it begins.
struct Quad_corner {
  int quad = -1, corner = 0;
};

/// Finds the quad of a place; its corner is the place's or 0. Fails with `refused_edit` if no quad contains
/// the point. Exact; O(Q) for a point, and of two quads that share the point the first.
Result<Quad_corner> find_quad(const Quad_texture& texture, const Texture_place& place);

/// Finds the edge of a place.
Result<Quad_corner> find_edge(const Quad_texture& texture, const Texture_place& place);

/// Finds the vertex of a place, as a corner of the place's quad.
Result<Quad_corner> find_vertex(const Quad_texture& texture, const Texture_place& place);

/// The edge between entries `step` and `step` + 1 of a side. It runs like the side or against it. O(Q). \pre
/// The side has the step.
Quad_corner side_edge(const Quad_texture& texture, int side, int step);

/// A place by a point that names the quad.
Texture_place quad_place(const Quad_texture& texture, int quad);

/// A place by a point that names the edge, counterclockwise around the same quad.
Texture_place edge_place(const Quad_texture& texture, const Quad_corner& edge);

/// A place by a point that names the vertex.
Texture_place vertex_place(const Quad_texture& texture, const Quad_corner& vertex);

/// Checks a texture in the plane: every quad is a simple polygon, counterclockwise: one of its diagonals
/// splits it into two counterclockwise triangles, by exact predicates. So a corner may be straight or reflex,
/// as the corner of a doublet always is, but no two edges cross or touch. Since the quads' boundary is that
/// of the domain, such quads tile the domain: they cover every point once.
///
/// On an annulus V is taken to the nearest multiple of 2^-52 (there V + 1 is exact), and each edge is the
/// shorter way around; an edge of half a turn is refused. Fails with `refused_edit` and the first quad that
/// is not as it should be. O(Q).
Result<void> check_texture_plane(const Quad_texture& texture);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_TEXTURE_PLACE_H
