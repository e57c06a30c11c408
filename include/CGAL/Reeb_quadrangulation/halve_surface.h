// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_HALVE_SURFACE_H
#define CGAL_REEB_QUADRANGULATION_HALVE_SURFACE_H

#include <CGAL/Reeb_quadrangulation/Mirror_plane.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The part of a surface on one side of a plane.
struct Surface_half {
  Triangle_surface surface;   ///< connected; points on the plane are on it exactly, across an axis to the bit
  Mirror_plane plane;         ///< as `Mirror_grid` has it
  std::vector<char> on_plane; ///< of each halfedge: a boundary edge that the cut has made
  int curves = 0;             ///< boundary loops that lie on the plane as a whole
  int arcs = 0;               ///< parts of other loops that do: they end on the surface's own boundary
  double dropped_area = 0;    ///< of islands, which are cut off where a surface is symmetric only nearly
};

/// Vertices nearer to the plane than this, by the diagonal of the bounding box, are put onto it before the
/// surface is cut.
constexpr double plane_tolerance = 1e-6;

/// Cuts a connected surface along a plane and keeps the half where the normal points to. The side of a vertex
/// is decided exactly. Edges that cross the plane get a vertex there; no other vertex is moved but those
/// within `plane_tolerance`, onto the plane. The half of a surface that equals its mirror image is connected,
/// and twice its Euler characteristic is that of the surface, less one for each arc. O(F log F).
///
/// Fails with `impossible_request`, naming the place, where the plane misses the surface, touches it without
/// crossing, or leaves other pieces than a half; with `not_a_surface` where there are no faces. \pre
/// `surface` is connected by `connect()`.
Result<Surface_half> halve_surface(const Triangle_surface& surface, const Mirror_plane& plane);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_HALVE_SURFACE_H
