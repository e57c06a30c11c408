// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quad_connectivity.h"
#include <CGAL/Reeb_quadrangulation/stitch.h>

#include "stitching/meetings.h"
#include "textures/edge_table.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

int modulo(int a, int n) {
  return ((a % n) + n) % n;
}

using internal::Meetings;
using internal::Stop;

// Global vertices: nodes, then those on each contour edge, then the inner vertices of each texture.
class Stitcher {
public:
  Stitcher(const std::vector<Point>& points, const Contour_network& network, const Atlas& atlas,
           const Contour_samples& samples, const std::vector<const Placed_texture*>& textures)
      : m_network_points(points), m_network(network), m_atlas(atlas), m_samples(samples),
        m_textures(textures) {}

  Result<Stitched_mesh> run(const T_junction_options& options) {
    add_nodes();
    m_stops.resize(m_network.edges.size());
    m_first_on_edge.assign(m_network.edges.size(), 0);
    m_on_edge.assign(m_network.edges.size(), 0);
    for (std::size_t c = 0; c < m_atlas.charts.size(); ++c) {
      m_global.emplace_back(m_textures[c]->texture.v.size(), -1);
      if (Result<void> found = find_stops(int(c)); !found) return found.error();
    }
    for (std::size_t e = 0; e < m_network.edges.size(); ++e)
      if (!m_network.is_removed(m_network.edges[e])) add_contour_edge(int(e));
    for (std::size_t c = 0; c < m_atlas.charts.size(); ++c) add_chart(int(c));
    find_boundary();
    predict_valences();
    if (!m_hanging.empty())
      if (Result<void> resolved = resolve(options); !resolved) return resolved.error();
    if (m_out.holes > 0) {
      if (Result<void> left_out = leave_out_holes(); !left_out) return left_out.error();
    } else
      m_out.held_vertices = m_anchors;
    for (std::size_t v = 0; v < m_valence.size(); ++v)
      if (m_valence[v] > 0 && !m_boundary[v]) ++m_out.valences[m_valence[v]];
    return std::move(m_out);
  }

private:
  void add_nodes() {
    std::vector<char> used(m_network.nodes.size(), 0);
    for (const Contour_edge& e : m_network.edges)
      if (!m_network.is_removed(e)) used[e.from] = used[e.to] = 1;
    for (std::size_t i = 0; i < used.size(); ++i) {
      m_out.node_vertex.push_back(used[i] ? int(m_out.mesh.points.size()) : -1);
      if (used[i]) m_out.mesh.points.push_back(m_network_points[m_network.nodes[i].vertex]);
    }
  }

  // A coarse edge between two texture vertices of a chart, and the vertices between, from the first to the
  // second.
  struct Coarse_edge {
    int chart, from, to;
    std::vector<int> between;
  };

  // Sorts a chart's side vertices by contour edges; those at nodes get their global vertex.
  Result<void> find_stops(int c) {
    const Chart& chart = *m_atlas.charts[c];
    const Placed_texture& placed = *m_textures[c];
    for (std::size_t w = 0; w < chart.walks.size(); ++w) {
      const Walk& walk = chart.walks[w];
      const std::vector<int>& side = placed.texture.sides[w];
      int samples = 0;
      for (const Walk_edge& we : walk.edges) samples += m_samples.counts[we.edge];
      std::vector<Stop> stops;
      for (int i = 0; i < int(side.size()); ++i) {
        double at = placed.step(int(w), i) + modulo(-placed.offset[w], samples);
        while (at >= samples) at -= samples;
        stops.push_back({at, side[i]});
      }
      std::sort(stops.begin(), stops.end(), [](const Stop& x, const Stop& y) { return x.at < y.at; });
      if (Result<void> spread = spread_stops(c, walk, stops); !spread) return spread;
    }
    return {};
  }

