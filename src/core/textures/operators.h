// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_TEXTURES_OPERATORS_H
#define REEBQUAD_TEXTURES_OPERATORS_H

#include "textures/texture_draft.h"

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

/// Where the polychords of one texture end; its connectivity is found once. See `polychord_ends()`.
class Polychord_tracer {
public:
  /// The texture must outlive the tracer.
  explicit Polychord_tracer(const Quad_texture& texture);
  Polychord_tracer(const Polychord_tracer&) = delete;
  Polychord_tracer& operator=(const Polychord_tracer&) = delete;
  struct Strip {
    std::vector<Polychord_end> ends;
    int quads = 0; ///< that it crosses
  };
  Result<Strip> strip(const Insert_polychord& edit) const;

private:
  Texture_limits m_limits;
  Texture_draft m_draft;
  Result<void> m_connected;
};

/// The quads of places, each once, in increasing order.
Result<std::vector<int>> find_quads(const Quad_texture& texture, const std::vector<Texture_place>& places);

/// A vertex moved by the fraction `at` of the way to the mean of the middles of quads of its fan.
Plane_point inward(const Texture_draft& draft, int vertex, const std::vector<int>& quads, double at);

/// Replaces a quad by four around a new vertex, between the vertices `middle` of its edges.
void split_in_four(Texture_draft& draft, int quad, const std::array<int, 4>& middle);

/// Whether a fraction may lie strictly between two ends.
Result<void> check_fraction(double at);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_TEXTURES_OPERATORS_H
