// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_TEXTURES_TEXTURE_DRAFT_H
#define REEBQUAD_TEXTURES_TEXTURE_DRAFT_H

#include "base/quad_connectivity.h"
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>

#include "textures/texture_plane.h"

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

inline Error refused(std::string message, Element_kind kind = Element_kind::none, int index = -1) {
  return make_error(Error_code::refused_edit, std::move(message), kind, index);
}

/// A texture with its connectivity, while an operator changes it. The operator reads the texture as it was,
/// and notes what it removes, adds, merges and moves; `finish()` carries that out and checks the result.
class Texture_draft {
public:
  Texture_draft(const Quad_texture& texture, const Texture_limits& limits,
                const Observer* observer = nullptr);

  /// Must succeed before anything else is asked. Fails if the texture is not a quad mesh with these sides.
  Result<void> connect();

  const Quad_texture& before() const { return m_before; }
  bool is_cancelled() const { return m_observer && m_observer->cancelled(); }
  const Texture_plane& plane() const { return m_plane; }
  int opposite(int h) const { return m_opposite[h]; }
  int source(int h) const { return internal::source(m_before.quads, h); }
  int target(int h) const { return internal::target(m_before.quads, h); }
  Plane_point point(int vertex) const { return {m_after.v[vertex], m_after.u[vertex]}; }
  /// The side of a vertex, or -1 inside.
  int side(int vertex) const { return m_side[vertex]; }
  bool is_inside(int vertex) const { return m_side[vertex] < 0; }
  /// Whether a side vertex must stay.
  bool is_kept(int vertex) const { return m_kept[vertex]; }
  /// The halfedges that leave the source of h, counterclockwise; at a side vertex from the one along the
  /// side.
  std::vector<int> fan(int h) const;

  int add_vertex(const Plane_point& p);
  void move_vertex(int vertex, const Plane_point& p);
  void remove_quad(int quad) { m_removed[quad] = 1; }
  /// Adds a quad; it is a hole if `parent` is.
  void add_quad(const Quad& quad, int parent);
  void set_hole(int quad, bool hole) { m_hole[quad] = hole; }
  bool is_hole(int quad) const { return m_hole[quad] != 0; }
  /// Whether a quad of vertices as they are now is valid in the plane.
  bool is_valid(const Quad& quad) const { return m_plane.is_valid(m_after.v, m_after.u, quad); }
  /// Puts a new vertex on a side, at a fraction of the way along the side edge from a to b.
  void split_side_edge(int a, int b, int vertex, double fraction);
  /// Makes one vertex of two: both become `keep`.
  void merge(int keep, int gone);
  /// The vertex that a vertex has become.
  int merged(int vertex) const;
  /// Renames the merged vertices and removes quads folded to a singlet.
  void remove_folded_quads();

  Result<Edited_texture> finish();

private:
  struct Side_entry {
    double step;
    int vertex;
  };

  Result<void> find_sides();
  void keep_limits();
  void compress(std::vector<char>& changed);
  Result<void> check(const std::vector<char>& changed) const;

  const Quad_texture& m_before;
  const Observer* m_observer;
  const Texture_limits& m_limits;
  Texture_plane m_plane;
  std::vector<int> m_opposite;
  std::vector<int> m_side;   ///< per vertex
  std::vector<int> m_entry;  ///< per vertex: its entry in its side
  std::vector<char> m_kept;  ///< per vertex
  std::vector<char> m_moved; ///< per vertex: moved, new or merged
  std::vector<int> m_name;   ///< per vertex: merged into
  std::vector<char> m_removed, m_added, m_hole;
  std::vector<std::vector<Side_entry>> m_sides;
  Quad_texture m_after;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_TEXTURES_TEXTURE_DRAFT_H
