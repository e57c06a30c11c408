// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Contour_network.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

Point Contour_network::position(const Triangle_surface& surface, int vertex) const {
  if (!is_crossing(vertex)) return surface.points[vertex];
  const Edge_crossing& c = crossing(vertex);
  if (c.halfedge < 0) return Point(0, 0, 0);
  const Point &p = surface.points[surface.source(c.halfedge)],
              &q = surface.points[surface.target(c.halfedge)];
  return p + c.t * (q - p);
}

std::vector<Point> network_points(const Triangle_surface& surface, const Contour_network& network) {
  std::vector<Point> points;
  points.reserve(surface.points.size() + network.crossings.size());
  points = surface.points;
  for (std::size_t c = 0; c < network.crossings.size(); ++c)
    points.push_back(network.position(surface, network.surface_vertices + int(c)));
  return points;
}

int add_crossing(Contour_network& network, const Edge_crossing& crossing) {
  network.crossings.push_back(crossing);
  return network.surface_vertices + int(network.crossings.size()) - 1;
}

int add_node(Contour_network& network, int vertex, Node_kind kind) {
  network.nodes.push_back({vertex, kind, 0});
  return int(network.nodes.size()) - 1;
}

std::vector<char> nodes_in_use(const Contour_network& network) {
  std::vector<char> used(network.nodes.size(), 0);
  for (const Contour_edge& e : network.edges)
    if (!network.is_removed(e)) used[e.from] = used[e.to] = 1;
  return used;
}

void reverse(Contour_edge& edge) {
  std::reverse(edge.vertices.begin(), edge.vertices.end());
  std::reverse(edge.faces.begin(), edge.faces.end());
  std::swap(edge.from, edge.to);
}

void remove_edge(Contour_network& network, int e) {
  Contour_edge& edge = network.edges[e];
  for (std::size_t i = 1; i + 1 < edge.vertices.size(); ++i)
    if (network.is_crossing(edge.vertices[i]))
      network.crossings[edge.vertices[i] - network.surface_vertices].halfedge = -1;
  edge.vertices.clear();
  edge.faces.clear();
}

std::vector<int> split_edge(Contour_network& network, Contour_id e, int at, Node_kind kind) {
  const Contour_edge whole = network.edges[e];
  const int last = int(whole.vertices.size()) - 1;
  CGAL_precondition(0 <= at && at <= last);
  if (at == 0 || at == last) return {e};
  const int node = add_node(network, whole.vertices[at], kind);
  Contour_edge first = whole, second = whole;
  first.vertices.resize(at + 1);
  first.faces.resize(at);
  first.to = second.from = node;
  second.vertices.erase(second.vertices.begin(), second.vertices.begin() + at);
  second.faces.erase(second.faces.begin(), second.faces.begin() + at);
  network.edges[e].vertices.clear();
  network.edges[e].faces.clear();
  const bool lonely = whole.from == whole.to && network.nodes[whole.from].kind == Node_kind::regular;
  if (lonely) { // the loop now begins at the new node
    second.vertices.insert(second.vertices.end(), first.vertices.begin() + 1, first.vertices.end());
    second.faces.insert(second.faces.end(), first.faces.begin(), first.faces.end());
    second.to = node;
    network.edges.push_back(std::move(second));
    return {int(network.edges.size()) - 1};
  }
  network.edges.push_back(std::move(first));
  network.edges.push_back(std::move(second));
  return {int(network.edges.size()) - 2, int(network.edges.size()) - 1};
}

std::vector<Traced_contour> trace_contour(const Triangle_surface& closed, const Vertex_order& order,
                                          int seed) {
  const int level = order.rank[seed];
  std::vector<Traced_contour> loops;
  int spoke = closed.outgoing[seed];
  do {
    int exit = Triangle_surface::next(spoke); // the link edge, counterclockwise as seen from the seed
    if (order.rank[closed.source(exit)] < level && level < order.rank[closed.target(exit)]) {
      Traced_contour loop;
      loop.seed = seed;
      for (;;) {
        loop.halfedges.push_back(exit);
        const int entry = closed.opposite[exit], apex = closed.target(Triangle_surface::next(entry));
        if (apex == seed) break;
        exit = order.rank[apex] > level ? Triangle_surface::next(entry) : Triangle_surface::previous(entry);
      }
      loops.push_back(std::move(loop));
    }
    spoke = closed.rotate_ccw(spoke);
  } while (spoke != closed.outgoing[seed]);
  return loops;
}

Traced_contour trace_threshold(const Triangle_surface& closed, const Vertex_order& order, Rank threshold,
                               Halfedge_index halfedge) {
  Traced_contour loop;
  loop.threshold = threshold;
  int exit = halfedge;
  do {
    loop.halfedges.push_back(exit);
    const int entry = closed.opposite[exit], apex = closed.target(Triangle_surface::next(entry));
    exit = order.rank[apex] > threshold ? Triangle_surface::next(entry) : Triangle_surface::previous(entry);
  } while (exit != halfedge);
  return loop;
}

