// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_ADAPT_QUADS_H
#define CGAL_REEB_QUADRANGULATION_ADAPT_QUADS_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include <functional>
#include <map>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A mesh in which some quads were subdivided.
struct Refined_quads {
  Quad_mesh mesh;          ///< all vertices before keep their numbers and places
  std::vector<int> parent; ///< per quad: the quad before that it is a part of
  int t_junctions = 0;     ///< between quads that were subdivided and others
  /// What subdividing changes in the numbers of inner vertices by valence, predicted from the edges that it
  /// adds.
  std::map<int, int> valence_changes;
};

/// Splits the quads that are marked into four, at the middles of their edges, and leads from them to the
/// others by `resolve_t_junctions()`: one-sided subdivision of any region. O(Q log Q) and as
/// `resolve_t_junctions()`. Fails with `not_a_surface` if the quads are not an oriented manifold mesh. \pre
/// One mark a quad.
Result<Refined_quads> refine_quads(const Quad_mesh& mesh, const std::vector<char>& marked,
                                   const T_junction_options& options = {});

/// Where quads shall be how fine.
struct Adaptive_options {
  /// How many times finer, in length, the finest quads are than the others: 2, 4 or 8.
  int ratio = 2;
  /// By curvature: about so many quads there shall be in the end; 0: twice as many as before for each step
  /// from a length to its half.
  int quads = 0;
  /// By curvature: quads over which the surface's normal turns less than so many degrees are not subdivided.
  double flat = 12;
  /// The length that edges shall have at a point. If given, it decides instead of the curvature: a quad is
  /// subdivided as long as the mean of its edges is longer by the square root of 2.
  std::function<double(const Point&)> size = {};
  /// The same for each vertex of the projector's surface, linear in triangles; read where `size` is not
  /// given. A recipe keeps them.
  std::vector<double> sizes = {};
  /// How the lines from finer to coarser quads go: rather far and straight, so that they make few
  /// extraordinary vertices.
  T_junction_options lines = {15, true, {}};
};

/// A mesh after `adapt_quads()`.
struct Adapted_quads {
  Quad_mesh mesh;
  std::vector<int> parent; ///< per quad: the quad before that it is a part of
  std::map<int, int> valence_changes;
  int subdivided = 0; ///< quads of all steps
  int t_junctions = 0;
};

/// Subdivides the quads where the surface bends most within them, or where `size` asks for it, step by step.
/// How much it bends is the greatest angle between the normals of the surface at nine points of the quad,
/// averaged over its surroundings. The borders of regions are smoothed: corners are filled, and what sticks
/// out is left. New vertices are put on the surface; relax the mesh afterwards. Fails with
/// `impossible_request` if an option is out of range, or a size is not positive. Time: nine closest-point
/// queries a quad and step, and O(log Q) times `refine_quads()`.
Result<Adapted_quads> adapt_quads(const Quad_mesh& mesh, const Surface_projector& projector,
                                  const Adaptive_options& options = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_ADAPT_QUADS_H
