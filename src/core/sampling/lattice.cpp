// SPDX-License-Identifier: GPL-3.0-or-later
// Counts whose equations are not a flow: the integer solutions are a point plus a lattice; walk in the
// lattice.
#include "sampling/count_problem.h"

#include <CGAL/Exact_integer.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <algorithm>
#include <limits>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

using Integer = CGAL::Exact_integer;
using Vector = std::vector<std::int64_t>;

constexpr std::int64_t largest_count = std::numeric_limits<int>::max() / 4;

Error infeasible(int chart, const std::string& why) {
  return make_error(Error_code::infeasible_sampling,
                    "the counts around chart " + std::to_string(chart) + " cannot be balanced: " + why,
                    Element_kind::chart, chart);
}

// The free unknowns alone, in steps k >= 0 above their minima: matrix * k = right.
struct Step_system {
  std::vector<int> variables;
  std::vector<Vector> matrix; // rows
  Vector right;
  std::vector<int> chart; // of each row
};

Step_system step_system(const Count_problem& problem) {
  Step_system s;
  std::vector<int> column(problem.variables.size(), -1);
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (problem.variables[i].fixed) continue;
    column[i] = int(s.variables.size());
    s.variables.push_back(int(i));
  }
  for (const Count_row& row : problem.rows) {
    s.matrix.emplace_back(s.variables.size(), 0);
    std::int64_t right = 0;
    for (const auto& [i, coefficient] : row.terms) {
      const Count_variable& v = problem.variables[i];
      right -= std::int64_t(coefficient) * v.minimum;
      if (column[i] >= 0) s.matrix.back()[column[i]] += std::int64_t(coefficient) * v.step;
    }
    s.right.push_back(right);
    s.chart.push_back(row.chart);
  }
  return s;
}

// The integer solutions of a system: a particular one and a basis of the homogeneous ones.
struct Solution_lattice {
  Vector point;
  std::vector<Vector> basis;
};

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  const std::int64_t q = a / b;
  return a % b != 0 && (a < 0) != (b < 0) ? q - 1 : q;
}

std::int64_t dot(const Vector& a, const Vector& b) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Unimodular column operations bring the matrix to an echelon form H; `point` solves H y = right on the way.
// Rows with few entries come first, and short columns are pivots: entries stay as small as those of the
// matrix in practice, where rows and columns as they come let them grow beyond all bounds.
class Echelon_form {
public:
  explicit Echelon_form(const Step_system& s)
      : m_system(s), m_rows(int(s.matrix.size())), m_columns(int(s.variables.size())) {
    for (int j = 0; j < m_columns; ++j) { // of the matrix above those of the transformation
      m_column.emplace_back(m_rows + m_columns, 0);
      for (int i = 0; i < m_rows; ++i) m_column[j][i] = s.matrix[i][j];
      m_column[j][m_rows + j] = 1;
    }
    m_residual = s.right; // right - H y above, -U y below
    m_residual.resize(m_rows + m_columns, 0);
  }

  Result<Solution_lattice> solve() {
    std::vector<int> left(m_rows);
    for (int i = 0; i < m_rows; ++i) left[i] = i;
    while (!left.empty()) {
      const auto next = std::min_element(left.begin(), left.end(), [&](int a, int b) {
        const int na = entries(a), nb = entries(b);
        return na != nb ? na < nb : a < b;
      });
      const int row = *next;
      left.erase(next);
      if (!eliminate(row)) return too_large(row);
      const std::int64_t pivot = m_rank < m_columns ? m_column[m_rank][row] : 0;
      if (m_residual[row] != 0 && (pivot == 0 || m_residual[row] % pivot != 0))
        return infeasible(m_system.chart[row],
                          "the locked counts leave a number that the free edges cannot make up");
      if (pivot == 0) continue;
      subtract(m_residual, m_residual[row] / pivot, m_column[m_rank]);
      ++m_rank;
    }
    Solution_lattice result;
    for (int j = 0; j < m_columns; ++j) result.point.push_back(-m_residual[m_rows + j]);
    for (int j = m_rank; j < m_columns; ++j)
      result.basis.emplace_back(m_column[j].begin() + m_rows, m_column[j].end());
    return result;
  }

private:
  static constexpr std::int64_t largest = std::int64_t(1) << 24; // products of such numbers can be summed

  static void subtract(Vector& a, std::int64_t q, const Vector& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= q * b[i];
  }
  Error too_large(int row) const {
    return infeasible(m_system.chart[row], "no integers were found for these counts");
  }
  int entries(int row) const {
    int n = 0;
    for (int j = m_rank; j < m_columns; ++j) n += m_column[j][row] != 0;
    return n;
  }

