// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/Surface_editor.h"

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

int next(int h) {
  return Triangle_surface::next(h);
}
int previous(int h) {
  return Triangle_surface::previous(h);
}

// Calls `visit` for each outgoing halfedge of v.
template <class Visit> void for_each_outgoing(const Triangle_surface& s, int v, Visit visit) {
  int h = s.outgoing[v];
  do {
    visit(h);
    h = s.rotate_ccw(h);
  } while (h >= 0 && h != s.outgoing[v]);
}

// The neighbours of v, sorted.
std::vector<int> neighbours(const Triangle_surface& s, int v) {
  std::vector<int> result;
  for_each_outgoing(s, v, [&](int h) {
    result.push_back(s.target(h));
    if (s.opposite[previous(h)] < 0) result.push_back(s.source(previous(h)));
  });
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

void Surface_editor::link(int h, int g) {
  if (h >= 0) m_surface.opposite[h] = g;
  if (g >= 0) m_surface.opposite[g] = h;
}

// Takes the outgoing halfedge h of v, or the boundary one if there is one clockwise from it.
void Surface_editor::fix_outgoing(int v, int h) {
  const int first = h;
  do {
    m_surface.outgoing[v] = h;
    h = m_surface.rotate_cw(h);
  } while (h >= 0 && h != first);
}

int Surface_editor::add_vertex(const Point& p) {
  m_surface.points.push_back(p);
  m_surface.outgoing.push_back(-1);
  return m_surface.number_of_vertices() - 1;
}

int Surface_editor::add_face(const Triangle& t) {
  m_surface.triangles.push_back(t);
  m_surface.opposite.insert(m_surface.opposite.end(), 3, -1);
  return m_surface.number_of_faces() - 1;
}

bool Surface_editor::are_adjacent(int v, int w) const {
  bool found = false;
  for_each_outgoing(m_surface, v, [&](int h) {
    found = found || m_surface.target(h) == w || m_surface.source(previous(h)) == w;
  });
  return found;
}

int Surface_editor::degree(int v) const {
  int count = 0;
  for_each_outgoing(m_surface, v, [&](int) { ++count; });
  return count;
}

bool Surface_editor::can_flip(int h) const {
  const int o = m_surface.opposite[h];
  if (o < 0) return false;
  const int a = m_surface.source(h), b = m_surface.target(h);
  const int c = m_surface.target(next(h)), d = m_surface.target(next(o));
  if (c == d || (is_boundary_vertex(c) && is_boundary_vertex(d))) return false;
  for (int v : {a, b})
    if (degree(v) < (is_boundary_vertex(v) ? 3 : 4)) return false;
  return !are_adjacent(c, d);
}

void Surface_editor::flip(int h) {
  CGAL_precondition(can_flip(h));
  Triangle_surface& s = m_surface;
  const int o = s.opposite[h], f = h / 3, g = o / 3;
  const int a = s.source(h), b = s.target(h), c = s.target(next(h)), d = s.target(next(o));
  const int bc = s.opposite[next(h)], ca = s.opposite[previous(h)];
  const int ad = s.opposite[next(o)], db = s.opposite[previous(o)];
  s.triangles[f] = {d, b, c};
  s.triangles[g] = {c, a, d};
  link(3 * f, db);
  link(3 * f + 1, bc);
  link(3 * g, ca);
  link(3 * g + 1, ad);
  link(3 * f + 2, 3 * g + 2);
  // An outgoing halfedge that was in the two faces is, on the boundary, again the one of the same edge.
  const std::array<std::pair<int, int>, 4> outgoing{{{a, 3 * g + 1}, {b, 3 * f + 1}, {c, 3 * g}, {d, 3 * f}}};
  for (const auto& [v, halfedge] : outgoing)
    if (s.outgoing[v] / 3 == f || s.outgoing[v] / 3 == g) s.outgoing[v] = halfedge;
}

int Surface_editor::split_edge(int h, const Point& p) {
  Triangle_surface& s = m_surface;
  const int o = s.opposite[h], m = add_vertex(p);
  // Shortens halfedge x to end in m, and adds the face beyond m: {m, old target, apex}.
  const auto halve = [&](int x) {
    const int end = s.target(x), apex = s.target(next(x)), beyond = s.opposite[next(x)];
    const int f = add_face({m, end, apex});
    s.triangles[x / 3][next(x) % 3] = m;
    link(3 * f + 1, beyond);
    link(3 * f + 2, next(x));
    if (s.outgoing[end] == next(x)) s.outgoing[end] = 3 * f + 1;
    return 3 * f;
  };
  const int beyond_h = halve(h);
  s.outgoing[m] = beyond_h;
  link(beyond_h, o);
  if (o >= 0) link(halve(o), h);
  return m;
}

int Surface_editor::split_face(int f, const Point& p) {
  Triangle_surface& s = m_surface;
  const int m = add_vertex(p);
  const Triangle t = s.triangles[f];
  const int h1 = s.opposite[3 * f + 1], h2 = s.opposite[3 * f + 2];
  const int f1 = add_face({t[1], t[2], m}), f2 = add_face({t[2], t[0], m});
  s.triangles[f] = {t[0], t[1], m};
  link(3 * f1, h1);
  link(3 * f2, h2);
  link(3 * f + 1, 3 * f1 + 2);
  link(3 * f1 + 1, 3 * f2 + 2);
  link(3 * f2 + 1, 3 * f + 2);
  if (s.outgoing[t[1]] == 3 * f + 1) s.outgoing[t[1]] = 3 * f1;
  if (s.outgoing[t[2]] == 3 * f + 2) s.outgoing[t[2]] = 3 * f2;
  s.outgoing[m] = 3 * f + 2;
  return m;
}

bool Surface_editor::can_collapse(int h) const {
  const Triangle_surface& s = m_surface;
  const int o = s.opposite[h], a = s.source(h), b = s.target(h);
  const bool a_on_boundary = is_boundary_vertex(a);
  if (a_on_boundary && o >= 0) return false;
  for (int x : {h, o}) {
    if (x < 0) continue;
    const int apex = s.target(next(x));
    if (degree(apex) < (is_boundary_vertex(apex) ? 2 : 4)) return false;
    // Both other edges on the boundary: the apex would be cut off.
    if (s.opposite[next(x)] < 0 && s.opposite[previous(x)] < 0) return false;
  }
  std::vector<int> common;
  const std::vector<int> of_a = neighbours(s, a), of_b = neighbours(s, b);
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
  if (common.size() != (o >= 0 ? 2u : 1u)) return false;
  if (a_on_boundary) { // keep at least three edges on the loop
    const int after_b = s.target(s.outgoing[b]);
    return s.target(s.outgoing[after_b]) != a;
  }
  return true;
}

void Surface_editor::collapse(int h) {
  CGAL_precondition(can_collapse(h));
  Triangle_surface& s = m_surface;
  const int a = s.source(h), b = s.target(h);
  std::vector<int> star;
  for_each_outgoing(s, a, [&](int x) { star.push_back(x); });
  for (int x : star) s.triangles[x / 3][x % 3] = b;
  std::vector<int> touched;
  for (int x : {h, s.opposite[h]}) {
    if (x < 0) continue;
    const int p = s.opposite[next(x)], q = s.opposite[previous(x)];
    touched.push_back(p);
    touched.push_back(q);
    link(p, q);
    s.triangles[x / 3] = {-1, -1, -1};
  }
  s.outgoing[a] = -1;
  // Each surviving side of a vanished face gives its two ends an outgoing halfedge that is alive.
  for (int x : touched) {
    if (x < 0) continue;
    fix_outgoing(s.source(x), x);
    fix_outgoing(s.target(x), next(x));
  }
}

std::vector<int> Surface_editor::compact() {
  Triangle_surface& s = m_surface;
  const auto dead = [](const Triangle& t) { return t[0] < 0; };
  s.triangles.erase(std::remove_if(s.triangles.begin(), s.triangles.end(), dead), s.triangles.end());
  std::vector<int> index(s.number_of_vertices(), -1);
  int count = 0;
  for (int v = 0; v < s.number_of_vertices(); ++v) {
    if (s.outgoing[v] < 0) continue;
    index[v] = count;
    s.points[count++] = s.points[v];
  }
  s.points.resize(count);
  for (Triangle& t : s.triangles)
    for (int& v : t) v = index[v];
  const Result<void> connected = s.connect();
  CGAL_assertion(bool(connected));
  CGAL_USE(connected);
  return index;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
