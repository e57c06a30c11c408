// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_GUIDE_H
#define CGAL_REEB_QUADRANGULATION_GUIDE_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/Vertex_constraints.h>

#include <vector>

/// \file
/// Strokes on a surface that quads follow.

namespace CGAL {
namespace Reeb_quadrangulation {

/// Which of the two families of lines of quads' edges follows a guide.
enum class Guide_way : signed char {
  nearer, ///< that which makes the smaller angle with the stroke, place by place
  level,  ///< rows: they go around with the level lines of the field
  flow    ///< columns: they rise with the field
};

/// A stroke that quads follow.
struct Guide {
  /// In order, each within `guide_tolerance` of the surface. Between neighbours the stroke lies in the plane
  /// through both that contains the mean of the surface's normals there.
  std::vector<Point> points;
  bool closed = false; ///< the last point is joined with the first
  /// 1: vertices of quads lie on the stroke; less: quads go that part of the way there. Positive.
  double strength = 1;
  Guide_way way = Guide_way::nearer;
};

/// How far a point of a guide may lie off the surface, as a part of the diagonal of the surface's box.
constexpr double guide_tolerance = 0.01;

/// A guide whose stroke is shorter than so many edges of quads hardly matters.
constexpr double least_guide_length = 2;

/// Where a stroke leaves a face: a halfedge of it, and where from the halfedge's source (0) to its target
/// (1).
struct Stroke_crossing {
  int halfedge = -1;
  double t = 0;
};

/// A guide's stroke on a surface: each segment lies in one face.
struct Stroke {
  Surface_curve curve; ///< with normals
  std::vector<Stroke_crossing> crossings;
  std::vector<int> faces; ///< of the curve's segments
};

/// Lays the stroke of a guide on a surface: its points go to the nearest ones inside faces, and the way
/// between two of them is straight on the surface, as seen against its normal. Where none is straight, it
/// goes by the point that is nearest to their middle. O(n log F + crossings). Fails with
/// `impossible_request`, naming the point of the guide, where a point is not finite or farther from the
/// surface than `guide_tolerance`, where fewer than two points (of a closed stroke three) are different,
/// where the surface has no way between two points, and where the strength does not lie in (0, 1].
/// \pre the projector's surface is connected by `connect()`
Result<Stroke> trace_stroke(const Surface_projector& projector, const Guide& guide);

/// What is known of a guide where quads are finished: the guide, and the directions in which the field rises
/// at equal distances along its stroke, from end to end, unit or zero; or none.
struct Guide_line {
  Guide guide;
  std::vector<Point> flow;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_GUIDE_H
