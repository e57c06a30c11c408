// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_QUAD_CONNECTIVITY_H
#define REEBQUAD_BASE_QUAD_CONNECTIVITY_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Halfedge `h = 4 q + i` runs from `quads[q][i]` to `quads[q][(i + 1) % 4]`, with quad q on its left.
inline int quad_of(int h) {
  return h / 4;
}
inline int next(int h) {
  return (h & ~3) | ((h + 1) & 3);
}
inline int across(int h) {
  return (h & ~3) | ((h + 2) & 3);
}
inline int previous(int h) {
  return (h & ~3) | ((h + 3) & 3);
}
inline int source(const std::vector<Quad>& quads, int h) {
  return quads[h / 4][h & 3];
}
inline int target(const std::vector<Quad>& quads, int h) {
  return quads[h / 4][(h + 1) & 3];
}

/// The opposite halfedge of each, or -1 on the boundary. Returns the first quad with an edge that another
/// quad passes in the same direction or that joins a vertex to itself, or -1 if there is none. O(Q) where
/// valences are bounded.
int connect_quads(const std::vector<Quad>& quads, int number_of_vertices, std::vector<int>& opposite);

/// A quad that names a vertex twice, whose edge another passes in the same direction, or at a vertex whose
/// quads are not one fan; -1 if the quads are a manifold. O(Q).
int find_fault(const std::vector<Quad>& quads, int number_of_vertices);

/// The Euler characteristic and the number of boundary loops of each component of manifold quads. O(Q). \pre
/// `connect_quads()` succeeds.
std::vector<std::pair<int, int>> quad_components(const std::vector<Quad>& quads, int number_of_vertices);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_QUAD_CONNECTIVITY_H
