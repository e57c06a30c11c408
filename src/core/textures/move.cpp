// SPDX-License-Identifier: GPL-3.0-or-later
// Moving vertices in the plane without inverting a quad.
#include "textures/observed_edit.h"
#include "textures/operators.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// The quads at each vertex, as ranges of halfedges that leave it.
class Vertex_quads {
public:
  explicit Vertex_quads(const Quad_texture& texture)
      : m_begin(texture.v.size() + 1, 0), m_halfedge(4 * texture.quads.size()) {
    for (const Quad& q : texture.quads)
      for (int v : q) ++m_begin[v + 1];
    for (std::size_t v = 0; v + 1 < m_begin.size(); ++v) m_begin[v + 1] += m_begin[v];
    std::vector<int> end(m_begin.begin(), m_begin.end() - 1);
    for (int h = 0; h < int(m_halfedge.size()); ++h) m_halfedge[end[source(texture.quads, h)]++] = h;
  }
  const int* begin(int v) const { return m_halfedge.data() + m_begin[v]; }
  const int* end(int v) const { return m_halfedge.data() + m_begin[v + 1]; }

private:
  std::vector<int> m_begin, m_halfedge;
};

struct Displacement {
  double v = 0, u = 0;
};

Error cancelled() {
  return make_error(Error_code::cancelled, "cancelled by the user");
}

// Moves single vertices of a draft, each as far as its quads stay valid.
class Mover {
public:
  explicit Mover(Texture_draft& draft)
      : m_draft(draft), m_quads(draft.before()), m_fixed(draft.before().v.size(), 0) {
    for (std::size_t v = 0; v < m_fixed.size(); ++v) m_fixed[v] = !draft.is_inside(int(v));
  }

  bool is_fixed(int v) const { return m_fixed[v] != 0; }
  void fix(int v) { m_fixed[v] = 1; }

  // The part of the displacement that was possible.
  double move(int v, const Displacement& d) {
    if (is_fixed(v) || (d.v == 0 && d.u == 0)) return 0;
    const Plane_point old = m_draft.point(v);
    double good = 0, bad = 2;
    for (double part = 1; part > 1e-6 && good == 0; part /= 2)
      if (try_move(v, old, d, part))
        good = part;
      else
        bad = part;
    for (int i = 0; i < 5 && good > 0 && bad < 2; ++i) {
      const double part = (good + bad) / 2;
      (try_move(v, old, d, part) ? good : bad) = part;
    }
    m_draft.move_vertex(v, {m_draft.plane().wrapped(old.v + good * d.v), old.u + good * d.u});
    return good;
  }

  // From a vertex to where the sum of the squares of its edges and of the twists of its quads (a - b + c - d)
  // is least: even spacing, and opposite edges parallel.
  Displacement relaxing(int v) const {
    const Plane_point p = m_draft.point(v);
    Displacement sum;
    int count = 0;
    for (const int* h = m_quads.begin(v); h != m_quads.end(v); ++h) {
      const Displacement a = to(p, m_draft.target(*h)), b = to(p, m_draft.source(previous(*h))),
                         c = to(p, m_draft.source(across(*h)));
      // Each neighbour is in two of the quads; a + b - c completes the parallelogram.
      sum.v += (a.v + b.v) / 2 + (a.v + b.v - c.v);
      sum.u += (a.u + b.u) / 2 + (a.u + b.u - c.u);
      count += 2;
    }
    return {sum.v / count, sum.u / count};
  }

  // The vertices within so many edges of those marked.
  std::vector<char> grown(std::vector<char> marked, int rings) const {
    std::vector<int> ring, next;
    for (int v = 0; v < int(marked.size()); ++v)
      if (marked[v]) ring.push_back(v);
    for (int r = 0; r < rings && !ring.empty(); ++r, ring.swap(next), next.clear())
      for (int v : ring)
        for (const int* h = m_quads.begin(v); h != m_quads.end(v); ++h)
          for (int w : {m_draft.target(*h), m_draft.source(previous(*h))})
            if (!std::exchange(marked[w], char(1))) next.push_back(w);
    return marked;
  }

  Result<void> relax(const std::vector<char>& region, int steps) {
    for (int s = 0; s < steps; ++s)
      for (int v = 0; v < int(region.size()); ++v) {
        if (v % 1024 == 0 && m_draft.is_cancelled()) return cancelled();
        if (region[v] && !is_fixed(v)) move(v, relaxing(v));
      }
    return {};
  }

private:
  bool try_move(int v, const Plane_point& old, const Displacement& d, double part) {
    m_draft.move_vertex(v, {m_draft.plane().wrapped(old.v + part * d.v), old.u + part * d.u});
    return std::abs(part * d.v) < 0.25 * period() && are_valid(v);
  }
  double period() const { return m_draft.plane().is_periodic() ? 1 : 1e300; }
  Displacement to(const Plane_point& p, int w) const {
    const Plane_point q = m_draft.point(w);
    return {m_draft.plane().step(p.v, q.v), q.u - p.u};
  }
  bool are_valid(int v) const {
    return std::all_of(m_quads.begin(v), m_quads.end(v),
                       [&](int h) { return m_draft.is_valid(m_draft.before().quads[quad_of(h)]); });
  }

