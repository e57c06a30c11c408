// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_SHARED_INTERSECTIONS_H
#define REEBQUAD_CERTIFICATE_SHARED_INTERSECTIONS_H

#include "certificate/input_surface.h"

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// Which of the intersecting pairs of quads lie where the input intersects itself: two of its triangles meet
/// within half the diagonals of the quads' boxes from where these boxes meet, and they are of one component
/// if and only if the quads are. Only the input's triangles near such pairs are looked at. Nothing if the
/// observer cancels.
std::optional<std::vector<char>> are_in_input(const std::vector<std::pair<int, int>>& pairs,
                                              const Quad_mesh& mesh, const Soup_topology& topology,
                                              const Input_surface& input, const Observer* observer);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_SHARED_INTERSECTIONS_H