  // Euclid's algorithm on the entries of a row beyond the pivots; false if a number becomes too large.
  bool eliminate(int row) {
    while (true) {
      int pivot = -1;
      std::int64_t shortest = 0;
      for (int j = m_rank; j < m_columns; ++j) {
        const std::int64_t entry = std::abs(m_column[j][row]), length = dot(m_column[j], m_column[j]);
        if (entry == 0) continue;
        const std::int64_t best = pivot < 0 ? 0 : std::abs(m_column[pivot][row]);
        if (pivot >= 0 && (entry > best || (entry == best && length >= shortest))) continue;
        pivot = j;
        shortest = length;
      }
      if (pivot < 0) return true;
      std::swap(m_column[m_rank], m_column[pivot]);
      bool done = true;
      for (int j = m_rank + 1; j < m_columns; ++j) {
        if (m_column[j][row] == 0) continue;
        const std::int64_t p = m_column[m_rank][row];
        subtract(m_column[j], floor_divide(2 * m_column[j][row] + p, 2 * p), m_column[m_rank]);
        done = done && m_column[j][row] == 0;
        for (std::int64_t x : m_column[j])
          if (std::abs(x) > largest) return false;
      }
      if (done) return true;
    }
  }

  const Step_system& m_system;
  int m_rows, m_columns, m_rank = 0;
  std::vector<Vector> m_column;
  Vector m_residual;
};

// Shortens the basis by pairwise reduction (Gauss, Lagrange) until no vector is shortened by another.
void reduce(std::vector<Vector>& basis) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < basis.size(); ++i)
      for (std::size_t j = 0; j < basis.size(); ++j) {
        if (i == j) continue;
        const std::int64_t norm = dot(basis[j], basis[j]), product = dot(basis[i], basis[j]);
        if (2 * std::abs(product) <= norm) continue;
        const std::int64_t q = floor_divide(2 * product + norm, 2 * norm);
        for (std::size_t k = 0; k < basis[i].size(); ++k) basis[i][k] -= q * basis[j][k];
        changed = true;
      }
  }
}

// A vertex of { k >= 0, matrix * k = right } as numerators over a common denominator, or the reason for none:
// a combination of the rows that no k satisfies (Farkas), of which the heaviest row is named.
struct Rational_point {
  std::vector<Integer> numerator;
  Integer denominator = 1;
};

Result<Rational_point> rational_point(const Step_system& s) {
  CGAL::Quadratic_program<int> program(CGAL::EQUAL, true, 0, false, 0);
  for (std::size_t i = 0; i < s.matrix.size(); ++i) {
    for (std::size_t j = 0; j < s.matrix[i].size(); ++j)
      if (s.matrix[i][j] != 0) program.set_a(int(j), int(i), int(s.matrix[i][j]));
    program.set_b(int(i), int(s.right[i]));
    program.set_r(int(i), CGAL::EQUAL);
  }
  // Few steps in all: a start near the minima.
  for (std::size_t j = 0; j < s.variables.size(); ++j) program.set_c(int(j), 1);
  const auto solution = CGAL::solve_nonnegative_linear_program(program, Integer());
  if (solution.is_infeasible()) {
    int heaviest = 0;
    double most = -1;
    auto y = solution.infeasibility_certificate_begin();
    for (std::size_t i = 0; i < s.matrix.size(); ++i, ++y) {
      const double weight = std::abs(CGAL::to_double(*y));
      if (weight > most && s.chart[i] >= 0) {
        most = weight;
        heaviest = int(i);
      }
    }
    return infeasible(s.chart[heaviest], "the equations of this layout force a count below its minimum");
  }
  Rational_point result;
  result.denominator = solution.variables_common_denominator();
  for (auto v = solution.variable_numerators_begin(); v != solution.variable_numerators_end(); ++v)
    result.numerator.push_back(*v);
  return result;
}

// Minimises in the lattice, first how far steps are below zero, then the cost.
class Lattice_walk {
public:
  Lattice_walk(const Count_problem& problem, const Step_system& system, const std::vector<Vector>& basis)
      : m_problem(problem), m_system(system) {
    for (const Vector& b : basis) add_move(b);
    const std::size_t n = basis.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        if (!overlap(basis[i], basis[j])) continue;
        Vector sum(basis[i]), difference(basis[i]);
        for (std::size_t k = 0; k < sum.size(); ++k) {
          sum[k] += basis[j][k];
          difference[k] -= basis[j][k];
        }
        add_move(sum);
        add_move(difference);
      }
  }

  // Ends where no move gains, or after many rounds: from far away, along an edge of what is allowed, gains
  // can be tiny ones for ever.
  void descend(Vector& k) const {
    constexpr int most_rounds = 500;
    bool improved = true;
    for (int round = 0; improved && round < most_rounds; ++round) {
      improved = false;
      for (const Move& move : m_moves)
        for (int sign : {1, -1}) improved = slide(k, move, sign) || improved;
    }
  }

