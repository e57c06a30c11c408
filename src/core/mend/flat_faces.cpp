// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/flat_faces.h"

#include "mend/corners.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

class Flat_face_remover {
public:
  explicit Flat_face_remover(Mended_component& component)
      : m_component(component), m_surface(component.surface) {}

  Flat_face_counts run() {
    for (int f = 0; f < m_surface.number_of_faces(); ++f)
      if (is_flat(f)) m_work.push_back(f);
    if (m_work.empty()) return {};
    // A flip may make another flat face, and then another; the budget ends what does not come to an end.
    const std::size_t budget = 10 * m_work.size() + 100;
    // Stars are walked round again and again; at a vertex with very many faces that would not end either.
    const std::size_t steps = 10 * std::size_t(m_surface.number_of_halfedges()) + 1000;
    for (std::size_t i = 0; i < m_work.size() && i < budget && m_steps < steps; ++i)
      if (is_flat(m_work[i])) treat(m_work[i]);
    compact();
    return m_counts;
  }

private:
  bool is_removed(int f) const { return m_surface.triangles[f][0] < 0; }
  const Point& corner(int f, int i) const { return m_surface.points[m_surface.triangles[f][i]]; }
  bool is_flat(int f) const {
    return !is_removed(f) && are_collinear(corner(f, 0), corner(f, 1), corner(f, 2));
  }

