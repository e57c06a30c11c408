// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PLACE_TEXTURE_H
#define CGAL_REEB_QUADRANGULATION_PLACE_TEXTURE_H

#include <CGAL/Reeb_quadrangulation/Placed_texture.h>
#include <CGAL/Reeb_quadrangulation/dislocations.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What the user decides about a chart's texture.
struct Texture_placement {
  /// A dislocation by the place on the chart where it is to lie.
  struct Dislocation_at {
    Chart_location at;
    int columns = -2; ///< see `Dislocation::columns`
  };
  int shift = 0;      ///< annulus: columns by which the HIGH walk is turned east, beyond the best fit
  double grading = 1; ///< annulus: height of the uppermost row over that of the lowest, positive
  int corner = -1;    ///< disc: the sample of the walk where the corner (0, 0) lies; -1 = the best fit
  std::vector<Dislocation_at> dislocations{}; ///< annulus
};

/// The U of `rows + 1` level lines whose rows' heights grow geometrically by `grading` from the first to the
/// last.
std::vector<double> graded_rows(const Height_profile& profile, int rows, double grading);

/// How many columns the HIGH walk of an annulus is to be turned east, so that V fits the natural V best: not
/// a whole number.
double best_turn(const Chart& chart, const Contour_samples& samples, const Chart_parameterization& map);

/// Solves V of an annulus for the samples, turning the HIGH walk by the whole number of columns that fits the
/// natural V best, and fills it with `rows` rows of equal height, or as `maker` does; with dislocations as
/// `dislocated_annulus_texture()` does, evened out on the surface. A texture that does not fit is an
/// `impossible_request`. \pre The walks differ by as many samples as the dislocations have columns.
Result<Placed_texture> place_annulus(const Chart& chart, const Contour_samples& samples, int rows,
                                     Chart_parameterization& map, const Texture_maker& maker = {},
                                     const Texture_placement& placement = {});

/// Of the corners of a cap with the samples: twice the area of the quadrilateral that they span if the first
/// is sample 0, 1, ..., for as many as are different.
std::vector<double> areas_between_corners(const Chart& chart, const Contour_samples& samples);

/// Maps a disc to a x b, its corners where they span the largest quadrilateral, and fills it regularly, or as
/// `maker` does.
Result<Placed_texture> place_disc(const Chart& chart, const Contour_samples& samples, int a, int b,
                                  Chart_parameterization& map, const Texture_maker& maker = {},
                                  const Texture_placement& placement = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PLACE_TEXTURE_H
