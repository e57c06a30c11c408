// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include "base/equal_points.h"
#include "mend/corners.h"
#include "mend/junctions.h"
#include "mend/weld.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

const char* name(Defect_kind kind) {
  switch (kind) {
  case Defect_kind::non_finite_point: return "non_finite_point";
  case Defect_kind::non_manifold_edge: return "non_manifold_edge";
  case Defect_kind::non_manifold_vertex: return "non_manifold_vertex";
  case Defect_kind::inconsistent_orientation: return "inconsistent_orientation";
  case Defect_kind::non_orientable: return "non_orientable";
  case Defect_kind::boundary_loop: return "boundary_loop";
  case Defect_kind::degenerate_face: return "degenerate_face";
  case Defect_kind::duplicate_face: return "duplicate_face";
  case Defect_kind::unreferenced_point: return "unreferenced_point";
  case Defect_kind::duplicate_point: return "duplicate_point";
  case Defect_kind::near_point: return "near_point";
  case Defect_kind::t_junction: return "t_junction";
  case Defect_kind::extreme_coordinate: return "extreme_coordinate";
  }
  return "";
}

bool Surface_check::is_clean() const {
  if (faces == 0 || triangles != faces) return false;
  for (int k = 0; k < number_of_defect_kinds; ++k)
    if (Defect_kind(k) != Defect_kind::boundary_loop && counts[std::size_t(k)] > 0) return false;
  return true;
}

namespace {

std::string edge_text(int a, int b) {
  return "the edge between the points " + std::to_string(a) + " and " + std::to_string(b);
}

class Checker {
public:
  Checker(const Polygon_soup& soup, const Check_options& options) : m_soup(soup), m_options(options) {}

