// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/defects.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

namespace {

// Later rounds move hardly anything.
constexpr int rounds_of_polish = 10;

// So often what has spoilt something is taken back, each time with more around it, before all is.
constexpr int withdrawals = 3;

// A vertex farther from the surface, in edges, has left it for a reason, and would be brought back.
constexpr double on_surface = 1e-6;

} // namespace

std::vector<int> polish(State& state, double wanted, const std::vector<int>& defects, Observer* observer) {
  const State::Snapshot snapshot = state.snapshot();
  std::vector<char> free(state.number_of_vertices(), 1);
  for (int v = 0; v < state.number_of_vertices(); ++v) {
    const Point& p = state.mesh.points[v];
    free[v] = (state.constrain(v, p).point - p).norm() <= on_surface * state.size_around(v);
  }
  untangle(state, wanted, rounds_of_polish, &free, observer);
  return without_new_defects(state, snapshot, defects, withdrawals);
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
