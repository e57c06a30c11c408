// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/laplacian.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Below this ratio of height to length a triangle's cotangents are noise of its coordinates' rounding.
constexpr double thinnest = 1e-8;

double cotangent(const Point& u, const Point& v) {
  const double scale = std::sqrt(u.squaredNorm() * v.squaredNorm());
  if (!(scale > 0)) return 0; // an edge of length zero has no angle
  return u.dot(v) / std::max(u.cross(v).norm(), thinnest * scale);
}

} // namespace

Edge_weights cotangent_weights(const Triangle_surface& s) {
  const int halfedges = s.number_of_halfedges();
  std::vector<double> half(halfedges);
  for (int f = 0; f < s.number_of_faces(); ++f) {
    const Triangle& t = s.triangles[f];
    const Point a = s.points[t[1]] - s.points[t[0]], b = s.points[t[2]] - s.points[t[1]],
                c = s.points[t[0]] - s.points[t[2]];
    half[3 * f] = 0.5 * cotangent(-b, c); // the corner opposite halfedge 3 f is the third one
    half[3 * f + 1] = 0.5 * cotangent(-c, a);
    half[3 * f + 2] = 0.5 * cotangent(-a, b);
  }
  Edge_weights weights{std::vector<double>(halfedges)};
  for (int h = 0; h < halfedges; ++h)
    weights.of_halfedge[h] = s.is_boundary(h) ? half[h] : half[h] + half[s.opposite[h]];
  return weights;
}

Edge_weights clamped_cotangent_weights(const Triangle_surface& surface, double low, double high) {
  CGAL_precondition(0 < low && low <= high);
  Edge_weights weights = cotangent_weights(surface);
  for (double& w : weights.of_halfedge) w = std::clamp(w, low, high);
  return weights;
}

Edge_weights uniform_weights(const Triangle_surface& surface) {
  return Edge_weights{std::vector<double>(surface.number_of_halfedges(), 1.0)};
}

namespace {

// The edges ordered by their larger end: walking them in this order appends to every column in increasing
// rows.
std::vector<int> edges_by_larger_end(const Triangle_surface& s) {
  const int halfedges = s.number_of_halfedges();
  std::vector<int> begin(s.number_of_vertices() + 1, 0);
  for (int h = 0; h < halfedges; ++h)
    if (s.edge(h) == h) ++begin[std::max(s.source(h), s.target(h)) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<int> edges(begin.back());
  for (int h = 0; h < halfedges; ++h)
    if (s.edge(h) == h) edges[begin[std::max(s.source(h), s.target(h))]++] = h;
  return edges;
}

} // namespace

Laplace_system assemble(const Triangle_surface& s, const Edge_weights& weights,
                        const std::vector<char>& is_fixed) {
  const int vertices = s.number_of_vertices();
  CGAL_precondition(int(is_fixed.size()) == vertices);
  CGAL_precondition(int(weights.of_halfedge.size()) == s.number_of_halfedges());
  Laplace_system system;
  std::vector<int>& unknown = system.unknown_of_vertex;
  unknown.assign(vertices, -1);
  for (int v = 0; v < vertices; ++v)
    if (!is_fixed[v]) {
      unknown[v] = int(system.vertex_of_unknown.size());
      system.vertex_of_unknown.push_back(v);
    }
  Symmetric_matrix& m = system.matrix;
  m.size = int(system.vertex_of_unknown.size());

  const std::vector<int> edges = edges_by_larger_end(s);
  m.column_begin.assign(m.size + 1, 0);
  for (int j = 0; j < m.size; ++j) m.column_begin[j + 1] = 1;
  for (const int h : edges) {
    const int i = unknown[s.source(h)], j = unknown[s.target(h)];
    if (i >= 0 && j >= 0) ++m.column_begin[std::min(i, j) + 1];
  }
  for (int j = 0; j < m.size; ++j) m.column_begin[j + 1] += m.column_begin[j];
  m.row.resize(m.column_begin[m.size]);
  m.value.assign(m.row.size(), 0.0);
  system.entry_of_halfedge.assign(s.number_of_halfedges(), -1);

  std::vector<int> end(m.column_begin.begin(), m.column_begin.end() - 1);
  for (int j = 0; j < m.size; ++j) m.row[end[j]++] = j;
  for (const int h : edges) {
    const int i = unknown[s.source(h)], j = unknown[s.target(h)];
    const double w = weights.of_halfedge[h];
    if (i >= 0) m.value[m.column_begin[i]] += w;
    if (j >= 0) m.value[m.column_begin[j]] += w;
    if (i < 0 || j < 0) continue;
    const int entry = end[std::min(i, j)]++;
    m.row[entry] = std::max(i, j);
    m.value[entry] = -w;
    system.entry_of_halfedge[h] = entry;
    if (!s.is_boundary(h)) system.entry_of_halfedge[s.opposite[h]] = entry;
  }
  return system;
}

Laplace_system assemble(const Triangle_surface& surface, const Edge_weights& weights) {
  return assemble(surface, weights, std::vector<char>(surface.number_of_vertices(), 0));
}

std::vector<double> right_hand_side(const Triangle_surface& s, const Edge_weights& weights,
                                    const Laplace_system& system, const std::vector<double>& values) {
  CGAL_precondition(int(values.size()) == s.number_of_vertices());
  std::vector<double> b(system.matrix.size, 0.0);
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    if (s.edge(h) != h) continue;
    const int u = s.source(h), v = s.target(h);
    const int i = system.unknown_of_vertex[u], j = system.unknown_of_vertex[v];
    if (i >= 0 && j < 0) b[i] += weights.of_halfedge[h] * values[v];
    if (i < 0 && j >= 0) b[j] += weights.of_halfedge[h] * values[u];
  }
  return b;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