private:
  using Move = std::vector<std::pair<int, std::int64_t>>;

  static bool overlap(const Vector& a, const Vector& b) {
    for (std::size_t k = 0; k < a.size(); ++k)
      if (a[k] != 0 && b[k] != 0) return true;
    return false;
  }
  void add_move(const Vector& v) {
    Move move;
    for (std::size_t k = 0; k < v.size(); ++k)
      if (v[k] != 0) move.emplace_back(int(k), v[k]);
    m_moves.push_back(move);
  }
  // Lexicographic: steps below zero, then cost. Both are convex along a line.
  std::pair<std::int64_t, double> value(const Vector& k, const Move& move, std::int64_t t) const {
    std::pair<std::int64_t, double> sum(0, 0);
    for (const auto& [j, d] : move) {
      const std::int64_t steps = k[j] + t * d;
      const Count_variable& v = m_problem.variables[m_system.variables[j]];
      sum.first += std::max<std::int64_t>(0, -steps);
      sum.second += v.cost(v.minimum + v.step * steps);
    }
    return sum;
  }
  // Moves while that gains, with doubling strides.
  bool slide(Vector& k, const Move& move, int sign) const {
    bool moved = false;
    auto now = value(k, move, 0);
    for (std::int64_t stride = 1;;) {
      const auto then = value(k, move, sign * stride);
      const bool gain =
          then.first < now.first || (then.first == now.first && then.second < now.second - slack(now));
      if (gain) {
        for (const auto& [j, d] : move) k[j] += sign * stride * d;
        now = then;
        moved = true;
        stride *= 2;
      } else if (stride > 1) {
        stride /= 2;
      } else {
        return moved;
      }
    }
  }
  // Gains below rounding are none: they could cycle.
  static double slack(const std::pair<std::int64_t, double>& value) { return 1e-12 * std::abs(value.second); }

  const Count_problem& m_problem;
  const Step_system& m_system;
  std::vector<Move> m_moves;
};

// The lattice point near a rational one: coordinates rounded one basis vector after the other.
Vector near_point(const Solution_lattice& lattice, const Rational_point& target) {
  Vector k(lattice.point);
  const double scale = CGAL::to_double(target.denominator);
  std::vector<double> goal(k.size());
  for (std::size_t j = 0; j < k.size(); ++j) goal[j] = CGAL::to_double(target.numerator[j]) / scale;
  for (int pass = 0; pass < 8; ++pass)
    for (const Vector& b : lattice.basis) {
      double product = 0;
      for (std::size_t j = 0; j < k.size(); ++j) product += double(b[j]) * (goal[j] - double(k[j]));
      const std::int64_t t = std::llround(product / double(dot(b, b)));
      for (std::size_t j = 0; j < k.size(); ++j) k[j] += t * b[j];
    }
  return k;
}

bool nonnegative(const Vector& k) {
  return std::all_of(k.begin(), k.end(), [](std::int64_t steps) { return steps >= 0; });
}

// A multiple of a rational solution of homogeneous equations is an integer one, and above the same minima.
// Nothing if it is too large to be of use.
Vector multiple_point(const Count_problem& problem, const Step_system& s, const Rational_point& p) {
  Vector k;
  const Integer& d = p.denominator;
  for (std::size_t j = 0; j < s.variables.size(); ++j) {
    const Count_variable& v = problem.variables[s.variables[j]];
    // n = minimum + step * (p / d); all steps divide 2, so 2 d n is a multiple of them.
    const double n = CGAL::to_double(Integer(2 * (d * v.minimum + v.step * p.numerator[j])));
    if (n > double(largest_count)) return {};
    k.push_back((std::int64_t(n) - v.minimum) / v.step);
  }
  return k;
}

} // namespace

Result<std::vector<int>> solve_lattice(const Count_problem& problem) {
  const Step_system system = step_system(problem);
  Result<Solution_lattice> lattice = Echelon_form(system).solve();
  if (!lattice) return lattice.error();
  const Result<Rational_point> rational = rational_point(system);
  if (!rational) return rational.error();
  reduce(lattice->basis);
  const Lattice_walk walk(problem, system, lattice->basis);
  Vector k = near_point(*lattice, *rational);
  walk.descend(k);
  const bool homogeneous = system.variables.size() == problem.variables.size();
  if (!nonnegative(k) && homogeneous) {
    if (Vector multiple = multiple_point(problem, system, *rational); !multiple.empty()) {
      k = std::move(multiple);
      walk.descend(k);
    }
  }
  if (!nonnegative(k)) {
    const int chart = system.chart.empty() ? -1 : system.chart.front();
    return infeasible(chart, "no integers were found for these locked counts; unlock one of them");
  }
  std::vector<int> counts;
  for (const Count_variable& v : problem.variables) counts.push_back(v.minimum);
  for (std::size_t j = 0; j < system.variables.size(); ++j) {
    const Count_variable& v = problem.variables[system.variables[j]];
    const std::int64_t n = v.minimum + v.step * k[j];
    if (n > largest_count)
      return make_error(Error_code::impossible_request,
                        "the sampling needs more than 10^8 edges on one contour");
    counts[system.variables[j]] = int(n);
  }
  return counts;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
