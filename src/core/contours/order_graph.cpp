// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Order_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

class Sets {
public:
  explicit Sets(int size) : m_parent(std::size_t(size)) { std::iota(m_parent.begin(), m_parent.end(), 0); }
  int find(int x) {
    while (m_parent[std::size_t(x)] != x)
      x = m_parent[std::size_t(x)] = m_parent[std::size_t(m_parent[std::size_t(x)])];
    return x;
  }
  // The smaller representative stays.
  void join(int a, int b) {
    a = find(a);
    b = find(b);
    m_parent[std::size_t(std::max(a, b))] = std::min(a, b);
  }

private:
  std::vector<int> m_parent;
};

// Pairs of one sweep: `born` nodes begin components, others join them.
class Elder_rule {
public:
  explicit Elder_rule(const Order_graph& graph)
      : m_graph(graph), m_sets(int(graph.nodes.size())), m_eldest(graph.nodes.size()) {
    std::iota(m_eldest.begin(), m_eldest.end(), 0);
  }

  std::vector<std::array<int, 2>> sweep(bool upward) {
    std::vector<std::array<int, 2>> pairs;
    const int n = int(m_graph.nodes.size());
    const auto is_elder = [&](int a, int b) { return upward ? a < b : a > b; };
    for (int i = 0; i < n; ++i) {
      const int node = upward ? i : n - 1 - i;
      const Order_graph::Node& at = m_graph.nodes[std::size_t(node)];
      bool is_first = true;
      for (int a : upward ? at.lower : at.upper) {
        const Order_graph::Arc& arc = m_graph.arcs[std::size_t(a)];
        const int from = m_sets.find(upward ? arc.low : arc.high), here = m_sets.find(node);
        if (from == here) continue;
        int &old = m_eldest[std::size_t(from)], &young = m_eldest[std::size_t(here)];
        const int elder = is_elder(old, young) ? old : young, younger = is_elder(old, young) ? young : old;
        if (!is_first) pairs.push_back({younger, node});
        is_first = false;
        m_sets.join(from, here);
        m_eldest[std::size_t(m_sets.find(node))] = elder;
      }
    }
    return pairs;
  }

  // The first and the last node of each component, after an upward sweep.
  std::vector<std::array<int, 2>> whole_components() {
    std::map<int, std::array<int, 2>> ends;
    for (int node = 0; node < int(m_graph.nodes.size()); ++node)
      ends.emplace(m_eldest[std::size_t(m_sets.find(node))], std::array<int, 2>{node, node})
          .first->second[1] = node;
    std::vector<std::array<int, 2>> pairs;
    for (const auto& [eldest, pair] : ends) pairs.push_back(pair);
    return pairs;
  }

private:
  const Order_graph& m_graph;
  Sets m_sets;
  std::vector<int> m_eldest; // node of each component, at its representative
};

// Edges are cut into pieces where contours of critical vertices cross them. Two pieces belong to one arc if a
// face has no such contour between them.
class Sweeper {
public:
  Sweeper(const Triangle_surface& surface, const Vertex_order& order, const std::vector<double>& values)
      : m_surface(surface), m_rank(order.rank), m_values(values),
        m_node(std::size_t(surface.number_of_vertices()), -1) {
    for (int v : order.by_rank)
      if (surface.outgoing[std::size_t(v)] >= 0) add_if_critical(v);
  }

  Order_graph run() {
    m_done.assign(std::size_t(m_surface.number_of_faces()), 0);
    for (int n = 0; n < int(m_graph.nodes.size()); ++n) trace(n);
    std::sort(m_crossings.begin(), m_crossings.end());
    number_pieces();
    Sets sets(m_pieces);
    for (int f = 0; f < m_surface.number_of_faces(); ++f) join_pieces(f, sets);
    make_arcs(sets);
    assign_vertices(sets);
    for (int f = 0; f < m_surface.number_of_faces(); ++f)
      m_graph.arc_of_face.push_back(m_arc[std::size_t(sets.find(largest_piece(f)))]);
    pair_nodes();
    return std::move(m_graph);
  }

private:
  struct Crossing {
    int edge, node; // an edge's crossings are ordered as the nodes are
    bool operator<(const Crossing& other) const {
      return edge != other.edge ? edge < other.edge : node < other.node;
    }
  };

  int rank(int v) const { return m_rank[std::size_t(v)]; }
  int low_end(int h) const {
    const int a = m_surface.source(h), b = m_surface.target(h);
    return rank(a) < rank(b) ? a : b;
  }
  int high_end(int h) const {
    const int a = m_surface.source(h), b = m_surface.target(h);
    return rank(a) < rank(b) ? b : a;
  }

