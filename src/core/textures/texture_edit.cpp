// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>

#include "textures/observed_edit.h"
#include "textures/operators.h"

#include <array>

namespace CGAL {
namespace Reeb_quadrangulation {

const char* name(const Texture_edit& edit) {
  // In the order of the variant.
  static const std::array<const char*, std::variant_size_v<Texture_edit>> names{
      "subdivide_texture", "coarsen_texture", "insert_polychord", "delete_polychord", "inset_quads",
      "open_quad",         "close_quad",      "rotate_edge",      "rotate_vertex",    "insert_doublet",
      "remove_doublet",    "delete_quads",    "restore_quads",    "move_vertices",    "relax_vertices"};
  return names[edit.index()];
}

Result<Edited_texture> edit_texture(const Quad_texture& texture, const Texture_edit& edit,
                                    const Texture_limits& limits) {
  return internal::edit_observed(texture, edit, limits, nullptr);
}

namespace internal {

Result<Edited_texture> edit_observed(const Quad_texture& texture, const Texture_edit& edit,
                                     const Texture_limits& limits, const Observer* observer) {
  Texture_draft draft(texture, limits, observer);
  if (Result<void> connected = draft.connect(); !connected) return connected.error();
  const Result<void> drawn = std::visit([&](const auto& operation) { return draw(draft, operation); }, edit);
  if (!drawn) return drawn.error();
  return draft.finish();
}

} // namespace internal

} // namespace Reeb_quadrangulation
} // namespace CGAL
