// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_STUDIO_DESIGN_FIELD_H
#define REEBQUAD_STUDIO_DESIGN_FIELD_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <vector>

namespace reebquad {
namespace studio {

/// A field that the contours of a design are level lines of, at the vertices of its embedded surface: on an annulus the height U
/// of its map between the values of its two contours; on a disc between contour and extremum by the distances to both along
/// edges. It is for the eye only: a design is not made of a field any more once contours were edited.
std::vector<double> design_field(const CGAL::Reeb_quadrangulation::Design& design,
                                 const CGAL::Reeb_quadrangulation::Embedding& embedding);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_STUDIO_DESIGN_FIELD_H
