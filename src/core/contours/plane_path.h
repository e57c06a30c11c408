// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CONTOURS_PLANE_PATH_H
#define REEBQUAD_CONTOURS_PLANE_PATH_H

#include <CGAL/Reeb_quadrangulation/plane_contour.h>

#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The side of a loop on which the vertices above its plane are.
enum class Loop_sense : signed char { above_on_left, above_on_right };

/// A path in the intersection of the surface with a plane, from one network vertex to another (or back to the
/// same vertex of the surface), both of which count as on the plane. All other vertices are classified
/// exactly. Of several paths that which comes nearest to `at`, and of the two ways around a loop that with
/// the plane's upper side on the left, or on the right, if that is asked for; its crossings are added to the
/// network, its nodes are not set. Fails with `refused_edit` if there is none.
Result<Contour_edge> plane_path(const Triangle_surface& surface, Contour_network& network, int from, int to,
                                const Cutting_plane& plane, const Point& at,
                                std::optional<Loop_sense> sense = {});

/// The same in the plane through both ends whose normal is nearest to the one given.
Result<Contour_edge> plane_path(const Triangle_surface& surface, Contour_network& network, int from, int to,
                                const Eigen::Vector3d& normal, const Point& at,
                                std::optional<Loop_sense> sense = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CONTOURS_PLANE_PATH_H
