// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_DESIGN_DISLOCATION_PLACES_H
#define REEBQUAD_DESIGN_DISLOCATION_PLACES_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Where dislocations of an annulus do best. Their rows are those in which the lengths of the level lines,
/// over that of an edge, pass the numbers of columns: a dynamic program over the rows chooses them, by the
/// cost that counts have in sampling.h. In its row each goes where the level line's edges are shortest, if
/// columns end, or longest, and not near one placed before.
class Dislocation_places {
public:
  /// For `grid[0]` columns at the chart's low side, `grid[1]` rows, and edges of a length; keeps a reference.
  /// \pre The chart is an annulus.
  Dislocation_places(const Design_chart& chart, const std::array<int, 2>& grid, double edge_length);

  /// Chooses the rows, so that the high side has so many more columns; an even number. With a positive price
  /// of an end, columns also begin and end again where the chart is wider or thinner inside; else they only
  /// end, or only begin. Returns the number of dislocations.
  int choose_rows(int columns, double price_of_end = 0);

  /// The quads of the chart with these, about: a dislocation counts in the row where it begins.
  std::int64_t quads() const;

  /// The dislocations whose rows are chosen.
  std::vector<Design_dislocation> place();

private:
  struct Begin {
    int row, pairs; // of columns that begin; negative if they end
  };
  class Program;
  double cost(int row, int columns) const;
  double best_place(const Chart_locator& locator, int row, int columns, bool ends) const;

  const Design_chart& m_chart;
  int m_low;
  std::vector<double> m_levels, m_ideal;      // per level line: U, length over that of an edge
  std::vector<Begin> m_begins;                // by row
  std::vector<std::array<double, 2>> m_taken; // V and row of those that are placed
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DESIGN_DISLOCATION_PLACES_H