  Result<void> spread_stops(int c, const Walk& walk, const std::vector<Stop>& stops) {
    std::size_t i = 0;
    int before = 0;
    for (const Walk_edge& we : walk.edges) {
      const Contour_edge& edge = m_network.edges[we.edge];
      const int n = m_samples.counts[we.edge];
      if (i == stops.size() || stops[i].at != before)
        return make_error(Error_code::refused_edit, "a side of a chart's texture has no vertex at a node",
                          Element_kind::chart, c);
      m_global[c][stops[i++].vertex] = m_out.node_vertex[we.forward ? edge.from : edge.to];
      Edge_side& side = m_stops[we.edge][(walk.side == Side::low) == we.forward ? 0 : 1];
      side.chart = c;
      for (; i < stops.size() && stops[i].at < before + n; ++i)
        side.stops.push_back(
            {we.forward ? stops[i].at - before : n - (stops[i].at - before), stops[i].vertex});
      if (!we.forward) std::reverse(side.stops.begin(), side.stops.end());
      before += n;
    }
    return {};
  }

  // Adds the vertices between the ends of a contour edge, and notes where one side has more than the other.
  void add_contour_edge(int e) {
    const std::array<Edge_side, 2>& sides = m_stops[e];
    const bool boundary = sides[0].chart < 0 || sides[1].chart < 0;
    m_first_on_edge[e] = int(m_out.mesh.points.size());
    const Meetings meetings = internal::meet(sides[0].stops, sides[1].stops);
    // The larger list has the authority about places: then they increase.
    const int main = sides[0].stops.size() >= sides[1].stops.size() ? 0 : 1;
    for (const std::array<int, 2>& m : meetings) {
      const int side = m[main] >= 0 ? main : 1 - main;
      const int vertex = add_point_on_edge(e, sides[side].stops[m[side]].at);
      for (int s = 0; s < 2; ++s)
        if (m[s] >= 0) m_global[sides[s].chart][sides[s].stops[m[s]].vertex] = vertex;
    }
    m_on_edge[e] = int(meetings.size());
    if (boundary || sides[0].stops.size() + sides[1].stops.size() == 2 * meetings.size()) return;
    for (int s = 0; s < 2; ++s) find_coarse_edges(e, s, meetings);
  }

  void find_coarse_edges(int e, int s, const Meetings& meetings) {
    const Contour_edge& edge = m_network.edges[e];
    const Edge_side& side = m_stops[e][s];
    Coarse_edge coarse{side.chart, m_out.node_vertex[edge.from], -1, {}};
    const auto close = [&](int to) {
      coarse.to = to;
      if (!coarse.between.empty()) m_hanging.push_back(coarse);
      m_out.t_junctions += int(coarse.between.size());
      coarse = {side.chart, to, -1, {}};
    };
    for (std::size_t k = 0; k < meetings.size(); ++k) {
      const int vertex = m_first_on_edge[e] + int(k);
      if (meetings[k][s] >= 0)
        close(vertex);
      else
        coarse.between.push_back(vertex);
    }
    close(m_out.node_vertex[edge.to]);
  }

  int add_point_on_edge(int e, double steps) {
    const std::vector<double>& p = m_samples.parameter[e];
    const std::vector<int>& v = m_network.edges[e].vertices;
    const double at = steps / m_samples.counts[e];
    const std::size_t last = p.size() - 2;
    const std::size_t i = std::min(last, std::size_t(std::max<std::ptrdiff_t>(
                                             0, std::lower_bound(p.begin(), p.end(), at) - p.begin() - 1)));
    const Point &a = m_network_points[v[i]], &b = m_network_points[v[i + 1]];
    m_out.mesh.points.push_back(a + (at - p[i]) / (p[i + 1] - p[i]) * (b - a));
    return int(m_out.mesh.points.size()) - 1;
  }

