// SPDX-License-Identifier: GPL-3.0-or-later
// Edit a connectivity texture: each edit gives a new value or a reason; undoing is keeping the values.
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>

#include <iostream>
#include <vector>

using namespace CGAL::Reeb_quadrangulation;

int main() {
  // An annulus of 8 x 3 quads. V goes around from 0 to 1, U up from 0 to 1.
  std::vector<Quad_texture> history{regular_annulus_texture(8, {0, 1.0 / 3, 2.0 / 3, 1})};

  const std::vector<Texture_edit> edits{
      Insert_polychord{{0.5, 0.5}, 0.5}, // around: through the edge nearest to (0.5, 0.5) and its opposites
      Inset_quads{{{0.30, 0.4}, {0.40, 0.4}}}, // a box on two quads
      Rotate_vertex{{0.875, 0.66}},
      Delete_polychord{{0.1, 0.001}}, // a column, from the lower side to the upper
      Close_quad{{0.05, 0.1}},
      Subdivide_texture{},
      Delete_polychord{{0.3, 0.2}, 2}, // refused: 2 is no fraction
      Relax_vertices{}};
  for (const Texture_edit& edit : edits) {
    const Result<Edited_texture> result = edit_texture(history.back(), edit);
    if (!result) {
      std::cout << name(edit) << " refused: " << result.error().message << "\n";
      continue;
    }
    history.push_back(result->texture);
    std::cout << name(edit) << ": " << result->texture.quads.size() << " quads, sides of "
              << result->texture.sides[0].size() << " and " << result->texture.sides[1].size() << "\n";
  }

  // The last state is still a tiling of the cylinder; the first is what it was.
  const bool valid = bool(check_texture_plane(history.back()));
  std::cout << (valid ? "every quad is counterclockwise" : "a quad is inverted") << "\n";
  return valid && history.front().quads.size() == 24 && history.size() == edits.size() ? 0 : 1;
}
