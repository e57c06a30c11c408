// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>

#include "textures/observed_edit.h"
#include "textures/operators.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

int number_of_samples(const Walk& walk, const Contour_samples& samples) {
  int n = 0;
  for (const Walk_edge& we : walk.edges) n += samples.counts[we.edge];
  return n;
}

// The place on the walk, in samples from its first node, of a number of steps along the texture's side.
double on_walk(const Placed_texture& placed, int w, double step, int samples) {
  double at = step + ((-placed.offset[w] % samples) + samples) % samples;
  while (at >= samples) at -= samples;
  return at;
}

// The entries of a side that lie at the contours' nodes.
std::vector<int> nodes_of_side(const Placed_texture& placed, const Walk& walk, int w,
                               const Contour_samples& samples) {
  const int n = number_of_samples(walk, samples);
  std::vector<double> nodes;
  double before = 0;
  for (const Walk_edge& we : walk.edges) {
    nodes.push_back(before);
    before += samples.counts[we.edge];
  }
  std::vector<int> entries;
  for (int i = 0; i < int(placed.texture.sides[w].size()); ++i)
    if (std::binary_search(nodes.begin(), nodes.end(), on_walk(placed, w, placed.step(w, i), n)))
      entries.push_back(i);
  return entries;
}

// Steps along the side before an edit, in samples; the entry after the last is the first again.
double interpolate(const Placed_texture& placed, int w, double entry, int samples) {
  const int size = int(placed.texture.sides[w].size());
  const int i = std::min(size - 1, int(entry));
  const double a = placed.step(w, i), b = i + 1 < size ? placed.step(w, i + 1) : samples + placed.step(w, 0);
  return entry == i ? a : a + (entry - i) * (b - a);
}

// A contour edge needs a vertex between its nodes, or two if it is a loop: else two edges would join the same
// vertices.
Result<void> check_contour_edges(const Placed_texture& placed, const Chart& chart,
                                 const Contour_samples& samples) {
  for (std::size_t w = 0; w < chart.walks.size(); ++w) {
    const Walk& walk = chart.walks[w];
    const int n = number_of_samples(walk, samples);
    std::vector<double> at;
    for (int i = 0; i < int(placed.texture.sides[w].size()); ++i)
      at.push_back(on_walk(placed, int(w), placed.step(int(w), i), n));
    std::sort(at.begin(), at.end());
    double before = 0;
    for (std::size_t i = 0; i < walk.edges.size(); ++i) {
      const auto node = [&](std::size_t k) {
        return chart.vertex_origin[walk.vertices[walk.edges[k % walk.edges.size()].begin]];
      };
      const double after = before + samples.counts[walk.edges[i].edge];
      const auto inside =
          std::lower_bound(at.begin(), at.end(), after) - std::upper_bound(at.begin(), at.end(), before);
      if (inside < (node(i) == node(i + 1) ? 2 : 1))
        return make_error(Error_code::refused_edit,
                          "the edit would leave a contour too few vertices between its nodes");
      before = after;
    }
  }
  return {};
}

// The texture after an edit, and where its sides' vertices lie; its vertices have no places on the chart yet.
Result<Placed_texture> edit_in_plane(const Placed_texture& placed, const Chart& chart,
                                     const Contour_samples& samples, const Texture_edit& edit,
                                     const Observer* observer) {
  Texture_limits limits;
  for (std::size_t w = 0; w < chart.walks.size(); ++w)
    limits.kept.push_back(nodes_of_side(placed, chart.walks[w], int(w), samples));
  Result<Edited_texture> edited = internal::edit_observed(placed.texture, edit, limits, observer);
  if (!edited) return edited.error();
  Placed_texture out;
  out.offset = placed.offset;
  out.anchors = placed.anchors;
  for (std::size_t w = 0; w < chart.walks.size(); ++w) {
    const int n = number_of_samples(chart.walks[w], samples);
    bool plain = int(edited->side_steps[w].size()) == n;
    for (double entry : edited->side_steps[w]) {
      out.steps[w].push_back(interpolate(placed, int(w), entry, n));
      plain = plain && out.steps[w].back() == double(out.steps[w].size()) - 1;
    }
    if (plain) out.steps[w].clear();
  }
  out.texture = std::move(edited->texture);
  if (Result<void> checked = check_contour_edges(out, chart, samples); !checked) return checked.error();
  return out;
}

} // namespace

