// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_DESIGN_FIELD_H
#define REEBQUAD_VIEW_DESIGN_FIELD_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <vector>

namespace reebquad {
namespace studio {

/// The values between which the field of a chart runs: of an annulus, on its LOW and its HIGH walk; of a
/// disc, on its walk and at its extremum, or the same twice if it has none.
struct Chart_levels {
  double first = 0, last = 0;
  bool operator==(const Chart_levels& o) const { return first == o.first && last == o.last; }
};
Chart_levels chart_levels(const CGAL::Reeb_quadrangulation::Design& design,
                          const CGAL::Reeb_quadrangulation::Chart& chart);

/// A field that the contours of a chart are level lines of, at the vertices of its mesh: on an annulus the
/// height U of its map between its levels; on a disc between contour and extremum by the distances to both
/// along edges. It is for the eye only: a design is not made of a field any more once contours were edited.
std::vector<double> chart_field(const CGAL::Reeb_quadrangulation::Design_chart& chart,
                                const Chart_levels& levels);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_DESIGN_FIELD_H
