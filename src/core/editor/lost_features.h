// SPDX-License-Identifier: GPL-3.0-or-later
// What quads do not keep of a surface's shape, for hints.
#ifndef REEBQUAD_EDITOR_LOST_FEATURES_H
#define REEBQUAD_EDITOR_LOST_FEATURES_H

#include <CGAL/Reeb_quadrangulation/Design.h>
#include <CGAL/Reeb_quadrangulation/deviation.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Sharp edges in one piece that no quads run along.
struct Lost_line {
  double length = 0;
  Point middle = Point::Zero(); ///< of the edge that is nearest to the mean of all
};

/// The pieces of `Deviation::lost_sharp_edges`, the longest first.
std::vector<Lost_line> lost_lines(const Deviation& deviation);

/// How far the quads of a design, as its charts have them, are from the surface.
Result<Deviation> deviation_of(const Design& design, const Triangle_surface& surface,
                               const Observer* observer);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_EDITOR_LOST_FEATURES_H
