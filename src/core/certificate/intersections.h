// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_INTERSECTIONS_H
#define REEBQUAD_CERTIFICATE_INTERSECTIONS_H

#include "certificate/geometry.h"
#include "certificate/tree.h"

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// The pairs i < j of quads that meet in more than the vertices and edges they share, ascending; see
/// `certify()`. `tree` is over `points` and `split.triangles`. Stops when `limit` pairs are found. Nothing if
/// `observer` (may be null) cancels.
std::optional<std::vector<std::pair<int, int>>> intersecting_quads(const std::vector<Point>& points,
                                                                   const Split_quads& split,
                                                                   const Triangle_tree& tree, int limit,
                                                                   const Observer* observer);

/// The same of triangles.
std::optional<std::vector<std::pair<int, int>>> intersecting_triangles(const std::vector<Point>& points,
                                                                       const std::vector<Triangle>& triangles,
                                                                       const Triangle_tree& tree, int limit,
                                                                       const Observer* observer);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_INTERSECTIONS_H
