// SPDX-License-Identifier: GPL-3.0-or-later
// The connection of polygons about which nothing is known: corners, grouped by edge and by fan.
#ifndef REEBQUAD_MEND_CORNERS_H
#define REEBQUAD_MEND_CORNERS_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Sets of integers that grow together; the smallest member represents its set, so nothing depends on the
/// order.
class Disjoint_sets {
public:
  explicit Disjoint_sets(int size);
  int find(int i) {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  void join(int i, int j) {
    i = find(i);
    j = find(j);
    if (i < j)
      m_parent[j] = i;
    else
      m_parent[i] = j;
  }

private:
  std::vector<int> m_parent;
};

/// Corner `c` of face `face[c]` lies at point `source[c]`; it stands also for the side of the face from there
/// to the point of corner `next[c]`. Corners of faces that are left out have face -1.
struct Corner_mesh {
  std::vector<int> source, next, face;
  int number_of_corners() const { return int(source.size()); }
  int target(int c) const { return source[next[c]]; }
};

/// The corners of the polygons for which `taken[p]`.
Corner_mesh corner_mesh(const Polygon_soup& soup, const std::vector<char>& taken);
/// The corners of triangles; corner 3 f + i belongs to triangle f.
Corner_mesh corner_mesh(const std::vector<Triangle>& triangles);

/// The sides grouped by edge; edges are ordered by their smaller point, then by their larger one.
struct Edge_groups {
  std::vector<int> begin = {0}; ///< number of edges + 1 entries
  std::vector<int> side;        ///< sides of edge e: side[begin[e]] .. side[begin[e + 1] - 1], increasing
  int number_of_edges() const { return int(begin.size()) - 1; }
  int size(int e) const { return begin[e + 1] - begin[e]; }
  int first(int e) const { return side[begin[e]]; }
  int second(int e) const { return side[begin[e] + 1]; }
};

Edge_groups group_edges(const Corner_mesh& mesh, int number_of_points);

/// Joins the corners that meet across the edges for which `joined(e)`, at both ends: the sets at a point are
/// its fans.
template <class Predicate>
Disjoint_sets join_fans(const Corner_mesh& mesh, const Edge_groups& edges, Predicate joined) {
  Disjoint_sets fans(mesh.number_of_corners());
  for (int e = 0; e < edges.number_of_edges(); ++e) {
    if (!joined(e)) continue;
    const int g = edges.first(e);
    for (int i = edges.begin[e] + 1; i < edges.begin[e + 1]; ++i) {
      const int h = edges.side[i];
      const bool alike = mesh.source[g] == mesh.source[h];
      fans.join(g, alike ? h : mesh.next[h]);
      fans.join(mesh.next[g], alike ? mesh.next[h] : h);
    }
  }
  return fans;
}

/// Whether the points lie on a line; exact for finite points.
bool are_collinear(const Point& a, const Point& b, const Point& c);

/// Whether a polygon has no area because of the positions of its points: all of them on one line.
bool is_flat(const Polygon_soup& soup, int polygon);

/// "(x, y, z)" with enough digits to find the place.
std::string text_of(const Point& p);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_CORNERS_H
