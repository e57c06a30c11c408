// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PLANE_CURVES_H
#define CGAL_REEB_QUADRANGULATION_PLANE_CURVES_H

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>
#include <CGAL/Reeb_quadrangulation/plane_contour.h>

#include <CGAL/Kernel_traits.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// One curve of a plane's intersection with a face graph, the plane's positive side on its left.
template <class Graph, class Point_3> struct Face_graph_curve {
  bool is_closed = true; ///< else it begins and ends on the boundary
  /// The edges that it crosses, in order, none twice, each as the halfedge whose target is above.
  std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor> halfedges;
  std::vector<Point_3>
      points; ///< where; constructed in the kernel, exact in a kernel with exact constructions
};

namespace internal {

template <class NamedParameters, class Kernel_point> auto kernel_of(const NamedParameters& np) {
  if constexpr (parameters::has_parameter<CGAL::internal_np::geom_traits_t, NamedParameters>)
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits_t());
  else
    return typename CGAL::Kernel_traits<Kernel_point>::Kernel();
}

// Where the plane meets the segment from a point below it to one above or on it. In a kernel without exact
// constructions the values may come out as zero together, or with signs that the predicates do not confirm:
// then the middle, or the nearer end.
template <class Plane_3, class Point_3>
Point_3 point_on_plane(const Plane_3& plane, const Point_3& below, const Point_3& above) {
  const auto value = [&](const Point_3& p) -> decltype(plane.d()) {
    return plane.a() * p.x() + plane.b() * p.y() + plane.c() * p.z() + plane.d();
  };
  using FT = std::decay_t<decltype(value(below))>;
  const FT down = -value(below), up = value(above), sum = down + up;
  if (!(sum > FT(0))) return CGAL::midpoint(below, above);
  FT t = down / sum;
  if (t < FT(0)) t = FT(0);
  if (t > FT(1)) t = FT(1);
  return below + t * (above - below);
}

} // namespace internal

/// Cuts a triangle mesh by a plane of its own kernel and appends the curves, as
/// `Face_graph_curve<TriangleMesh, Point_3>`, to `out`, ordered by the first face that they cross. Returns
/// their number.
///
/// The sides are those of the kernel's `Oriented_side_3` on the kernel's own points, nothing is rounded
/// first; the curves then follow by integers. A vertex on the plane counts as above, as if the plane were
/// moved down by an infinitesimal: each edge is crossed once or not at all, each face by one curve at most,
/// and curves are simple whatever the position.
///
/// Fails with `impossible_request` if the plane is degenerate, `not_a_surface` as `to_triangle_surface()`
/// does. O(V + F). Named parameters: `vertex_point_map`, `geom_traits` (a model of `Kernel`, that of the
/// points if not given).
template <class TriangleMesh, class Plane_3, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Result<int> plane_curves(const TriangleMesh& tmesh, const Plane_3& plane, OutputIterator out,
                         const NamedParameters& np = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters>(parameters::Point_tags()));
  for (const double coefficient : {internal::coordinate(plane.a()), internal::coordinate(plane.b()),
                                   internal::coordinate(plane.c()), internal::coordinate(plane.d())})
    if (!std::isfinite(coefficient))
      return make_error(Error_code::impossible_request, "a coefficient of the plane is not finite");
  if (plane.is_degenerate())
    return make_error(Error_code::impossible_request, "the normal of the plane is zero");
  const auto converted = internal::triangle_surface(tmesh, np);
  if (!converted) return converted.error();
  const auto points = parameters::vertex_points(np, tmesh);
  using Point_3 = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  const auto side = internal::kernel_of<NamedParameters, Point_3>(np).oriented_side_3_object();
  std::vector<char> is_above;
  for (const auto v : converted->vertices)
    is_above.push_back(side(plane, get(points, v)) != CGAL::ON_NEGATIVE_SIDE);
  const std::vector<Plane_curve> curves = trace_curves(converted->surface, is_above);
  for (const Plane_curve& curve : curves) {
    Face_graph_curve<TriangleMesh, Point_3> result;
    result.is_closed = curve.is_closed;
    for (const Edge_crossing& crossing : curve.crossings) {
      auto h = converted->halfedges[std::size_t(crossing.halfedge)];
      if (is_above[std::size_t(converted->surface.source(crossing.halfedge))]) h = opposite(h, tmesh);
      result.halfedges.push_back(h);
      result.points.push_back(internal::point_on_plane(plane, Point_3(get(points, source(h, tmesh))),
                                                       Point_3(get(points, target(h, tmesh)))));
    }
    *out++ = std::move(result);
  }
  return int(curves.size());
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PLANE_CURVES_H
