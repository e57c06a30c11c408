// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#include "atlas/chart_lines.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

struct Plane_point {
  double v, u;
};

// Walks along a straight line through a chart in its plane.
class Line_tracer {
public:
  Line_tracer(const Triangle_surface& surface, const Chart& chart, const Chart_parameterization& map,
              const Contour_network& network)
      : m_surface(surface), m_chart(chart), m_map(map), m_network(network) {}

  // From vertex p, as it is lifted, to vertex q whose V is `end_v`. The first face is returned in
  // `first_face`.
  Result<std::vector<Line_crossing>> trace(int p, int q, double end_v, int& first_face) {
    m_start = {m_map.v()[p], m_map.u()[p]};
    m_end = {end_v, m_map.u()[q]};
    std::vector<Line_crossing> crossings;
    const Triangle_surface& mesh = m_chart.mesh;
    // The first face: its far edge has one end on each side, or is reached at q itself.
    const int first = mesh.outgoing[p];
    int h = first, exit = -1;
    double va = 0, vb = 0;
    do {
      const int a = mesh.target(h), far = Triangle_surface::next(h), b = mesh.target(far);
      va = m_map.v()[p] + step(h);
      vb = m_map.v()[p] - step(Triangle_surface::previous(h));
      first_face = m_chart.face_origin[h / 3];
      if (is_end(a, va, q) || is_end(b, vb, q)) return crossings;
      if (!left(a, va) && left(b, vb)) exit = far;
      h = mesh.rotate_ccw(h);
    } while (exit < 0 && h >= 0 && h != first);
    if (exit < 0) return astray();
    for (int steps = 0; steps <= mesh.number_of_faces(); ++steps) {
      const int entry = mesh.opposite[exit];
      if (entry < 0) return astray();
      record(exit, va, vb, crossings);
      const int toward = Triangle_surface::next(entry), c = mesh.target(toward);
      const double vc = va + step(toward);
      if (is_end(c, vc, q)) return crossings;
      if (left(c, vc)) {
        exit = toward;
        vb = vc;
      } else {
        exit = Triangle_surface::previous(entry);
        va = vc;
      }
    }
    return astray();
  }

private:
  static Error astray() {
    return make_error(Error_code::impossible_request, "a line through a chart could not be followed");
  }
  double step(int h) const {
    return m_map.v()[m_chart.mesh.target(h)] + m_map.jump(h) - m_map.v()[m_chart.mesh.source(h)];
  }
  bool is_end(int x, double v, int q) const { return x == q && std::abs(v - m_end.v) < 0.5; }
  double side(int x, double v) const {
    return (m_end.v - m_start.v) * (m_map.u()[x] - m_start.u) - (m_end.u - m_start.u) * (v - m_start.v);
  }
  bool left(int x, double v) const { return side(x, v) > 0; }

  void record(int exit, double va, double vb, std::vector<Line_crossing>& crossings) const {
    const Triangle_surface& mesh = m_chart.mesh;
    const double sa = side(mesh.source(exit), va), sb = side(mesh.target(exit), vb);
    const double w = sb > sa ? std::min(0.95, std::max(0.05, -sa / (sb - sa))) : 0.5;
    if (const auto crossing =
            surface_crossing(m_surface, m_chart, m_network, exit, w, mesh.opposite[exit] / 3))
      crossings.push_back(*crossing);
  }

  const Triangle_surface& m_surface;
  const Chart& m_chart;
  const Chart_parameterization& m_map;
  const Contour_network& m_network;
  Plane_point m_start{}, m_end{};
};

int visit_node(const Contour_network& network, const Walk_edge& e) {
  return e.forward ? network.edges[e.edge].from : network.edges[e.edge].to;
}

} // namespace

Result<Contour_edge> trace_line(const Triangle_surface& surface, const Chart& chart,
                                const Chart_parameterization& map, int p, int q, double end_v,
                                Contour_network& network) {
  int first_face = -1;
  Result<std::vector<Line_crossing>> line =
      Line_tracer(surface, chart, map, network).trace(p, q, end_v, first_face);
  if (!line) return line.error();
  const int start = chart.vertex_origin[p], end = chart.vertex_origin[q];
  pull_tight(surface, network, start, end, first_face, *line);
  Contour_edge edge;
  edge.vertices.push_back(start);
  edge.faces.push_back(first_face);
  append_crossings(*line, network, edge);
  edge.vertices.push_back(end);
  if (line->empty() && are_on_one_edge(surface, network, start, end)) edge.faces.back() = -1;
  return edge;
}

Result<Contour_edge> trace_line(const Triangle_surface& surface, const Chart& chart,
                                const Chart_parameterization& map, int from, int to, double turns,
                                bool backwards, Contour_network& network) {
  const int p = chart.walks[0].vertices[from], q = chart.walks[1].vertices[to];
  Result<Contour_edge> edge = trace_line(surface, chart, map, p, q, map.v()[q] + turns, network);
  if (edge && backwards) reverse(*edge);
  return edge;
}

