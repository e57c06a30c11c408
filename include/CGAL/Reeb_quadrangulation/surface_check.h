// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SURFACE_CHECK_H
#define CGAL_REEB_QUADRANGULATION_SURFACE_CHECK_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What can be wrong, or at least remarkable, with polygons that are meant to be a surface.
enum class Defect_kind {
  non_finite_point,         ///< a coordinate is NaN or infinite
  non_manifold_edge,        ///< more than two faces share an edge
  non_manifold_vertex,      ///< the faces at a point are several fans
  inconsistent_orientation, ///< two neighbours run through their edge in the same direction
  non_orientable,           ///< a component has no consistent orientation (Moebius, Klein)
  boundary_loop,            ///< a hole, or the rim of an open surface
  degenerate_face,          ///< no area: fewer than three corners, a corner twice, or all corners on a line
  duplicate_face,           ///< the same corners as an earlier face, in any order
  unreferenced_point,       ///< no face uses the point
  duplicate_point,          ///< the same coordinates as an earlier point
  near_point,               ///< a border point a hair from another; joining them closes an edge
  t_junction,               ///< a border point on the inside of an edge that has one face
  extreme_coordinate        ///< too large to compute with, or the whole mesh is too small
};
constexpr int number_of_defect_kinds = 13;

/// The name of a kind as it stands in reports: "non_manifold_edge", ...
const char* name(Defect_kind kind);

/// One finding, with the elements it is about, in the numbering of the soup.
struct Defect {
  Defect_kind kind = Defect_kind::non_finite_point;
  std::vector<int> points; ///< the two ends of an edge; the points of a loop in order; both duplicates; ...
  std::vector<int> faces;  ///< the faces concerned, at most eight
  Point where = Point::Zero();
  double length = 0; ///< of a boundary loop, in the unit of the points
  std::string text;  ///< a sentence for people
};

/// A maximal set of faces connected through edges; degenerate faces (see `Defect_kind`) with a repeated
/// corner belong to none.
struct Component_check {
  int first_face = 0; ///< the smallest face
  int faces = 0;
  int edges = 0;
  int vertices = 0; ///< a pinched point counts once per fan
  int boundary_loops = 0;
  int euler_characteristic = 0;
  bool manifold = true; ///< every edge has one or two faces
  bool orientable = true;
  bool closed() const { return boundary_loops == 0; }
  /// The genus, or -1 where it has no meaning (not manifold, not orientable).
  int genus() const { return manifold && orientable ? (2 - euler_characteristic - boundary_loops) / 2 : -1; }
};

struct Check_options {
  int listed_per_kind = 100; ///< defects listed of each kind; all are counted. Negative: list all.
  double weld = -1;          ///< what is a hair, as in `Mend_options`
};

/// All findings about a soup; see `check_surface()`.
struct Surface_check {
  int points = 0;
  int faces = 0;
  int triangles = 0;
  Point lowest = Point::Zero(); ///< corner of the bounding box of the finite points
  Point highest = Point::Zero();
  std::vector<Component_check> components; ///< by their smallest face
  std::vector<Defect> defects;             ///< by kind, then by element
  std::array<std::int64_t, number_of_defect_kinds> counts{};

  std::int64_t count(Defect_kind kind) const { return counts[std::size_t(kind)]; }
  /// Whether the soup, as it is, is an oriented manifold triangle surface without any defect; open or closed.
  bool is_clean() const;
};

/// Lists what is wrong with `soup`. O(n log n) in the worst case, nearly linear on meshes; deterministic.
Surface_check check_surface(const Polygon_soup& soup, const Check_options& options = {});

/// The check as JSON text: `points`, `faces`, `triangles`, `bounding_box`, `clean`, `components`, `counts`,
/// `defects` (a non-finite number becomes null).
std::string to_json(const Surface_check& check);

/// What `mend_surface()` did; `count` elements were concerned.
struct Mend {
  std::int64_t count = 0;
  std::string text; ///< a sentence for people, with the count
};

/// Coordinates larger than this, and meshes whose diagonal is smaller than its inverse, are refused:
/// products of four lengths must neither overflow nor vanish.
constexpr double largest_coordinate = 1e70;

struct Mend_options {
  /// Fill boundary loops of at most that many edges.
  int fill_holes = 0;
  /// Turn closed components outward, and those inside an odd number of others inward.
  bool orient_outward = true;
  /// Border points nearer than this are welded where that closes an edge and gives none more than two
  /// faces; it is also how far a point may lie off an edge to be a T-junction. Negative: a millionth of the
  /// diagonal. 0: only equal points.
  double weld = -1;
  /// Cut edges with more than two faces: solids that touch come apart, and so do sheets; otherwise they
  /// refuse their component.
  bool cut_non_manifold_edges = true;
  /// Components are dropped if the diagonal of their box is smaller than this length, than this part of the
  /// diagonal of all, or if they have fewer triangles.
  double smallest_diagonal = 0;
  double smallest_part = 0;
  int fewest_triangles = 0;
};

/// A component ready for the method. `surface` is connected, manifold and oriented.
struct Mended_component {
  Triangle_surface surface;
  std::vector<int> point_of_vertex;  ///< the point of the soup, or -1 for a point that was added
  std::vector<int> face_of_triangle; ///< the polygon of the soup, or -1 for a triangle that fills a hole
};

struct Mended_surface {
  std::vector<Mended_component> components; ///< by their smallest polygon
  std::vector<Error> refused; ///< one for each component that is not a surface and cannot be made one
  std::vector<Mend> mends;    ///< what was changed, in the order of the work
};

/// Makes oriented manifold triangle surfaces of a soup by what is safe, and says what it did.
///
/// In this order: polygons are triangulated (a quad by the better diagonal, others by least area, a polygon
/// that lies on another one as that); faces with a repeated corner are dropped; border points that are
/// equal are merged and those a hair apart welded; faces are divided at T-junctions; of faces that lie on
/// each other one is kept, or none if they are a wall inside a surface; faces without area that hang on
/// others are dropped; edges with more than two faces are cut by the angles at which their faces stand (or
/// refuse their component); points whose faces are several fans are split; neighbours are turned alike;
/// faces without area are removed by collapsing edges without length and flipping the long edge of a cap,
/// so that no hole opens, and kept where that is impossible; small holes are filled if asked; components
/// that are too small are dropped if asked; closed components are turned outward, or inward where they lie
/// inside an odd number of others; points without faces are dropped.
///
/// Fails with `not_a_surface` if nothing is left: no faces, or every component was refused (the first reason
/// is given; it ends with what to do). Nearly linear in the size of the soup; deterministic.
Result<Mended_surface> mend_surface(const Polygon_soup& soup, const Mend_options& options = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SURFACE_CHECK_H
