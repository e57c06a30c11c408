// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_DESIGN_DISLOCATION_PLACES_H
#define REEBQUAD_DESIGN_DISLOCATION_PLACES_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Where dislocations of an annulus do best. Their rows are those in which the lengths of the level lines,
/// over that of an edge, pass the numbers of columns: a dynamic program chooses them. In its row each goes
/// where the level line's edges are shortest, if columns end, or longest, and not near one placed before.
class Dislocation_places {
public:
  /// For `low` columns at the chart's low side and edges of a length; keeps a reference. \pre The chart is an
  /// annulus.
  Dislocation_places(const Design_chart& chart, int low, double edge_length);

  /// Places dislocations so that the high side has so many more columns; an even number.
  std::vector<Design_dislocation> place(int columns);

private:
  std::vector<int> choose_rows(int number, int columns_each, int columns_of_last) const;
  double cost(int row, int columns) const;
  double best_place(int row, int columns, bool ends) const;

  const Design_chart& m_chart;
  int m_low;
  std::vector<double> m_levels, m_ideal;      // per level line: U, length over that of an edge
  std::vector<std::array<double, 2>> m_taken; // V and row of those that are placed
  Chart_locator m_locator;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DESIGN_DISLOCATION_PLACES_H
