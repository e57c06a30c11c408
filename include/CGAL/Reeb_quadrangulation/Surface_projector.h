// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SURFACE_PROJECTOR_H
#define CGAL_REEB_QUADRANGULATION_SURFACE_PROJECTOR_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <limits>
#include <memory>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A point of a surface nearest to a query.
struct Closest_point {
  Point point = Point::Zero();
  int face = -1;               ///< a triangle that contains `point`; -1 if no triangle was eligible
  double squared_distance = 0; ///< from the query
};

/// Answers closest-point queries on a triangle surface.
///
/// Runs of eight triangles, consecutive on a Morton curve, are the primitives of a `CGAL::AABB_tree`: an
/// eighth of the nodes of the usual tree and no sorting while it is built. The tree is built by the first
/// query, or by `build()`. Queries are const and may run in several threads at once; an answer depends on the
/// arguments alone.
///
/// The projector refers to the surface, which must outlive it and must not change. \pre the surface has a
/// face.
class Surface_projector {
public:
  explicit Surface_projector(const Triangle_surface& surface);
  ~Surface_projector();
  Surface_projector(Surface_projector&&) noexcept;
  Surface_projector& operator=(Surface_projector&&) noexcept;

  const Triangle_surface& surface() const;

  /// Builds the tree now: O(F log F), 20 bytes a triangle.
  void build() const;

  /// The closest point of the surface, in O(log F).
  Closest_point closest(const Point& query) const;

  /// The same answer, sooner when `hint_face` is near it: the search starts with a walk over neighbouring
  /// faces. A negative hint is no hint. \pre the surface is connected by `connect()`.
  Closest_point closest(const Point& query, int hint_face) const;

  /// A point that no neighbouring face improves on, found by walking from `face` for as long as the distance
  /// falls. Sooner than a search, needs no tree, and cannot jump between two sheets that lie close together:
  /// the right query for a point that slides by small steps. \pre the surface is connected by `connect()`.
  Closest_point closest_nearby(const Point& query, int face) const;

  /// The closest point among the faces whose normal makes a cosine of at least `min_cosine` with `normal`, a
  /// unit vector. With 0 a vertex on one side of a thin sheet cannot snap to the other side. Faces without
  /// area are skipped. If no such face is closer than `maximum_distance`, `face` is -1.
  Closest_point closest_compatible(const Point& query, const Point& normal, double min_cosine,
                                   int hint_face = -1,
                                   double maximum_distance = std::numeric_limits<double>::infinity()) const;

  /// Unit normal of a face; zero if the face has no area.
  Point normal(int face) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SURFACE_PROJECTOR_H
