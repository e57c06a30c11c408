// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/halve_surface.h>

#include "base/place.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;

// Islands may have so much of the area: what noise on the plane cuts off.
constexpr double most_islands = 1e-3;

Predicates::Point_3 exact_point(const Point& p) {
  return Predicates::Point_3(p.x(), p.y(), p.z());
}

// 1 where the normal points to, -1 on the other side, 0 on the plane.
int side(const Mirror_plane& plane, const Point& p) {
  const Predicates::Plane_3 direction(plane.normal.x(), plane.normal.y(), plane.normal.z(), 0);
  const auto less = Predicates().less_signed_distance_to_plane_3_object();
  if (less(direction, exact_point(plane.point), exact_point(p))) return 1;
  return less(direction, exact_point(p), exact_point(plane.point)) ? -1 : 0;
}

class Halver {
public:
  Halver(const Triangle_surface& surface, const Mirror_plane& plane)
      : m_whole(surface), m_grid(plane, surface.points) {}

  Result<Surface_half> run() {
    m_half.plane = m_grid.plane();
    if (m_whole.number_of_faces() == 0)
      return make_error(Error_code::not_a_surface, "the surface has no faces");
    classify();
    for (int f = 0; f < m_whole.number_of_faces(); ++f)
      if (Result<void> kept = cut(f); !kept) return kept.error();
    compact();
    if (const auto both = std::minmax_element(m_side.begin(), m_side.end());
        *both.first >= 0 || *both.second <= 0)
      return misses();
    if (Result<void> connected = m_half.surface.connect(); !connected) {
      const Error& error = connected.error();
      return touches(
          error.element == Element_kind::vertex
              ? m_half.surface.points[std::size_t(error.index)]
              : m_half.surface.points[std::size_t(m_half.surface.triangles[std::size_t(error.index)][0])]);
    }
    if (Result<void> one = keep_largest(); !one) return one.error();
    find_arcs();
    if (Result<void> fine = check_kind(); !fine) return fine.error();
    return std::move(m_half);
  }

private:
  void classify() {
    Point low = m_whole.points[std::size_t(m_whole.triangles[0][0])], high = low;
    for (const Triangle& t : m_whole.triangles)
      for (int v : t) {
        low = low.cwiseMin(m_whole.points[std::size_t(v)]);
        high = high.cwiseMax(m_whole.points[std::size_t(v)]);
      }
    m_near = plane_tolerance * (high - low).norm();
    m_side.assign(m_whole.points.size(), 0);
    m_half.surface.points = m_whole.points;
    for (std::size_t v = 0; v < m_side.size(); ++v) {
      if (m_whole.outgoing[v] < 0) continue;
      Point& p = m_half.surface.points[v];
      if (std::abs(m_half.plane.signed_distance(p)) <= m_near)
        p = m_half.plane.projected(p);
      else
        m_side[v] = side(m_half.plane, p);
    }
    m_vertex_of_edge.assign(m_whole.opposite.size(), -1);
    m_is_on_plane.assign(m_side.size(), 0);
    for (std::size_t v = 0; v < m_side.size(); ++v) m_is_on_plane[v] = m_side[v] == 0;
  }

  // The vertex on an edge that crosses, the same from both sides.
  int crossing(int h) {
    int& vertex = m_vertex_of_edge[std::size_t(m_whole.edge(h))];
    if (vertex >= 0) return vertex;
    int a = m_whole.source(h), b = m_whole.target(h);
    if (m_side[std::size_t(a)] < 0) std::swap(a, b);
    const Point &p = m_half.surface.points[std::size_t(a)], &q = m_half.surface.points[std::size_t(b)];
    const double above = std::max(0.0, m_half.plane.signed_distance(p)),
                 below = std::max(0.0, -m_half.plane.signed_distance(q));
    const double t = above + below > 0 ? above / (above + below) : 0.5;
    const Point on = m_half.plane.projected(p + t * (q - p));
    vertex = m_half.surface.number_of_vertices();
    m_half.surface.points.push_back(on);
    m_is_on_plane.push_back(1);
    return vertex;
  }

