// SPDX-License-Identifier: GPL-3.0-or-later
// fails with: Make_disc_texture
// A traits class of textures without textures for discs.
#include <CGAL/Reeb_quadrangulation/Quad_texture_traits.h>

namespace RQ = CGAL::Reeb_quadrangulation;

struct Traits {
  using Compute_row_levels = RQ::Quad_texture_traits::Compute_row_levels;
  using Make_annulus_texture = RQ::Quad_texture_traits::Make_annulus_texture;
  Compute_row_levels compute_row_levels_object() const { return {}; }
  Make_annulus_texture make_annulus_texture_object() const { return {}; }
#ifndef REEBQUAD_LEAVE_OUT
  using Make_disc_texture = RQ::Quad_texture_traits::Make_disc_texture;
  Make_disc_texture make_disc_texture_object() const {
    return {};
  }
#endif
};

RQ::Texture_maker maker() {
  return RQ::texture_maker(Traits());
}
