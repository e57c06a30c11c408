// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/topology.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

// Disjoint sets whose representative is the smallest member.
class Disjoint_sets {
public:
  explicit Disjoint_sets(int n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), 0); }
  int find(int x) {
    while (m_parent[x] != x) {
      m_parent[x] = m_parent[m_parent[x]];
      x = m_parent[x];
    }
    return x;
  }
  void unite(int x, int y) {
    x = find(x);
    y = find(y);
    if (x < y)
      m_parent[y] = x;
    else
      m_parent[x] = y;
  }

private:
  std::vector<int> m_parent;
};

// One side of one face, filed under the smaller vertex of its edge.
struct Side {
  int other;  // the greater vertex
  int corner; // arity * face + i; the side runs from corner i to corner i + 1
  bool operator<(const Side& side) const {
    return std::tie(other, corner) < std::tie(side.other, side.corner);
  }
};

template <class Face> class Analysis {
public:
  Analysis(const std::vector<Face>& faces, int number_of_vertices, Fans fans)
      : m_faces(faces), m_nv(number_of_vertices), m_fans(fans), m_pieces(number_of_vertices),
        m_corners(fans == Fans::unknown ? arity * int(faces.size()) : 0) {}

  Soup_topology run() {
    find_usable_faces();
    if (arity == 4) find_duplicates();
    file_sides();
    m_result.valence.assign(m_nv, 0);
    m_result.on_boundary.assign(m_nv, 0);
    for (int v = 0; v < m_nv; ++v) visit_edges_at(v);
    if (m_fans == Fans::unknown) find_fans();
    find_components();
    count_loops();
    return std::move(m_result);
  }

private:
  static constexpr int arity = int(std::tuple_size<Face>::value);

  int vertex(int corner) const { return m_faces[corner / arity][corner % arity]; }
  static int after(int corner) { return corner % arity == arity - 1 ? corner - arity + 1 : corner + 1; }

  void find_usable_faces() {
    m_result.usable.assign(m_faces.size(), 1);
    for (int f = 0; f < int(m_faces.size()); ++f) {
      const Face& face = m_faces[f];
      const bool in_range = std::all_of(face.begin(), face.end(), [&](int v) { return v >= 0 && v < m_nv; });
      bool repeated = false;
      for (int i = 1; i < arity; ++i)
        repeated |= std::find(face.begin(), face.begin() + i, face[i]) != face.begin() + i;
      if (!in_range)
        m_result.bad_indices.note(f);
      else if (repeated)
        m_result.repeated_vertices.note(f);
      m_result.usable[f] = in_range && !repeated;
    }
  }

  void find_duplicates() {
    std::vector<std::pair<Face, int>> sorted;
    sorted.reserve(m_faces.size());
    for (int f = 0; f < int(m_faces.size()); ++f)
      if (m_result.usable[f]) {
        sorted.emplace_back(m_faces[f], f);
        std::sort(sorted.back().first.begin(), sorted.back().first.end());
      }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 1, first = 0; i < sorted.size(); ++i) {
      if (sorted[i].first != sorted[first].first) {
        first = i;
        continue;
      }
      m_result.duplicates.note(sorted[i].second, sorted[first].second);
      m_result.usable[sorted[i].second] = 0;
    }
  }

  // Files every side under the smaller vertex of its edge, by counting.
  void file_sides() {
    m_begin.assign(m_nv + 1, 0);
    const auto for_sides = [&](auto&& visit) {
      for (int f = 0; f < int(m_faces.size()); ++f)
        for (int c = arity * f; m_result.usable[f] && c < arity * f + arity; ++c) {
          const int a = vertex(c), b = vertex(after(c));
          visit(std::min(a, b), Side{std::max(a, b), c});
        }
    };
    for_sides([&](int v, const Side&) { ++m_begin[v + 1]; });
    for (int v = 0; v < m_nv; ++v) m_begin[v + 1] += m_begin[v];
    m_sides.resize(m_begin[m_nv]);
    std::vector<int> end(m_begin.begin(), m_begin.end() - 1);
    for_sides([&](int v, const Side& side) { m_sides[end[v]++] = side; });
  }

  // The edges from v to greater vertices are the runs of equal `other` among the sorted sides of v.
  void visit_edges_at(int v) {
    std::sort(m_sides.begin() + m_begin[v], m_sides.begin() + m_begin[v + 1]);
    for (int first = m_begin[v], last; first < m_begin[v + 1]; first = last) {
      for (last = first + 1; last < m_begin[v + 1] && m_sides[last].other == m_sides[first].other;) ++last;
      visit_edge(v, m_sides.data() + first, last - first);
    }
  }

  void visit_edge(int v, const Side* sides, int count) {
    const int w = sides[0].other;
    ++m_result.edges;
    ++m_result.valence[v];
    ++m_result.valence[w];
    m_pieces.unite(v, w);
    if (count == 1) {
      m_result.on_boundary[v] = m_result.on_boundary[w] = 1;
      m_boundary_sides.push_back(sides[0].corner);
    }
    if (count > 2) m_result.crowded_edges.note(v, w);
    if (count == 2 && vertex(sides[0].corner) == vertex(sides[1].corner))
      m_result.misdirected_edges.note(v, w);
    if (m_fans == Fans::unknown)
      for (int i = 1; i < count; ++i) {
        m_corners.unite(corner_at(sides[0].corner, v), corner_at(sides[i].corner, v));
        m_corners.unite(corner_at(sides[0].corner, w), corner_at(sides[i].corner, w));
      }
  }

  int corner_at(int side, int v) const { return vertex(side) == v ? side : after(side); }

  void find_fans() {
    std::vector<int> fan(m_nv, -1);
    std::vector<char> reported(m_nv, 0);
    for (int c = 0; c < arity * int(m_faces.size()); ++c) {
      if (!m_result.usable[c / arity]) continue;
      const int v = vertex(c), root = m_corners.find(c);
      if (fan[v] < 0) fan[v] = root;
      if (fan[v] == root || reported[v]) continue;
      reported[v] = 1;
      m_result.several_fans.note(v);
    }
  }

  void find_components() {
    m_result.component.assign(m_nv, -1);
    for (int v = 0; v < m_nv; ++v) {
      if (m_result.valence[v] == 0) {
        m_result.unreferenced.note(v);
        continue;
      }
      const int root = m_pieces.find(v); // the smallest vertex of the piece, so it was numbered before
      if (root == v) {
        m_result.component[v] = int(m_result.components.size());
        m_result.components.emplace_back();
      }
      m_result.component[v] = m_result.component[root];
      ++m_result.components[m_result.component[v]].vertices;
    }
    for (int f = 0; f < int(m_faces.size()); ++f)
      if (m_result.usable[f]) {
        ++m_result.faces;
        ++m_result.components[m_result.component[m_faces[f][0]]].faces;
      }
    for (int v = 0; v < m_nv; ++v)
      for (int i = m_begin[v]; i < m_begin[v + 1]; ++i)
        if (i == m_begin[v] || m_sides[i].other != m_sides[i - 1].other)
          ++m_result.components[m_result.component[v]].edges;
  }

  // Boundary sides follow each other where they end in the same fan of the same vertex.
  void count_loops() {
    const int n = int(m_boundary_sides.size());
    Disjoint_sets loops(n);
    std::vector<int> last(m_fans == Fans::unknown ? arity * int(m_faces.size()) : m_nv, -1);
    for (int i = 0; i < n; ++i)
      for (int corner : {m_boundary_sides[i], after(m_boundary_sides[i])}) {
        int& partner = last[m_fans == Fans::unknown ? m_corners.find(corner) : vertex(corner)];
        if (partner >= 0) loops.unite(partner, i);
        partner = i;
      }
    for (int i = 0; i < n; ++i)
      if (loops.find(i) == i)
        ++m_result.components[m_result.component[vertex(m_boundary_sides[i])]].boundary_loops;
  }

  const std::vector<Face>& m_faces;
  int m_nv;
  Fans m_fans;
  Disjoint_sets m_pieces;  // of vertices
  Disjoint_sets m_corners; // of corners around a vertex
  std::vector<int> m_begin;
  std::vector<Side> m_sides;
  std::vector<int> m_boundary_sides;
  Soup_topology m_result;
};

} // namespace

int Soup_topology::boundary_loops() const {
  int n = 0;
  for (const Component_counts& c : components) n += c.boundary_loops;
  return n;
}

int Soup_topology::euler_characteristic() const {
  int n = 0;
  for (const Component_counts& c : components) n += c.euler_characteristic();
  return n;
}

template <class Face>
Soup_topology analyse(const std::vector<Face>& faces, int number_of_vertices, Fans fans) {
  return Analysis<Face>(faces, number_of_vertices, fans).run();
}

template Soup_topology analyse(const std::vector<Triangle>&, int, Fans);
template Soup_topology analyse(const std::vector<Quad>&, int, Fans);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