  // Appends what a face has on the kept side, a polygon of three or four corners, as triangles.
  Result<void> cut(int f) {
    const Triangle& t = m_whole.triangles[std::size_t(f)];
    int above = 0, below = 0;
    for (int v : t) {
      above += m_side[std::size_t(v)] > 0;
      below += m_side[std::size_t(v)] < 0;
    }
    if (above == 0 && below == 0) return touches(m_whole.points[std::size_t(t[0])]);
    if (above == 0) return {};
    std::vector<int> polygon;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int from = m_side[std::size_t(m_whole.source(h))], to = m_side[std::size_t(m_whole.target(h))];
      if (from >= 0) polygon.push_back(m_whole.source(h));
      if (from * to < 0) polygon.push_back(crossing(h));
    }
    std::vector<Triangle>& out = m_half.surface.triangles;
    if (polygon.size() == 3) {
      out.push_back({polygon[0], polygon[1], polygon[2]});
      return {};
    }
    const std::vector<Point>& p = m_half.surface.points;
    const auto length = [&](std::size_t i) {
      return (p[std::size_t(polygon[i])] - p[std::size_t(polygon[i + 2])]).squaredNorm();
    };
    const std::size_t i = length(1) < length(0) ? 1 : 0; // the shorter diagonal
    out.push_back({polygon[i], polygon[i + 1], polygon[i + 2]});
    out.push_back({polygon[i + 2], polygon[(i + 3) % 4], polygon[i]});
    return {};
  }

  // Leaves out vertices without a face.
  void compact() {
    Triangle_surface& s = m_half.surface;
    std::vector<int> index(s.points.size(), -1);
    for (const Triangle& t : s.triangles)
      for (int v : t) index[std::size_t(v)] = 0;
    int number = 0;
    for (std::size_t v = 0; v < index.size(); ++v) {
      if (index[v] < 0) continue;
      s.points[std::size_t(number)] = s.points[v];
      m_is_on_plane[std::size_t(number)] = m_is_on_plane[v];
      index[v] = number++;
    }
    s.points.resize(std::size_t(number));
    m_is_on_plane.resize(std::size_t(number));
    for (Triangle& t : s.triangles)
      for (int& v : t) v = index[std::size_t(v)];
  }

  Result<void> keep_largest() {
    Triangle_surface& s = m_half.surface;
    const auto [component, number] = connected_components(s);
    if (number == 1) return {};
    std::vector<double> areas(std::size_t(number), 0);
    for (int f = 0; f < s.number_of_faces(); ++f) areas[std::size_t(component[std::size_t(f)])] += area(s, f);
    const int largest = int(std::max_element(areas.begin(), areas.end()) - areas.begin());
    double all = 0;
    for (double a : areas) all += a;
    m_half.dropped_area = all - areas[std::size_t(largest)];
    if (m_half.dropped_area > most_islands * all)
      return make_error(Error_code::impossible_request, "the plane of the mirror, " + to_text(m_half.plane) +
                                                            ", leaves " + std::to_string(number) +
                                                            " pieces on one side: a half has one");
    std::vector<Triangle> kept;
    for (int f = 0; f < s.number_of_faces(); ++f)
      if (component[std::size_t(f)] == largest) kept.push_back(s.triangles[std::size_t(f)]);
    s.triangles = std::move(kept);
    compact();
    return s.connect();
  }

  // Boundary edges that the cut has made; an edge that was boundary before and lies on the plane has no other
  // side to be glued to.
  void find_arcs() {
    const Triangle_surface& s = m_half.surface;
    std::vector<std::array<Point, 2>> own;
    for (int h = 0; h < m_whole.number_of_halfedges(); ++h) {
      const std::size_t a = std::size_t(m_whole.source(h)), b = std::size_t(m_whole.target(h));
      if (m_whole.is_boundary(h) && m_side[a] == 0 && m_side[b] == 0)
        own.push_back({m_half.plane.projected(m_whole.points[a]), m_half.plane.projected(m_whole.points[b])});
    }
    m_half.on_plane.assign(s.opposite.size(), 0);
    for (int h = 0; h < s.number_of_halfedges(); ++h) {
      const std::size_t a = std::size_t(s.source(h)), b = std::size_t(s.target(h));
      if (!s.is_boundary(h) || !m_is_on_plane[a] || !m_is_on_plane[b]) continue;
      const std::array<Point, 2> ends{s.points[a], s.points[b]};
      m_half.on_plane[std::size_t(h)] = std::find(own.begin(), own.end(), ends) == own.end();
    }
    for (const std::vector<int>& loop : boundary_loops(s)) {
      int ends = 0, cut_edges = 0;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const char now = m_half.on_plane[std::size_t(loop[i])];
        cut_edges += now;
        ends += now && !m_half.on_plane[std::size_t(loop[(i + 1) % loop.size()])];
      }
      m_half.curves += cut_edges == int(loop.size());
      m_half.arcs += ends;
    }
  }

  Result<void> check_kind() const {
    if (m_half.curves + m_half.arcs == 0) return misses();
    const int whole = euler_characteristic(m_whole), half = euler_characteristic(m_half.surface);
    if (2 * half - m_half.arcs == whole) return {};
    return make_error(Error_code::impossible_request,
                      "the two sides of the mirror's plane, " + to_text(m_half.plane) +
                          ", are not alike: the surface has the Euler characteristic " +
                          std::to_string(whole) + ", twice one side would have " +
                          std::to_string(2 * half - m_half.arcs));
  }

  Error misses() const {
    double nearest = std::numeric_limits<double>::infinity();
    Point at = Point::Zero();
    for (std::size_t v = 0; v < m_side.size(); ++v) {
      const double d = std::abs(m_half.plane.signed_distance(m_whole.points[v]));
      if (m_whole.outgoing[v] < 0 || d >= nearest) continue;
      nearest = d;
      at = m_whole.points[v];
    }
    return make_error(Error_code::impossible_request, "the plane of the mirror, " + to_text(m_half.plane) +
                                                          ", does not cut the surface; it comes nearest at " +
                                                          place(at));
  }

  Error touches(const Point& at) const {
    return make_error(Error_code::impossible_request, "the plane of the mirror, " + to_text(m_half.plane) +
                                                          ", touches the surface without crossing it at " +
                                                          place(at));
  }

  const Triangle_surface& m_whole;
  Mirror_grid m_grid;
  Surface_half m_half;
  double m_near = 0;
  std::vector<int> m_side;           ///< of each vertex of the whole
  std::vector<char> m_is_on_plane;   ///< of each vertex of the half
  std::vector<int> m_vertex_of_edge; ///< by the edge's first halfedge
};

} // namespace

Result<Surface_half> halve_surface(const Triangle_surface& surface, const Mirror_plane& plane) {
  return Halver(surface, plane).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
