// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/defects.h"
#include "relax/relax_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

namespace {

// A smooth stand-in for "the worst quality around v": large where one quad is bad, flat where all are good.
// What is at least `most` may be told as anything from it on.
double penalty(const State& state, int v, const Step& step,
               double most = std::numeric_limits<double>::infinity()) {
  double sum = 0;
  for (int k = state.first[v]; k < state.first[v + 1] && sum < most; ++k)
    sum += std::exp(-7 * state.quality(state.corners[k] / 4, v, step));
  return sum;
}

bool touches(const State& state, int q, const std::vector<char>& mask) {
  const Quad& quad = state.mesh.quads[q];
  return mask[quad[0]] || mask[quad[1]] || mask[quad[2]] || mask[quad[3]];
}

// Pattern search on the surface: eight directions in the tangent plane, steps from half the size of the quads
// down.
bool improve(State& state, int v) {
  const Site& site = state.sites[v];
  if (site.freedom == Freedom::fixed) return false;
  const double size = state.size_around(v);
  double best = penalty(state, v, state.here(v));
  const double start = best;
  int moves = 0;
  for (double step = 0.5 * size; step > 0.01 * size;) {
    const Point n = state.normal(v), side = n.unitOrthogonal(), other = n.cross(side);
    Step found;
    for (int i = 0; i < 8; ++i) {
      static const double half = std::sqrt(0.5);
      static const double cosine[8] = {1, half, 0, -half, -1, -half, 0, half};
      const Point target = state.mesh.points[v] + step * (cosine[i] * side + cosine[(i + 6) % 8] * other);
      const Step candidate = state.constrain(v, target);
      const double less = best * (1 - 1e-4), p = penalty(state, v, candidate, less);
      if (p >= less) continue;
      best = p;
      found = candidate;
    }
    if (found.face >= 0) state.move(v, found);
    if (found.face < 0 || ++moves > 20) step *= 0.5;
  }
  return best < start * (1 - 1e-3);
}

} // namespace

void untangle(State& state, double wanted, int rounds, const std::vector<char>* mask, Observer* observer) {
  const int nq = int(state.mesh.quads.size());
  // A vertex that did not get better is not tried again before something around it has moved.
  std::vector<char> at_rest(state.number_of_vertices(), 0);
  const auto wake = [&](int v) {
    for (int k = state.first[v]; k < state.first[v + 1]; ++k)
      for (int w : state.mesh.quads[state.corners[k] / 4]) at_rest[w] = 0;
  };
  for (int round = 0; round < rounds; ++round) {
    if (observer && observer->cancelled()) return;
    std::vector<char> chosen(state.number_of_vertices(), 0);
    bool any = false;
    for (int q = 0; q < nq; ++q)
      if ((!mask || touches(state, q, *mask)) && state.quality(q) < wanted) {
        any = true;
        for (int v : state.mesh.quads[q]) chosen[v] = 1;
      }
    if (!any) return;
    // Each further round that is needed lets one more ring of vertices give way, up to three.
    add_rings(state.mesh, std::min(round / 3, 3), chosen);
    bool improved = false;
    for (int v = 0; v < state.number_of_vertices(); ++v) {
      if (!chosen[v] || at_rest[v] || (mask && !(*mask)[v])) continue;
      if (improve(state, v)) {
        improved = true;
        wake(v);
      } else {
        at_rest[v] = 1;
      }
    }
    if (!improved && round >= 9) return;
  }
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
