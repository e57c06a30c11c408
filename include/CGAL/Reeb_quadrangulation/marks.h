// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MARKS_H
#define CGAL_REEB_QUADRANGULATION_MARKS_H

#include <CGAL/Reeb_quadrangulation/given_features.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A straight piece of a feature line, by the positions of its ends: they outlast what mending does to
/// vertices.
struct Mark {
  Point from = Point::Zero(), to = Point::Zero();
};

/// The feature edges that a user sets, beside those that an angle makes.
struct Marks {
  std::vector<Mark> marked;   ///< edges along these are features, whatever angle the faces there make
  std::vector<Mark> unmarked; ///< edges along these are none, unless they are marked too
  /// How far an edge may lie off a mark, as a part of the surface's diagonal.
  double tolerance = 1e-6;

  bool empty() const { return marked.empty() && unmarked.empty(); }
};

/// The features that marks and an angle give on a surface.
struct Marked_features {
  Given_features features;
  std::vector<double> found; ///< per mark: which part of its length edges of the surface lie along, 0 to 1
  std::vector<double> found_unmarked; ///< the same for `Marks::unmarked`
};

/// The features of a surface that `marks` set: edges whose ends and middle lie within the tolerance of marks,
/// be these edges, parts of edges or several edges in a line; and the edges whose faces' normals differ by
/// more than `feature_angle` degrees, which are none if that is 0. O((E + M) log M) for E edges and M marks.
/// Fails with `impossible_request` where a position or the tolerance is not finite, the tolerance negative or
/// the angle out of range. \pre `surface` is connected by `connect()`
Result<Marked_features> marked_features(const Triangle_surface& surface, const Marks& marks,
                                        double feature_angle);

/// The edges of a surface between faces of different groups, as marks; `group` has an entry a face. Linear
/// time.
std::vector<Mark> borders_of_groups(const Triangle_surface& surface, const std::vector<int>& group);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MARKS_H
