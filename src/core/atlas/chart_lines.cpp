// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas/chart_lines.h"

#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

std::optional<double> position_on_edge(const Triangle_surface& surface, const Chart& chart,
                                       const Contour_network& network, int vertex, int edge) {
  const int origin = chart.vertex_origin[vertex];
  if (origin < 0) {
    const std::size_t i = vertex - (chart.vertex_origin.size() - chart.split_chords.size());
    const auto a = position_on_edge(surface, chart, network, chart.split_chords[i][0], edge);
    const auto b = position_on_edge(surface, chart, network, chart.split_chords[i][1], edge);
    if (!a || !b) return std::nullopt;
    return 0.5 * (*a + *b);
  }
  if (network.is_crossing(origin)) {
    const Edge_crossing& c = network.crossing(origin);
    if (c.halfedge != edge) return std::nullopt;
    return c.t;
  }
  if (origin == surface.source(edge)) return 0.0;
  if (origin == surface.target(edge)) return 1.0;
  return std::nullopt;
}

std::optional<Line_crossing> surface_crossing(const Triangle_surface& surface, const Chart& chart,
                                              const Contour_network& network, int h, double t,
                                              int next_local_face) {
  const int face = chart.face_origin[h / 3];
  for (int i = 0; i < 3; ++i) {
    const int edge = surface.edge(3 * face + i);
    const auto a = position_on_edge(surface, chart, network, chart.mesh.source(h), edge);
    const auto b = position_on_edge(surface, chart, network, chart.mesh.target(h), edge);
    if (a && b) return Line_crossing{edge, *a + t * (*b - *a), chart.face_origin[next_local_face]};
  }
  return std::nullopt;
}

void append_crossings(const std::vector<Line_crossing>& crossings, Contour_network& network,
                      Contour_edge& edge) {
  for (const Line_crossing& c : crossings) {
    edge.vertices.push_back(add_crossing(network, {c.edge, c.t}));
    edge.faces.push_back(c.next_face);
  }
}

void pull_loop_tight(std::vector<Line_crossing>& crossings) {
  std::vector<Line_crossing> tight;
  for (const Line_crossing& c : crossings) {
    if (!tight.empty() && tight.back().edge == c.edge)
      tight.pop_back();
    else
      tight.push_back(c);
  }
  while (tight.size() > 1 && tight.front().edge == tight.back().edge) {
    tight.erase(tight.begin());
    tight.pop_back();
  }
  crossings = std::move(tight);
}

namespace {

bool touches(const Triangle_surface& surface, const Contour_network& network, int edge, int vertex) {
  if (network.is_crossing(vertex)) return network.crossing(vertex).halfedge == edge;
  return surface.source(edge) == vertex || surface.target(edge) == vertex;
}

} // namespace

bool are_on_one_edge(const Triangle_surface& surface, const Contour_network& network, int a, int b) {
  if (network.is_crossing(a)) return touches(surface, network, network.crossing(a).halfedge, b);
  if (network.is_crossing(b)) return touches(surface, network, network.crossing(b).halfedge, a);
  const int first = surface.outgoing[a];
  int h = first;
  do {
    if (surface.target(h) == b) return true;
    if (surface.source(Triangle_surface::previous(h)) == b) return true;
    h = surface.rotate_ccw(h);
  } while (h >= 0 && h != first);
  return false;
}

void pull_tight(const Triangle_surface& surface, const Contour_network& network, int start, int end,
                int& first_face, std::vector<Line_crossing>& c) {
  std::vector<Line_crossing> tight;
  for (const Line_crossing& x : c) {
    if (!tight.empty() && tight.back().edge == x.edge)
      tight.pop_back();
    else if (tight.empty() && touches(surface, network, x.edge, start))
      first_face = x.next_face;
    else
      tight.push_back(x);
    if (tight.empty()) first_face = x.next_face;
  }
  while (!tight.empty() && touches(surface, network, tight.back().edge, end)) tight.pop_back();
  c = std::move(tight);
}

namespace {

Error too_near() {
  return make_error(Error_code::refused_edit, "too near to another contour: there is no vertex in between");
}

class Transfer {
public:
  Transfer(const Triangle_surface& surface, const Chart& chart, const Contour_network& local,
           Contour_network& network)
      : m_surface(surface), m_chart(chart), m_local(local), m_network(network) {}

  Result<int> add(const Contour_edge& edge) {
    m_crossings.clear();
    const bool from_vertex = !m_local.is_crossing(edge.vertices.front());
    for (std::size_t i = from_vertex ? 1 : 0; i + 1 < edge.vertices.size(); ++i)
      cross(m_local.crossing(edge.vertices[i]), edge.faces[i]);
    return from_vertex ? loop_at_vertex(edge) : free_loop(edge);
  }

private:
  // A crossing of an edge that is, or is part of, an edge of the surface.
  void cross(const Edge_crossing& crossing, int next_face) {
    if (const auto on_surface =
            surface_crossing(m_surface, m_chart, m_network, crossing.halfedge, crossing.t, next_face))
      m_crossings.push_back(*on_surface);
  }

  int node(int local_node, int vertex) {
    const auto [found, is_new] = m_node.emplace(local_node, int(m_network.nodes.size()));
    if (is_new) {
      Contour_node node = m_local.nodes[local_node];
      node.vertex = vertex;
      m_network.nodes.push_back(node);
    }
    return found->second;
  }

  int finish(const Contour_edge& edge, Contour_edge& made) {
    made.value = edge.value;
    made.from = made.to = node(edge.from, made.vertices.front());
    m_network.edges.push_back(std::move(made));
    return int(m_network.edges.size()) - 1;
  }

  Result<int> loop_at_vertex(const Contour_edge& edge) {
    const int seed = m_chart.vertex_origin[edge.vertices.front()];
    if (seed < 0 || seed >= m_network.surface_vertices) return too_near();
    int first_face = m_chart.face_origin[edge.faces.front()];
    pull_tight(m_surface, m_network, seed, seed, first_face, m_crossings);
    if (m_crossings.empty()) return too_near();
    Contour_edge made;
    made.vertices.push_back(seed);
    made.faces.push_back(first_face);
    append_crossings(m_crossings, m_network, made);
    made.vertices.push_back(seed);
    return finish(edge, made);
  }

  Result<int> free_loop(const Contour_edge& edge) {
    pull_loop_tight(m_crossings);
    if (m_crossings.size() < 3) return too_near();
    Contour_edge made;
    append_crossings(m_crossings, m_network, made);
    made.vertices.push_back(made.vertices.front());
    return finish(edge, made);
  }

  const Triangle_surface& m_surface;
  const Chart& m_chart;
  const Contour_network& m_local;
  Contour_network& m_network;
  std::vector<Line_crossing> m_crossings;
  std::map<int, int> m_node;
};

} // namespace

Result<std::vector<int>> transfer_contours(const Triangle_surface& surface, const Chart& chart,
                                           const Contour_network& local, const std::vector<int>& which,
                                           Contour_network& network) {
  Transfer transfer(surface, chart, local, network);
  std::vector<int> added;
  for (int e : which) {
    Result<int> edge = transfer.add(local.edges[e]);
    if (!edge) return edge.error();
    added.push_back(*edge);
  }
  return added;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