  // Whether the vertices around v are higher, in order; around an inner vertex the last is followed by the
  // first.
  std::vector<char> link(int v) const {
    std::vector<char> higher;
    const int first = m_surface.outgoing[std::size_t(v)];
    int h = first, last = h;
    do {
      higher.push_back(rank(m_surface.target(h)) > rank(v));
      last = h;
      h = m_surface.rotate_ccw(h);
    } while (h >= 0 && h != first);
    if (h < 0) higher.push_back(rank(m_surface.source(m_surface.previous(last))) > rank(v));
    return higher;
  }

  void add_if_critical(int v) {
    const std::vector<char> higher = link(v);
    int changes = 0;
    for (std::size_t i = 0; i + 1 < higher.size(); ++i) changes += higher[i] != higher[i + 1];
    const bool is_boundary = m_surface.is_boundary(m_surface.outgoing[std::size_t(v)]);
    if (!is_boundary) changes += higher.back() != higher.front();
    if (changes == (is_boundary ? 1 : 2)) return;
    m_node[std::size_t(v)] = int(m_graph.nodes.size());
    const Critical_kind kind = changes > 0      ? Critical_kind::saddle
                               : higher.front() ? Critical_kind::minimum
                                                : Critical_kind::maximum;
    m_graph.nodes.push_back({v, kind, {}, {}});
  }

  // The contour through a critical vertex, from each of its faces that it leaves through the opposite edge.
  void trace(int node) {
    const int v = m_graph.nodes[std::size_t(node)].vertex;
    int spoke = m_surface.outgoing[std::size_t(v)];
    const int first = spoke;
    std::vector<int> faces;
    do {
      const int f = spoke / 3, across = Triangle_surface::next(spoke);
      if (rank(low_end(across)) < rank(v) && rank(v) < rank(high_end(across)) && !m_done[std::size_t(f)])
        follow(node, across, faces);
      spoke = m_surface.rotate_ccw(spoke);
    } while (spoke >= 0 && spoke != first);
    for (int f : faces) m_done[std::size_t(f)] = 0;
  }

  // From face to face until the contour is back, or ends on the boundary. The face where it comes back is not
  // begun from again.
  void follow(int node, int exit, std::vector<int>& faces) {
    const int v = m_graph.nodes[std::size_t(node)].vertex;
    for (;;) {
      m_crossings.push_back({m_surface.edge(exit), node});
      const int entry = m_surface.opposite[std::size_t(exit)];
      if (entry < 0) return;
      const int next = Triangle_surface::next(entry), apex = m_surface.target(next);
      if (apex == v) {
        m_done[std::size_t(entry / 3)] = 1;
        faces.push_back(entry / 3);
        return;
      }
      const bool apex_is_higher = rank(apex) > rank(v),
                 target_is_higher = rank(m_surface.target(entry)) > rank(v);
      exit = apex_is_higher != target_is_higher ? next : Triangle_surface::previous(entry);
    }
  }

  void number_pieces() {
    m_first_crossing.assign(std::size_t(m_surface.number_of_halfedges()) + 1, 0);
    for (const Crossing& c : m_crossings) ++m_first_crossing[std::size_t(c.edge) + 1];
    for (std::size_t h = 1; h < m_first_crossing.size(); ++h) m_first_crossing[h] += m_first_crossing[h - 1];
    m_pieces = int(m_crossings.size()) + m_surface.number_of_halfedges();
  }
  int crossings(int h) const {
    const std::size_t e = std::size_t(m_surface.edge(h));
    return m_first_crossing[e + 1] - m_first_crossing[e];
  }
  int crossing_node(int h, int i) const {
    return m_crossings[std::size_t(m_first_crossing[std::size_t(m_surface.edge(h))] + i)].node;
  }
  // Piece i of an edge, from its lower end up. One number more than crossings for each halfedge before.
  int piece(int h, int i) const {
    const int e = m_surface.edge(h);
    return m_first_crossing[std::size_t(e)] + e + i;
  }

  // The halfedges of a face from its lowest vertex to the middle one, from there to the highest, and from the
  // lowest to it, in any direction.
  std::array<int, 3> sides(int f) const {
    std::array<int, 3> h{3 * f, 3 * f + 1, 3 * f + 2};
    std::sort(h.begin(), h.end(), [&](int a, int b) {
      const int la = rank(low_end(a)), lb = rank(low_end(b));
      return la != lb ? la < lb : rank(high_end(a)) < rank(high_end(b));
    });
    return {h[0], h[2], h[1]};
  }

