// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_AREA_DISTANCE_H
#define REEBQUAD_CERTIFICATE_AREA_DISTANCE_H

#include "certificate/tree.h"

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/shape_kept.h>

#include <cstdint>
#include <optional>
#include <vector>

/// \file
/// The one-sided Hausdorff distance between triangle surfaces by branch and bound.

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// A point that stands for an equal part of a surface's area.
struct Area_sample {
  Point point;
  int triangle = -1;
  int nearest = -1;    ///< triangle of the other surface
  double distance = 0; ///< to that surface
};

/// About `count` points spread evenly over the area, in the order of the triangles; none if the area is not
/// positive and finite. O(n + count)
std::vector<Area_sample> area_samples(const std::vector<Point>& points,
                                      const std::vector<Triangle>& triangles, int count);

/// How exactly to search.
struct Distance_precision {
  double relative = 0.01; ///< of the maximum
  double absolute = 0;    ///< nothing smaller than this is looked into
  std::int64_t queries =
      0; ///< at most so many nearest points in the search; then the bound is what is proved by then
};

/// Measures the samples, which fills them in and gives the mean, then searches all triangles for a greater
/// distance.
///
/// A triangle, or a part of one, need not be looked at when a bound of its distance is below what was found
/// already. The bound: on a convex set the distance to a convex set is greatest at a corner. So a part is cut
/// along the places that are as near to one triangle of `to` as to another, and each piece is compared with
/// its own one. Where the bound is not good enough, the part is halved. Lengths in the unit of the points.
/// Nothing if the observer cancels.
/// \pre neither surface is empty
std::optional<Area_distance> area_distance(const std::vector<Point>& points,
                                           const std::vector<Triangle>& triangles, const Triangle_tree& to,
                                           const Distance_precision& precision,
                                           std::vector<Area_sample>& samples, const Observer* observer);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_AREA_DISTANCE_H
