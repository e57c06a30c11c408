// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_VERTEX_CONSTRAINTS_H
#define CGAL_REEB_QUADRANGULATION_VERTEX_CONSTRAINTS_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A polyline on a surface that vertices may slide on, by arc length. On closed curves arc lengths go round:
/// t and t + length() name one point; on open ones they are brought into [0, length()].
struct Surface_curve {
  std::vector<Point> points;  ///< closed curves repeat the first point at the end; no two neighbours are
                              ///< equal, but where all are
  std::vector<double> arc;    ///< length up to each point, the first 0
  bool closed = false;        ///< the last point is the first
  std::vector<Point> normals; ///< per segment, of the surface there, unit; or none are known

  double length() const { return arc.back(); }
  /// O(log n) for n points, like the next two.
  Point at(double t) const;
  /// The unit direction of the segment at t.
  Point tangent(double t) const;
  /// The normal of the surface at t. \pre `normals` are known
  const Point& normal(double t) const;
  /// The arc length of the point nearest to p among those at `low` to `high`. O(log n) and the segments
  /// between.
  double nearest(const Point& p, double low, double high) const;
};

/// A curve through points, of which equal neighbours are taken once. \pre there is a point
Surface_curve make_surface_curve(const std::vector<Point>& points, bool closed);

/// What keeps vertices of a quad mesh from going where they like on the surface.
struct Vertex_constraints {
  /// A vertex on a curve.
  struct Place {
    int vertex, curve;
    double t; ///< its arc length there
  };

  std::vector<char> fixed; ///< one entry a vertex, or none: nonzero vertices do not move
  std::vector<Surface_curve> curves;
  std::vector<Place> places; ///< vertices that slide along curves, each on one, and never past each other

  Vertex_constraints() = default;
  /// Fixed vertices alone.
  Vertex_constraints(std::vector<char> held) : fixed(std::move(held)) {} // implicit: the most usual case
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_VERTEX_CONSTRAINTS_H
