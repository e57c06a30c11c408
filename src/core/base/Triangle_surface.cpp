// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Pairs halfedges by bucketing them on their smaller vertex: linear, and independent of any hash order.
Result<void> pair_halfedges(Triangle_surface& surface) {
  const int nv = surface.number_of_vertices(), nh = surface.number_of_halfedges();
  std::vector<int> begin(nv + 1, 0), bucket(nh);
  for (int h = 0; h < nh; ++h) ++begin[std::min(surface.source(h), surface.target(h)) + 1];
  for (int v = 0; v < nv; ++v) begin[v + 1] += begin[v];
  std::vector<int> end(begin.begin(), begin.end() - 1);
  for (int h = 0; h < nh; ++h) bucket[end[std::min(surface.source(h), surface.target(h))]++] = h;
  surface.opposite.assign(nh, -1);
  // first[o] is the halfedge that last opened the edge {v, o}; it is of this v only if it lies in this
  // bucket.
  std::vector<int> first(nv, -1), owner(nv, -1);
  for (int v = 0; v < nv; ++v)
    for (int i = begin[v]; i < begin[v + 1]; ++i) {
      const int h = bucket[i], other = std::max(surface.source(h), surface.target(h));
      if (owner[other] != v) {
        owner[other] = v;
        first[other] = h;
        continue;
      }
      const int g = first[other];
      if (surface.source(g) == surface.source(h))
        return make_error(Error_code::not_a_surface, "two faces use an edge in the same direction",
                          Element_kind::face, h / 3);
      if (surface.opposite[g] >= 0)
        return make_error(Error_code::not_a_surface, "an edge has more than two faces", Element_kind::face,
                          h / 3);
      surface.opposite[g] = h;
      surface.opposite[h] = g;
    }
  return {};
}

} // namespace

Result<void> Triangle_surface::connect() {
  for (int f = 0; f < number_of_faces(); ++f) {
    const Triangle& t = triangles[f];
    for (int v : t)
      if (v < 0 || v >= number_of_vertices())
        return make_error(Error_code::not_a_surface, "a face names a vertex that does not exist",
                          Element_kind::face, f);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return make_error(Error_code::not_a_surface, "a face names a vertex twice", Element_kind::face, f);
  }
  if (Result<void> paired = pair_halfedges(*this); !paired) return paired;

  outgoing.assign(number_of_vertices(), -1);
  std::vector<int> degree(number_of_vertices(), 0);
  for (int h = 0; h < number_of_halfedges(); ++h) {
    const int v = source(h);
    ++degree[v];
    if (outgoing[v] < 0 || opposite[h] < 0) outgoing[v] = h;
  }
  for (int v = 0; v < number_of_vertices(); ++v) {
    if (outgoing[v] < 0) continue;
    int h = outgoing[v], fan = 0;
    do {
      ++fan;
      h = rotate_ccw(h);
    } while (h >= 0 && h != outgoing[v] && fan <= degree[v]);
    if (fan != degree[v])
      return make_error(Error_code::not_a_surface, "the faces at a vertex are not one fan",
                        Element_kind::vertex, v);
  }
  return {};
}

int euler_characteristic(const Triangle_surface& surface) {
  int vertices = 0, edges = 0;
  for (int h : surface.outgoing) vertices += h >= 0;
  for (int h = 0; h < surface.number_of_halfedges(); ++h) edges += surface.edge(h) == h;
  return vertices - edges + surface.number_of_faces();
}

std::vector<std::vector<int>> boundary_loops(const Triangle_surface& surface) {
  std::vector<std::vector<int>> loops;
  std::vector<char> seen(surface.number_of_halfedges(), 0);
  for (int first = 0; first < surface.number_of_halfedges(); ++first) {
    if (!surface.is_boundary(first) || seen[first]) continue;
    loops.emplace_back();
    for (int h = first; !seen[h]; h = surface.outgoing[surface.target(h)]) {
      seen[h] = 1;
      loops.back().push_back(h);
    }
  }
  return loops;
}

std::pair<std::vector<int>, int> connected_components(const Triangle_surface& surface) {
  std::vector<int> component(surface.number_of_faces(), -1), stack;
  int count = 0;
  for (int first = 0; first < surface.number_of_faces(); ++first) {
    if (component[first] >= 0) continue;
    component[first] = count;
    stack.push_back(first);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const int o = surface.opposite[3 * f + i];
        if (o < 0 || component[o / 3] >= 0) continue;
        component[o / 3] = count;
        stack.push_back(o / 3);
      }
    }
    ++count;
  }
  return {std::move(component), count};
}

double area(const Triangle_surface& s, int face) {
  const Triangle& t = s.triangles[face];
  return 0.5 * (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]).norm();
}

double area(const Triangle_surface& surface) {
  double sum = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f) sum += area(surface, f);
  return sum;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
