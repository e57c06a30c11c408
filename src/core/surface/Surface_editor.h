// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SURFACE_SURFACE_EDITOR_H
#define REEBQUAD_SURFACE_SURFACE_EDITOR_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Local changes of a connected surface in place, each in time proportional to the vertex stars it touches.
/// The arrays `opposite` and `outgoing` stay right; after a collapse call `compact()` before other use.
class Surface_editor {
public:
  explicit Surface_editor(Triangle_surface& surface) : m_surface(surface) {}

  bool is_boundary_vertex(int v) const { return m_surface.is_boundary(m_surface.outgoing[v]); }
  bool are_adjacent(int v, int w) const;
  int degree(int v) const; ///< number of faces

  /// Whether the edge of `h` can be flipped: interior, its other diagonal is no edge and no chord of the
  /// boundary, and its ends keep enough faces. Only combinatorics.
  bool can_flip(int h) const;
  /// The other diagonal of the two faces of `h`. \pre `can_flip(h)`
  void flip(int h);

  /// Splits the edge of `h` at `p`; one new face on each side. Returns the new vertex. `h` keeps its source.
  int split_edge(int h, const Point& p);
  /// Splits a face in three. Returns the new vertex.
  int split_face(int f, const Point& p);

  /// Whether moving `source(h)` into `target(h)` keeps the surface a manifold of the same topology.
  bool can_collapse(int h) const;
  /// Moves `source(h)` into `target(h)`; its faces become {-1, -1, -1}. \pre `can_collapse(h)`
  void collapse(int h);
  bool is_dead(int f) const { return m_surface.triangles[f][0] < 0; }

  /// Removes dead faces and vertices without face. Returns the new index of each vertex, -1 for removed ones.
  std::vector<int> compact();

private:
  void link(int h, int g);
  void fix_outgoing(int v, int h);
  int add_vertex(const Point& p);
  int add_face(const Triangle& t);

  Triangle_surface& m_surface;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SURFACE_SURFACE_EDITOR_H
