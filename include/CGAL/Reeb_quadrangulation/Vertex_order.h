// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_VERTEX_ORDER_H
#define CGAL_REEB_QUADRANGULATION_VERTEX_ORDER_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A total order of the vertices: all topology is decided on it, never on field values (simulation of
/// simplicity, Edelsbrunner and Mücke 1990).
struct Vertex_order {
  std::vector<int> rank;    ///< V entries, a permutation of 0 .. V-1
  std::vector<int> by_rank; ///< its inverse
};

/// Orders vertices by (level, value, index). `level` may be empty (all 0); a boundary loop that is a minimum
/// has level -1 and one that is a maximum +1, so that no interior vertex ever ranks among a loop's vertices.
/// Non-finite values are a precondition violation. O(V log V).
Vertex_order order_vertices(const std::vector<double>& values, const std::vector<signed char>& level = {});

/// The surface with a cone over each boundary loop. Original vertices, faces and halfedges keep their
/// indices; the apex of loop `i` (in the order of `boundary_loops()`) is vertex `V + i`.
struct Closed_surface {
  Triangle_surface surface;
  int original_vertices = 0;
  int original_faces = 0;
};
Closed_surface close_boundaries(const Triangle_surface& surface);

/// Critical points of an order on a closed surface.
struct Critical_points {
  std::vector<int> minima, maxima; ///< by increasing vertex index
  std::vector<int> saddles;        ///< by increasing rank
  std::vector<int> multiplicity;   ///< of each saddle: 1 is simple, 2 a monkey saddle, ...
};

/// Finds the critical points in O(F): a vertex is the middle one of exactly as many triangles as the sign of
/// the order changes around its link, so 0 is an extremum, 2 regular, 2 (k + 1) a saddle of multiplicity k.
/// \pre `closed` has no boundary.
Critical_points critical_points(const Triangle_surface& closed, const Vertex_order& order);

/// Removes every extremum that is not allowed, by the flooding of Tierny and Pascucci ("Generalized
/// topological simplification of scalar fields on surfaces", 2012), changing `values` and `order`
/// monotonically. Does nothing, in O(F), if there is none. Returns the number of rounds (0, normally; rarely
/// more than 1). \pre both allowed sets are non-empty.
int remove_extrema(const Triangle_surface& closed, const std::vector<int>& allowed_minima,
                   const std::vector<int>& allowed_maxima, std::vector<double>& values, Vertex_order& order);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_VERTEX_ORDER_H
