// SPDX-License-Identifier: GPL-3.0-or-later
#include "stitching/t_junctions.h"

#include <algorithm>
#include <queue>
#include <string>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

Error bad_hanging(const char* reason, int quad) {
  return make_error(Error_code::impossible_request, std::string("a hanging edge ") + reason,
                    Element_kind::face, quad);
}

} // namespace

Hanging_mesh::Hanging_mesh(const Quad_mesh& mesh, const T_junction_options& options)
    : m_options(options), m_points(mesh.points), m_quads(mesh.quads), m_parent(mesh.quads.size()),
      m_gone(mesh.quads.size(), 0), m_added_edges(mesh.points.size(), 0), m_table(4 * mesh.quads.size()),
      m_parts(0) {
  for (std::size_t f = 0; f < m_parent.size(); ++f) m_parent[f] = int(f);
}

Result<void> Hanging_mesh::add_edges() {
  if (!m_options.fixed.empty() && m_options.fixed.size() != m_quads.size())
    return make_error(Error_code::impossible_request, "there is not one entry of `fixed` for each quad");
  for (int h = 0; h < 4 * int(m_quads.size()); ++h) {
    const int a = source(h), b = target(h);
    if (a < 0 || b < 0 || a >= int(m_points.size()) || b >= int(m_points.size()) || a == b)
      return make_error(Error_code::impossible_request,
                        "a quad has an edge between vertices that do not exist, or are one",
                        Element_kind::face, quad_of(h));
    if (m_table.find(a, b) >= 0)
      return make_error(Error_code::impossible_request,
                        "a quad has an edge that another passes in the same direction", Element_kind::face,
                        quad_of(h));
    m_table.set(a, b, h);
  }
  return {};
}

Result<void> Hanging_mesh::add(const Hanging_edge& edge) {
  if (edge.quad < 0 || edge.quad >= int(m_quads.size()) || edge.corner < 0 || edge.corner > 3)
    return bad_hanging("names a quad or a corner that does not exist", edge.quad);
  if (edge.vertices.empty()) return {};
  const int h = 4 * edge.quad + edge.corner;
  if (opposite(h) >= 0) return bad_hanging("has a quad on its other side", edge.quad);
  if (is_fixed(edge.quad)) return bad_hanging("belongs to a quad that must not be split", edge.quad);
  std::vector<int> chain{source(h)};
  chain.insert(chain.end(), edge.vertices.begin(), edge.vertices.end());
  chain.push_back(target(h));
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const int fine = m_table.find(chain[i + 1], chain[i]);
    if (fine < 0 || opposite(fine) >= 0)
      return bad_hanging("has no finer quads on its other side", edge.quad);
    if (m_parts.find(chain[i], chain[i + 1]) >= 0) return bad_hanging("is named twice", edge.quad);
  }
  m_t_junctions.insert(m_t_junctions.end(), edge.vertices.begin(), edge.vertices.end());
  set_hanging(source(h), target(h), edge.vertices);
  return {};
}

int Hanging_mesh::add_vertex(const Point& p) {
  m_points.push_back(p);
  m_added_edges.push_back(0);
  return int(m_points.size()) - 1;
}

// Where a vertex lies on the edge from a to b.
double Hanging_mesh::fraction(int a, int vertex, int b) const {
  const double before = (m_points[vertex] - m_points[a]).norm(),
               after = (m_points[b] - m_points[vertex]).norm();
  return before + after > 0 ? before / (before + after) : 0.5;
}

// The point of a quad at a fraction along its edge `in`, and at a depth from there.
Point Hanging_mesh::inside(int quad, int in, double along, double depth) const {
  return (1 - depth) * ((1 - along) * point(quad, in) + along * point(quad, in + 1)) +
         depth * ((1 - along) * point(quad, in + 3) + along * point(quad, in + 2));
}

void Hanging_mesh::replace(int quad, const std::vector<Quad>& parts) {
  m_gone[quad] = 1;
  for (int h = 4 * quad; h < 4 * quad + 4; ++h)
    if (m_table.find(source(h), target(h)) == h) m_table.set(source(h), target(h), -1);
  for (const Quad& q : parts) {
    const int f = int(m_quads.size());
    m_quads.push_back(q);
    m_parent.push_back(m_parent[quad]);
    m_gone.push_back(0);
    for (int i = 0; i < 4; ++i) m_table.set(q[i], q[(i + 1) % 4], 4 * f + i);
  }
}

std::vector<int> Hanging_mesh::take_hanging(int a, int b) {
  const auto place = m_hanging.find({a, b});
  std::vector<int> vertices = std::move(place->second);
  m_hanging.erase(place);
  return vertices;
}