  void add_chart(int c) {
    const Chart& chart = *m_atlas.charts[c];
    const Placed_texture& placed = *m_textures[c];
    std::vector<int>& global = m_global[c];
    std::vector<char> on_side(global.size(), 0);
    for (std::size_t i = 0; i < global.size(); ++i) {
      on_side[i] = global[i] >= 0;
      if (on_side[i]) continue;
      global[i] = int(m_out.mesh.points.size());
      m_out.mesh.points.push_back(position(chart, placed.location[i]));
    }
    for (int v : anchored_vertices(placed)) m_anchors.push_back(global[std::size_t(v)]);
    m_valence.resize(m_out.mesh.points.size(), 0);
    std::vector<int> quads(global.size(), 0);
    for (std::size_t f = 0; f < placed.texture.quads.size(); ++f) {
      const Quad& q = placed.texture.quads[f];
      for (int v : q) ++quads[v];
      m_out.mesh.quads.push_back({global[q[0]], global[q[1]], global[q[2]], global[q[3]]});
      m_out.chart_of_quad.push_back(c);
      m_hole.push_back(placed.texture.is_hole(int(f)));
      m_out.holes += m_hole.back();
    }
    // The edges that leave a vertex inside of the chart.
    for (std::size_t i = 0; i < global.size(); ++i) m_valence[global[i]] += quads[i] - on_side[i];
  }

  // A contour vertex has its edges along the contours and those that its charts send it.
  void predict_valences() {
    for (std::size_t e = 0; e < m_network.edges.size(); ++e) {
      const Contour_edge& edge = m_network.edges[e];
      if (m_network.is_removed(edge)) continue;
      for (int k = 0; k < m_on_edge[e]; ++k) m_valence[m_first_on_edge[e] + k] += 2;
      ++m_valence[m_out.node_vertex[edge.from]];
      ++m_valence[m_out.node_vertex[edge.to]];
    }
  }

  void find_boundary() {
    m_boundary.assign(m_out.mesh.points.size(), 0);
    for (std::size_t e = 0; e < m_network.edges.size(); ++e) {
      const Contour_edge& edge = m_network.edges[e];
      if (m_network.is_removed(edge)) continue;
      if (m_atlas.charts_of_edge[e][0] >= 0 && m_atlas.charts_of_edge[e][1] >= 0) continue;
      for (int k = 0; k < m_on_edge[e]; ++k) m_boundary[m_first_on_edge[e] + k] = 1;
      m_boundary[m_out.node_vertex[edge.from]] = m_boundary[m_out.node_vertex[edge.to]] = 1;
    }
  }

  Result<void> resolve(const T_junction_options& options) {
    internal::Edge_table table(4 * m_out.mesh.quads.size());
    for (int h = 0; h < 4 * int(m_out.mesh.quads.size()); ++h)
      table.set(internal::source(m_out.mesh.quads, h), internal::target(m_out.mesh.quads, h), h);
    std::vector<Hanging_edge> hanging;
    for (Coarse_edge& e : m_hanging) {
      int h = table.find(e.from, e.to);
      if (h < 0 || m_out.chart_of_quad[h / 4] != e.chart) {
        h = table.find(e.to, e.from);
        std::reverse(e.between.begin(), e.between.end());
      }
      CGAL_assertion(h >= 0);
      hanging.push_back({h / 4, h & 3, e.between});
    }
    const int before = int(m_out.mesh.points.size());
    Result<Resolved_mesh> resolved = resolve_t_junctions(m_out.mesh, hanging, options);
    if (!resolved) return resolved.error();
    for (int v = before; v < int(resolved->mesh.points.size()); ++v) m_out.interpolated.push_back(v);
    m_out.mesh = std::move(resolved->mesh);
    m_out.extraordinary = std::move(resolved->extraordinary);
    m_valence.resize(m_out.mesh.points.size(), 0);
    m_boundary.resize(m_out.mesh.points.size(), 0);
    for (int v : resolved->boundary_vertices) m_boundary[v] = 1;
    for (std::size_t v = 0; v < m_valence.size(); ++v) m_valence[v] += resolved->added_edges[v];
    std::vector<int> chart(resolved->parent.size());
    std::vector<char> hole(resolved->parent.size());
    for (std::size_t f = 0; f < chart.size(); ++f) {
      chart[f] = m_out.chart_of_quad[resolved->parent[f]];
      hole[f] = m_hole[resolved->parent[f]];
    }
    m_out.chart_of_quad = std::move(chart);
    m_hole = std::move(hole);
    return {};
  }

