// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of textures that can be asked to stop: moving and relaxing take long on large textures.
#ifndef REEBQUAD_TEXTURES_OBSERVED_EDIT_H
#define REEBQUAD_TEXTURES_OBSERVED_EDIT_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// More steps of relaxation than any texture needs are refused.
constexpr int most_relaxing_steps = 1000;

/// As `edit_texture()` of the same arguments without the observer, which may be null.
Result<Edited_texture> edit_observed(const Quad_texture& texture, const Texture_edit& edit,
                                     const Texture_limits& limits, const Observer* observer);
Result<Placed_texture> edit_observed(const Placed_texture& placed, const Chart& chart,
                                     const Chart_parameterization& map, const Contour_samples& samples,
                                     const std::vector<Texture_edit>& edits, const Observer* observer);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_TEXTURES_OBSERVED_EDIT_H
