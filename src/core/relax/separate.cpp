// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/relax_state.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

namespace {

constexpr double inverted = 0.03; // with a margin for what follows

struct Extent {
  Point low, high;
  bool meets(const Extent& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

Extent extent_of(const Quad_mesh& mesh, int q) {
  Extent e{mesh.points[mesh.quads[q][0]], mesh.points[mesh.quads[q][0]]};
  for (int v : mesh.quads[q]) {
    e.low = e.low.cwiseMin(mesh.points[v]);
    e.high = e.high.cwiseMax(mesh.points[v]);
  }
  return e;
}

// What v costs: the meetings of its quads with other quads first, then their shapes.
struct Cost {
  int meetings;
  double shape;
  bool operator<(const Cost& other) const {
    return meetings != other.meetings ? meetings < other.meetings : shape < other.shape * (1 - 1e-6);
  }
};

class Vertex_search {
public:
  Vertex_search(State& state, int v) : m_state(state), m_vertex(v), m_size(state.size_around(v)) {
    Extent reach{state.mesh.points[v], state.mesh.points[v]};
    for (int k = state.first[v]; k < state.first[v + 1]; ++k) {
      const Extent e = extent_of(state.mesh, state.corners[k] / 4);
      reach.low = reach.low.cwiseMin(e.low);
      reach.high = reach.high.cwiseMax(e.high);
    }
    reach.low.array() -= m_size;
    reach.high.array() += m_size;
    for (int q = 0; q < int(state.mesh.quads.size()); ++q)
      if (extent_of(state.mesh, q).meets(reach)) m_near.push_back(q);
  }

  /// Moves the vertex to the best place found; tells whether that lowered the number of meetings.
  bool run(double offset) {
    const Step start = m_state.here(m_vertex);
    Cost best = cost(start);
    if (best.meetings == 0) return false;
    const int before = best.meetings;
    Step found = start;
    const Point n = start.normal, side = n.unitOrthogonal(), other = n.cross(side);
    for (const double length : {0.6, 0.3, 0.12, 0.05})
      for (int i = 0; i < 8; ++i) {
        static const double half = std::sqrt(0.5);
        static const double cosine[8] = {1, half, 0, -half, -1, -half, 0, half};
        const Point way = length * m_size * (cosine[i] * side + cosine[(i + 6) % 8] * other);
        consider(m_state.constrain(m_vertex, start.point + way), best, found);
      }
    if (offset > 0 && m_state.sites[m_vertex].freedom == Freedom::surface)
      for (const double part : {0.25, 0.5, 1.0, -0.25, -0.5, -1.0}) {
        Step step = start;
        step.point =
            m_state.projector.closest_nearby(start.point, start.face).point + part * offset * m_size * n;
        consider(step, best, found);
      }
    m_state.move(m_vertex, found);
    return best.meetings < before;
  }

private:
  void consider(const Step& step, Cost& best, Step& found) {
    const Cost c = cost(step);
    if (!(c < best)) return;
    best = c;
    found = step;
  }

  Cost cost(const Step& step) {
    Cost result{0, 0};
    Quad_mesh& mesh = m_state.mesh;
    const Point kept = mesh.points[m_vertex];
    mesh.points[m_vertex] = step.point;
    for (int k = m_state.first[m_vertex]; k < m_state.first[m_vertex + 1]; ++k) {
      const int q = m_state.corners[k] / 4;
      const double quality = m_state.quality(q, m_vertex, step);
      result.shape += std::exp(-7 * quality);
      // An inverted quad is no better than a meeting.
      if (quality < inverted) result.meetings += 2;
      const Extent e = extent_of(mesh, q);
      for (int other : m_near)
        if (other != q && e.meets(extent_of(mesh, other)) && quads_meet(mesh, q, other)) ++result.meetings;
    }
    mesh.points[m_vertex] = kept;
    return result;
  }

  State& m_state;
  int m_vertex;
  double m_size;
  std::vector<int> m_near;
};

// Beyond this the mesh needs another layout, not single steps.
constexpr int most_quads = 600;

} // namespace

void separate(State& state, double offset, int rounds, Observer* observer) {
  for (int round = 0; round < rounds; ++round) {
    const std::vector<std::pair<int, int>> pairs = intersecting_quads(state.mesh);
    std::vector<int> quads, vertices;
    for (const auto& [i, j] : pairs) quads.insert(quads.end(), {i, j});
    for (int q = 0; q < int(state.mesh.quads.size()); ++q)
      if (state.quality(q) < inverted) quads.push_back(q);
    if (quads.empty() || int(quads.size()) > most_quads) return;
    for (int q : quads)
      for (int v : state.mesh.quads[q])
        if (state.sites[v].freedom != Freedom::fixed) vertices.push_back(v);
    // In later rounds their neighbours may make room.
    const std::size_t inner = round < 3 ? 0 : vertices.size();
    for (std::size_t i = 0; i < inner; ++i)
      for (int k = state.first[vertices[i]]; k < state.first[vertices[i] + 1]; ++k)
        for (int v : state.mesh.quads[state.corners[k] / 4])
          if (state.sites[v].freedom != Freedom::fixed) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    bool fewer = false;
    for (int v : vertices) {
      if (observer && observer->cancelled()) return;
      fewer = Vertex_search(state, v).run(offset) || fewer;
    }
    if (!fewer && round >= 4) return;
  }
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