  // Leaves out the holes' quads and the vertices that have no other.
  Result<void> leave_out_holes() {
    std::vector<Quad> quads;
    std::vector<int> chart, number(m_out.mesh.points.size(), -1);
    std::vector<char> at_hole(m_out.mesh.points.size(), 0);
    for (std::size_t f = 0; f < m_hole.size(); ++f) {
      for (int v : m_out.mesh.quads[f])
        if (m_hole[f])
          m_boundary[v] = at_hole[v] = 1;
        else
          number[v] = 0;
      if (m_hole[f]) continue;
      quads.push_back(m_out.mesh.quads[f]);
      chart.push_back(m_out.chart_of_quad[f]);
    }
    if (const int v = pinched_vertex(quads); v >= 0)
      return make_error(Error_code::refused_edit,
                        "the holes of neighbouring charts touch in a vertex whose quads are not one fan",
                        Element_kind::vertex, v);
    int count = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] < 0) continue;
      number[v] = count;
      m_out.mesh.points[count] = m_out.mesh.points[v];
      m_valence[count] = m_valence[v];
      m_boundary[count++] = m_boundary[v];
    }
    m_out.mesh.points.resize(count);
    m_valence.resize(count);
    for (Quad& q : quads)
      for (int& v : q) v = number[v];
    for (int& v : m_out.node_vertex) v = v < 0 ? -1 : number[v];
    for (std::vector<int>* list : {&m_out.extraordinary, &m_out.interpolated}) {
      list->erase(std::remove_if(list->begin(), list->end(), [&](int v) { return number[v] < 0; }),
                  list->end());
      for (int& v : *list) v = number[v];
    }
    for (int v : m_anchors) at_hole[v] = 1; // the boundary is marked already
    for (int v = 0; v < int(at_hole.size()); ++v)
      if (at_hole[v] && number[v] >= 0) m_out.held_vertices.push_back(number[v]);
    m_out.mesh.quads = std::move(quads);
    m_out.chart_of_quad = std::move(chart);
    m_out.components = internal::quad_components(m_out.mesh.quads, count);
    return {};
  }

  // A vertex at which the boundary passes twice, or -1.
  int pinched_vertex(const std::vector<Quad>& quads) const {
    std::vector<int> opposite, leaving(m_out.mesh.points.size(), 0);
    internal::connect_quads(quads, int(leaving.size()), opposite);
    for (int h = 0; h < int(opposite.size()); ++h)
      if (opposite[h] < 0 && ++leaving[internal::source(quads, h)] > 1) return internal::source(quads, h);
    return -1;
  }

  struct Edge_side {
    int chart = -1;
    std::vector<Stop> stops;
  };

  const std::vector<Point>& m_network_points;
  const Contour_network& m_network;
  const Atlas& m_atlas;
  const Contour_samples& m_samples;
  const std::vector<const Placed_texture*>& m_textures;
  Stitched_mesh m_out;
  std::vector<std::array<Edge_side, 2>> m_stops; ///< per contour edge, left and right
  std::vector<int> m_first_on_edge,
      m_on_edge; ///< per contour edge: its first vertex between nodes, and their number
  std::vector<std::vector<int>> m_global; ///< per chart and texture vertex
  std::vector<Coarse_edge> m_hanging;
  std::vector<int> m_valence;   ///< per vertex, predicted
  std::vector<char> m_boundary; ///< per vertex
  std::vector<char> m_hole;     ///< per quad
  std::vector<int> m_anchors;
};

} // namespace

Result<Stitched_mesh> stitch_textures(const std::vector<Point>& points, const Contour_network& network,
                                      const Atlas& atlas, const Contour_samples& samples,
                                      const std::vector<const Placed_texture*>& textures,
                                      const T_junction_options& options) {
  return Stitcher(points, network, atlas, samples, textures).run(options);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
