// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SAMPLING_COUNT_PROBLEM_H
#define REEBQUAD_SAMPLING_COUNT_PROBLEM_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A convex cost of one count: how far from its ideal, how far from the previous count, how many quads it
/// makes.
struct Count_cost {
  double ideal = 0;
  double weight = 0;    ///< times (n - ideal)^2 / n: twice as many cost as much as half as many
  double stability = 0; ///< times |n - previous|
  double linear = 0;    ///< times n
  double cap = 0;       ///< times the quads of a cap with n edges around it
  int previous = 0;
  int most = std::numeric_limits<int>::max(); ///< more cost as good as everything

  double operator()(std::int64_t n) const {
    const double m = double(std::max<std::int64_t>(n, 1)), d = m - ideal;
    // Below one it goes on as a line, which keeps it convex.
    double cost = weight * (d * d / m + (m - double(n)) * ideal * ideal) + linear * double(n);
    if (stability > 0) cost += stability * std::abs(double(n - previous));
    if (n > most) cost += 1e9 * double(n - most);
    if (cap > 0) cost += cap * double((n / 4) * (n / 2 - n / 4));
    return cost;
  }
};

/// An integer unknown `n = minimum + step k`, `k >= 0`, or a constant if `fixed`.
struct Count_variable {
  Count_cost cost;
  int minimum = 2;
  int step = 2;
  bool fixed = false; ///< then n = minimum
};

/// A linear equation `sum coefficient * n = 0`, on behalf of a chart.
struct Count_row {
  std::vector<std::pair<int, int>>
      terms; ///< (variable, coefficient), variables ascending, coefficients not 0
  int chart = -1;
};

/// Minimise a separable convex function of integers subject to homogeneous equations.
struct Count_problem {
  std::vector<Count_variable> variables;
  std::vector<Count_row> rows;
};

/// Whether every free unknown leaves at most one row and enters at most one, with equal weight, in steps of
/// two: then the equations are those of a flow.
bool is_network(const Count_problem& problem);

/// The exact minimum of a network. \pre `is_network(problem)`
Result<std::vector<int>> solve_network(const Count_problem& problem);

/// A good solution of any problem: feasibility is exact when nothing is fixed, optimality is with respect to
/// moves along sums and differences of two vectors of a reduced lattice basis.
Result<std::vector<int>> solve_lattice(const Count_problem& problem);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SAMPLING_COUNT_PROBLEM_H