  Surface_check run() {
    m_check.points = m_soup.number_of_points();
    m_check.faces = m_soup.number_of_polygons();
    look_at_points();
    look_at_faces();
    find_duplicate_faces();
    m_mesh = corner_mesh(m_soup, m_connects);
    m_edges = group_edges(m_mesh, m_soup.number_of_points());
    look_at_edges();
    look_at_rims();
    look_at_fans();
    look_at_components();
    trace_boundaries();
    std::stable_sort(m_check.defects.begin(), m_check.defects.end(),
                     [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
    return std::move(m_check);
  }

private:
  const Point& point(int v) const { return m_soup.points[v]; }

  /// Counts a defect; true if it is to be listed too.
  bool count(Defect_kind kind) {
    const std::int64_t n = ++m_check.counts[std::size_t(kind)];
    return m_options.listed_per_kind < 0 || n <= m_options.listed_per_kind;
  }

  void list(Defect_kind kind, std::vector<int> points, std::vector<int> faces, const Point& where,
            std::string text, double length = 0) {
    if (faces.size() > 8) faces.resize(8);
    m_check.defects.push_back({kind, std::move(points), std::move(faces), where, length, std::move(text)});
  }

  void look_at_points() {
    std::vector<char> used(m_soup.points.size(), 0);
    for (int v : m_soup.corner) used[v] = 1;
    const std::vector<int> first = first_equal_points(m_soup.points);
    bool any = false;
    for (int v = 0; v < m_soup.number_of_points(); ++v) {
      const Point& p = point(v);
      const auto the_point = [&] { return "point " + std::to_string(v) + " at " + text_of(p); };
      if (!p.allFinite()) {
        if (count(Defect_kind::non_finite_point))
          list(Defect_kind::non_finite_point, {v}, {}, p, the_point() + " is not finite");
      } else {
        m_check.lowest = any ? m_check.lowest.cwiseMin(p).eval() : p;
        m_check.highest = any ? m_check.highest.cwiseMax(p).eval() : p;
        any = true;
        if (used[v] && p.cwiseAbs().maxCoeff() > largest_coordinate && count(Defect_kind::extreme_coordinate))
          list(Defect_kind::extreme_coordinate, {v}, {}, p, the_point() + " is too far away to compute with");
      }
      if (!used[v] && count(Defect_kind::unreferenced_point))
        list(Defect_kind::unreferenced_point, {v}, {}, p, the_point() + " belongs to no face");
      if (first[v] != v && count(Defect_kind::duplicate_point))
        list(Defect_kind::duplicate_point, {first[v], v}, {}, p,
             the_point() + " has the coordinates of point " + std::to_string(first[v]));
    }
    look_at_extent();
  }

  // A mesh whose extent vanishes when it is multiplied with itself is as useless as one that overflows.
  void look_at_extent() {
    const double diagonal = (m_check.highest - m_check.lowest).norm();
    if (m_check.faces == 0 || diagonal * largest_coordinate >= 1 || !count(Defect_kind::extreme_coordinate))
      return;
    list(Defect_kind::extreme_coordinate, {}, {}, m_check.lowest,
         "the whole mesh is too small to compute with; scale it up");
  }

  void look_at_faces() {
    m_connects.assign(m_soup.number_of_polygons(), 1);
    std::vector<int> last_face(m_soup.points.size(), -1);
    for (int f = 0; f < m_soup.number_of_polygons(); ++f) {
      m_check.triangles += m_soup.size_of_polygon(f) == 3;
      const char* why = nullptr;
      if (m_soup.size_of_polygon(f) < 3) why = " has fewer than three corners";
      for (int c = m_soup.begin[f]; c < m_soup.begin[f + 1]; ++c) {
        if (last_face[m_soup.corner[c]] == f) why = " has a point twice among its corners";
        last_face[m_soup.corner[c]] = f;
      }
      m_connects[f] = !why;
      if (!why && is_flat(m_soup, f)) why = " has its corners on a line";
      if (why && count(Defect_kind::degenerate_face)) list_face(Defect_kind::degenerate_face, {f}, why);
    }
  }

  void list_face(Defect_kind kind, const std::vector<int>& faces, const std::string& what) {
    const int f = faces.back();
    const std::vector<int> corners(m_soup.corner.begin() + m_soup.begin[f],
                                   m_soup.corner.begin() + m_soup.begin[f + 1]);
    list(kind, corners, faces, corners.empty() ? Point(0, 0, 0) : point(corners[0]),
         "face " + std::to_string(f) + what);
  }

  // Faces with the same corners stand together when sorted by their smallest corner, their size, and their
  // sorted corners.
  void find_duplicate_faces() {
    std::vector<int> sorted = m_soup.corner, bucket(m_soup.points.size() + 1, 0);
    for (int f = 0; f < m_soup.number_of_polygons(); ++f) {
      std::sort(sorted.begin() + m_soup.begin[f], sorted.begin() + m_soup.begin[f + 1]);
      if (m_connects[f]) ++bucket[sorted[m_soup.begin[f]] + 1];
    }
    std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
    std::vector<int> order(bucket.back()), filled(bucket.begin(), bucket.end() - 1);
    for (int f = 0; f < m_soup.number_of_polygons(); ++f)
      if (m_connects[f]) order[filled[sorted[m_soup.begin[f]]]++] = f;
    const auto begin = [&](int f) { return sorted.begin() + m_soup.begin[f]; };
    const auto end = [&](int f) { return sorted.begin() + m_soup.begin[f + 1]; };
    const auto before = [&](int f, int g) {
      if (m_soup.size_of_polygon(f) != m_soup.size_of_polygon(g))
        return m_soup.size_of_polygon(f) < m_soup.size_of_polygon(g);
      const auto where = std::mismatch(begin(f), end(f), begin(g));
      return where.first == end(f) ? f < g : *where.first < *where.second;
    };
    for (std::size_t v = 0; v < m_soup.points.size(); ++v)
      std::sort(order.begin() + bucket[v], order.begin() + bucket[v + 1], before);
    std::vector<int> first_of(m_soup.number_of_polygons(), -1);
    for (std::size_t i = 1, first = 0; i < order.size(); ++i) {
      const int f = order[first], g = order[i];
      if (std::equal(begin(f), end(f), begin(g), end(g)))
        first_of[g] = f;
      else
        first = i;
    }
    for (int g = 0; g < m_soup.number_of_polygons(); ++g)
      if (first_of[g] >= 0 && count(Defect_kind::duplicate_face))
        list_face(Defect_kind::duplicate_face, {first_of[g], g},
                  " has the corners of face " + std::to_string(first_of[g]));
  }

  void list_edge(Defect_kind kind, int e, const std::string& what) {
    const int c = m_edges.first(e), a = m_mesh.source[c], b = m_mesh.target(c);
    std::vector<int> faces;
    for (int i = m_edges.begin[e]; i < m_edges.begin[e + 1] && faces.size() < 8; ++i)
      faces.push_back(m_mesh.face[m_edges.side[i]]);
    list(kind, {a, b}, std::move(faces), (point(a) + point(b)) / 2, edge_text(a, b) + what);
  }

  void look_at_edges() {
    for (int e = 0; e < m_edges.number_of_edges(); ++e) {
      if (m_edges.size(e) > 2 && count(Defect_kind::non_manifold_edge))
        list_edge(Defect_kind::non_manifold_edge, e, " has " + std::to_string(m_edges.size(e)) + " faces");
      if (m_edges.size(e) == 2 && m_mesh.source[m_edges.first(e)] == m_mesh.source[m_edges.second(e)] &&
          count(Defect_kind::inconsistent_orientation))
        list_edge(Defect_kind::inconsistent_orientation, e,
                  " is run through in the same direction by both its faces");
    }
  }

  // Border points a hair apart, and such on the inside of edges that have one face.
  void look_at_rims() {
    const double hair = weld_distance(m_soup.points, m_soup.corner, m_options.weld);
    std::vector<int> sides;
    for (int e = 0; e < m_edges.number_of_edges(); ++e)
      if (m_edges.size(e) == 1) sides.push_back(m_edges.first(e));
    if (sides.empty() || !(hair > 0)) return;
    look_at_near_points(hair);
    for (const Junctions& on : find_junctions(m_soup.points, m_mesh, sides, hair))
      for (int v : on.points)
        if (count(Defect_kind::t_junction))
          list(Defect_kind::t_junction, {m_mesh.source[on.side], v, m_mesh.target(on.side)},
               {m_mesh.face[on.side]}, point(v),
               "point " + std::to_string(v) + " at " + text_of(point(v)) + " lies on " +
                   edge_text(m_mesh.source[on.side], m_mesh.target(on.side)) +
                   ", which has one face: a T-junction");
  }

  void look_at_near_points(double hair) {
    std::vector<Triangle> fans; // a polygon as a fan has the rim that it had
    for (int f = 0; f < m_soup.number_of_polygons(); ++f)
      for (int c = m_soup.begin[f] + 1; m_connects[f] && c + 1 < m_soup.begin[f + 1]; ++c)
        fans.push_back({m_soup.corner[m_soup.begin[f]], m_soup.corner[c], m_soup.corner[c + 1]});
    const std::vector<int> into = near_border_points(m_soup.points, fans, hair);
    for (int v = 0; v < m_soup.number_of_points(); ++v) {
      const double distance = (point(v) - point(into[v])).norm();
      if (into[v] == v || distance == 0 || !count(Defect_kind::near_point)) continue;
      char far[32];
      std::snprintf(far, sizeof far, "%.2g", distance);
      list(Defect_kind::near_point, {into[v], v}, {}, point(v),
           "point " + std::to_string(v) + " at " + text_of(point(v)) + " is only " + far + " from point " +
               std::to_string(into[v]) + ": boundary edges lie on each other");
    }
  }

  void look_at_fans() {
    Disjoint_sets fans = join_fans(m_mesh, m_edges, [](int) { return true; });
    m_fan.assign(m_mesh.number_of_corners(), -1);
    std::vector<int> fans_at(m_soup.points.size(), 0);
    for (int c = 0; c < m_mesh.number_of_corners(); ++c) {
      if (m_mesh.face[c] < 0) continue;
      m_fan[c] = fans.find(c);
      fans_at[m_mesh.source[c]] += m_fan[c] == c;
    }
    for (int v = 0; v < m_soup.number_of_points(); ++v)
      if (fans_at[v] > 1 && count(Defect_kind::non_manifold_vertex))
        list(Defect_kind::non_manifold_vertex, {v}, {}, point(v),
             "the faces at point " + std::to_string(v) + " at " + text_of(point(v)) + " are " +
                 std::to_string(fans_at[v]) + " separate fans");
  }

  void look_at_components() {
    const int n = m_soup.number_of_polygons();
    Disjoint_sets sets(n);
    for (int e = 0; e < m_edges.number_of_edges(); ++e)
      for (int i = m_edges.begin[e] + 1; i < m_edges.begin[e + 1]; ++i)
        sets.join(m_mesh.face[m_edges.first(e)], m_mesh.face[m_edges.side[i]]);
    m_component.assign(n, -1);
    for (int f = 0; f < n; ++f) {
      if (!m_connects[f]) continue;
      const int root = sets.find(f);
      if (root == f) {
        m_component[f] = int(m_check.components.size());
        m_check.components.emplace_back();
        m_check.components.back().first_face = f;
      }
      m_component[f] = m_component[root];
      ++m_check.components[m_component[f]].faces;
    }
    for (int e = 0; e < m_edges.number_of_edges(); ++e) {
      Component_check& component = m_check.components[m_component[m_mesh.face[m_edges.first(e)]]];
      ++component.edges;
      component.manifold &= m_edges.size(e) <= 2;
    }
    for (int c = 0; c < m_mesh.number_of_corners(); ++c)
      if (m_fan[c] == c) ++m_check.components[m_component[m_mesh.face[c]]].vertices;
    for (Component_check& c : m_check.components) c.euler_characteristic = c.vertices - c.edges + c.faces;
    look_for_orientations();
  }

  // Faces and their copies turned round are joined across edges with two faces; where a face is joined with
  // its own copy there is no orientation.
  void look_for_orientations() {
    const int n = m_soup.number_of_polygons();
    if (n > std::numeric_limits<int>::max() / 2) return;
    Disjoint_sets sides(2 * n);
    for (int e = 0; e < m_edges.number_of_edges(); ++e) {
      if (m_edges.size(e) != 2) continue;
      const int f = m_mesh.face[m_edges.first(e)], g = m_mesh.face[m_edges.second(e)];
      const int turn = m_mesh.source[m_edges.first(e)] == m_mesh.source[m_edges.second(e)];
      sides.join(2 * f, 2 * g + turn);
      sides.join(2 * f + 1, 2 * g + 1 - turn);
    }
    for (int f = 0; f < n; ++f) {
      const int i = m_component[f];
      if (i < 0 || !m_check.components[i].orientable) continue;
      m_check.components[i].orientable = sides.find(2 * f) != sides.find(2 * f + 1);
      if (m_check.components[i].orientable || !count(Defect_kind::non_orientable)) continue;
      list(Defect_kind::non_orientable, {}, {f}, point(m_soup.corner[m_soup.begin[f]]),
           "component " + std::to_string(i) + " with face " + std::to_string(f) +
               " has only one side: its faces cannot be oriented consistently");
    }
  }

  // Walks along the edges with one face from fan to fan. Where other than two of them meet, at an edge with
  // more than two faces, a walk may end before it closes.
  void trace_boundaries() {
    std::vector<int> rim, first_of(m_mesh.number_of_corners(), -1), next_of;
    for (int e = 0; e < m_edges.number_of_edges(); ++e)
      if (m_edges.size(e) == 1) rim.push_back(m_edges.first(e));
    // Two entries for each rim edge, chained at the fans of its ends: 2 i at its source, 2 i + 1 at its
    // target.
    next_of.assign(2 * rim.size(), -1);
    for (std::size_t i = 0; i < rim.size(); ++i)
      for (int end = 0; end < 2; ++end) {
        int& first = first_of[m_fan[end == 0 ? rim[i] : m_mesh.next[rim[i]]]];
        next_of[2 * i + end] = first;
        first = int(2 * i) + end;
      }
    std::vector<char> seen(rim.size(), 0);
    for (std::size_t i = 0; i < rim.size(); ++i)
      if (!seen[i]) trace_loop(int(2 * i), rim, first_of, next_of, seen);
  }

  void trace_loop(int start, const std::vector<int>& rim, std::vector<int>& first_of,
                  const std::vector<int>& next_of, std::vector<char>& seen) {
    std::vector<int> points, faces;
    double length = 0;
    for (int entry = start; entry >= 0;) {
      const int c = rim[entry / 2];
      seen[entry / 2] = 1;
      const int here = entry % 2 == 0 ? c : m_mesh.next[c], there = entry % 2 == 0 ? m_mesh.next[c] : c;
      points.push_back(m_mesh.source[here]);
      if (faces.size() < 8) faces.push_back(m_mesh.face[c]);
      length += (point(m_mesh.source[there]) - point(m_mesh.source[here])).norm();
      int& head = first_of[m_fan[there]];
      while (head >= 0 && seen[head / 2]) head = next_of[head];
      entry = head;
    }
    const int component = m_component[m_mesh.face[rim[start / 2]]];
    ++m_check.components[component].boundary_loops;
    if (!count(Defect_kind::boundary_loop)) return;
    const Point where = point(points[0]);
    const std::string text = "a boundary of " + std::to_string(points.size()) + " edges passes point " +
                             std::to_string(points[0]) + " at " + text_of(where);
    list(Defect_kind::boundary_loop, std::move(points), std::move(faces), where, text, length);
  }

  const Polygon_soup& m_soup;
  const Check_options m_options;
  Surface_check m_check;
  std::vector<char> m_connects; ///< per face: it has three or more different corners
  Corner_mesh m_mesh;
  Edge_groups m_edges;
  std::vector<int> m_fan;       ///< per corner: the smallest corner of its fan
  std::vector<int> m_component; ///< per face
};

} // namespace

Surface_check check_surface(const Polygon_soup& soup, const Check_options& options) {
  return Checker(soup, options).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
