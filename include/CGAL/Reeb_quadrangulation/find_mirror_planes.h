// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FIND_MIRROR_PLANES_H
#define CGAL_REEB_QUADRANGULATION_FIND_MIRROR_PLANES_H

#include <CGAL/Reeb_quadrangulation/Mirror_plane.h>
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How far a surface is from its mirror image: distances of reflected points of the surface from the surface,
/// as fractions of the diagonal of its bounding box.
struct Mirror_deviation {
  double largest = 0;       ///< of up to 20,000 vertices and 2,000 points spread evenly over the area
  double mean = 0;          ///< of the latter
  Point at = Point::Zero(); ///< the point whose image lies farthest from the surface
};

/// A plane of symmetry, up to a deviation.
struct Found_mirror {
  Mirror_plane plane;
  Mirror_deviation deviation;
  double curve_length = 0; ///< of the plane's intersection with the surface
};

/// How the positions of the other side come about.
enum class Mirror_positions : signed char {
  exact,    ///< by reflection: the quads equal their mirror image
  projected ///< by reflection, then onto the surface: of use where that is symmetric only nearly
};

/// The plane that a user has chosen for good, as a recipe keeps it.
struct Mirror {
  Mirror_plane plane;
  Mirror_positions positions = Mirror_positions::exact;
};

/// Which plane is asked for.
enum class Mirror_choice : signed char {
  best,     ///< the best that is found
  across_x, ///< across an axis, through the middle of the shape
  across_y,
  across_z,
  given ///< `Mirror_request::plane`
};

/// What is asked for.
struct Mirror_request {
  Mirror_choice choice = Mirror_choice::best;
  Mirror_plane plane;     ///< if it is given
  bool is_turned = false; ///< keep the half on the other side of the plane that was chosen
  Mirror_positions positions = Mirror_positions::exact;
  /// A surface counts as symmetric if its largest deviation is not greater, as a fraction of the diagonal.
  double tolerance = 0.01;
};

/// How far the surface is from its mirror image in a plane. O(n log F) for n points.
Mirror_deviation mirror_deviation(const Surface_projector& projector, const Mirror_plane& plane);

/// The planes of symmetry of a surface with deviations up to `tolerance`, the best first; of a round shape,
/// which has infinitely many, some. Sought from the axes of coordinates and from those of inertia of the
/// area, through its centroid: refined by pairing points with the nearest ones to their images, for as long
/// as that brings them nearer. Planes across an axis are preferred to neighbours of the same deviation, for
/// their reflections are exact, and those through 0 or the middle of the box to others. Those with nearly
/// equal deviations are ordered by the lengths of their curves, the shortest first. Deterministic. A few
/// seconds of work at most, whatever the surface.
std::vector<Found_mirror> find_mirror_planes(const Surface_projector& projector, double tolerance = 0.01,
                                             const Observer* observer = nullptr);

/// The plane that is asked for, with its deviation. Fails with `impossible_request`, with the deviation and
/// its place, where the surface is not symmetric, and where a given plane has no normal.
Result<Found_mirror> choose_mirror(const Surface_projector& projector, const Mirror_request& request = {},
                                   const Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FIND_MIRROR_PLANES_H
