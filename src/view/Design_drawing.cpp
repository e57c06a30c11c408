// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Design_drawing.h"

#include "view/Skeleton.h"

#include <numeric>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

Design_drawing::Design_drawing(const Triangle_surface& surface) : m_surface(surface) {
  m_cut.surface.points = surface.points;
  m_cut.surface.triangles = surface.triangles;
  m_cut.base_face.resize(surface.triangles.size());
  std::iota(m_cut.base_face.begin(), m_cut.base_face.end(), 0);
}

void Design_drawing::update(const Design& design) {
  auto before = std::move(m_known);
  m_known.clear();
  m_charts.clear();
  begin(design);
  for (const auto& chart : design.charts) {
    const Chart_levels levels = chart_levels(design, *chart->chart);
    const auto known = before.find(chart.get());
    m_charts.push_back(known != before.end() && known->second->levels == levels
                           ? known->second
                           : std::make_shared<const Drawn_chart>(draw(chart, levels)));
    m_known[chart.get()] = m_charts.back();
    add(int(m_charts.size()) - 1);
  }
}

Charted_surface Design_drawing::charted(const Design& design, const Reeb_graph& graph) const {
  return {m_surface, m_cut, design.network, graph, m_chart_of_face, m_values, &m_lines};
}

Design_drawing::Drawn_chart Design_drawing::draw(const std::shared_ptr<const Design_chart>& made,
                                                 const Chart_levels& levels) const {
  const Chart& chart = *made->chart;
  Drawn_chart drawn{made, levels, chart_field(*made, levels), {}, {}};
  for (int f = 0; f < chart.mesh.number_of_faces(); ++f) {
    const Triangle &t = chart.mesh.triangles[f], &base = m_surface.triangles[chart.face_origin[f]];
    const auto is_corner = [&](int k) {
      const int v = chart.vertex_origin[t[k]];
      return v == base[0] || v == base[1] || v == base[2];
    };
    if (!is_corner(0) || !is_corner(1) || !is_corner(2)) drawn.pieces.push_back(f);
  }
  drawn.line = line_of_chart(chart.mesh, drawn.values);
  return drawn;
}

// The surface without cuts, with the points of the contours. A face that was cut has more than one piece.
void Design_drawing::begin(const Design& design) {
  const std::size_t vertices = m_surface.points.size(), faces = m_surface.triangles.size();
  for (std::size_t f = faces; f < m_cut.surface.triangles.size(); ++f) {
    const int base = m_cut.base_face[f];
    m_cut.surface.triangles[base] = m_surface.triangles[base];
  }
  m_cut.surface.triangles.resize(faces);
  m_cut.base_face.resize(faces);
  m_cut.surface.points.resize(vertices);
  for (std::size_t c = 0; c < design.network.crossings.size(); ++c)
    m_cut.surface.points.push_back(design.network.position(m_surface, int(vertices + c)));
  m_chart_of_face.assign(faces, -1);
  m_values.assign(m_cut.surface.points.size(), 0.5);
  m_lines.clear();
}

void Design_drawing::add(int index) {
  const Drawn_chart& drawn = *m_charts[index];
  const Chart& chart = *drawn.chart->chart;
  // The chart's own vertices, which have no number in the network, are the last ones of it and get the next
  // numbers.
  const int first_own = int(chart.vertex_origin.size() - chart.split_chords.size()),
            next = int(m_cut.surface.points.size());
  const auto number = [&](int v) { return v < first_own ? chart.vertex_origin[v] : next + v - first_own; };
  m_cut.surface.points.insert(m_cut.surface.points.end(), chart.mesh.points.begin() + first_own,
                              chart.mesh.points.end());
  m_values.resize(m_cut.surface.points.size());
  for (int v = 0; v < int(drawn.values.size()); ++v) m_values[number(v)] = drawn.values[v];
  auto piece = drawn.pieces.begin();
  for (int f = 0; f < int(chart.face_origin.size()); ++f) {
    const int base = chart.face_origin[f];
    if (piece == drawn.pieces.end() || *piece != f) {
      m_chart_of_face[base] = index;
      continue;
    }
    ++piece;
    const Triangle& t = chart.mesh.triangles[f];
    const Triangle numbered{number(t[0]), number(t[1]), number(t[2])};
    if (m_chart_of_face[base] < 0) { // the first piece stands for the face
      m_cut.surface.triangles[base] = numbered;
      m_chart_of_face[base] = index;
    } else {
      m_cut.surface.triangles.push_back(numbered);
      m_cut.base_face.push_back(base);
      m_chart_of_face.push_back(index);
    }
  }
  m_lines.push_back(drawn.line);
}

} // namespace studio
} // namespace reebquad
