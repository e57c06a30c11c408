// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SURFACE_INTERSECTIONS_H
#define CGAL_REEB_QUADRANGULATION_SURFACE_INTERSECTIONS_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Where a surface intersects itself.
struct Surface_intersections {
  std::int64_t within = 0;                ///< pairs of triangles of one component
  std::int64_t between = 0;               ///< pairs of triangles of two components
  std::vector<std::pair<int, int>> pairs; ///< ascending pairs i < j of triangles
  bool is_complete = true; ///< false if there are more than were asked for, or the observer cancelled
};

/// The pairs of triangles that meet in more than the vertices and edges they share, decided by exact
/// predicates, at most `most` of them. Components share no vertex. Triangles without area and with indices or
/// points that are not usable are left out. O(n log n + k) for k pairs whose boxes meet.
Surface_intersections surface_intersections(const Triangle_surface& surface, int most = 1000000,
                                            const Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SURFACE_INTERSECTIONS_H
