// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEB_QUADRANGULATION_CORE_PLANE_PATH_H
#define REEB_QUADRANGULATION_CORE_PLANE_PATH_H

#include <CGAL/Reeb_quadrangulation/plane_contour.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A path in the intersection of the surface with a plane, from one network vertex to another (or back to the same vertex of the
/// surface), both of which count as on the plane. All other vertices are classified exactly. Of several paths that which comes
/// nearest to `at`; its crossings are added to the network, its nodes are not set. Fails with `refused_edit` if there is none.
Result<Contour_edge> plane_path(const Triangle_surface& surface, Contour_network& network, int from, int to,
                                const Cutting_plane& plane, const Point& at);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEB_QUADRANGULATION_CORE_PLANE_PATH_H
