// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/loops.h"

#include "base/equal_points.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A set of edges; only asked for membership, so that its order does not matter.
class Edge_set {
public:
  explicit Edge_set(std::size_t expected) {
    std::size_t slots = 16;
    while (slots < 2 * expected) slots *= 2;
    m_slots.assign(slots, 0);
  }
  bool contains(int a, int b) const { return m_slots[slot(key(a, b))] != 0; }
  void insert(int a, int b) {
    const std::uint64_t k = key(a, b);
    const std::size_t s = slot(k);
    if (m_slots[s] == 0) ++m_size;
    m_slots[s] = k;
    if (2 * m_size > m_slots.size()) grow();
  }

private:
  static std::uint64_t key(int a, int b) { // never 0
    return std::uint64_t(std::min(a, b)) << 32 | (std::uint64_t(std::max(a, b)) + 1);
  }
  std::size_t slot(std::uint64_t k) const {
    std::uint64_t x = (k ^ (k >> 32)) * 0xd6e8feb86659fd93u;
    x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
    std::size_t s = (x ^ (x >> 32)) & (m_slots.size() - 1);
    while (m_slots[s] != 0 && m_slots[s] != k) s = (s + 1) & (m_slots.size() - 1);
    return s;
  }
  void grow() {
    std::vector<std::uint64_t> old(2 * m_slots.size(), 0);
    old.swap(m_slots);
    for (std::uint64_t k : old)
      if (k != 0) m_slots[slot(k)] = k;
  }

  std::vector<std::uint64_t> m_slots;
  std::size_t m_size = 0;
};

double cost(const Point& a, const Point& b, const Point& c) {
  const double area = (b - a).cross(c - a).norm() / 2;
  return area + 0.01 * ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
}

} // namespace

bool triangulate_loop(const std::vector<Point>& loop, const std::function<bool(int, int)>& allowed,
                      std::vector<Triangle>& triangles) {
  const int n = int(loop.size());
  const double impossible = std::numeric_limits<double>::infinity();
  // least[i n + j]: of the part between i and j, closed by the diagonal; middle: its triangle's third corner.
  std::vector<double> least(std::size_t(n) * n, 0);
  std::vector<int> middle(std::size_t(n) * n, -1);
  for (int length = 2; length < n; ++length)
    for (int i = 0; i + length < n; ++i) {
      const int j = i + length;
      double& best = least[std::size_t(i) * n + j];
      best = impossible;
      if (length < n - 1 && !allowed(i, j)) continue;
      for (int k = i + 1; k < j; ++k) {
        const double parts = least[std::size_t(i) * n + k] + least[std::size_t(k) * n + j];
        if (parts == impossible) continue;
        const double sum = parts + cost(loop[i], loop[k], loop[j]);
        // Equal costs differ by rounding only; the first one stays, wherever the loop lies and however large
        // it is.
        if (!(sum < best - 1e-9 * std::abs(best)) && best != impossible) continue;
        best = sum;
        middle[std::size_t(i) * n + j] = k;
      }
    }
  if (n < 3 || middle[std::size_t(n) - 1] < 0) return false;
  std::vector<std::pair<int, int>> stack = {{0, n - 1}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const int k = middle[std::size_t(i) * n + j];
    triangles.push_back({i, k, j});
    if (j - k > 1) stack.emplace_back(k, j);
    if (k - i > 1) stack.emplace_back(i, k);
  }
  return true;
}

namespace {

class Polygon_triangulator {
public:
  Polygon_triangulator(const Polygon_soup& soup, std::vector<Point>& points)
      : m_soup(soup), m_points(points), m_edges(0) {}

