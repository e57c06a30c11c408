// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a design's guides where its quads are finished.
#ifndef REEBQUAD_DESIGN_GUIDE_LINES_H
#define REEBQUAD_DESIGN_GUIDE_LINES_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The guides of a design with the directions in which its field rises along them. O(V) and O(n log F) for n
/// points of guides.
std::vector<Guide_line> guide_lines(const Surface_projector& projector, const Design& design);

/// The part of a stroke, by length, that makes more than 45 degrees with the directions in which a field
/// rises; 1 where the field is constant. `values` has an entry a vertex.
double level_part(const Triangle_surface& surface, const Stroke& stroke, const std::vector<double>& values);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DESIGN_GUIDE_LINES_H
