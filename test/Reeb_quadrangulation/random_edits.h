// SPDX-License-Identifier: GPL-3.0-or-later
// Random edits of a design, most of them sensible enough to be applied now and then.
#ifndef REEBQUAD_TEST_RANDOM_EDITS_H
#define REEBQUAD_TEST_RANDOM_EDITS_H

#include <CGAL/Reeb_quadrangulation/Editor.h>

#include "tiny_surfaces.h"

#include <algorithm>
#include <vector>

namespace random_edits {

using namespace CGAL::Reeb_quadrangulation;

class Generator {
public:
  Generator(const Editor& editor, tiny::Random& random) : m_editor(editor), m_random(random) {}

  Edit next() {
    switch (m_random.below(37)) {
    case 0:
      return Add_extremum{vertex(), m_random.below(2) == 0, Edit_scope::chart, 0.1 + 0.8 * m_random.unit()};
    case 1: return Add_extremum{vertex(), m_random.below(2) == 0, scope()};
    case 2: return Remove_extremum{extremum(), scope()};
    case 3: return Move_extremum{extremum(), vertex(), scope()};
    case 4: return Move_extremum{extremum(), near(extremum()), Edit_scope::chart};
    case 5: return Change_value{extremum(), m_random.unit()};
    case 6:
    case 7: return Move_contour{contour(), tilted(), normal(), {}, Enforcement(m_random.below(2))};
    case 8: return Move_contour{contour(), tilted(), normal(), {contour(), contour()}};
    case 9: return Drag_contour{contour(), vertex()};
    case 10: {
      const Surface_point c = contour();
      return Drag_contour{c, near(c)};
    }
    case 11: return Straighten_contour{contour()};
    case 12: return Snap_contour{contour(), 20 + 60 * m_random.unit()};
    case 13:
    case 14: return Subdivide_chart{vertex()};
    case 15: return Remove_contour{contour()};
    case 16: {
      const Surface_point s = saddle();
      if (m_random.below(2) == 0) return Align_saddles{s, saddle()};
      return m_random.below(3) == 0 ? Move_saddle{s, s, normal()} : Move_saddle{s, near(s)};
    }
    case 17: return m_random.below(3) == 0 ? Edit(Collapse_thin_charts{}) : Edit(Collapse_chart{vertex()});
    case 18: return Split_pole{extremum(), Pole_kind(m_random.below(3)), {}};
    case 19: {
      const Surface_point e = extremum();
      return Split_pole{e, Pole_kind::half, {near(e), near(e)}};
    }
    case 20: return Split_saddle{saddle(), Saddle_kind(m_random.below(2)), {}, 0.3 * m_random.unit()};
    case 21: return Pin_corners{m_random.below(2) == 0 ? vertex() : extremum()};
    case 22: return Move_corner{extremum(), contour()};
    case 23: return count();
    case 24: return Set_target{0, m_editor.design().edge_length * (0.8 + 0.5 * m_random.unit())};
    case 25: return Lock_chart{vertex(), m_random.below(3) == 0};
    case 26: {
      const Surface_point p = vertex();
      return Drag_vertices{{p, near(p)},      near(p),  0.3 * m_random.unit(), Falloff(m_random.below(3)), 2,
                           m_random.below(3), {near(p)}};
    }
    case 27:
      return Relax_texture{
          vertex(), 1 + m_random.below(4), m_random.below(2) * 0.3 * m_random.unit(), {}, scope()};
    case 28: return Snap_vertices{{vertex()}, 20 + 60 * m_random.unit()};
    case 29: return Reset_texture{vertex(), scope()};
    case 30: return Fit_texture{vertex(), 20 + 60 * m_random.unit(), scope()};
    default: return texture_operator();
    }
  }

private:
  Edit count() {
    switch (m_random.below(8)) {
    case 7: return Balance_columns{1 + m_random.below(6), 0.5 + 8 * m_random.unit()};
    case 4: return Set_columns{vertex(), 2 * m_random.below(12), Chart_side(1 + m_random.below(2))};
    case 5: return Add_dislocation{vertex(), 2 * (m_random.below(7) - 3)};
    case 6: return Remove_dislocation{vertex()};
    case 0: return Set_columns{vertex(), 2 * m_random.below(12)};
    case 1: return Set_rows{vertex(), m_random.below(9)};
    case 2: return Set_shift{vertex(), m_random.below(7) - 3};
    default: return Set_grading{vertex(), 0.25 + 3 * m_random.unit()};
    }
  }
  // Subdivisions of everything would soon make too many quads.
  Edit texture_operator() {
    const Surface_point p = vertex();
    if (!is_coarse(p)) return Reset_texture{p};
    Edit_texture edit;
    edit.operation = Texture_operator(m_random.below(14));
    edit.points = {p};
    switch (edit.operation) {
    case Texture_operator::subdivide: return m_random.below(3) == 0 ? Edit(edit) : Reset_texture{p};
    case Texture_operator::coarsen: break;
    case Texture_operator::insert_polychord:
    case Texture_operator::delete_polychord:
      edit.fraction = 0.2 + 0.6 * m_random.unit();
      edit.scope = m_random.below(2) == 0 ? Edit_scope::surface : Edit_scope::chart;
      break;
    case Texture_operator::open_quad:
    case Texture_operator::inset_quads:
    case Texture_operator::delete_quads:
    case Texture_operator::restore_quads: edit.points.push_back(near(p)); break;
    default: break;
    }
    return edit;
  }
  bool is_coarse(const Surface_point& p) const {
    const int c = m_editor.chart_at(p);
    return c >= 0 && m_editor.design().charts[std::size_t(c)]->texture.texture.quads.size() < 1000;
  }
  Edit_scope scope() { return m_random.below(4) == 0 ? Edit_scope::surface : Edit_scope::chart; }
  Surface_point at(int v) const { return {m_editor.working_surface().points[v], v}; }
  Surface_point vertex() { return at(m_random.below(m_editor.working_surface().number_of_vertices())); }
  Surface_point near(const Surface_point& p) { // a few steps from a point
    const Triangle_surface& s = m_editor.working_surface();
    int v = p.vertex;
    if (v < 0) {
      v = 0;
      for (int w = 1; w < s.number_of_vertices(); ++w)
        if ((s.points[w] - p.point).squaredNorm() < (s.points[v] - p.point).squaredNorm()) v = w;
    }
    for (int steps = 1 + m_random.below(4); steps > 0; --steps) {
      int h = s.outgoing[v];
      for (int turns = m_random.below(6); turns > 0; --turns)
        if (s.rotate_ccw(h) >= 0) h = s.rotate_ccw(h);
      v = s.target(h);
    }
    return at(v);
  }
  Surface_point extremum() {
    const auto& extrema = m_editor.design().extrema;
    return extrema.empty() ? vertex() : at(extrema[m_random.below(int(extrema.size()))].vertex);
  }
  Surface_point contour() {
    const Design& d = m_editor.design();
    std::vector<int> alive;
    for (std::size_t e = 0; e < d.network.edges.size(); ++e)
      if (!d.network.is_removed(d.network.edges[e])) alive.push_back(int(e));
    if (alive.empty()) return vertex();
    const std::vector<int>& v = d.network.edges[alive[m_random.below(int(alive.size()))]].vertices;
    return {d.network.position(m_editor.working_surface(), v[m_random.below(int(v.size()))]), -1};
  }
  Surface_point saddle() {
    const Design& d = m_editor.design();
    std::vector<int> saddles;
    for (const Contour_node& node : d.network.nodes)
      if (node.kind == Node_kind::saddle) saddles.push_back(node.vertex);
    return saddles.empty() ? vertex() : at(saddles[m_random.below(int(saddles.size()))]);
  }
  Point tilted() {
    const Surface_point c = contour();
    return c.point + 0.05 * normal();
  }
  Eigen::Vector3d normal() { return {m_random.unit() - 0.5, m_random.unit() - 0.5, m_random.unit() - 0.5}; }

  const Editor& m_editor;
  tiny::Random& m_random;
};

} // namespace random_edits

#endif // REEBQUAD_TEST_RANDOM_EDITS_H