void Hanging_mesh::set_hanging(int a, int b, std::vector<int> vertices) {
  if (vertices.empty()) return;
  int from = a;
  for (int v : vertices) {
    m_parts.set(from, v, int(m_keys.size()));
    from = v;
  }
  m_parts.set(from, b, int(m_keys.size()));
  m_keys.push_back({a, b});
  m_hanging[{a, b}] = std::move(vertices);
}

// The T-junction where a line begins or ends: the one next to where it turns, and in any case one with an
// even number on either side. The rest stays on the two parts of the edge. On the boundary, or on a part of a
// hanging edge: a new vertex.
int Hanging_mesh::end_of_line(const Crossing& c, bool start) {
  const int corner = start ? c.in : c.out, other = start ? c.out : c.in;
  const int a = m_quads[c.quad][corner], b = m_quads[c.quad][(corner + 1) % 4];
  if (m_hanging.find({a, b}) == m_hanging.end()) {
    const int m = cross_edge(a, b);
    if (const int k = m_parts.find(b, a); k >= 0) {
      const Edge whole = m_keys[k];
      std::vector<int> t = take_hanging(whole.first, whole.second);
      t.insert(b == whole.first ? t.begin() : std::find(t.begin(), t.end(), b) + 1, m);
      set_hanging(whole.first, whole.second, std::move(t));
    }
    return m;
  }
  const std::vector<int> t = take_hanging(a, b);
  const int n = int(t.size());
  const int turn = (other - corner + 4) % 4;
  const int i = turn == 1 ? n - 1 : turn == 3 ? 0 : (n - 1) / 2 / 2 * 2;
  set_hanging(a, t[i], {t.begin(), t.begin() + i});
  set_hanging(t[i], b, {t.begin() + i + 1, t.end()});
  return t[i];
}

// Splits a quad by a line from m on its edge `in` to n on its edge `out`.
void Hanging_mesh::split(const Crossing& k, int m, int n) {
  const Quad q = m_quads[k.quad];
  const int a = q[k.in], b = q[(k.in + 1) % 4], c = q[(k.in + 2) % 4], d = q[(k.in + 3) % 4];
  const int turn = (k.out - k.in + 4) % 4;
  if (turn == 2) {
    add_edge(m, n);
    replace(k.quad, {{a, m, n, d}, {m, b, c, n}});
    return;
  }
  const double along = fraction(a, m, b);
  if (turn == 1) {
    const int x = add_vertex(inside(k.quad, k.in, along, fraction(b, n, c)));
    add_edge(m, x);
    add_edge(n, x);
    add_edge(x, d);
    replace(k.quad, {{m, b, n, x}, {n, c, d, x}, {a, m, x, d}});
  } else {
    const int x = add_vertex(inside(k.quad, k.in, along, fraction(a, n, d)));
    add_edge(m, x);
    add_edge(n, x);
    add_edge(x, c);
    replace(k.quad, {{a, m, x, n}, {m, b, c, x}, {x, c, d, n}});
  }
}

void Hanging_mesh::draw_line(const std::vector<Crossing>& path) {
  std::vector<int> at{end_of_line(path.front(), true)};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Quad& q = m_quads[path[i].quad];
    at.push_back(cross_edge(q[path[i].out], q[(path[i].out + 1) % 4]));
  }
  at.push_back(end_of_line(path.back(), false));
  for (std::size_t i = 0; i < path.size(); ++i) split(path[i], at[i], at[i + 1]);
}

// A vertex in the middle of an edge.
int Hanging_mesh::cross_edge(int a, int b) {
  const int m = add_vertex(0.5 * (m_points[a] + m_points[b]));
  m_added_edges[m] = 2;
  return m;
}

void Hanging_mesh::add_edge(int a, int b) {
  ++m_added_edges[a];
  ++m_added_edges[b];
}

void Hanging_mesh::draw_templates(const Edge& edge) {
  std::vector<int> t = take_hanging(edge.first, edge.second);
  int h = find(edge);
  for (; !t.empty(); ++templates) {
    const int f = quad_of(h), in = h & 3;
    const Quad q = m_quads[f];
    const int a = q[in], b = q[(in + 1) % 4], c = q[(in + 2) % 4], d = q[(in + 3) % 4];
    const int first = t.front(), last = t.back();
    // The rings of nested templates are equally deep.
    const double rings = double(t.size() / 2), depth = rings / (rings + 1);
    const int p = add_vertex(inside(f, in, fraction(a, first, b), depth));
    const int r = add_vertex(inside(f, in, fraction(a, last, b), depth));
    for (const auto& [x, y] : {Edge(first, p), Edge(last, r), Edge(p, r), Edge(p, d), Edge(r, c)})
      add_edge(x, y);
    replace(f, {{a, first, p, d}, {last, b, c, r}, {p, r, c, d}, {first, last, r, p}});
    h = 4 * (int(m_quads.size()) - 1);
    t.erase(t.begin());
    t.pop_back();
  }
}

