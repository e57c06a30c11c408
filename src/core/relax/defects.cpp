// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/defects.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

std::vector<int> count_defects(const State& state) {
  std::vector<int> defects(state.mesh.quads.size(), 0);
  for (int q = 0; q < int(defects.size()); ++q) {
    const Quad& v = state.mesh.quads[q];
    const std::vector<Point>& p = state.mesh.points;
    defects[q] = scaled_jacobian(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) < 0.01;
  }
  for (const auto& [i, j] : intersecting_quads(state.mesh)) {
    ++defects[i];
    ++defects[j];
  }
  return defects;
}

namespace {

// The vertices within so many quads of a defect.
std::vector<char> near_defects(const State& state, const std::vector<int>& defects, int rings) {
  std::vector<char> mask(state.number_of_vertices(), 0);
  for (std::size_t q = 0; q < defects.size(); ++q)
    if (defects[q])
      for (int v : state.mesh.quads[q]) mask[v] = 1;
  add_rings(state.mesh, rings, mask);
  return mask;
}

bool has_more(const std::vector<int>& now, const std::vector<int>& before) {
  for (std::size_t q = 0; q < now.size(); ++q)
    if (now[q] > before[q]) return true;
  return false;
}

} // namespace

void add_rings(const Quad_mesh& mesh, int rings, std::vector<char>& mask) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> inner = mask;
    for (const Quad& q : mesh.quads)
      if (inner[q[0]] || inner[q[1]] || inner[q[2]] || inner[q[3]])
        for (int v : q) mask[v] = 1;
  }
}

std::vector<int> without_new_defects(State& state, const State::Snapshot& snapshot,
                                     const std::vector<int>& before, int times) {
  std::vector<int> now = count_defects(state);
  for (int i = 0; i < times && has_more(now, before); ++i) {
    std::vector<int> more(now.size());
    for (std::size_t q = 0; q < now.size(); ++q) more[q] = std::max(0, now[q] - before[q]);
    const Regions spoilt(state, more, 1 + 2 * i);
    for (int v = 0; v < state.number_of_vertices(); ++v)
      if (spoilt.of_vertex[v] >= 0) state.restore(snapshot, v);
    now = count_defects(state);
  }
  if (!has_more(now, before)) return now;
  for (int v = 0; v < state.number_of_vertices(); ++v) state.restore(snapshot, v);
  return before;
}

Regions::Regions(const State& state, const std::vector<int>& defects, int rings)
    : of_vertex(state.number_of_vertices(), -1) {
  const std::vector<char> mask = near_defects(state, defects, rings);
  std::vector<int> stack;
  for (int start = 0; start < state.number_of_vertices(); ++start) {
    if (!mask[start] || of_vertex[start] >= 0) continue;
    of_vertex[start] = count;
    stack.push_back(start);
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      for (int k = state.first[v]; k < state.first[v + 1]; ++k)
        for (int w : state.mesh.quads[state.corners[k] / 4])
          if (mask[w] && of_vertex[w] < 0) {
            of_vertex[w] = count;
            stack.push_back(w);
          }
    }
    ++count;
  }
}

std::vector<char> Regions::mask() const {
  std::vector<char> result(of_vertex.size());
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = of_vertex[v] >= 0;
  return result;
}

std::vector<int> Regions::sum(const State& state, const std::vector<int>& defects) const {
  std::vector<int> result(count, 0);
  for (std::size_t q = 0; q < defects.size(); ++q) {
    int region = -1;
    for (int v : state.mesh.quads[q]) region = std::max(region, of_vertex[v]);
    if (region >= 0) result[region] += defects[q];
  }
  return result;
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
