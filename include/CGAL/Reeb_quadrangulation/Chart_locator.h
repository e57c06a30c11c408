// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CHART_LOCATOR_H
#define CGAL_REEB_QUADRANGULATION_CHART_LOCATOR_H

#include <CGAL/Reeb_quadrangulation/Chart_parameterization.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A place on a chart: a face and barycentric coordinates in it.
struct Chart_location {
  int face = -1;
  std::array<double, 3> weights{{0, 0, 0}};
};

/// The point of a location.
Point position(const Chart& chart, const Chart_location& location);

/// Finds where points of a chart's parameter domain lie on the chart: the search tree of section 7 of the
/// paper.
///
/// A grid lies over the triangles of the map, its cells about as large as their boxes; a cell that many boxes
/// reach into has a grid of its own, and so on. A query looks at the triangles of one cell, decides by exact
/// orientation predicates which of them contain the point, and takes the one with the smallest index: the
/// answer is a function of the map and the point alone.
///
/// Every point of the domain is found. On an annulus V is rounded to multiples of a power of two, so that
/// adding a turn is exact and neighbouring triangles agree about their common edge. Then the closed
/// counterclockwise triangles cover the domain, whatever rounding did to the map: it takes the chart's
/// boundary to the domain's boundary once around, and so covers each point once more counterclockwise than
/// clockwise. A point outside the domain goes to its nearest point; where a disc's border cuts off a corner
/// of the rectangle, to the nearest point of the chart's border.
///
/// Building takes O(F) for each depth of grids, a query O(depth): one on charts that are stretched evenly,
/// O(log F) where the triangles' sizes fall off exponentially, as they do along limbs. No more than a few
/// boxes may contain one point. The locator is a value of its own and refers neither to the chart nor to the
/// map. Queries may run in several threads at once.
class Chart_locator {
public:
  /// \pre The map is solved: `solve_columns()` or `solve_rectangle()`.
  Chart_locator(const Chart& chart, const Chart_parameterization& map);

  /// \pre `v` and `u` are finite.
  Chart_location locate(double v, double u) const;
  std::vector<Chart_location> locate(const std::vector<double>& v, const std::vector<double>& u) const;

private:
  struct Plane_triangle { ///< counterclockwise in the plane
    std::array<double, 3> v, u;
    int face;
  };
  struct Box {
    double v0, v1, u0, u1;
  };
  struct Grid {
    double v0, u0, columns_per_v, rows_per_u;
    int columns, rows;
    int first; ///< cell
    int column(double v) const;
    int row(double u) const;
  };
  struct Cell {
    int begin = 0, end = 0; ///< of `m_items`
    int grid = -1;          ///< instead of items
  };
  struct Border_edge {
    std::array<double, 2> v, u;
    int halfedge;
  };

  double rounded(double v) const { return (v + m_rounding) - m_rounding; }
  void add_triangle(const Chart& chart, const Chart_parameterization& map, int face);
  static Grid fit_grid(const Box& box, const std::vector<Box>& boxes);
  int build_grid(const Box& box, const std::vector<int>& items, int depth);
  void gather();
  void find_triangle(double v, double u, const Plane_triangle*& found) const;
  Chart_location nearest_on_border(double v, double u) const;

  bool m_periodic;
  double m_rounding = 0; ///< 0 on a disc
  Box m_domain;
  double m_last_v; ///< the greatest V of a triangle
  std::vector<Plane_triangle> m_triangles;
  std::vector<Grid> m_grids; ///< the first covers all
  std::vector<Cell> m_cells;
  std::vector<int> m_items; ///< triangles
  std::vector<Border_edge> m_border;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CHART_LOCATOR_H
