// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_DESIGN_ENERGY_H
#define CGAL_REEB_QUADRANGULATION_DESIGN_ENERGY_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What each part of a design's energy counts. With all at their defaults, one extraordinary vertex is worth
/// as much as a thirtieth of the area lying one seventh of an edge nearer to the quads.
struct Energy_weights {
  double shape = 1;
  double farthest = 0.01;
  double angle = 0.5;
  double size = 0;
  double vertices = 0.0006;
  double patches =
      0.0005; ///< of the logarithm of the base complex's patches, where layouts are brought in line
  double features =
      0.15; ///< of the part of the sharp edges that quads cross obliquely, where curves of them are searched
};

/// How well the quads of a design would do, told from those that its textures give, after a few sweeps of
/// relaxation. Lengths are in edges of the quads: square roots of the area for each.
struct Design_energy {
  double shape = 0;      ///< mean square of the distance of the surface from the quads
  double farthest = 0;   ///< largest such distance, at the samples
  double angle = 0;      ///< 1 less the mean scaled Jacobian
  double size = 0;       ///< variance of the logarithm of the quads' areas
  int inverted = 0;      ///< quads with a scaled Jacobian of 0 or less
  int extraordinary = 0; ///< vertices whose valence is not 4, as predicted

  /// The sum of the parts, as `weights` has it; a quad that is inverted costs a few extraordinary vertices.
  double total(const Energy_weights& weights) const;
};

/// Points spread evenly over a surface, each for the same area.
struct Surface_samples {
  std::vector<Point> points;
  std::vector<int> faces; ///< of the surface, parallel to `points`
  double area = 0;        ///< of the surface
};

/// About `number` samples, the same for the same surface. O(F + number).
Surface_samples sample_surface(const Triangle_surface& surface, int number);

/// A sample that lies far from the quads.
struct Far_sample {
  Point point = Point::Zero();
  int face = -1;
  double distance = 0; ///< in edges of the quads
};

/// Above which nobody wants to know more of a design.
struct Energy_bound {
  const Energy_weights& weights;
  double most;
};

/// The energy of stitched quads on the surface of a projector. With `bound`, the distance is not measured any
/// further once the total is above it: `shape` and `farthest` are then lower than they are, with a total
/// above the bound. With `far`, also where the surface is farthest from the quads: the worst samples, the
/// farthest first, no two of them within four edges. O((Q + samples) log Q).
Design_energy design_energy(Stitched_mesh quads, const Surface_projector& projector,
                            const Surface_samples& samples, std::vector<Far_sample>* far = nullptr,
                            const Energy_bound* bound = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_DESIGN_ENERGY_H
