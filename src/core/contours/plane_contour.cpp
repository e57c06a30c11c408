// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/plane_contour.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 exact_point(const Point& p) {
  return Kernel::Point_3(p.x(), p.y(), p.z());
}

// Scaled so that the largest coordinate is 1: products neither overflow nor vanish.
Eigen::Vector3d scaled(const Eigen::Vector3d& x) {
  const double largest = x.cwiseAbs().maxCoeff();
  return largest > 0 ? Eigen::Vector3d(x / largest) : x;
}

Result<void> check_plane(const Cutting_plane& plane) {
  for (const Point& p : plane.points())
    if (!p.allFinite())
      return make_error(Error_code::impossible_request, "a coordinate of the plane is not finite");
  const std::array<Point, 3>& p = plane.points();
  if (plane.is_through_points() && CGAL::collinear(exact_point(p[0]), exact_point(p[1]), exact_point(p[2])))
    return make_error(Error_code::impossible_request, "the three points of the plane are on one line");
  if (!plane.is_through_points() && p[1].isZero(0))
    return make_error(Error_code::impossible_request, "the normal of the plane is zero");
  return {};
}

// The side that the plane through three points has a point on.
class Three_points_predicate {
public:
  explicit Three_points_predicate(const std::array<Point, 3>& p)
      : m_p(exact_point(p[0])), m_q(exact_point(p[1])), m_r(exact_point(p[2])) {}
  bool is_below(const Point& x) const {
    return CGAL::orientation(m_p, m_q, m_r, exact_point(x)) == CGAL::NEGATIVE;
  }

private:
  Kernel::Point_3 m_p, m_q, m_r;
};

// Compares normal * x with normal * point. The kernel's plane through a point would round its last
// coefficient; this predicate reads the first three only.
class Normal_predicate {
public:
  Normal_predicate(const Point& point, const Eigen::Vector3d& normal)
      : m_point(exact_point(point)), m_direction(normal.x(), normal.y(), normal.z(), 0) {}
  bool is_below(const Point& x) const {
    return Kernel().less_signed_distance_to_plane_3_object()(m_direction, exact_point(x), m_point);
  }

private:
  Kernel::Point_3 m_point;
  Kernel::Plane_3 m_direction;
};

template <class Predicate>
Result<std::vector<char>> classify(const Triangle_surface& surface, const Predicate& predicate) {
  std::vector<char> is_above(surface.points.size());
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    const Point& p = surface.points[v];
    if (!p.allFinite())
      return make_error(Error_code::not_a_surface, "a coordinate of a vertex is not finite",
                        Element_kind::vertex, v);
    is_above[v] = !predicate.is_below(p);
  }
  return is_above;
}

} // namespace

Eigen::Vector3d Cutting_plane::unit_normal() const {
  if (!m_is_through_points) return scaled(m_data[1]).normalized();
  // Halves cannot overflow where the difference of two large coordinates would.
  const Eigen::Vector3d a = 0.5 * m_data[1] - 0.5 * m_data[0], b = 0.5 * m_data[2] - 0.5 * m_data[0];
  return scaled(scaled(a).cross(scaled(b))).normalized();
}

Result<std::vector<char>> classify_vertices(const Triangle_surface& surface, const Cutting_plane& plane) {
  if (Result<void> checked = check_plane(plane); !checked) return checked.error();
  return plane.is_through_points() ? classify(surface, Three_points_predicate(plane.points()))
                                   : classify(surface, Normal_predicate(plane.point(), plane.points()[1]));
}

std::vector<Plane_curve> trace_curves(const Triangle_surface& surface, const std::vector<char>& is_above) {
  CGAL_precondition(is_above.size() == surface.points.size());
  // A curve enters a face over the halfedge that runs down and leaves it over the one that runs up.
  const auto runs_down = [&](int h) { return is_above[surface.source(h)] && !is_above[surface.target(h)]; };
  std::vector<char> is_done(surface.number_of_faces(), 0);
  const auto follow = [&](int entry) {
    Plane_curve curve;
    const int first = entry;
    do {
      curve.crossings.push_back({surface.edge(entry), 0.5});
      curve.faces.push_back(entry / 3);
      is_done[entry / 3] = 1;
      const int next = Triangle_surface::next(entry);
      const int exit = is_above[surface.target(next)] ? next : Triangle_surface::previous(entry);
      entry = surface.opposite[exit];
      if (entry < 0) curve.crossings.push_back({surface.edge(exit), 0.5});
    } while (entry >= 0 && entry != first);
    curve.is_closed = entry >= 0;
    return curve;
  };

  std::vector<Plane_curve> curves;
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (surface.is_boundary(h) && runs_down(h)) curves.push_back(follow(h));
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (!is_done[h / 3] && runs_down(h)) curves.push_back(follow(h));
  std::sort(curves.begin(), curves.end(),
            [](const Plane_curve& a, const Plane_curve& b) { return a.faces[0] < b.faces[0]; });
  return curves;
}

void place_crossings(const Triangle_surface& surface, const Cutting_plane& plane, double margin,
                     std::vector<Plane_curve>& curves) {
  CGAL_precondition(0 < margin && margin <= 0.5);
  const Eigen::Vector3d normal = plane.unit_normal();
  const auto distance = [&](int v) { return std::abs(normal.dot(surface.points[v] - plane.point())); };
  for (Plane_curve& curve : curves)
    for (Edge_crossing& crossing : curve.crossings) {
      // The ends are on different sides, whatever rounding makes of their distances.
      const double from = distance(surface.source(crossing.halfedge)),
                   to = distance(surface.target(crossing.halfedge));
      const double t = from / (from + to);
      crossing.t = std::isfinite(t) ? std::min(1 - margin, std::max(margin, t)) : 0.5;
    }
}

Result<Plane_curves> plane_curves(const Triangle_surface& surface, const Cutting_plane& plane) {
  // Positions closer to an end than this are of no use to a mesh: the corner that the curve cuts off is a
  // needle.
  constexpr double margin = 1e-3;
  Result<std::vector<char>> is_above = classify_vertices(surface, plane);
  if (!is_above) return is_above.error();
  Plane_curves result;
  result.curves = trace_curves(surface, *is_above);
  place_crossings(surface, plane, margin, result.curves);
  result.is_above = std::move(*is_above);
  return result;
}

std::vector<Point> curve_points(const Triangle_surface& surface, const Plane_curve& curve) {
  std::vector<Point> points;
  points.reserve(curve.crossings.size());
  for (const Edge_crossing& c : curve.crossings) {
    const Point &p = surface.points[surface.source(c.halfedge)],
                &q = surface.points[surface.target(c.halfedge)];
    points.push_back((1 - c.t) * p + c.t * q);
  }
  return points;
}

int nearest_curve(const Triangle_surface& surface, const std::vector<Plane_curve>& curves,
                  const Point& point) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::vector<Point> points = curve_points(surface, curves[i]);
    const std::size_t n = points.size(), segments = curves[i].is_closed ? n : n - 1;
    for (std::size_t k = 0; k < segments; ++k) {
      const Point &a = points[k], d = points[(k + 1) % n] - a;
      const double along = d.squaredNorm() > 0 ? d.dot(point - a) / d.squaredNorm() : 0.0;
      const double distance = (a + std::min(1.0, std::max(0.0, along)) * d - point).norm();
      if (distance < least || best < 0) {
        least = distance;
        best = int(i);
      }
    }
  }
  return best;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