  Triangulated_polygons run() {
    m_result.triangles.reserve(m_soup.begin.size());
    m_result.face_of_triangle.reserve(m_soup.begin.size());
    collect_edges();
    find_twins();
    for (int f = 0; f < m_soup.number_of_polygons(); ++f) {
      clean_corners(f);
      if (m_corners.size() < 3)
        ++m_result.dropped;
      else if (m_corners.size() == 3)
        add(f, m_corners[0], m_corners[1], m_corners[2]);
      else
        triangulate(f);
    }
    return std::move(m_result);
  }

private:
  void collect_edges() {
    int large = 0;
    for (int f = 0; f < m_soup.number_of_polygons(); ++f) large = std::max(large, m_soup.size_of_polygon(f));
    if (large <= 3) return;
    m_edges = Edge_set(m_soup.corner.size() / 2);
    for (int f = 0; f < m_soup.number_of_polygons(); ++f)
      for (int c = m_soup.begin[f]; c < m_soup.begin[f + 1]; ++c)
        m_edges.insert(m_soup.corner[c],
                       m_soup.corner[c + 1 < m_soup.begin[f + 1] ? c + 1 : m_soup.begin[f]]);
  }

  // Polygons of more than three corners at the same places, in any order: the back of a panel is divided as
  // its front is.
  void find_twins() {
    m_twin_of.assign(std::size_t(m_soup.number_of_polygons()), -1);
    bool any = false;
    for (int f = 0; f < m_soup.number_of_polygons() && !any; ++f) any = m_soup.size_of_polygon(f) > 3;
    if (!any) return;
    m_place = first_equal_points(m_soup.points);
    std::vector<std::pair<std::uint64_t, int>> keys;
    for (int f = 0; f < m_soup.number_of_polygons(); ++f) {
      if (m_soup.size_of_polygon(f) <= 3 || m_soup.size_of_polygon(f) > largest_polygon) continue;
      std::uint64_t key = 0; // does not depend on the order of the corners
      for (int c = m_soup.begin[f]; c < m_soup.begin[f + 1]; ++c) {
        const std::uint64_t x = (std::uint64_t(m_place[m_soup.corner[c]]) + 1) * 0xd6e8feb86659fd93u;
        key += (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
      }
      keys.emplace_back(key, f);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1, first = 0; i < keys.size(); ++i) {
      if (keys[i].first != keys[first].first || places(keys[i].second) != places(keys[first].second)) {
        first = i;
        continue;
      }
      m_twin_of[keys[i].second] = keys[first].second;
      m_triples_of.emplace(keys[first].second, std::vector<Triangle>());
    }
  }

  std::vector<int> places(int f) const {
    std::vector<int> result;
    for (int c = m_soup.begin[f]; c < m_soup.begin[f + 1]; ++c) result.push_back(m_place[m_soup.corner[c]]);
    std::sort(result.begin(), result.end());
    return result;
  }

  /// The triples of the polygon on which polygon `f`, whose corners are at hand, lies; false if that has
  /// none, or a place occurs twice.
  bool as_twin(int f, std::vector<Triangle>& triples) const {
    const auto found = m_triples_of.find(m_twin_of[f]);
    if (m_twin_of[f] < 0 || found == m_triples_of.end() || found->second.empty()) return false;
    std::map<int, int> position;
    for (std::size_t i = 0; i < m_corners.size(); ++i) position[m_place[m_corners[i]]] = int(i);
    if (position.size() != m_corners.size() || found->second.size() + 2 != m_corners.size()) return false;
    for (Triangle t : found->second) {
      for (int& place : t) place = position.at(place);
      std::sort(t.begin(), t.end());
      triples.push_back(t);
    }
    return true;
  }

  void clean_corners(int f) {
    m_corners.clear();
    for (int c = m_soup.begin[f]; c < m_soup.begin[f + 1]; ++c)
      if (m_corners.empty() || m_corners.back() != m_soup.corner[c]) m_corners.push_back(m_soup.corner[c]);
    while (m_corners.size() > 1 && m_corners.back() == m_corners.front()) m_corners.pop_back();
  }

  void add(int f, int a, int b, int c) {
    m_result.triangles.push_back({a, b, c});
    m_result.face_of_triangle.push_back(f);
  }

  void triangulate(int f) {
    ++m_result.polygons;
    const double n = double(m_corners.size());
    m_work += n * n * n / 6;
    std::vector<Triangle> triples;
    if (as_twin(f, triples) || (n <= largest_polygon && m_work <= largest_work && best(triples))) {
      if (const auto twins = m_triples_of.find(f); twins != m_triples_of.end())
        for (const Triangle& t : triples)
          twins->second.push_back(
              {m_place[m_corners[t[0]]], m_place[m_corners[t[1]]], m_place[m_corners[t[2]]]});
      for (const Triangle& t : triples) {
        add(f, m_corners[t[0]], m_corners[t[1]], m_corners[t[2]]);
        for (int i = 0; i < 3; ++i) m_edges.insert(m_corners[t[i]], m_corners[t[(i + 1) % 3]]);
      }
      return;
    }
    Point sum(0, 0, 0);
    for (int v : m_corners) sum += m_points[v] / n;
    m_points.push_back(sum);
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      add(f, m_corners[i], m_corners[(i + 1) % m_corners.size()], int(m_points.size()) - 1);
  }

  bool best(std::vector<Triangle>& triples) const {
    std::vector<Point> loop;
    for (int v : m_corners) loop.push_back(m_points[v]);
    return triangulate_loop(
        loop,
        [&](int i, int j) {
          return m_corners[i] != m_corners[j] && !m_edges.contains(m_corners[i], m_corners[j]);
        },
        triples);
  }

  // Steps spent on all polygons of a file together; about a second.
  static constexpr double largest_work = 3e8;
  static constexpr int largest_polygon = 256;

  const Polygon_soup& m_soup;
  std::vector<Point>& m_points;
  Edge_set m_edges;
  std::vector<int> m_corners;
  double m_work = 0;
  std::vector<int> m_place;   ///< per point: the first at its place; empty if there are triangles only
  std::vector<int> m_twin_of; ///< per polygon: the first that lies on it, or -1
  std::map<int, std::vector<Triangle>> m_triples_of; ///< of polygons with twins, by places
  Triangulated_polygons m_result;
};

bool are_joined(const Triangle_surface& surface, int v, int w) {
  int h = surface.outgoing[v];
  do {
    if (surface.target(h) == w || surface.source(Triangle_surface::previous(h)) == w) return true;
    h = surface.rotate_ccw(h);
  } while (h >= 0 && h != surface.outgoing[v]);
  return false;
}

bool fill_loop(Mended_component& component, const std::vector<int>& halfedges) {
  Triangle_surface& surface = component.surface;
  const int n = int(halfedges.size()), largest = 400;
  std::vector<int> loop;
  std::vector<Point> points;
  for (int h : halfedges) {
    loop.push_back(surface.source(h));
    points.push_back(surface.points[loop.back()]);
  }
  // Filling a triangle with itself would make a pillow.
  if (n == 3 && surface.target(Triangle_surface::next(halfedges[0])) == loop[2]) return false;
  const auto add = [&](int a, int b, int c) {
    surface.triangles.push_back({a, b, c});
    component.face_of_triangle.push_back(-1);
  };
  std::vector<Triangle> triples;
  if (n <= largest &&
      triangulate_loop(
          points, [&](int i, int j) { return !are_joined(surface, loop[i], loop[j]); }, triples)) {
    for (const Triangle& t : triples) add(loop[t[2]], loop[t[1]], loop[t[0]]);
    return true;
  }
  Point middle(0, 0, 0);
  for (const Point& p : points) middle += p / n;
  surface.points.push_back(middle);
  component.point_of_vertex.push_back(-1);
  for (int i = 0; i < n; ++i) add(loop[(i + 1) % n], loop[i], surface.number_of_vertices() - 1);
  return true;
}

} // namespace

Triangulated_polygons triangulate_polygons(const Polygon_soup& soup, std::vector<Point>& points) {
  return Polygon_triangulator(soup, points).run();
}

int fill_holes(Mended_component& component, int largest) {
  // A boundary vertex lies on one loop only, so that filling one does not concern the others.
  int filled = 0;
  for (const std::vector<int>& loop : boundary_loops(component.surface))
    filled += int(loop.size()) <= largest && fill_loop(component, loop);
  return filled;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
