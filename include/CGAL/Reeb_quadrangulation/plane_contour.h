// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PLANE_CONTOUR_H
#define CGAL_REEB_QUADRANGULATION_PLANE_CONTOUR_H

#include <CGAL/Reeb_quadrangulation/Contour_network.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// An oriented plane, kept as it was given, so that no rounding moves it.
class Cutting_plane {
public:
  /// The plane through three points; its upper side is where they are seen counterclockwise.
  static Cutting_plane through(const Point& p, const Point& q, const Point& r) {
    return Cutting_plane{{p, q, r}, true};
  }
  /// The plane through a point with a normal of any length, which points to the upper side.
  static Cutting_plane at(const Point& point, const Eigen::Vector3d& normal) {
    return Cutting_plane{{point, normal, normal}, false};
  }

  bool is_through_points() const { return m_is_through_points; }
  const Point& point() const { return m_data[0]; }
  /// The three points, if it `is_through_points()`.
  const std::array<Point, 3>& points() const { return m_data; }
  /// The unit normal towards the upper side, rounded: for positions, not for decisions.
  Eigen::Vector3d unit_normal() const;

private:
  Cutting_plane(const std::array<Point, 3>& data, bool is_through_points)
      : m_data(data), m_is_through_points(is_through_points) {}

  std::array<Point, 3> m_data; // three points, or a point and the normal
  bool m_is_through_points;
};

/// Decides for each vertex whether it is above the plane, by exact arithmetic on the doubles given (filtered
/// predicates of CGAL's Exact_predicates_inexact_constructions_kernel).
///
/// A vertex on the plane counts as above: as if the plane were moved down, against its normal, by an
/// infinitesimal. So a plane never goes through a vertex, and one that contains faces or edges passes just
/// below them. Two planes that differ only in the sense of the normal pass on different sides of such
/// vertices.
///
/// Fails with `impossible_request` if three points are collinear, the normal is zero, or a coordinate is not
/// finite, and with `not_a_surface`, naming the vertex, if a vertex is not finite. O(V).
Result<std::vector<char>> classify_vertices(const Triangle_surface& surface, const Cutting_plane& plane);

/// One curve of a plane's intersection with a surface, the upper side on its left.
struct Plane_curve {
  bool is_closed = true; ///< else it begins and ends on the boundary
  /// The edges that are crossed, in order, none twice; each by its representative, as
  /// `Contour_network::crossings` has them.
  std::vector<Edge_crossing> crossings;
  /// The faces between: face i is between crossing i and crossing i + 1, the last of a closed curve before
  /// crossing 0.
  std::vector<int> faces;
};

/// The curves, ordered by the first face (closed and open ones together) that they cross.
struct Plane_curves {
  std::vector<Plane_curve> curves;
  std::vector<char> is_above; ///< per vertex, as decided
};

/// Cuts a surface by a plane: `classify_vertices()`, then `trace_curves()`. O(V + F), positions last.
Result<Plane_curves> plane_curves(const Triangle_surface& surface, const Cutting_plane& plane);

/// Traces the curves between the vertices that are above and those that are not, by integers only: every edge
/// whose ends differ is crossed by exactly one curve, once; every face by at most one. All `t` are 0.5. O(F).
/// \pre `is_above` has V entries; `surface` is connected by `connect()`.
std::vector<Plane_curve> trace_curves(const Triangle_surface& surface, const std::vector<char>& is_above);

/// Puts the crossings where the plane is, but no closer than `margin` to an end of the edge (as a fraction of
/// the edge), since a curve never meets a vertex. \pre 0 < margin <= 0.5
void place_crossings(const Triangle_surface& surface, const Cutting_plane& plane, double margin,
                     std::vector<Plane_curve>& curves);

/// The points of a curve; a closed one does not repeat the first.
std::vector<Point> curve_points(const Triangle_surface& surface, const Plane_curve& curve);

/// The index of the curve nearest to a point, the first of equally near ones, or -1 if there is none.
/// O(crossings).
int nearest_curve(const Triangle_surface& surface, const std::vector<Plane_curve>& curves,
                  const Point& point);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PLANE_CONTOUR_H