Result<Placed_texture> edit_texture(const Placed_texture& placed, const Chart& chart,
                                    const Chart_parameterization& map, const Contour_samples& samples,
                                    const std::vector<Texture_edit>& edits) {
  return internal::edit_observed(placed, chart, map, samples, edits, nullptr);
}

namespace internal {

Result<Placed_texture> edit_observed(const Placed_texture& placed, const Chart& chart,
                                     const Chart_parameterization& map, const Contour_samples& samples,
                                     const std::vector<Texture_edit>& edits, const Observer* observer) {
  CGAL_precondition(!edits.empty());
  Result<Placed_texture> out = edit_in_plane(placed, chart, samples, edits.front(), observer);
  for (std::size_t i = 1; i < edits.size() && out; ++i)
    out = edit_in_plane(*out, chart, samples, edits[i], observer);
  if (out) out->location = locate(chart, map, out->texture.v, out->texture.u);
  return out;
}

} // namespace internal

Result<Placed_texture> edit_texture(const Placed_texture& placed, const Chart& chart,
                                    const Chart_locator& locator, const Contour_samples& samples,
                                    const Texture_edit& edit) {
  Result<Placed_texture> out = edit_in_plane(placed, chart, samples, edit, nullptr);
  if (out) out->location = locator.locate(out->texture.v, out->texture.u);
  return out;
}

namespace {

// A place between two vertices of a side of a chart.
struct Side_place {
  int chart, walk, step;
  double fraction; ///< from entry `step` of the side to the next
};

// The same place on the other side of its contour edge; chart -1 on a boundary loop.
class Contour_crossing {
public:
  Contour_crossing(const Atlas& atlas, const Contour_samples& samples,
                   const std::vector<const Placed_texture*>& textures)
      : m_atlas(atlas), m_samples(samples), m_textures(textures) {
    m_passes.resize(samples.counts.size());
    for (std::size_t c = 0; c < atlas.charts.size(); ++c)
      for (std::size_t w = 0; w < atlas.charts[c]->walks.size(); ++w) {
        const Walk& walk = atlas.charts[c]->walks[w];
        int before = 0;
        for (const Walk_edge& we : walk.edges) {
          m_passes[we.edge][(walk.side == Side::low) == we.forward ? 0 : 1] = {int(c), int(w), before,
                                                                               we.forward};
          before += samples.counts[we.edge];
        }
      }
  }

  Result<Side_place> cross(const Side_place& p) const {
    const Walk& walk = m_atlas.charts[p.chart]->walks[p.walk];
    const Placed_texture& placed = *m_textures[p.chart];
    const int n = number_of_samples(walk, m_samples);
    double at = on_walk(placed, p.walk, interpolate(placed, p.walk, p.step + p.fraction, n), n);
    std::size_t i = 0;
    for (; i + 1 < walk.edges.size() && at >= m_samples.counts[walk.edges[i].edge]; ++i)
      at -= m_samples.counts[walk.edges[i].edge];
    const Walk_edge& we = walk.edges[i];
    const int count = m_samples.counts[we.edge];
    const bool left = (walk.side == Side::low) == we.forward;
    const Pass& other = m_passes[we.edge][left ? 1 : 0];
    if (other.chart < 0) return Side_place{-1, 0, 0, 0};
    const double along = we.forward == other.forward ? at : count - at;
    return find(other, other.before + along);
  }

private:
  struct Pass {
    int chart = -1, walk = 0, before = 0;
    bool forward = true;
  };

  // The edge of a side that contains a place of its walk.
  Result<Side_place> find(const Pass& pass, double at) const {
    const Placed_texture& placed = *m_textures[pass.chart];
    const int n = number_of_samples(m_atlas.charts[pass.chart]->walks[pass.walk], m_samples);
    const int size = int(placed.texture.sides[pass.walk].size());
    for (int i = 0; i < size; ++i) {
      const double a = on_walk(placed, pass.walk, placed.step(pass.walk, i), n);
      double b = on_walk(placed, pass.walk, placed.step(pass.walk, (i + 1) % size), n), x = at;
      if (b <= a) b += n;
      if (x < a) x += n;
      if (a < x && x < b) return Side_place{pass.chart, pass.walk, i, (x - a) / (b - a)};
    }
    return make_error(Error_code::refused_edit,
                      "the polychord meets a vertex of the chart on the other side of a contour",
                      Element_kind::chart, pass.chart);
  }

