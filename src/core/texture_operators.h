// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SRC_TEXTURE_OPERATORS_H
#define CGAL_REEB_QUADRANGULATION_SRC_TEXTURE_OPERATORS_H

#include "texture_draft.h"

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// One function an operator: notes in the draft what the edit changes. \pre The draft is connected.
Result<void> draw(Texture_draft& draft, const Subdivide_texture& edit);
Result<void> draw(Texture_draft& draft, const Coarsen_texture& edit);
Result<void> draw(Texture_draft& draft, const Insert_polychord& edit);
Result<void> draw(Texture_draft& draft, const Delete_polychord& edit);
Result<void> draw(Texture_draft& draft, const Inset_quads& edit);
Result<void> draw(Texture_draft& draft, const Open_quad& edit);
Result<void> draw(Texture_draft& draft, const Close_quad& edit);
Result<void> draw(Texture_draft& draft, const Rotate_edge& edit);
Result<void> draw(Texture_draft& draft, const Rotate_vertex& edit);
Result<void> draw(Texture_draft& draft, const Insert_doublet& edit);
Result<void> draw(Texture_draft& draft, const Remove_doublet& edit);
Result<void> draw(Texture_draft& draft, const Delete_quads& edit);
Result<void> draw(Texture_draft& draft, const Restore_quads& edit);
Result<void> draw(Texture_draft& draft, const Move_vertices& edit);
Result<void> draw(Texture_draft& draft, const Relax_vertices& edit);

/// The halfedge that begins at a corner.
inline int halfedge(const Quad_corner& c) {
  return 4 * c.quad + c.corner;
}

/// The quads of places, each once, in increasing order.
Result<std::vector<int>> find_quads(const Quad_texture& texture, const std::vector<Texture_place>& places);

/// A vertex moved by the fraction `at` of the way to the mean of the middles of quads of its fan.
Plane_point inward(const Texture_draft& draft, int vertex, const std::vector<int>& quads, double at);

/// Whether a fraction may lie strictly between two ends.
Result<void> check_fraction(double at);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SRC_TEXTURE_OPERATORS_H
