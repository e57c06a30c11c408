// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_TRIANGLE_SURFACE_H
#define CGAL_REEB_QUADRANGULATION_TRIANGLE_SURFACE_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

using Point = Eigen::Vector3d;
using Triangle = std::array<int, 3>;
using Quad = std::array<int, 4>;

/// An oriented manifold triangle surface as flat arrays: the form in which the stages share a surface.
///
/// Halfedge `h = 3 f + i` runs from `triangles[f][i]` to `triangles[f][(i + 1) % 3]`, with face `f` on its
/// left. `connect()` computes the two connectivity arrays from `points` and `triangles`.
struct Triangle_surface {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<int> opposite; ///< 3F entries: the opposite halfedge, or -1 on the boundary
  std::vector<int> outgoing; ///< V entries: an outgoing halfedge; at a boundary vertex the boundary halfedge
                             ///< (`opposite[outgoing[v]] == -1`); -1 if the vertex has no face

  int number_of_vertices() const { return int(points.size()); }
  int number_of_faces() const { return int(triangles.size()); }
  int number_of_halfedges() const { return 3 * int(triangles.size()); }

  static int face(int h) { return h / 3; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int source(int h) const { return triangles[h / 3][h % 3]; }
  int target(int h) const { return source(next(h)); }
  bool is_boundary(int h) const { return opposite[h] < 0; }
  /// The next outgoing halfedge counterclockwise around `source(h)`, or -1 at a boundary.
  int rotate_ccw(int h) const { return opposite[previous(h)]; }
  /// The next outgoing halfedge clockwise around `source(h)`, or -1 at a boundary.
  int rotate_cw(int h) const { return opposite[h] < 0 ? -1 : next(opposite[h]); }
  /// One halfedge for both directions of an edge (the smaller of the two).
  int edge(int h) const { return opposite[h] < 0 || h < opposite[h] ? h : opposite[h]; }

  /// Fills `opposite` and `outgoing` in O(F). Fails with `not_a_surface`, naming the element, if an edge has
  /// more than two faces or two of equal direction, or if the faces at a vertex are not one fan.
  Result<void> connect();
};

/// Euler characteristic V - E + F over the vertices that have a face. \pre `surface` is connected by
/// `connect()`.
int euler_characteristic(const Triangle_surface& surface);

/// The boundary loops, each as its halfedges in order (face on the left), loops ordered by their smallest
/// halfedge.
std::vector<std::vector<int>> boundary_loops(const Triangle_surface& surface);

/// Component of each face and their number; numbered by their smallest face.
std::pair<std::vector<int>, int> connected_components(const Triangle_surface& surface);

/// Area of a triangle, and of all of them in the order of their numbers.
double area(const Triangle_surface& surface, int face);
double area(const Triangle_surface& surface);

/// A quad mesh as flat arrays; quads are oriented counterclockwise seen from outside.
struct Quad_mesh {
  std::vector<Point> points;
  std::vector<Quad> quads;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_TRIANGLE_SURFACE_H
