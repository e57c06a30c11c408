// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/junctions.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// A balanced tree over points, asked for those near a segment. A node is a range of the order; its point
/// is in the middle of the range.
class Point_tree {
public:
  Point_tree(const std::vector<Point>& points, std::vector<int> ids)
      : m_points(points), m_order(std::move(ids)) {
    m_boxes.resize(m_order.size());
    build(0, int(m_order.size()));
  }

  template <class Visit>
  void near_segment(const Point& a, const Point& b, double distance, Visit&& visit) const {
    search(0, int(m_order.size()), a, b, distance, visit);
  }

private:
  using Box = Eigen::AlignedBox3d;

  void build(int begin, int end) {
    if (begin >= end) return;
    Box box;
    for (int i = begin; i < end; ++i) box.extend(m_points[m_order[i]]);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(
        m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end, [&](int v, int w) {
          return m_points[v][axis] != m_points[w][axis] ? m_points[v][axis] < m_points[w][axis] : v < w;
        });
    m_boxes[middle] = box;
    build(begin, middle);
    build(middle + 1, end);
  }

  template <class Visit>
  void search(int begin, int end, const Point& a, const Point& b, double distance, Visit&& visit) const {
    if (begin >= end) return;
    const int middle = (begin + end) / 2;
    const Box& box = m_boxes[middle];
    if (distance_to_segment(box.center(), a, b) > box.diagonal().norm() / 2 + distance) return;
    if (distance_to_segment(m_points[m_order[middle]], a, b) <= distance && !visit(m_order[middle])) return;
    search(begin, middle, a, b, distance, visit);
    search(middle + 1, end, a, b, distance, visit);
  }

  static double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const double length = (b - a).squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
    return (a + t * (b - a) - p).norm();
  }

  const std::vector<Point>& m_points;
  std::vector<int> m_order;
  std::vector<Box> m_boxes;
};

} // namespace

std::vector<Junctions> find_junctions(const std::vector<Point>& points, const Corner_mesh& mesh,
                                      const std::vector<int>& sides, double distance) {
  std::vector<int> ids;
  for (int side : sides)
    for (int v : {mesh.source[side], mesh.target(side)})
      if (points[v].allFinite() && points[v].cwiseAbs().maxCoeff() < largest_coordinate) ids.push_back(v);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const Point_tree tree(points, std::move(ids));
  std::vector<Junctions> all;
  // Where very many points lie on very many sides the file is no surface with T-junctions.
  const std::size_t most = 16 * sides.size() + 1000;
  std::size_t seen = 0;
  for (int side : sides) {
    if (seen > most) return {};
    const Point &a = points[mesh.source[side]], &b = points[mesh.target(side)];
    if (!a.allFinite() || !b.allFinite()) continue;
    std::vector<std::pair<double, int>> on;
    tree.near_segment(a, b, distance, [&](int v) {
      if (++seen > most) return false;
      // Not a corner of the face itself; of very large polygons a part is looked at.
      for (int c = side, steps = 0; steps < 64 && (steps == 0 || c != side); ++steps, c = mesh.next[c])
        if (mesh.source[c] == v) return true;
      const double along = (points[v] - a).dot(b - a) / (b - a).norm();
      if (along > distance && along < (b - a).norm() - distance) on.emplace_back(along, v);
      return true;
    });
    if (on.empty()) continue;
    std::sort(on.begin(), on.end());
    all.push_back({side, {}});
    for (const auto& [along, v] : on) all.back().points.push_back(v);
  }
  return all;
}

namespace {

class Junction_mender {
public:
  Junction_mender(Loose_triangles& soup, std::vector<Junctions> junctions)
      : m_soup(soup), m_junctions(std::move(junctions)) {}

