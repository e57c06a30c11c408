// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_TRAITS_H
#define CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_TRAITS_H

#include <CGAL/Reeb_quadrangulation/place_texture.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The default model of `QuadTextureTraits`: regular grids, rows of equal height on the surface.
struct Quad_texture_traits {
  struct Compute_row_levels {
    std::vector<double> operator()(const Height_profile& profile, int rows) const {
      return equal_rows(profile, rows);
    }
  };
  struct Make_annulus_texture {
    Quad_texture operator()(int columns, const std::vector<double>& levels) const {
      return regular_annulus_texture(columns, levels);
    }
  };
  struct Make_disc_texture {
    Quad_texture operator()(int a, int b, bool clockwise) const {
      return regular_disc_texture(a, b, clockwise);
    }
  };

  Compute_row_levels compute_row_levels_object() const { return {}; }
  Make_annulus_texture make_annulus_texture_object() const { return {}; }
  Make_disc_texture make_disc_texture_object() const { return {}; }
};

/// A model of `QuadTextureTraits` as a value: what `Quadrangulation_options::textures` and `place_annulus()`
/// take. The functors are copied.
template <class QuadTextureTraits> Texture_maker texture_maker(const QuadTextureTraits& traits) {
  const typename QuadTextureTraits::Compute_row_levels levels = traits.compute_row_levels_object();
  const typename QuadTextureTraits::Make_annulus_texture annulus = traits.make_annulus_texture_object();
  const typename QuadTextureTraits::Make_disc_texture disc = traits.make_disc_texture_object();
  Texture_maker maker;
  maker.levels = [levels](const Height_profile& profile, int rows) { return levels(profile, rows); };
  maker.annulus = [annulus](int columns, const std::vector<double>& u) { return annulus(columns, u); };
  maker.disc = [disc](int a, int b, bool clockwise) { return disc(a, b, clockwise); };
  return maker;
}

/// Fills one chart: `place_annulus()` or `place_disc()` with the textures of `traits`; `grid` is the chart's
/// entry of `Sampling::grid`. Fails with `impossible_request` if the texture does not fit the chart, see
/// `check_texture()`.
template <class QuadTextureTraits = Quad_texture_traits>
Result<Placed_texture> place_texture(const Chart& chart, const Contour_samples& samples,
                                     const std::array<int, 2>& grid, Chart_parameterization& map,
                                     const QuadTextureTraits& traits = QuadTextureTraits()) {
  const Texture_maker maker = texture_maker(traits);
  return chart.kind == Chart_kind::annulus ? place_annulus(chart, samples, grid[1], map, maker)
                                           : place_disc(chart, samples, grid[0], grid[1], map, maker);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_TRAITS_H
