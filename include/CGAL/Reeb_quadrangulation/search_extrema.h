// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SEARCH_EXTREMA_H
#define CGAL_REEB_QUADRANGULATION_SEARCH_EXTREMA_H

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/design_energy.h>

#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How long to search, and for what.
struct Search_options {
  /// Designs that are tried, at most. The search is counted in these, not in seconds: the same input gives
  /// the same bytes.
  int tries = 40;
  /// Seconds after which no further design is tried; 0: no limit. With a limit the outcome depends on the
  /// machine.
  double seconds = 0;
  Energy_weights weights;
  /// Designs with more extraordinary vertices than the first one and so many are not taken; negative: no
  /// limit but their price.
  int extra_vertices = -1;
  /// About how many triangles the copy has on which designs are tried; a surface with less than thrice as
  /// many is tried itself.
  int copy_triangles = 6000;
  /// Told of each design that could be made, with its energy; none is then cut short, see `Energy_bound`.
  std::function<void(const Edit&, const Design_energy&)> tried = {};
};

/// A change that the search has kept.
struct Search_step {
  std::string reason; ///< a sentence
  double energy = 0;  ///< after it
};

/// The extrema that the search ends with.
struct Searched_extrema {
  Set_extrema edit; ///< designs the field with them
  double first_energy = 0, energy = 0;
  std::vector<Search_step> steps; ///< none: the first extrema are the best that were tried
  int tries = 0;
};

/// Searches extrema whose design keeps the shape with few extraordinary vertices, beginning with those of an
/// edit (`Suggest` or `Set_extrema`).
///
/// A suggestion is compared with others, of half and of twice the persistence and along two more axes; the
/// search goes on from the best. Where the surface lies farther than an edge from the quads, a minimum or a
/// maximum is added; minima become maxima and the reverse; extrema are removed. Each change is tried by the
/// session's own edits on a coarse copy of the surface, and kept if the energy falls. All three kinds take
/// turns until none helps. Fails like the edit if the first design cannot be made, and with `cancelled`. \pre
/// `session` has an empty design.
Result<Searched_extrema> search_extrema(const Editor& session, const Edit& first,
                                        const Search_options& options = {}, Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SEARCH_EXTREMA_H
