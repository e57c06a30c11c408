// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CHART_TEXTURE_EDIT_H
#define CGAL_REEB_QUADRANGULATION_CHART_TEXTURE_EDIT_H

#include <CGAL/Reeb_quadrangulation/Placed_texture.h>
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Applies edits, one after the other, to the texture of a chart, whose sides keep their vertices at the
/// contours' nodes, and finds its new vertices on the chart; the argument is left alone. Vertices of the
/// sides may come and go: `stitch_textures()` joins the chart with its neighbours all the same. Fails as
/// `edit_texture()` of a texture alone does. O(Q) for each edit, and O(F). \pre There is an edit.
Result<Placed_texture> edit_texture(const Placed_texture& placed, const Chart& chart,
                                    const Chart_parameterization& map, const Contour_samples& samples,
                                    const std::vector<Texture_edit>& edits);

/// The same for one edit.
inline Result<Placed_texture> edit_texture(const Placed_texture& placed, const Chart& chart,
                                           const Chart_parameterization& map, const Contour_samples& samples,
                                           const Texture_edit& edit) {
  return edit_texture(placed, chart, map, samples, std::vector<Texture_edit>{edit});
}

/// The same with a locator of the chart that is kept from edit to edit: O(Q) for Q quads, whatever the
/// chart's size.
Result<Placed_texture> edit_texture(const Placed_texture& placed, const Chart& chart,
                                    const Chart_locator& locator, const Contour_samples& samples,
                                    const Texture_edit& edit);

/// The texture of a chart whose contours get other counts: its vertices stay where they are.
Placed_texture with_counts(const Placed_texture& placed, const Chart& chart, const Contour_samples& before,
                           const Contour_samples& after);

/// The parameters (V, U) of a place on a chart.
Eigen::Vector2d plane_point(const Chart& chart, const Chart_parameterization& map,
                            const Chart_location& location);

/// A polychord to be inserted in a chart.
struct Chart_polychord {
  int chart = -1;
  Insert_polychord edit;
};

/// Carries a polychord from a chart across the contours through all charts until it closes or ends on
/// boundary loops: the insertions to be applied, in any order, after which both sides of each contour that it
/// crosses have a new vertex in the same place. The edges are named by points. `textures` are those of the
/// atlas' charts. Fails with `refused_edit` where the polychord meets a vertex of the next chart, or goes
/// through charts again and again: more than 64 times, whose quads add up to more than a million.
Result<std::vector<Chart_polychord>>
polychord_through_charts(const Atlas& atlas, const Contour_samples& samples,
                         const std::vector<const Placed_texture*>& textures, const Chart_polychord& start);

/// The change of (V, U) that moves the texture's point at `location` by `displacement` in space, as far as it
/// lies in the surface there: a drag follows the pointer. Zero where the map is degenerate.
Eigen::Vector2d parameter_displacement(const Chart& chart, const Chart_parameterization& map,
                                       const Chart_location& location, const Eigen::Vector3d& displacement);

/// How long a step of V and a step of U are in space, per unit, at a location. Zero where the map is
/// degenerate.
Eigen::Vector2d parameter_lengths(const Chart& chart, const Chart_parameterization& map,
                                  const Chart_location& location);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CHART_TEXTURE_EDIT_H
