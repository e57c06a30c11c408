// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_STITCHING_T_JUNCTIONS_H
#define REEBQUAD_STITCHING_T_JUNCTIONS_H

#include "base/quad_connectivity.h"
#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include "textures/edge_table.h"

#include <array>
#include <map>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A quad mesh with hanging edges while lines are drawn through it.
class Hanging_mesh {
public:
  using Edge = std::pair<int, int>;

  Hanging_mesh(const Quad_mesh& mesh, const T_junction_options& options);

  Result<void> add_edges();
  Result<void> add(const Hanging_edge& edge);

  const std::vector<Quad>& quads() const { return m_quads; }
  int source(int h) const { return internal::source(m_quads, h); }
  int target(int h) const { return internal::target(m_quads, h); }
  /// The opposite halfedge, or -1 on the boundary and on hanging edges.
  int opposite(int h) const { return m_table.find(target(h), source(h)); }
  int find(const Edge& e) const { return m_table.find(e.first, e.second); }
  bool is_fixed(int quad) const { return !m_options.fixed.empty() && m_options.fixed[m_parent[quad]]; }
  /// The hanging edge of the other side of which a halfedge without an opposite is a part, or null.
  const Edge* whole(int h) const {
    const int k = m_parts.find(target(h), source(h));
    return k < 0 ? nullptr : &m_keys[k];
  }
  /// The T-junctions of each hanging edge, by its ends.
  const std::map<Edge, std::vector<int>>& hanging() const { return m_hanging; }

  /// A quad on a line, and the edges where the line enters and leaves it, as corners.
  struct Crossing {
    int quad, in, out;
  };

  /// Draws a line along a path from a hanging edge to another, to the boundary, or to a part of one, which
  /// gets a T-junction.
  void draw_line(const std::vector<Crossing>& path);
  /// Joins the T-junctions of a hanging edge with an even number of them, the outermost first.
  void draw_templates(const Edge& edge);

  Resolved_mesh finish(const Quad_mesh& before) const;
  int templates = 0;

private:
  Point point(int quad, int corner) const { return m_points[m_quads[quad][corner & 3]]; }
  Point inside(int quad, int in, double along, double depth) const;
  double fraction(int a, int vertex, int b) const;
  int add_vertex(const Point& p);
  int end_of_line(const Crossing& c, bool start);
  int cross_edge(int a, int b);
  void add_edge(int a, int b);
  void split(const Crossing& c, int m, int n);
  void replace(int quad, const std::vector<Quad>& parts);
  std::vector<int> take_hanging(int a, int b);
  void set_hanging(int a, int b, std::vector<int> vertices);

  const T_junction_options& m_options;
  std::vector<Point> m_points;
  std::vector<Quad> m_quads;
  std::vector<int> m_parent;
  std::vector<char> m_gone;
  std::vector<int> m_added_edges;
  Edge_table m_table; ///< directed edge -> halfedge
  Edge_table
      m_parts; ///< directed edge of the coarse side, between consecutive T-junctions -> entry of `m_keys`
  std::vector<Edge> m_keys;
  std::map<Edge, std::vector<int>> m_hanging;
  std::vector<int> m_t_junctions;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_STITCHING_T_JUNCTIONS_H
