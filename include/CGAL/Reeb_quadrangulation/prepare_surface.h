// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PREPARE_SURFACE_H
#define CGAL_REEB_QUADRANGULATION_PREPARE_SURFACE_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Result.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

/// \file
/// The working copy of the input, on which the field is solved and contours are traced: the same surface with
/// triangles that the method can use. Final quads are projected on the true input, so the working copy may
/// deviate from it a little; how much is bounded by the options.
///
/// In this order: (1) edges much too short are collapsed; (2) edges are flipped where that enlarges the
/// smallest angle, first of all in flat regions, as of CAD models; (3) edges much too long are bisected, the
/// longest first, which keeps the surface conforming and angles at least half as large (Rivara, 1984); (4)
/// interior edges that join two boundary vertices are split, so that no triangle has all its vertices on the
/// boundary.

namespace CGAL {
namespace Reeb_quadrangulation {

/// What to prepare. Lengths are in the units of the surface, angles in degrees. For quads of edge length h
/// good values are `max_edge` about 0.7 h (where the input is coarser), `min_edge` about 0.02 h, and a
/// `max_deviation` of 0.02 h over the diagonal where the input has many slivers along sharp edges.
struct Prepare_options {
  double max_edge = 0;      ///< edges longer than this are bisected; 0: none
  int max_faces = 400000;   ///< bisection stops at so many faces
  double min_edge = 0;      ///< edges shorter than this are collapsed where that is safe; 0: none
  bool flip = true;         ///< flip edges of triangles whose smallest angle is below `poor_angle`
  double poor_angle = 20;   ///< triangles below it are looked at
  double sliver_angle = 10; ///< only below it may a flip deviate by more than rounding
  double max_deviation =
      1e-4; ///< how far a flip may take the surface, as a fraction of the bounding box's diagonal
  double sharp_angle = 20;  ///< edges whose faces' normals differ by more are never flipped
  bool split_chords = true; ///< split interior edges that join two boundary vertices
};

/// What was done.
struct Prepare_report {
  int faces_before = 0, faces_after = 0;
  double min_angle_before = 0, min_angle_after = 0; ///< degrees
  int collapses = 0, flips = 0, bisections = 0, chords = 0;
};

/// The working copy and how its vertices relate to the input's.
struct Prepared_surface {
  Triangle_surface surface;
  std::vector<int> input_vertex; ///< for each vertex of `surface`: the input vertex at the same place, or -1
  std::vector<int> working_vertex; ///< for each input vertex: where it is now (or what it was collapsed into)
  Prepare_report report;
};

/// A flip between two triangles that are coplanar up to this fraction of the bounding box's diagonal counts
/// as one that does not change the surface.
constexpr double flat_tolerance = 1e-6;

/// Prepares a connected surface. Genus, components and boundary loops are kept, vertices are not moved, and
/// every new vertex is the midpoint of an edge (or the centroid of an isolated triangle). Where nothing is to
/// be done the surface is returned as it came: pass it by `std::move` to save the copy. Deterministic. O(F)
/// to find that nothing is to be done, O(N log N) for N bisections. Fails only with `cancelled`. \pre
/// `surface` is connected by `connect()`.
Result<Prepared_surface> prepare_surface(Triangle_surface surface, const Prepare_options& options = {},
                                         Observer* observer = nullptr);

/// The smallest angle of all triangles, in degrees; 180 for a surface without faces.
double smallest_angle(const Triangle_surface& surface);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PREPARE_SURFACE_H