  Texture_draft& m_draft;
  Vertex_quads m_quads;
  std::vector<char> m_fixed;
};

Result<std::vector<int>> find_vertices(const Texture_draft& draft, const std::vector<Texture_place>& places) {
  std::vector<int> vertices;
  for (const Texture_place& place : places) {
    const Result<Quad_corner> found = find_vertex(draft.before(), place);
    if (!found) return found.error();
    vertices.push_back(draft.source(halfedge(*found)));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double weight(Falloff falloff, double x) {
  switch (falloff) {
  case Falloff::constant: return 1;
  case Falloff::linear: return 1 - x;
  case Falloff::smooth: return (1 - x * x) * (1 - x * x);
  }
  return 0;
}

// How much of the displacement each vertex gets: by its distance to the nearest of the vertices moved.
Result<std::vector<double>> brush_weights(const Texture_draft& draft, const Move_vertices& edit,
                                          const std::vector<int>& vertices) {
  std::vector<double> weights(draft.before().v.size(), 0);
  for (int m : vertices) weights[m] = 1;
  if (!(edit.radius > 0)) return weights;
  for (int v = 0; v < int(weights.size()); ++v) {
    if (v % 64 == 0 && draft.is_cancelled()) return cancelled();
    for (int m : vertices) {
      const Plane_point p = draft.point(m), q = draft.point(v);
      const double x = std::hypot(edit.aspect * draft.plane().step(p.v, q.v), q.u - p.u) / edit.radius;
      if (x < 1) weights[v] = std::max(weights[v], weight(edit.falloff, x));
    }
  }
  return weights;
}

// A vertex may be in the way of another that goes the same way: the rest is tried again as long as something
// moves.
void displace(Mover& mover, const std::vector<double>& weights, const Displacement& d) {
  std::vector<double> left = weights;
  for (int round = 0; round < 8; ++round) {
    bool moved = false;
    for (int v = 0; v < int(left.size()); ++v) {
      if (!(left[v] > 1.0 / 128)) continue;
      const double part = mover.move(v, {left[v] * d.v, left[v] * d.u});
      left[v] *= 1 - part;
      moved = moved || part > 0;
    }
    if (!moved) return;
  }
}

Result<void> check_numbers(const Move_vertices& edit) {
  if (!std::isfinite(edit.dv) || !std::isfinite(edit.du) || !std::isfinite(edit.radius) ||
      !std::isfinite(edit.aspect) || edit.radius < 0 || !(edit.aspect > 0) || edit.rings < 0 ||
      edit.steps < 0 || edit.steps > most_relaxing_steps)
    return refused("a displacement, radius, aspect or number of steps is not a sensible number: at most " +
                   std::to_string(most_relaxing_steps) + " steps");
  return {};
}

} // namespace

Result<void> draw(Texture_draft& draft, const Move_vertices& edit) {
  if (Result<void> checked = check_numbers(edit); !checked) return checked;
  const Result<std::vector<int>> vertices = find_vertices(draft, edit.vertices),
                                 anchors = find_vertices(draft, edit.anchors);
  if (!vertices) return vertices.error();
  if (!anchors) return anchors.error();
  if (vertices->empty()) return refused("no vertices are named");
  for (int v : *vertices)
    if (!draft.is_inside(v))
      return refused("side vertices do not move with the texture", Element_kind::vertex, v);
  Mover mover(draft);
  for (int v : *anchors) mover.fix(v);
  const Result<std::vector<double>> weights = brush_weights(draft, edit, *vertices);
  if (!weights) return weights.error();
  displace(mover, *weights, {edit.dv, edit.du});
  std::vector<char> region(weights->size());
  for (std::size_t v = 0; v < weights->size(); ++v) region[v] = (*weights)[v] > 0;
  for (int v : *vertices) mover.fix(v);
  return mover.relax(mover.grown(region, edit.rings), edit.steps);
}

Result<void> draw(Texture_draft& draft, const Relax_vertices& edit) {
  if (edit.steps < 0 || edit.steps > most_relaxing_steps)
    return refused("the steps are 0 to " + std::to_string(most_relaxing_steps));
  const Result<std::vector<int>> vertices = find_vertices(draft, edit.vertices),
                                 anchors = find_vertices(draft, edit.anchors);
  if (!vertices) return vertices.error();
  if (!anchors) return anchors.error();
  Mover mover(draft);
  for (int v : *anchors) mover.fix(v);
  std::vector<char> region(draft.before().v.size(), vertices->empty());
  for (int v : *vertices) region[v] = 1;
  return mover.relax(region, edit.steps);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
