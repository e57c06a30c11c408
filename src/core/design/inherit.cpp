// SPDX-License-Identifier: GPL-3.0-or-later
// Edited textures of charts that are cut anew because one of their contours moved.
#include "design/draft.h"

#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

int old_edge(const Draft& draft, int edge) {
  const auto found = draft.replaced.find(edge);
  return found == draft.replaced.end() ? edge : found->second;
}

bool same_walk(const Draft& draft, const Walk& fresh, const Walk& old) {
  return fresh.side == old.side && fresh.edges.size() == old.edges.size() &&
         std::equal(fresh.edges.begin(), fresh.edges.end(), old.edges.begin(),
                    [&](const Walk_edge& a, const Walk_edge& b) {
                      return old_edge(draft, a.edge) == b.edge && a.forward == b.forward;
                    });
}

// The border of a texture's domain as one coordinate that grows along the walk: V around an annulus; the
// length from the corner (0, 0) around the rectangle of a disc.
class Domain_border {
public:
  Domain_border(const Quad_texture& texture, bool clockwise)
      : m_a(*std::max_element(texture.v.begin(), texture.v.end())),
        m_b(*std::max_element(texture.u.begin(), texture.u.end())), m_annulus(texture.sides.size() == 2),
        m_clockwise(clockwise) {}

  double length() const { return m_annulus ? 1 : 2 * (m_a + m_b); }

  double coordinate(double v, double u) const {
    if (m_annulus) return v;
    const double s = u == 0 ? v : v == m_a ? m_a + u : u == m_b ? 2 * m_a + m_b - v : length() - u;
    return m_clockwise ? length() - s : s;
  }

  std::array<double, 2> point(double s) const { // of a disc
    s = std::fmod(m_clockwise ? length() - s : s, length());
    if (s < 0) s += length();
    if (s <= m_a) return {s, 0};
    if (s <= m_a + m_b) return {m_a, s - m_a};
    if (s <= 2 * m_a + m_b) return {2 * m_a + m_b - s, m_b};
    return {0, length() - s};
  }

private:
  double m_a, m_b;
  bool m_annulus, m_clockwise;
};

// The border coordinates of a walk's vertices and, once around, of the first again: those of the old walk at
// the same parameter of its contours.
std::vector<double> border_coordinates(const Domain_border& border, const Chart_parameterization& map,
                                       const Walk& old, const std::vector<double>& old_steps,
                                       const std::vector<double>& steps) {
  std::vector<double> s;
  for (int v : old.vertices) {
    double x = border.coordinate(map.v()[v], map.u()[v]);
    if (!s.empty()) x += border.length() * std::ceil((s.back() - x) / border.length());
    s.push_back(x);
  }
  s.push_back(s.front() + border.length());
  std::vector<double> found;
  std::size_t i = 0;
  for (double step : steps) {
    while (i + 2 < old_steps.size() && old_steps[i + 1] <= step) ++i;
    found.push_back(s[i] + (step - old_steps[i]) / (old_steps[i + 1] - old_steps[i]) * (s[i + 1] - s[i]));
  }
  return found;
}

double mean_difference(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] - y[i];
  return sum / double(x.size());
}

Result<void> solve(Chart_parameterization& map, const Chart& chart, const Domain_border& border,
                   std::vector<std::vector<double>> s) {
  if (chart.kind == Chart_kind::annulus) {
    const double turns = std::round(mean_difference(s[0], map.natural(Side::low)) -
                                    mean_difference(s[1], map.natural(Side::high)));
    for (double& x : s[1]) x += turns;
    return map.solve_columns(chart, s[0], s[1]);
  }
  std::vector<double> v, u;
  for (std::size_t i = 0; i + 1 < s[0].size(); ++i) {
    const std::array<double, 2> p = border.point(s[0][i]);
    v.push_back(p[0]);
    u.push_back(p[1]);
  }
  return map.solve_rectangle(chart, v, u);
}

// The map of a chart that is cut anew moves what it does not hold on contours: an anchor stands for a place
// that the user chose.
void release_moved_anchors(const Design_chart& old, double edge_length, Design_chart& made) {
  std::vector<Eigen::Vector2d> kept;
  for (int v : anchored_vertices(made.texture)) {
    const Point was = position(*old.chart, old.texture.location[v]),
                is = position(*made.chart, made.texture.location[v]);
    if ((is - was).norm() <= 1e-6 * edge_length)
      kept.emplace_back(made.texture.texture.v[v], made.texture.texture.u[v]);
  }
  made.texture.anchors = std::move(kept);
}

} // namespace

const Design_chart* predecessor(const Draft& draft, int c) {
  const Chart& chart = draft.chart(c);
  for (const auto& old : draft.before().charts) {
    if (!old->edited || old->chart->kind != chart.kind || old->chart->walks.size() != chart.walks.size())
      continue;
    bool same = true;
    for (std::size_t w = 0; w < chart.walks.size(); ++w)
      same = same && same_walk(draft, chart.walks[w], old->chart->walks[w]);
    if (same) return old.get();
  }
  return nullptr;
}

Result<void> inherit_texture(const Draft& draft, const Design_chart& old, const Contour_samples& samples,
                             Chart_parameterization map, Design_chart& made) {
  // The counts before, for the contours as they are now.
  Contour_samples before = draft.before().samples;
  before.counts.resize(samples.counts.size(), 0);
  before.parameter = samples.parameter;
  for (const auto& [edge, replaced] : draft.replaced) before.counts[edge] = before.counts[replaced];
  const Domain_border border(old.texture.texture,
                             made.chart->kind == Chart_kind::disc && made.chart->walks[0].side == Side::high);
  std::vector<std::vector<double>> s;
  for (std::size_t w = 0; w < made.chart->walks.size(); ++w)
    s.push_back(border_coordinates(border, *old.map, old.chart->walks[w],
                                   walk_coordinates(old.chart->walks[w], draft.before().samples),
                                   walk_coordinates(made.chart->walks[w], before)));
  if (Result<void> solved = solve(map, *made.chart, border, s); !solved) return solved;
  made.texture = with_counts(old.texture, *made.chart, before, samples);
  made.texture.location = locate(*made.chart, map, made.texture.texture.v, made.texture.texture.u);
  release_moved_anchors(old, draft.before().edge_length, made);
  made.edited = true;
  made.texture_id = old.texture_id;
  made.map = std::make_shared<const Chart_parameterization>(std::move(map));
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
