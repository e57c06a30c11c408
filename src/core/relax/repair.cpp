// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/defects.h"
#include "relax/relax_state.h"

#include <algorithm>
#include <array>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

namespace {

// One way to mend the regions: sweeps under a regime and untangling; or averaging in space; or moving single
// vertices apart.
struct Attempt {
  Regime regime;
  int sweeps = 0;
  int rings = 3; // of quads around the defects that may move
  bool from_original =
      false;          // from where the vertices were before relaxation; otherwise lenient from where they are
  double offset = 0;  // how far single vertices may leave the surface
  int averagings = 0; // of each vertex and its neighbours in space
};

Attempt move_apart(double offset) {
  return {{}, 0, 3, false, offset};
}

// In a fold of the surface that is narrower than the quads these cannot stay apart unless they cut it off.
Attempt cut_off(int averagings, int rings) {
  Attempt attempt;
  attempt.averagings = averagings;
  attempt.rings = rings;
  return attempt;
}

// From gentle and local to drastic and wide. Even spacing lets the coarse parts of a layout borrow vertices
// from the fine ones; memory of the original lengths keeps quads on thin limbs from sliding off.
std::array<Attempt, 17> all_attempts() {
  return {move_apart(0),
          Attempt{{0.15, 1, 0.7}, 4, 4, true},
          Attempt{{0.15, 1, 0.5}, 12, 3},
          Attempt{{0.4, 1, 0}, 20, 4},
          move_apart(0),
          Attempt{{0.4, 1, 0.5}, 20, 6},
          Attempt{{0.4, 1, 0}, 40, 8},
          Attempt{{0.8, 0, 0}, 40, 8},
          move_apart(0.3),
          cut_off(4, 2),
          cut_off(10, 3),
          move_apart(0.3),
          Attempt{{0.4, 1, 0.5}, 60, 16},
          Attempt{{0.8, 0, 0}, 80, 24},
          move_apart(0.3),
          Attempt{{0.15, 1, 0.7}, 6, 8, true},
          move_apart(0.5)};
}

// Brings the vertices halfway to the mean of their neighbours, without regard to the surface.
void average(State& state, int rounds, const std::vector<char>& mask) {
  for (int round = 0; round < rounds; ++round)
    for (int v = 0; v < state.number_of_vertices(); ++v) {
      if (!mask[v] || state.sites[v].freedom != Freedom::surface) continue;
      Point sum = Point::Zero();
      for (int k = state.first[v]; k < state.first[v + 1]; ++k) {
        const Quad& q = state.mesh.quads[state.corners[k] / 4];
        sum += state.mesh.points[q[(state.corners[k] % 4 + 1) % 4]];
      }
      const Point& from = state.mesh.points[v];
      const Point target = 0.5 * (from + sum / double(state.first[v + 1] - state.first[v]));
      Step step = state.constrain(v, target);
      step.point = target;
      state.move(v, step);
    }
}

void carry_out(State& state, const Attempt& attempt, const std::vector<char>& mask,
               const State::Snapshot& original, Observer* observer) {
  if (attempt.averagings > 0) {
    average(state, attempt.averagings, mask);
    return;
  }
  if (attempt.sweeps == 0) {
    separate(state, attempt.offset, 8, observer);
    return;
  }
  if (attempt.from_original)
    for (int v = 0; v < state.number_of_vertices(); ++v)
      if (mask[v] && state.sites[v].freedom == Freedom::surface) state.restore(original, v);
  for (int i = 0; i < attempt.sweeps; ++i) {
    if (observer && observer->cancelled()) return;
    const bool early = 2 * i < attempt.sweeps;
    smooth(state, attempt.regime, {early ? 0.2 : 0.4, early && !attempt.from_original, &mask});
  }
  untangle(state, 0.1, 10, &mask, observer);
}

// Takes the regions back that have not fewer defects than before. Returns whether there was one.
bool take_back(State& state, const Regions& regions, const State::Snapshot& snapshot,
               const std::vector<int>& before, const std::vector<int>& now) {
  const std::vector<int> sum_before = regions.sum(state, before), sum_now = regions.sum(state, now);
  bool any = false;
  for (int v = 0; v < state.number_of_vertices(); ++v) {
    const int region = regions.of_vertex[v];
    if (region < 0 || sum_now[region] < sum_before[region]) continue;
    state.restore(snapshot, v);
    any = true;
  }
  return any;
}

} // namespace

std::vector<int> repair(State& state, const State::Snapshot& original, int attempts, Observer* observer) {
  std::vector<int> defects = count_defects(state);
  int made = 0;
  for (const Attempt& attempt : all_attempts()) {
    const std::ptrdiff_t good = std::count(defects.begin(), defects.end(), 0);
    if (good == std::ptrdiff_t(defects.size()) || (observer && observer->cancelled())) break;
    // A mesh that is bad all over needs another layout; the drastic attempts would only take time.
    const double bad = 1 - double(good) / double(defects.size());
    if (made == attempts) break;
    if (++made > 4 ? bad > 0.05 : made > 1 && bad > 0.15) break;
    const Regions regions(state, defects, attempt.rings);
    const State::Snapshot snapshot = state.snapshot();
    carry_out(state, attempt, regions.mask(), original, observer);
    const std::vector<int> now = count_defects(state);
    defects = take_back(state, regions, snapshot, defects, now) ? count_defects(state) : now;
  }
  return defects;
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
