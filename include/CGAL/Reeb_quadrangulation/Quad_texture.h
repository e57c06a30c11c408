// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_H
#define CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_H

#include <CGAL/Reeb_quadrangulation/Chart_locator.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A connectivity texture: a quad mesh of a chart's parameter domain.
///
/// On an annulus a vertex has V in [0, 1) around and U in [0, 1] up; a quad may step over V = 1. On a disc, V
/// is in [0, a] and U in [0, b]. Quads are counterclockwise in the (V, U) plane, hence on the surface seen
/// from outside.
struct Quad_texture {
  std::vector<double> v, u; ///< per vertex
  std::vector<Quad> quads;
  /// The vertices on each walk of the chart, in the order of `Chart::walks` and eastward like them; entry 0
  /// is V = 0 on an annulus, the corner (0, 0) on a disc.
  std::vector<std::vector<int>> sides;
  /// Per quad: 1 if it is a hole, in the texture but not in the mesh. Empty if there is none.
  std::vector<char> holes;

  bool is_hole(int quad) const { return !holes.empty() && holes[quad]; }
};

/// The U of `rows + 1` level lines, from 0 to 1, that cut an annulus into rows of equal height.
std::vector<double> equal_rows(const Height_profile& profile, int rows);

/// `columns` x `levels.size() - 1` quads; `levels` are the rows' U from 0 to 1.
Quad_texture regular_annulus_texture(int columns, const std::vector<double>& levels);

/// a x b quads. The side runs counterclockwise, or clockwise if `clockwise` (the walk of a minimum's disc).
Quad_texture regular_disc_texture(int a, int b, bool clockwise);

/// How the textures of charts are made; an empty function stands for the default. `texture_maker()` makes one
/// from a model of `QuadTextureTraits`, where it is told what the functions must do.
struct Texture_maker {
  std::function<std::vector<double>(const Height_profile& profile, int rows)> levels; ///< `equal_rows`
  std::function<Quad_texture(int columns, const std::vector<double>& levels)>
      annulus;                                                    ///< `regular_annulus_texture`
  std::function<Quad_texture(int a, int b, bool clockwise)> disc; ///< `regular_disc_texture`
};

/// Checks that a texture is a quad mesh of an annulus (`samples` has two entries, LOW and HIGH) or a disc
/// (one) whose boundary is its sides, of as many vertices as `samples` says, with finite parameters. Fails
/// with `impossible_request` and the reason. O(Q log Q). A disc's side runs clockwise if `clockwise`.
Result<void> check_texture(const Quad_texture& texture, const std::vector<int>& samples, bool clockwise);

/// Finds the places with the given parameters by a `Chart_locator` that is built for them alone: O(F + n).
std::vector<Chart_location> locate(const Chart& chart, const Chart_parameterization& map,
                                   const std::vector<double>& v, const std::vector<double>& u);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUAD_TEXTURE_H