namespace {

struct Pending_crossing {
  int edge;       // representative halfedge
  int key;        // order of the contours: twice the rank, or odd for thresholds
  int contour;    // index into the traced contours
  int position;   // index into its halfedges
  bool ascending; // the representative halfedge runs from the lower to the higher end
};

// Spreads increasing wishes in (0, 1) so that neighbours, and the ends, keep `gap`.
void spread(std::vector<double>& t) {
  const int k = int(t.size());
  const double gap = std::min(0.03, 1.0 / (k + 2));
  for (int i = 0; i < k; ++i) t[i] = std::max(t[i], i == 0 ? gap : t[i - 1] + gap);
  for (int i = k - 1; i >= 0; --i) t[i] = std::min(t[i], i == k - 1 ? 1 - gap : t[i + 1] - gap);
}

double contour_value(const Traced_contour& contour, const Vertex_order& order,
                     const std::vector<double>& values) {
  if (contour.seed >= 0) return values[contour.seed];
  const int below = order.by_rank[contour.threshold], above = order.by_rank[contour.threshold + 1];
  return 0.5 * (values[below] + values[above]);
}

// The value's position between the ends of an edge, guarded: after a cleanup neighbouring values may be
// equal.
double wish(double value, double low, double high) {
  if (!(high > low)) return 0.5;
  return std::min(1.0, std::max(0.0, (value - low) / (high - low)));
}

// For each contour, the network vertex of each halfedge that it crosses: the crossings are new ones of the
// network.
std::vector<std::vector<int>> add_crossings(const Triangle_surface& surface, const Vertex_order& order,
                                            const std::vector<double>& values,
                                            const std::vector<Traced_contour>& contours,
                                            Contour_network& network) {
  std::vector<Pending_crossing> pending;
  for (int c = 0; c < int(contours.size()); ++c) {
    const Traced_contour& contour = contours[c];
    const int key = contour.seed >= 0 ? 2 * order.rank[contour.seed] : 2 * contour.threshold + 1;
    for (int i = 0; i < int(contour.halfedges.size()); ++i) {
      const int h = contour.halfedges[i], e = surface.edge(h);
      pending.push_back({e, key, c, i, e == h});
    }
  }
  std::sort(pending.begin(), pending.end(), [](const Pending_crossing& a, const Pending_crossing& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    return a.ascending ? a.key < b.key : b.key < a.key;
  });

  std::vector<std::vector<int>> vertex_of(contours.size());
  for (std::size_t c = 0; c < contours.size(); ++c) vertex_of[c].resize(contours[c].halfedges.size());
  std::vector<double> t;
  for (std::size_t begin = 0, end; begin < pending.size(); begin = end) {
    const int e = pending[begin].edge;
    const double from = values[surface.source(e)], to = values[surface.target(e)];
    t.clear();
    for (end = begin; end < pending.size() && pending[end].edge == e; ++end) {
      const double value = contour_value(contours[pending[end].contour], order, values);
      t.push_back(pending[end].ascending ? wish(value, from, to) : 1 - wish(value, to, from));
    }
    spread(t);
    for (std::size_t i = begin; i < end; ++i) {
      vertex_of[pending[i].contour][pending[i].position] =
          network.surface_vertices + int(network.crossings.size());
      network.crossings.push_back({e, t[i - begin]});
    }
  }
  return vertex_of;
}

// The contour as an edge of the network that begins and ends at node `node`.
Contour_edge closed_edge(const Triangle_surface& surface, const Traced_contour& contour,
                         const std::vector<int>& vertices, int node, double value) {
  Contour_edge edge;
  edge.value = value;
  edge.from = edge.to = node;
  if (contour.seed >= 0) edge.vertices.push_back(contour.seed);
  for (std::size_t i = 0; i < contour.halfedges.size(); ++i) {
    edge.vertices.push_back(vertices[i]);
    if (contour.seed >= 0 || i > 0) edge.faces.push_back(contour.halfedges[i] / 3);
  }
  const int last = contour.halfedges.back();
  edge.faces.push_back(surface.opposite[last] / 3);
  edge.vertices.push_back(edge.vertices.front());
  return edge;
}

} // namespace

Contour_network build_network(const Triangle_surface& surface, const Vertex_order& order,
                              const std::vector<double>& values, const std::vector<Traced_contour>& contours,
                              const std::vector<int>& saddles, const std::vector<int>& multiplicity) {
  Contour_network network;
  network.surface_vertices = surface.number_of_vertices();

  const std::vector<std::vector<int>> vertex_of = add_crossings(surface, order, values, contours, network);
  std::map<int, int> saddle_node;
  for (std::size_t i = 0; i < saddles.size(); ++i) {
    saddle_node[saddles[i]] = int(network.nodes.size());
    network.nodes.push_back({saddles[i], Node_kind::saddle, multiplicity[i]});
  }
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const Traced_contour& contour = contours[c];
    const auto saddle = contour.seed >= 0 ? saddle_node.find(contour.seed) : saddle_node.end();
    const int node = saddle != saddle_node.end()
                         ? saddle->second
                         : add_node(network, contour.seed >= 0 ? contour.seed : vertex_of[c][0]);
    network.edges.push_back(
        closed_edge(surface, contour, vertex_of[c], node, contour_value(contour, order, values)));
  }
  return network;
}

void add_boundary_contour(const Triangle_surface& surface, const std::vector<int>& loop, bool is_maximum,
                          double value, Contour_network& network) {
  Contour_edge edge;
  edge.value = value;
  for (int h : loop) edge.vertices.push_back(surface.source(h));
  edge.vertices.push_back(edge.vertices.front());
  edge.faces.assign(loop.size(), -1);
  // The face is on the left of the loop. On a maximum it must be on the right, so the contour runs the other
  // way.
  if (is_maximum) std::reverse(edge.vertices.begin(), edge.vertices.end());
  edge.from = edge.to = add_node(network, edge.vertices.front(), Node_kind::boundary);
  network.edges.push_back(std::move(edge));
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
