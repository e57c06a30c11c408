// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FOLLOWED_GUIDE_H
#define CGAL_REEB_QUADRANGULATION_FOLLOWED_GUIDE_H

#include <CGAL/Reeb_quadrangulation/Guide.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How edges of quads follow a stroke. At points of the stroke that are an eighth of an edge apart, the edge
/// is taken that is nearest among those around the point which make at most 45 degrees with the stroke, or,
/// where none does, the smallest angle.
struct Followed_guide {
  double length = 0;   ///< of the stroke
  double angle = 0;    ///< degrees between the stroke and these edges, in the mean
  double distance = 0; ///< of the stroke from them in lengths of each, in the mean
  double on = 0;       ///< the part of the stroke that is nearer to them than a tenth of their length
};

/// Measures how a mesh follows a stroke. O((E + n) log E) for E edges and n points. \pre the mesh has a quad
Followed_guide followed_guide(const Quad_mesh& mesh, const Surface_curve& stroke);

/// What became of a guide when quads were finished.
struct Guide_outcome {
  bool kept = false;            ///< whether quads were moved for it
  std::string reason;           ///< else why not, a sentence
  Followed_guide before, after; ///< alike if it was not kept
  int vertices = 0;             ///< of the lines of edges that were brought onto the stroke
  /// The mean scaled Jacobian of the quads that have no vertex there.
  double jacobian_before = 0, jacobian_after = 0;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FOLLOWED_GUIDE_H
