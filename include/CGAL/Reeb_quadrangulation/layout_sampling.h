// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_LAYOUT_SAMPLING_H
#define CGAL_REEB_QUADRANGULATION_LAYOUT_SAMPLING_H

#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/sampling.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The integer problem of a layout whose charts have the given mean heights. Removed contour edges are left
/// out: its edge `i` is contour edge `edges[i]` of the network. `points` are those of the network's vertices;
/// with a `density` for each, lengths count so many times there.
struct Layout_sampling_problem {
  Sampling_problem problem;
  std::vector<int> edges;
};
Layout_sampling_problem sampling_problem(const std::vector<Point>& points, const Contour_network& network,
                                         const Atlas& atlas, const std::vector<double>& heights,
                                         const std::vector<double>& density = {});
Layout_sampling_problem sampling_problem(const Reeb_layout& layout, const std::vector<double>& heights);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_LAYOUT_SAMPLING_H
