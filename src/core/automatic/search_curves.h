// SPDX-License-Identifier: GPL-3.0-or-later
// Which closed lines of sharp edges a design should have as contours.
#ifndef REEBQUAD_AUTOMATIC_SEARCH_CURVES_H
#define REEBQUAD_AUTOMATIC_SEARCH_CURVES_H

#include <CGAL/Reeb_quadrangulation/search_extrema.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// What `search_curves()` ends with.
struct Searched_curves {
  std::optional<Set_extrema> edit; ///< none: no curve lowers the energy
  std::vector<Search_step> steps;
  int tries = 0;
  bool has_faces = false; ///< whether there is a line that could be tried: the shape has faces and edges
};

/// Searches sharp curves whose design keeps the sharp edges, beginning with the design of `first`: rings on
/// all closed lines without a corner, caps on two faces; then one curve more, one less or another kind of it,
/// as long as the energy falls. The energy is that of `design_energy()` and `Energy_weights::features` times
/// the part of the sharp edges that quads cross obliquely. A surface without a face for it costs O(F).
/// Deterministic. Fails with `cancelled` only. \pre `session` has an empty design.
Result<Searched_curves> search_curves(const Editor& session, const Edit& first, double feature_angle,
                                      const Search_options& options, Observer* observer);

/// How far the edges of quads turn away from the sharp edges that they lie at: the mean over the length of
/// these, 0 where quads' edges run along and 1 from `oblique` on. Chains shorter than two edges of the quads
/// do not count. 0 without sharp edges.
double missed_features(const Quad_mesh& mesh, const Triangle_surface& surface, double feature_angle);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_AUTOMATIC_SEARCH_CURVES_H
