// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_EMBEDDING_H
#define CGAL_REEB_QUADRANGULATION_EMBEDDING_H

#include <CGAL/Reeb_quadrangulation/Contour_network.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Where a contour runs along a halfedge of the embedded surface.
struct Wall {
  int edge = -1;       ///< contour edge, or -1: no contour here
  int segment = -1;    ///< index of the segment of its polyline
  bool forward = true; ///< the halfedge runs in the contour edge's direction
};

/// The surface with its contours as edges. Vertices are those of the network; faces `0 .. F-1` are the faces
/// of the surface, each crossed one replaced by a piece of it, and the other pieces follow. The geometry is
/// unchanged.
struct Embedding {
  Triangle_surface surface;
  std::vector<int> base_face; ///< the face of the original surface that each face lies in
  std::vector<int> wall_of;   ///< per halfedge: index into `walls`, or -1
  std::vector<Wall> walls;    ///< one for each halfedge of a contour

  bool is_wall(int halfedge) const { return wall_of[halfedge] >= 0; }
};

/// Splits the crossed faces by the network's segments: O(F) to copy, O(crossings) to cut. Every crossed face
/// is cut along its chords into polygons, which are triangulated with the best worst angle, never with three
/// points of one edge. Fails with `internal_error`, naming the face, if two contours cross; nothing else can
/// go wrong.
Result<Embedding> embed(const Triangle_surface& surface, const Contour_network& network);

/// The same for some faces of the surface only, in increasing order: O(V) to copy the points, the rest
/// O(faces given). Faces of the result `0 .. n-1` are those given, or pieces of them; where they end the
/// result has a boundary without walls, and `outgoing` is not to be used.
Result<Embedding> embed(const Triangle_surface& surface, const Contour_network& network,
                        const std::vector<int>& faces);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_EMBEDDING_H
