// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_DISLOCATIONS_H
#define CGAL_REEB_QUADRANGULATION_DISLOCATIONS_H

#include <CGAL/Reeb_quadrangulation/Placed_texture.h>

#include <array>
#include <vector>

/// \file
/// Dislocations: columns of an annulus that end between its walks, or begin there.
///
/// Where two neighbouring columns end, the two cells at their end are triangles that share the edge between
/// them. Without that edge they are one quad, and the column of vertices between them ends in its lower
/// corner, which keeps three edges; its upper corner gets a fifth one. All else stays regular: a pair of a
/// vertex of valence 3 and one of valence 5 at opposite corners of a quad takes two columns. Where a second
/// pair begins in the vertex of valence 5 that the first ends in, that vertex is regular, so `k` pairs in a
/// row end `2 k` columns with two extraordinary vertices. They enclose quads that are turned by 45 degrees,
/// which is why there are at most `most_pairs` of them. Upside down, columns begin.

namespace CGAL {
namespace Reeb_quadrangulation {

/// A dislocation in the domain of an annulus.
struct Dislocation {
  static constexpr int most_pairs = 3; ///< that follow each other

  double v = 0, u = 0; ///< about where its quads are to lie
  int columns = -2;    ///< that begin in it, going up, or end if negative: even, of 1 to `most_pairs` pairs

  int pairs() const { return (columns < 0 ? -columns : columns) / 2; }
  /// Whether the number of columns is one that a dislocation can have.
  static bool is_number(int columns) {
    return columns != 0 && columns % 2 == 0 && -2 * most_pairs <= columns && columns <= 2 * most_pairs;
  }
};

/// The fewest rows of an annulus with dislocations, no other than which have as many pairs: their vertices of
/// valence 3 keep off the walks, where the chart on the other side could take another edge from them.
int rows_for_dislocations(int most_pairs);

/// A texture with dislocations, and where they have come to lie.
struct Dislocated_texture {
  Quad_texture texture;
  std::vector<std::array<int, 2>> ends; ///< of each dislocation: its vertices of valence 3 and 5
};

/// An annulus of `columns` columns at its low side and as many more at its high side as the dislocations say,
/// in `levels.size() - 1` rows whose levels are those given. Each dislocation goes to the row and the column
/// nearest to its place where it fits beside the others: off the walks if the rows allow it, and with a
/// regular column between two of a row. Fails with `impossible_request` where there is no room for all, or
/// where fewer than four columns would be left. O(Q log Q). \pre `columns` is at least 4, and the levels
/// increase.
Result<Dislocated_texture> dislocated_annulus_texture(int columns, const std::vector<double>& levels,
                                                      const std::vector<Dislocation>& dislocations);

/// Evens out a texture around some of its vertices: those within `rings` edges of them that are not on sides
/// move towards the mean of their neighbours, on the surface, `steps` times. No quad is inverted in the
/// plane. Updates `location`. O(F) and O(steps) for each vertex.
void smooth_around(const std::vector<int>& vertices, int rings, int steps, const Chart& chart,
                   const Chart_parameterization& map, Placed_texture& placed);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_DISLOCATIONS_H
