// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that give way: several contour edges are taken out of a draft and drawn anew, one after the other,
// in the region that their charts make up.
#ifndef REEBQUAD_EDITS_REDRAW_H
#define REEBQUAD_EDITS_REDRAW_H

#include "atlas/region_curve.h"
#include "edits/steps.h"

#include <functional>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Where a contour shall run: zero on it, positive on its left. Gets a point and the side (1 left, -1 right)
/// on which it lies of the contour as it was.
using Course = std::function<double(const Point& point, int home)>;

/// The course in a plane whose upper side is on the left.
Course plane_course(const Point& point, const Eigen::Vector3d& normal);

/// The course that an edge of a draft has; other contours push it away.
Course old_course(const Draft& draft, int edge);

/// Contour edges of a draft that are drawn anew. Each parts the region of all their charts: it is a free
/// loop, or one of several loops at one saddle, or the only edge that is drawn. The charts beside them are
/// bounded as before, whatever the courses; how far a contour could follow its course, `draw()` tells. A
/// failure leaves the draft in any state.
class Redrawing {
public:
  /// Takes the edges out. Fails with `refused_edit` if one of them is a boundary, or has the same region on
  /// both sides.
  static Result<Redrawing> of(Draft& draft, const std::vector<int>& edges);

  /// Lets the edges that end at a node end at another, inside the region.
  void move_node(int old, int fresh) { m_moved_nodes[old] = fresh; }

  /// Draws an edge; returns the share of its length that follows the course. With `either_sense` the course's
  /// other side may be the left one, whichever it can follow better.
  Result<double> draw(int edge, const Course& course, bool either_sense = false);

  /// The contour edge that kept the last one that was drawn from its course on most of its way, or -1.
  int obstacle() const { return m_obstacle; }

  /// On which side of an edge a vertex of the surface lies in the region as it was: 1 left, -1 right, 0 on it
  /// or elsewhere.
  int side_of(int edge, int vertex) const;

  /// Draws an edge as short as the contours around it allow.
  Result<void> draw_short(int edge);

  /// Cuts the draft. Fails with `refused_edit` if charts are not bounded as before.
  Result<void> finish();

private:
  explicit Redrawing(Draft& draft) : m_draft(draft) {}
  struct Asked {
    Open_region region;
    Region_sides sides;
    std::vector<double> raw; // the wish of the course alone
  };
  std::vector<signed char> homes_of_charts(int edge) const;
  Result<void> prepare_levels();
  Result<int> face_beside(const Embedding& embedding, int edge) const;
  Result<Asked> ask(int edge, const Course& course);
  struct Drawing;
  Result<Drawing> drawing(int edge, Asked asked) const;
  bool find_ends(int edge, Asked& asked) const;
  std::vector<signed char> homes(const Open_region& region, const std::vector<signed char>& of_chart) const;
  void hold_extrema(Asked& asked) const;
  void keep_off(int edge, Asked& asked) const;
  int wall_against(const Asked& asked) const;
  Result<void> insert(int edge, const Asked& asked, const Region_curve& curve);
  int node_of(int old) const { return m_moved_nodes.count(old) ? m_moved_nodes.at(old) : old; }

  Draft& m_draft;
  std::vector<int> m_edges;
  std::map<int, Contour_edge> m_old;
  std::set<int> m_free;                            // the free loops among them
  std::map<int, std::array<int, 2>> m_sides;       // the charts beside each edge that was there
  std::map<int, std::vector<signed char>> m_homes; // per edge: of the draft's charts
  std::map<int, int> m_drawn, m_origin;            // the new edge of an old one, and back
  std::map<int, int> m_moved_nodes;
  std::vector<int> m_charts;          // of the region, in increasing order
  std::vector<int> m_chart_of_vertex; // of the surface: a chart of the region inside which it lies, or -1
  std::vector<double> m_level;        // there, from 0 on the low side of its chart to 1 on the high one
  std::map<int, double> m_height;     // of charts
  std::vector<Chart_signature> m_before;
  int m_obstacle = -1;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_EDITS_REDRAW_H