  const Atlas& m_atlas;
  const Contour_samples& m_samples;
  const std::vector<const Placed_texture*>& m_textures;
  std::vector<std::array<Pass, 2>> m_passes; ///< per contour edge: left and right
};

// The parts of a polychord, chart by chart.
class Polychord_walk {
public:
  Polychord_walk(const Atlas& atlas, const Contour_samples& samples,
                 const std::vector<const Placed_texture*>& textures)
      : m_textures(textures), m_crossing(atlas, samples, textures), m_tracers(textures.size()),
        m_added(textures.size(), 0) {}

  Result<std::vector<Chart_polychord>> run(const Chart_polychord& start) {
    m_parts = {start};
    const auto first = tracer(start.chart).strip(start.edit);
    if (!first) return first.error();
    const std::vector<Polychord_end>& ends = first->ends;
    if (ends.empty()) return m_parts;
    m_added[start.chart] = first->quads;
    const Side_place home{start.chart, ends[1].side, ends[1].step, 0};
    // From the one end forward; if that meets the boundary, from the other end too.
    for (const Polychord_end& end : ends) {
      const Result<bool> closed = go_on({start.chart, end.side, end.step, end.fraction}, home);
      if (!closed) return closed.error();
      if (*closed) break;
    }
    return m_parts;
  }

private:
  internal::Polychord_tracer& tracer(int chart) {
    if (!m_tracers[chart])
      m_tracers[chart] = std::make_unique<internal::Polychord_tracer>(m_textures[chart]->texture);
    return *m_tracers[chart];
  }

  // Until the polychord comes home (true) or meets the boundary.
  Result<bool> go_on(Side_place at, const Side_place& home) {
    for (;;) {
      const Result<Side_place> entered = m_crossing.cross(at);
      if (!entered) return entered.error();
      if (entered->chart < 0) return false;
      if (entered->chart == home.chart && entered->walk == home.walk && entered->step == home.step)
        return true;
      const Quad_texture& texture = m_textures[entered->chart]->texture;
      const Quad_corner edge = side_edge(texture, entered->walk, entered->step);
      const bool along = texture.quads[edge.quad][edge.corner] == texture.sides[entered->walk][entered->step];
      const double fraction = along ? entered->fraction : 1 - entered->fraction;
      m_parts.push_back({entered->chart, {edge_place(texture, edge), fraction}});
      const auto strip = tracer(entered->chart).strip({{0, 0, edge.quad, edge.corner}, fraction});
      if (!strip) return strip.error();
      if (Result<void> few = count_pass(entered->chart, strip->quads); !few) return few.error();
      const Polychord_end &a = strip->ends[0], &b = strip->ends[1];
      const Polychord_end& next = a.side == entered->walk && a.step == entered->step ? b : a;
      at = {entered->chart, next.side, next.step, next.fraction};
    }
  }

  // Where charts do not meet edge by edge a polychord can come back at ever other places, and each time the
  // textures have more quads.
  Result<void> count_pass(int chart, int crossed) {
    m_quads += m_textures[chart]->texture.quads.size() + std::size_t(m_added[chart]);
    m_added[chart] += crossed;
    if (m_parts.size() < few_passes || m_quads <= most_quads) return {};
    return make_error(Error_code::refused_edit,
                      "the polychord goes through the charts too often before it closes: more than " +
                          std::to_string(m_parts.size()) + " times",
                      Element_kind::chart, m_parts.front().chart);
  }

  static constexpr std::size_t few_passes = 64; ///< that are never too many
  static constexpr std::size_t most_quads =
      1000000; ///< of the charts as they then are, summed over the passes

  const std::vector<const Placed_texture*>& m_textures;
  Contour_crossing m_crossing;
  std::vector<std::unique_ptr<internal::Polychord_tracer>> m_tracers; ///< per chart, once it is needed
  std::vector<Chart_polychord> m_parts;
  std::vector<int> m_added; ///< per chart: quads so far
  std::size_t m_quads = 0;
};

} // namespace

Result<std::vector<Chart_polychord>>
polychord_through_charts(const Atlas& atlas, const Contour_samples& samples,
                         const std::vector<const Placed_texture*>& textures, const Chart_polychord& start) {
  return Polychord_walk(atlas, samples, textures).run(start);
}

