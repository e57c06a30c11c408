// SPDX-License-Identifier: GPL-3.0-or-later
// A model of QuadTextureTraits that has what the concept lists and nothing else: regular grids with twice the
// rows.
#ifndef REEBQUAD_TEST_TEXTURE_TRAITS_ARCHETYPE_H
#define REEBQUAD_TEST_TEXTURE_TRAITS_ARCHETYPE_H

#include <CGAL/Reeb_quadrangulation/Quad_texture.h>

#include <vector>

namespace archetype {

class Texture_traits {
public:
  class Compute_row_levels {
  public:
    explicit Compute_row_levels(int factor) : m_factor(factor) {}
    Compute_row_levels(const Compute_row_levels&) = default;
    Compute_row_levels& operator=(const Compute_row_levels&) = delete;
    std::vector<double> operator()(const CGAL::Reeb_quadrangulation::Height_profile& profile,
                                   int rows) const {
      return CGAL::Reeb_quadrangulation::equal_rows(profile, m_factor * rows);
    }

  private:
    int m_factor;
  };
  class Make_annulus_texture {
  public:
    explicit Make_annulus_texture(int) {}
    Make_annulus_texture(const Make_annulus_texture&) = default;
    Make_annulus_texture& operator=(const Make_annulus_texture&) = delete;
    CGAL::Reeb_quadrangulation::Quad_texture operator()(int columns,
                                                        const std::vector<double>& levels) const {
      return CGAL::Reeb_quadrangulation::regular_annulus_texture(columns, levels);
    }
  };
  class Make_disc_texture {
  public:
    explicit Make_disc_texture(int) {}
    Make_disc_texture(const Make_disc_texture&) = default;
    Make_disc_texture& operator=(const Make_disc_texture&) = delete;
    CGAL::Reeb_quadrangulation::Quad_texture operator()(int a, int b, bool clockwise) const {
      return CGAL::Reeb_quadrangulation::regular_disc_texture(a, b, clockwise);
    }
  };

  explicit Texture_traits(int factor) : m_factor(factor) {}
  Texture_traits(const Texture_traits&) = default;
  Texture_traits& operator=(const Texture_traits&) = delete;
  Compute_row_levels compute_row_levels_object() const { return Compute_row_levels(m_factor); }
  Make_annulus_texture make_annulus_texture_object() const { return Make_annulus_texture(0); }
  Make_disc_texture make_disc_texture_object() const { return Make_disc_texture(0); }

private:
  int m_factor;
};

} // namespace archetype

#endif // REEBQUAD_TEST_TEXTURE_TRAITS_ARCHETYPE_H