  void join_pieces(int f, Sets& sets) const {
    const auto [low, high, whole] = sides(f);
    const int jump = m_node[std::size_t(high_end(low))] >= 0 ? 1 : 0;
    CGAL_assertion(crossings(whole) == crossings(low) + crossings(high) + jump);
    for (int i = 0; i <= crossings(low); ++i) sets.join(piece(whole, i), piece(low, i));
    for (int i = 0; i <= crossings(high); ++i)
      sets.join(piece(whole, crossings(low) + jump + i), piece(high, i));
  }

  void make_arcs(Sets& sets) {
    m_arc.assign(std::size_t(m_pieces), -1);
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h) {
      if (m_surface.edge(h) != h) continue;
      const int k = crossings(h);
      for (int i = 0; i <= k; ++i) {
        int& arc = m_arc[std::size_t(sets.find(piece(h, i)))];
        if (arc < 0) {
          arc = int(m_graph.arcs.size());
          m_graph.arcs.push_back({-1, -1});
        }
        set_end(m_graph.arcs[std::size_t(arc)].low,
                i > 0 ? crossing_node(h, i - 1) : m_node[std::size_t(low_end(h))]);
        set_end(m_graph.arcs[std::size_t(arc)].high,
                i < k ? crossing_node(h, i) : m_node[std::size_t(high_end(h))]);
      }
    }
    for (int a = 0; a < int(m_graph.arcs.size()); ++a) {
      m_graph.nodes[std::size_t(m_graph.arcs[std::size_t(a)].low)].upper.push_back(a);
      m_graph.nodes[std::size_t(m_graph.arcs[std::size_t(a)].high)].lower.push_back(a);
    }
    for (Order_graph::Node& node : m_graph.nodes)
      if (node.lower.size() == 1 && node.upper.size() == 1 &&
          m_surface.is_boundary(m_surface.outgoing[std::size_t(node.vertex)]))
        node.kind = Critical_kind::touch;
  }

  static void set_end(int& end, int node) {
    CGAL_assertion(node < 0 || end < 0 || end == node);
    if (node >= 0) end = node;
  }

  void assign_vertices(Sets& sets) {
    for (int v = 0; v < m_surface.number_of_vertices(); ++v) {
      const int h = m_surface.outgoing[std::size_t(v)];
      int arc = -1;
      if (h >= 0 && m_node[std::size_t(v)] < 0)
        arc = m_arc[std::size_t(sets.find(piece(h, low_end(h) == v ? 0 : crossings(h))))];
      m_graph.arc_of_vertex.push_back(arc);
    }
  }

  // The part of a face below a value of its function, which is linear between its vertices.
  static double part_below(double value, double low, double middle, double high) {
    if (!(value > low)) return 0;
    if (!(value < high)) return 1;
    return value <= middle ? (value - low) * (value - low) / ((middle - low) * (high - low))
                           : 1 - (high - value) * (high - value) / ((high - middle) * (high - low));
  }

  int largest_piece(int f) const {
    const auto [low, high, whole] = sides(f);
    const auto value = [&](int v) { return m_values[std::size_t(v)]; };
    const double bottom = value(low_end(low)), middle = value(high_end(low)), top = value(high_end(high));
    int best = 0;
    double before = 0, largest = -1;
    for (int i = 0; i <= crossings(whole); ++i) {
      const bool is_last = i == crossings(whole);
      const double below = is_last
                               ? 1
                               : part_below(value(m_graph.nodes[std::size_t(crossing_node(whole, i))].vertex),
                                            bottom, middle, top);
      if (below - before > largest) {
        largest = below - before;
        best = i;
      }
      before = below;
    }
    return piece(whole, best);
  }

  void pair_nodes() {
    Elder_rule upward(m_graph), downward(m_graph);
    m_graph.pairs = upward.sweep(true);
    for (const std::array<int, 2>& pair : downward.sweep(false)) m_graph.pairs.push_back(pair);
    const std::vector<std::array<int, 2>> whole = upward.whole_components();
    m_graph.components = int(whole.size());
    m_graph.pairs.insert(m_graph.pairs.end(), whole.begin(), whole.end());
    std::sort(m_graph.pairs.begin(), m_graph.pairs.end());
  }

  const Triangle_surface& m_surface;
  const std::vector<int>& m_rank;
  const std::vector<double>& m_values;
  std::vector<int> m_node; // of each critical vertex
  std::vector<char> m_done;
  std::vector<Crossing> m_crossings;
  std::vector<int> m_first_crossing; // per halfedge, of the edges' representatives
  int m_pieces = 0;
  std::vector<int> m_arc; // of each piece that represents its arc
  Order_graph m_graph;
};

} // namespace

Order_graph order_graph(const Triangle_surface& surface, const Vertex_order& order,
                        const std::vector<double>& values) {
  CGAL_precondition(order.rank.size() == surface.points.size());
  CGAL_precondition(values.size() == surface.points.size());
  return Sweeper(surface, order, values).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