namespace {

// The two edges of a triangle that leave its first vertex, in (V, U), as columns.
Eigen::Matrix2d parameter_edges(const Chart& chart, const Chart_parameterization& map, int face) {
  const Triangle& t = chart.mesh.triangles[face];
  Eigen::Matrix2d m;
  m << map.v()[t[1]] + map.jump(3 * face) - map.v()[t[0]],
      map.v()[t[2]] - map.jump(3 * face + 2) - map.v()[t[0]], map.u()[t[1]] - map.u()[t[0]],
      map.u()[t[2]] - map.u()[t[0]];
  return m;
}

} // namespace

Eigen::Vector2d plane_point(const Chart& chart, const Chart_parameterization& map,
                            const Chart_location& location) {
  const int first = chart.mesh.triangles[location.face][0];
  return Eigen::Vector2d(map.v()[first], map.u()[first]) +
         parameter_edges(chart, map, location.face) *
             Eigen::Vector2d(location.weights[1], location.weights[2]);
}

Placed_texture with_counts(const Placed_texture& placed, const Chart& chart, const Contour_samples& before,
                           const Contour_samples& after) {
  Placed_texture out = placed;
  for (std::size_t w = 0; w < chart.walks.size(); ++w) {
    const Walk& walk = chart.walks[w];
    const int n = number_of_samples(walk, before), m = number_of_samples(walk, after);
    // From the number of samples along the walk before to that after.
    const auto converted = [&](double at) {
      double begin = 0;
      for (const Walk_edge& we : walk.edges) {
        const int old = before.counts[we.edge], now = after.counts[we.edge];
        if (at < old) {
          const double x = at * now / old, whole = std::round(x);
          return begin + (at == 0 || (whole > 0 && whole < now && std::abs(x - whole) < 1e-9) ? whole : x);
        }
        at -= old;
        begin += now;
      }
      return begin;
    };
    std::vector<double> steps;
    for (int i = 0; i < int(placed.texture.sides[w].size()); ++i) {
      const double at = converted(on_walk(placed, int(w), placed.step(int(w), i), n));
      steps.push_back(steps.empty() || at >= steps.front() ? at : at + m);
    }
    const int whole = int(std::floor(steps.front()));
    bool plain = int(steps.size()) == m;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      steps[i] -= whole;
      plain = plain && steps[i] == double(i);
    }
    out.offset[w] = -whole;
    out.steps[w] = plain ? std::vector<double>() : std::move(steps);
  }
  return out;
}

Eigen::Vector2d parameter_displacement(const Chart& chart, const Chart_parameterization& map,
                                       const Chart_location& location, const Eigen::Vector3d& displacement) {
  const Triangle& t = chart.mesh.triangles[location.face];
  const Eigen::Vector3d e1 = chart.mesh.points[t[1]] - chart.mesh.points[t[0]],
                        e2 = chart.mesh.points[t[2]] - chart.mesh.points[t[0]];
  const double a = e1.dot(e1), b = e1.dot(e2), c = e2.dot(e2), det = a * c - b * b;
  if (!(det > 0)) return Eigen::Vector2d::Zero();
  const double x = e1.dot(displacement), y = e2.dot(displacement);
  const double s = (c * x - b * y) / det, r = (a * y - b * x) / det;
  return parameter_edges(chart, map, location.face) * Eigen::Vector2d(s, r);
}

Eigen::Vector2d parameter_lengths(const Chart& chart, const Chart_parameterization& map,
                                  const Chart_location& location) {
  const Triangle& t = chart.mesh.triangles[location.face];
  const Eigen::Matrix2d edges = parameter_edges(chart, map, location.face);
  if (!(edges.determinant() > 0)) return Eigen::Vector2d::Zero();
  const Eigen::Matrix2d steps = edges.inverse(); // a unit of V, of U in edges of the triangle
  const Eigen::Vector3d e1 = chart.mesh.points[t[1]] - chart.mesh.points[t[0]],
                        e2 = chart.mesh.points[t[2]] - chart.mesh.points[t[0]];
  return {(steps(0, 0) * e1 + steps(1, 0) * e2).norm(), (steps(0, 1) * e1 + steps(1, 1) * e2).norm()};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