namespace {

struct Visit {
  double v;        // in [0, 1)
  double turn;     // v = natural V + turn
  int walk, index; // of the walk's edge that begins here
};

std::vector<Visit> sorted_visits(const Chart& chart, const Chart_parameterization& map) {
  std::vector<Visit> visits;
  for (int w = 0; w < 2; ++w)
    for (int i = 0; i < int(chart.walks[w].edges.size()); ++i) {
      const double natural = map.natural(chart.walks[w].side)[chart.walks[w].edges[i].begin];
      visits.push_back({natural - std::floor(natural), -std::floor(natural), w, i});
    }
  std::sort(visits.begin(), visits.end(), [](const Visit& a, const Visit& b) {
    if (a.v != b.v) return a.v < b.v;
    return a.walk != b.walk ? a.walk < b.walk : a.index < b.index;
  });
  return visits;
}

// New crossings on an edge keep their order but stay clear of each other and of those that were there.
void separate_new_crossings(Contour_network& network, int first_new) {
  std::map<int, std::vector<int>> on_edge;
  for (int c = first_new; c < int(network.crossings.size()); ++c) on_edge[network.crossings[c].halfedge];
  for (int c = 0; c < int(network.crossings.size()); ++c)
    if (const auto found = on_edge.find(network.crossings[c].halfedge); found != on_edge.end())
      found->second.push_back(c);
  for (auto& [edge, list] : on_edge) {
    std::sort(list.begin(), list.end(), [&](int a, int b) {
      return network.crossings[a].t != network.crossings[b].t
                 ? network.crossings[a].t < network.crossings[b].t
                 : a < b;
    });
    for (std::size_t begin = 0; begin < list.size();) {
      if (list[begin] < first_new) {
        ++begin;
        continue;
      }
      std::size_t end = begin;
      while (end < list.size() && list[end] >= first_new) ++end;
      const double low = begin > 0 ? network.crossings[list[begin - 1]].t : 0;
      const double high = end < list.size() ? network.crossings[list[end]].t : 1;
      const int n = int(end - begin);
      const double gap = (high - low) * std::min(0.1, 1.0 / (n + 2));
      double floor = low;
      for (std::size_t i = begin; i < end; ++i) {
        double& t = network.crossings[list[i]].t;
        t = std::max(t, floor + gap);
        t = std::min(t, high - gap * double(end - i));
        floor = t;
      }
      begin = end;
    }
  }
}

} // namespace

Result<void> collapse_chart(const Triangle_surface& surface, const Chart& chart,
                            const Chart_parameterization& map, Contour_network& network) {
  CGAL_precondition(chart.kind == Chart_kind::annulus);
  for (const Walk& walk : chart.walks)
    for (const Walk_edge& e : walk.edges)
      if (network.nodes[visit_node(network, e)].kind != Node_kind::saddle || !e.forward)
        return make_error(Error_code::impossible_request, "only contours through saddles can be joined");
  const std::vector<Visit> visits = sorted_visits(chart, map);
  const double value = 0.5 * (network.edges[chart.walks[0].edges[0].edge].value +
                              network.edges[chart.walks[1].edges[0].edge].value);
  const int first_new = int(network.crossings.size());
  std::vector<Contour_edge> lines;
  std::vector<char> kept(network.edges.size(), 0);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit &a = visits[i], &b = visits[(i + 1) % visits.size()];
    if (a.walk == b.walk && visits.size() > 1) {
      kept[chart.walks[a.walk].edges[a.index].edge] = 1;
      continue;
    }
    const double around = i + 1 == visits.size() ? 1 : 0;
    const bool upward = a.walk == 0;
    const Visit &low = upward ? a : b, &high = upward ? b : a;
    // Seen from the stored V of the LOW vertex, the HIGH vertex is this many turns from its own.
    const int from = chart.walks[0].edges[low.index].begin, to = chart.walks[1].edges[high.index].begin;
    const double stored_low = map.v()[chart.walks[0].vertices[from]],
                 stored_high = map.v()[chart.walks[1].vertices[to]];
    const double apart = high.v - low.v + (upward ? around : -around);
    const double turns = std::round(stored_low + apart - stored_high);
    Result<Contour_edge> line = trace_line(surface, chart, map, from, to, turns, !upward, network);
    if (!line) return line.error();
    line->from = visit_node(network, chart.walks[a.walk].edges[a.index]);
    line->to = visit_node(network, chart.walks[b.walk].edges[b.index]);
    line->value = value;
    lines.push_back(std::move(*line));
  }
  for (const Walk& walk : chart.walks)
    for (const Walk_edge& e : walk.edges) {
      if (kept[e.edge])
        network.edges[e.edge].value = value;
      else
        remove_edge(network, e.edge);
    }
  separate_new_crossings(network, first_new);
  for (Contour_edge& line : lines) network.edges.push_back(std::move(line));
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
