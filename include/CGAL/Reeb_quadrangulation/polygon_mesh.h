// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_POLYGON_MESH_H
#define CGAL_REEB_QUADRANGULATION_POLYGON_MESH_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Meshes of other polygons that a quad mesh can be turned into. None of them is certified: they are pictures
/// of a texture, to be written to a file. A boundary loop keeps its vertices, with the middles of its edges
/// between them where it says so.
enum class Polygon_kind {
  /// A polygon around every vertex, its corners in the middles of the quads: k sides where k quads meet.
  /// Boundary edges are cut in
  /// their middles.
  dual,
  /// Every edge becomes a quad between its ends and the middles of its quads: twice as many, turned by half a
  /// right angle. At
  /// boundary edges triangles.
  diagonal,
  /// Every quad is cut along a diagonal, neighbours along parallel ones, and a polygon is put around every
  /// vertex: hexagons, three
  /// at every corner. Around vertices of k quads there are polygons of 3 k / 2 sides for even k. Odd vertices
  /// come in pairs; between
  /// them runs a line where diagonals are not parallel, with pairs of polygons of five and seven sides.
  /// Boundary edges are cut in
  /// their middles.
  hexagons
};

/// "dual", "diagonal", "hex".
const char* name(Polygon_kind kind);

/// The polygons of a quad mesh, oriented as the quads. Fails with `not_a_surface` if the quads are not an
/// oriented manifold mesh. O(Q log Q).
Result<Polygon_soup> polygon_mesh(const Quad_mesh& mesh, Polygon_kind kind);

/// Number of sides -> number of polygons.
std::map<int, int> polygon_sizes(const Polygon_soup& mesh);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_POLYGON_MESH_H