  void treat(int f) {
    int longest = 3 * f;
    double length = -1;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const double l = (point(m_surface.target(h)) - point(m_surface.source(h))).squaredNorm();
      if (point(m_surface.target(h)) == point(m_surface.source(h)) && collapse(h)) return;
      if (l > length) longest = h;
      length = std::max(length, l);
    }
    if (length == 0) return;
    if (m_surface.is_boundary(longest))
      remove_cap(longest);
    else
      flip(longest);
  }

  const Point& point(int v) const { return m_surface.points[v]; }

  /// The halfedges from `source(h)`, found by turning round both ways.
  std::vector<int> outgoing(int h) const {
    std::vector<int> all;
    int g = h;
    for (; g >= 0; g = m_surface.rotate_ccw(g)) {
      all.push_back(g);
      ++m_steps;
      if (m_surface.rotate_ccw(g) == h) return all;
    }
    for (g = m_surface.rotate_cw(h); g >= 0; g = m_surface.rotate_cw(g)) all.push_back(g);
    return all;
  }

  /// Whether the source of `h` is an inner vertex with three faces.
  bool has_three_faces(int h) const {
    int g = h;
    for (int turn = 0; turn < 3 && g >= 0; ++turn) g = m_surface.rotate_ccw(g);
    return g == h;
  }

  bool at_boundary(const std::vector<int>& star) const {
    return std::any_of(star.begin(), star.end(), [&](int g) { return m_surface.opposite[g] < 0; });
  }

  std::vector<int> neighbours(const std::vector<int>& star) const {
    std::vector<int> all;
    for (int g : star) {
      all.push_back(m_surface.target(g));
      all.push_back(m_surface.source(Triangle_surface::previous(g)));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  // The link condition: the ends have no common neighbours but the corners opposite to the edge.
  bool can_collapse(int h, const std::vector<int>& at_source, const std::vector<int>& at_target) const {
    const int o = m_surface.opposite[h];
    if (o >= 0 && at_boundary(at_source) && at_boundary(at_target)) return false;
    std::vector<int> common;
    const std::vector<int> a = neighbours(at_source), b = neighbours(at_target);
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    if (common.size() != (o < 0 ? 1u : 2u)) return false;
    for (int g : {h, o}) {
      if (g < 0) continue;
      const int n = Triangle_surface::next(g), p = Triangle_surface::previous(g);
      if (m_surface.is_boundary(n) && m_surface.is_boundary(p)) return false;
      if (has_three_faces(p)) return false;
    }
    return true;
  }

  bool collapse(int h) {
    const int u = m_surface.source(h);
    const std::vector<int> at_source = outgoing(h), at_target = outgoing(Triangle_surface::next(h));
    if (!can_collapse(h, at_source, at_target)) return false;
    for (int g : at_target) m_surface.triangles[g / 3][g % 3] = u;
    for (int g : {h, m_surface.opposite[h]}) {
      if (g < 0) continue;
      const int a = m_surface.opposite[Triangle_surface::next(g)],
                b = m_surface.opposite[Triangle_surface::previous(g)];
      if (a >= 0) m_surface.opposite[a] = b;
      if (b >= 0) m_surface.opposite[b] = a;
    }
    for (int g : {h, m_surface.opposite[h]})
      if (g >= 0) m_surface.triangles[g / 3] = {-1, -1, -1};
    ++m_counts.collapsed;
    return true;
  }

  // A cap whose long edge h lies on the boundary. Its tip must not touch the boundary elsewhere.
  void remove_cap(int h) {
    const int n = Triangle_surface::next(h), p = Triangle_surface::previous(h);
    const int rim = int(m_surface.is_boundary(n)) + int(m_surface.is_boundary(p));
    if (rim == 2 || (rim == 0 && at_boundary(outgoing(p)))) return;
    for (int g : {n, p})
      if (m_surface.opposite[g] >= 0) m_surface.opposite[m_surface.opposite[g]] = -1;
    m_surface.triangles[h / 3] = {-1, -1, -1};
    ++m_counts.removed;
  }

  // The tip c of the cap (a, b, c) lies on the edge from a to b; joined with d beyond it, it cuts (b, a, d)
  // in two.
  void flip(int h) {
    const int o = m_surface.opposite[h], f = h / 3, g = o / 3;
    const int n = Triangle_surface::next(h), p = Triangle_surface::previous(h);
    const int on = Triangle_surface::next(o), op = Triangle_surface::previous(o);
    const int a = m_surface.source(h), b = m_surface.target(h), c = m_surface.source(p),
              d = m_surface.source(op);
    const std::vector<int> around = neighbours(outgoing(p));
    if (c == d || std::binary_search(around.begin(), around.end(), d)) return;
    const int bc = m_surface.opposite[n], ca = m_surface.opposite[p];
    const int ad = m_surface.opposite[on], db = m_surface.opposite[op];
    m_surface.triangles[f] = {a, d, c};
    m_surface.triangles[g] = {d, b, c};
    pair(3 * f, ad);
    pair(3 * f + 1, 3 * g + 2);
    pair(3 * f + 2, ca);
    pair(3 * g, db);
    pair(3 * g + 1, bc);
    ++m_counts.flipped;
    for (int changed : {f, g})
      if (is_flat(changed)) m_work.push_back(changed);
  }

  void pair(int h, int o) {
    m_surface.opposite[h] = o;
    if (o >= 0) m_surface.opposite[o] = h;
  }

  void compact() {
    std::vector<int> number(m_surface.points.size(), -1);
    int faces = 0, vertices = 0;
    for (int f = 0; f < m_surface.number_of_faces(); ++f) {
      if (is_removed(f)) continue;
      m_counts.kept += is_flat(f);
      for (int v : m_surface.triangles[f]) number[v] = 0;
      m_surface.triangles[faces] = m_surface.triangles[f];
      m_component.face_of_triangle[faces++] = m_component.face_of_triangle[f];
    }
    m_surface.triangles.resize(faces);
    m_component.face_of_triangle.resize(faces);
    for (int v = 0; v < m_surface.number_of_vertices(); ++v) {
      if (number[v] < 0) continue;
      number[v] = vertices;
      m_surface.points[vertices] = Point(m_surface.points[v]);
      m_component.point_of_vertex[vertices++] = m_component.point_of_vertex[v];
    }
    m_surface.points.resize(vertices);
    m_component.point_of_vertex.resize(vertices);
    for (Triangle& t : m_surface.triangles)
      for (int& v : t) v = number[v];
  }

  Mended_component& m_component;
  Triangle_surface& m_surface;
  std::vector<int> m_work;
  Flat_face_counts m_counts;
  mutable std::size_t m_steps = 0;
};

} // namespace

Flat_face_counts remove_flat_faces(Mended_component& component) {
  return Flat_face_remover(component).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