namespace {

// Vertex -> number of quads, and whether it is on the boundary.
struct Fans {
  std::vector<int> quads;
  std::vector<char> boundary;
};

Fans count_fans(const std::vector<Quad>& quads, std::size_t vertices) {
  Fans fans{std::vector<int>(vertices, 0), std::vector<char>(vertices, 0)};
  std::vector<int> opposite;
  connect_quads(quads, int(vertices), opposite);
  for (int h = 0; h < int(opposite.size()); ++h) {
    ++fans.quads[source(quads, h)];
    if (opposite[h] < 0) fans.boundary[source(quads, h)] = fans.boundary[target(quads, h)] = 1;
  }
  return fans;
}

} // namespace

Resolved_mesh Hanging_mesh::finish(const Quad_mesh& before) const {
  Resolved_mesh out;
  out.mesh.points = m_points;
  for (std::size_t f = 0; f < m_quads.size(); ++f) {
    if (m_gone[f]) continue;
    out.mesh.quads.push_back(m_quads[f]);
    out.parent.push_back(m_parent[f]);
  }
  out.templates = templates;
  out.added_edges = m_added_edges;
  std::vector<int> quads_before(m_points.size(), -1);
  for (std::size_t v = 0; v < before.points.size(); ++v) quads_before[v] = 0;
  for (const Quad& q : before.quads)
    for (int v : q) ++quads_before[v];
  for (int v : m_t_junctions) quads_before[v] += 2; // its angle in the coarse quad is straight
  const Fans after = count_fans(out.mesh.quads, m_points.size());
  for (std::size_t v = 0; v < m_points.size(); ++v) {
    const bool changed = after.quads[v] != quads_before[v];
    if (v >= before.points.size() && after.boundary[v]) out.boundary_vertices.push_back(int(v));
    if (changed && after.quads[v] != (after.boundary[v] ? 2 : 4)) out.extraordinary.push_back(int(v));
  }
  return out;
}

namespace {

// The search for the path of least cost from a hanging edge with an odd number of T-junctions.
class Line_search {
public:
  Line_search(const Hanging_mesh& mesh, const T_junction_options& options)
      : m_mesh(mesh), m_options(options) {}

  struct Line {
    double cost = -1; ///< negative: none
    std::vector<Hanging_mesh::Crossing> path;
  };

  Line run(int start) {
    m_start = start;
    m_reached.resize(4 * m_mesh.quads().size(), Reached{0, -1, 0, false});
    ++m_run;
    m_queue = {};
    reach(start, -1, 0);
    while (!m_queue.empty()) {
      const Entry e = m_queue.top();
      m_queue.pop();
      Reached& r = m_reached[e.halfedge];
      if (r.done) continue;
      r.done = true;
      if (e.end) return line(e);
      leave(e);
    }
    return {};
  }

private:
  struct Reached {
    double cost;
    int from; ///< the halfedge by which the quad before was entered
    int run;  ///< of the search: else it is not reached
    bool done;
  };
  // A line that has entered a quad by a halfedge, or ends at one (`end`) having entered its quad by `from`.
  struct Entry {
    double cost;
    bool end;
    int halfedge;
    int from;
    bool operator<(const Entry& other) const {
      return std::tie(other.cost, other.end, other.halfedge) < std::tie(cost, end, halfedge);
    }
  };

  // Whether that is the cheapest way to a halfedge so far.
  bool note(int h, int from, double cost) {
    Reached& r = m_reached[std::size_t(h)];
    if (r.run == m_run && !(cost < r.cost)) return false;
    r = {cost, from, m_run, false};
    return true;
  }

  void reach(int h, int from, double cost) {
    if (note(h, from, cost)) m_queue.push({cost, false, h, from});
  }

  void leave(const Entry& e) {
    if (m_mesh.is_fixed(quad_of(e.halfedge))) return;
    int out = e.halfedge;
    for (int turn = 1; turn < 4; ++turn) {
      out = next(out);
      const double cost = e.cost + (turn == 2 ? 1 : m_options.turn_cost);
      if (const int o = m_mesh.opposite(out); o >= 0) {
        reach(o, e.halfedge, cost);
        continue;
      }
      const auto t = m_mesh.hanging().find({m_mesh.source(out), m_mesh.target(out)});
      if (t != m_mesh.hanging().end()) {
        if (t->second.size() % 2 == 1) end(out, e.halfedge, cost);
      } else if (const Hanging_mesh::Edge* whole = m_mesh.whole(out); whole != nullptr) {
        if (m_mesh.find(*whole) != m_start) end(out, e.halfedge, cost + cost_of_part(*whole));
      } else if (m_options.may_end_on_boundary)
        end(out, e.halfedge, cost);
    }
  }