  /// The number of points that faces were divided at. Taking a point back may open what another one closed:
  /// a few rounds, and nothing if they do not end.
  std::int64_t run() {
    for (int round = 0; round < 16 && !m_junctions.empty(); ++round) {
      divide();
      if (take_back()) continue;
      std::int64_t count = 0;
      for (const Junctions& j : m_junctions) count += std::int64_t(j.points.size());
      m_soup = std::move(m_divided);
      return count;
    }
    return 0;
  }

private:
  void divide() {
    m_divided = m_soup;
    m_divided.triangles.clear();
    m_divided.face_of.clear();
    m_origin.clear();
    std::vector<std::array<std::vector<int>, 3>> on_side(m_soup.triangles.size());
    for (const Junctions& j : m_junctions) on_side[j.side / 3][j.side % 3] = j.points;
    for (int f = 0; f < m_soup.number_of_triangles(); ++f)
      for (const Triangle& part : divided(m_soup.triangles[f], on_side[f])) {
        m_divided.triangles.push_back(part);
        m_divided.face_of.push_back(m_soup.face_of[f]);
        m_origin.push_back(f);
      }
  }

  /// Takes back the points that close nothing, and those that give an edge more than two faces; whether
  /// there are any.
  bool take_back() {
    const Corner_mesh mesh = corner_mesh(m_divided.triangles);
    const Edge_groups edges = group_edges(mesh, m_divided.number_of_points());
    using Marks = std::vector<std::pair<int, int>>; // a face and a point on one of its sides
    Marks useful, harmful;
    const auto mark = [&](Marks& marks, int side) {
      const int f = m_origin[side / 3];
      for (int v : {mesh.source[side], mesh.target(side)})
        if (!has_corner(f, v)) marks.emplace_back(f, v);
    };
    for (int e = 0; e < edges.number_of_edges(); ++e)
      for (int i = edges.begin[e]; i < edges.begin[e + 1]; ++i) {
        if (edges.size(e) > 2) mark(harmful, edges.side[i]);
        if (edges.size(e) == 2 && m_origin[edges.first(e) / 3] != m_origin[edges.second(e) / 3])
          mark(useful, edges.side[i]);
      }
    std::sort(useful.begin(), useful.end());
    std::sort(harmful.begin(), harmful.end());
    const auto has = [](const Marks& marks, int f, int v) {
      return std::binary_search(marks.begin(), marks.end(), std::make_pair(f, v));
    };
    bool any = false;
    for (Junctions& j : m_junctions) {
      const auto bad = [&](int v) { return has(harmful, j.side / 3, v) || !has(useful, j.side / 3, v); };
      const auto end = std::remove_if(j.points.begin(), j.points.end(), bad);
      any |= end != j.points.end();
      j.points.erase(end, j.points.end());
    }
    m_junctions.erase(std::remove_if(m_junctions.begin(), m_junctions.end(),
                                     [](const Junctions& j) { return j.points.empty(); }),
                      m_junctions.end());
    return any;
  }

  bool has_corner(int f, int v) const {
    const Triangle& t = m_soup.triangles[f];
    return t[0] == v || t[1] == v || t[2] == v;
  }

  Loose_triangles& m_soup;
  std::vector<Junctions> m_junctions;
  Loose_triangles m_divided;
  std::vector<int> m_origin; ///< per triangle of `m_divided`: the face of `m_soup`
};

} // namespace

void mend_junctions(Loose_triangles& soup, double distance, std::vector<Mend>& mends) {
  const Corner_mesh mesh = corner_mesh(soup.triangles);
  const Edge_groups edges = group_edges(mesh, soup.number_of_points());
  std::vector<int> sides;
  for (int e = 0; e < edges.number_of_edges(); ++e)
    if (edges.size(e) == 1) sides.push_back(edges.first(e));
  if (sides.empty()) return;
  std::vector<Junctions> junctions = find_junctions(soup.points, mesh, sides, distance);
  say(mends, Junction_mender(soup, std::move(junctions)).run(),
      "T-junction was mended: a face was divided at a point of its neighbours that lay on its edge",
      "T-junctions were mended: faces were divided at points of their neighbours that lay on their edges");
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