  // A line that ends between two T-junctions of the coarser side gives it one more: that makes two of one, or
  // an odd number that needs a line of its own.
  double cost_of_part(const Hanging_mesh::Edge& whole) const {
    return (m_mesh.hanging().at(whole).size() % 2 == 1 ? 4 : 8) * m_options.turn_cost;
  }

  void end(int h, int from, double cost) {
    if (note(h, from, cost)) m_queue.push({cost, true, h, from});
  }

  Line line(const Entry& e) {
    Line out;
    out.cost = e.cost;
    int leaving = e.halfedge & 3;
    for (int h = m_reached[e.halfedge].from;;) {
      out.path.push_back({quad_of(h), h & 3, leaving});
      if (h == m_start) break;
      leaving = m_mesh.opposite(h) & 3;
      h = m_reached[h].from;
    }
    std::reverse(out.path.begin(), out.path.end());
    cut_loops(out.path);
    return out;
  }

  // A path of few turns may cross itself: it turns there instead.
  static void cut_loops(std::vector<Hanging_mesh::Crossing>& path) {
    for (std::size_t i = 0; i < path.size(); ++i)
      for (std::size_t j = path.size() - 1; j > i; --j)
        if (path[j].quad == path[i].quad) {
          path[i].out = path[j].out;
          path.erase(path.begin() + std::ptrdiff_t(i) + 1, path.begin() + std::ptrdiff_t(j) + 1);
          break;
        }
  }

  const Hanging_mesh& m_mesh;
  const T_junction_options& m_options;
  int m_start = -1;
  int m_run = 0;
  std::vector<Reached> m_reached; ///< per halfedge
  std::priority_queue<Entry> m_queue;
};

Error no_partner(const Hanging_mesh::Edge& edge) {
  return make_error(Error_code::impossible_request,
                    "a T-junction has neither another one nor the boundary for its line to end",
                    Element_kind::vertex, edge.first);
}

// The odd hanging edges in the order in which their lines are drawn: the shortest first.
Result<std::vector<Hanging_mesh::Edge>>
lines_by_cost(const Hanging_mesh& mesh, const std::vector<Hanging_mesh::Edge>& edges, Line_search& search) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (mesh.hanging().at(edges[i]).size() % 2 == 0) continue;
    const Line_search::Line line = search.run(mesh.find(edges[i]));
    if (line.cost < 0) return no_partner(edges[i]);
    order.push_back({line.cost, i});
  }
  std::sort(order.begin(), order.end());
  std::vector<Hanging_mesh::Edge> out;
  for (const auto& [cost, i] : order) out.push_back(edges[i]);
  return out;
}

} // namespace
} // namespace internal

Result<Resolved_mesh> resolve_t_junctions(const Quad_mesh& mesh, const std::vector<Hanging_edge>& hanging,
                                          const T_junction_options& options) {
  using namespace internal;
  if (!(options.turn_cost >= 0))
    return make_error(Error_code::impossible_request, "the cost of a turn is negative or no number");
  Hanging_mesh work(mesh, options);
  if (Result<void> added = work.add_edges(); !added) return added.error();
  std::vector<Hanging_mesh::Edge> edges;
  for (const Hanging_edge& e : hanging) {
    if (Result<void> added = work.add(e); !added) return added.error();
    if (!e.vertices.empty())
      edges.push_back({mesh.quads[e.quad][e.corner], mesh.quads[e.quad][(e.corner + 1) % 4]});
  }
  Line_search search(work, options);
  const auto order = lines_by_cost(work, edges, search);
  if (!order) return order.error();
  int lines = 0;
  std::vector<Hanging_mesh::Edge> odd = *order;
  const int enough = 2 * int(odd.size()) + 64; // a line joins two, or leaves one where it ends on a part
  while (!odd.empty()) {
    for (const Hanging_mesh::Edge& e : odd) {
      const auto t = work.hanging().find(e);
      if (t == work.hanging().end() || t->second.size() % 2 == 0) continue; // another line ended here
      const Line_search::Line line = search.run(work.find(e));
      if (line.cost < 0 || ++lines > enough) return no_partner(e);
      work.draw_line(line.path);
    }
    odd.clear();
    for (const auto& [edge, vertices] : work.hanging())
      if (vertices.size() % 2 == 1) odd.push_back(edge);
  }
  std::vector<Hanging_mesh::Edge> left;
  for (const auto& [edge, vertices] : work.hanging()) left.push_back(edge);
  for (const Hanging_mesh::Edge& e : left) work.draw_templates(e);
  Resolved_mesh out = work.finish(mesh);
  out.lines = lines;
  return out;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
