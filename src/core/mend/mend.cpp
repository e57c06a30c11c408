// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include "io/readers.h"
#include "mend/corners.h"
#include "mend/flat_faces.h"
#include "mend/loops.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

std::string text_of_count(std::int64_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

class Mender {
public:
  Mender(const Polygon_soup& soup, const Mend_options& options) : m_options(options), m_points(soup.points) {
    m_point_of.resize(soup.points.size());
    std::iota(m_point_of.begin(), m_point_of.end(), 0);
    Triangulated_polygons all = triangulate_polygons(soup, m_points);
    m_point_of.resize(m_points.size(), -1);
    m_triangles = std::move(all.triangles);
    m_face_of = std::move(all.face_of_triangle);
    say(all.polygons, "polygon was triangulated", "polygons were triangulated");
    say(all.dropped, "face with fewer than three different corners was dropped",
        "faces with fewer than three different corners were dropped");
  }

  Result<Mended_surface> run() {
    if (m_triangles.empty())
      return make_error(Error_code::not_a_surface, "There are " + std::to_string(m_points.size()) +
                                                       " points, but no faces with three different corners.");
    say(drop_repeated_corners(), "face with a repeated corner was dropped",
        "faces with a repeated corner were dropped");
    if (!take_whole()) {
      merge_points();
      drop_duplicate_faces();
      split_into_components();
      for (int c = 0; c < m_components; ++c) build(c);
    }
    say_totals();
    if (!m_result.components.empty()) return std::move(m_result);
    if (m_result.refused.empty())
      return make_error(Error_code::not_a_surface, "No face is left after mending.");
    return m_result.refused.front();
  }

private:
  void say(std::int64_t count, const char* one, const char* many) {
    if (count > 0) m_result.mends.push_back({count, text_of_count(count, one, many)});
  }

  /// Keeps the triangles for which `keep(f)`; the number of the others.
  template <class Predicate> std::int64_t keep_triangles(Predicate keep) {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < m_triangles.size(); ++f) {
      if (!keep(f)) continue;
      m_triangles[kept] = m_triangles[f];
      m_face_of[kept++] = m_face_of[f];
    }
    const std::int64_t dropped = std::int64_t(m_triangles.size() - kept);
    m_triangles.resize(kept);
    m_face_of.resize(kept);
    return dropped;
  }

  std::int64_t drop_repeated_corners() {
    return keep_triangles([&](std::size_t f) {
      const Triangle& t = m_triangles[f];
      return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    });
  }

  int number_of_points() const { return int(m_points.size()); }

  /// The short way for what nearly all files hold: one component that is a surface already. False, with nothing
  /// changed, if it is not so.
  bool take_whole() {
    Mended_component whole;
    whole.surface.points = m_points;
    whole.surface.triangles = m_triangles;
    Triangle_surface& surface = whole.surface;
    if (!surface.connect() || connected_components(surface).second != 1) return false;
    std::vector<char> on_border(m_points.size(), 0);
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (surface.is_boundary(h)) on_border[surface.source(h)] = 1;
    const std::vector<int> into = equal_border_points(on_border);
    for (int v = 0; v < number_of_points(); ++v)
      if (into[v] != v || surface.outgoing[v] < 0) return false;
    m_components = 1;
    m_component.assign(m_triangles.size(), 0);
    m_refusal.assign(1, Error{});
    look_at_points(0, m_triangles.size(), [](std::size_t i) { return i; });
    if (m_triangles.size() == 2 && is_pillow(0, 1)) refuse_pillow(0, 0);
    whole.point_of_vertex = m_point_of;
    whole.face_of_triangle = m_face_of;
    m_vertices = std::int64_t(m_points.size());
    accept(0, std::move(whole));
    return true;
  }

  // ---- equal points ----

  void merge_points() {
    const Corner_mesh mesh = corner_mesh(m_triangles);
    const Edge_groups edges = group_edges(mesh, number_of_points());
    std::vector<char> on_border(m_points.size(), 0);
    bool any = false, manifold = true;
    for (int e = 0; e < edges.number_of_edges(); ++e) {
      manifold &= edges.size(e) <= 2;
      if (edges.size(e) == 2) continue;
      on_border[mesh.source[edges.first(e)]] = on_border[mesh.target(edges.first(e))] = 1;
      any = true;
    }
    if (!any) return;
    std::vector<int> into = equal_border_points(on_border);
    if (manifold) leave_apart_where_harmful(into);
    std::int64_t merged = 0;
    m_merged.resize(m_points.size(), 0);
    for (int v = 0; v < number_of_points(); ++v) merged += m_merged[v] = into[v] != v;
    if (merged == 0) return;
    for (Triangle& t : m_triangles)
      for (int& v : t) v = into[v];
    say(merged, "point was merged with one of equal coordinates",
        "points were merged with others of equal coordinates");
    say(drop_repeated_corners(), "face whose corners were merged was dropped",
        "faces whose corners were merged were dropped");
  }

  std::vector<int> equal_border_points(const std::vector<char>& on_border) const {
    std::vector<Point> points;
    std::vector<int> ids, into(m_points.size());
    std::iota(into.begin(), into.end(), 0);
    for (int v = 0; v < number_of_points(); ++v)
      if (on_border[v]) {
        points.push_back(m_points[v]);
        ids.push_back(v);
      }
    const std::vector<int> first = first_equal_points(points);
    for (std::size_t i = 0; i < ids.size(); ++i) into[ids[i]] = ids[first[i]];
    return into;
  }

  // Two sheets that touch along an edge were apart in the file, and stay so.
  void leave_apart_where_harmful(std::vector<int>& into) const {
    for (int round = 0; round < 8; ++round) {
      std::vector<Triangle> merged;
      for (const Triangle& t : m_triangles) {
        const Triangle m = {into[t[0]], into[t[1]], into[t[2]]};
        if (m[0] != m[1] && m[1] != m[2] && m[2] != m[0]) merged.push_back(m);
      }
      const Corner_mesh mesh = corner_mesh(merged);
      const Edge_groups edges = group_edges(mesh, number_of_points());
      std::vector<char> harmful(m_points.size(), 0);
      for (int e = 0; e < edges.number_of_edges(); ++e)
        if (edges.size(e) > 2)
          harmful[mesh.source[edges.first(e)]] = harmful[mesh.target(edges.first(e))] = 1;
      bool changed = false;
      for (int v = 0; v < number_of_points(); ++v)
        if (into[v] != v && harmful[into[v]]) {
          into[v] = v;
          changed = true;
        }
      if (!changed) return;
    }
  }

  // ---- duplicate faces ----

  // Faces with the same corners are one face; patches of such faces that end at faces of the surface are
  // sheets inside it and vanish. Two faces that have only each other as neighbours stay, and are refused as a
  // pillow.
  void drop_duplicate_faces() {
    const int n = int(m_triangles.size());
    std::vector<int> order(n), first_of(n), copies(n, 0);
    std::vector<Triangle> sorted = m_triangles;
    for (Triangle& t : sorted) std::sort(t.begin(), t.end());
    std::iota(order.begin(), order.end(), 0);
    if (!bring_equal_together(sorted, order)) return;
    for (int i = 0, first = 0; i < n; ++i) {
      if (sorted[order[i]] != sorted[order[first]]) first = i;
      first_of[order[i]] = order[first];
      ++copies[order[first]];
    }
    const std::vector<char> sheet = inner_sheets(first_of, copies);
    std::int64_t sheets = 0;
    const std::int64_t dropped = keep_triangles([&](std::size_t f) {
      sheets += sheet[first_of[f]];
      return (first_of[f] == int(f) || copies[first_of[f]] < 0) && !sheet[first_of[f]];
    });
    say(sheets, "face of a double sheet inside a surface was dropped",
        "faces of double sheets inside a surface were dropped");
    say(dropped - sheets, "duplicate face was dropped", "duplicate faces were dropped");
  }

  /// Sorts the faces by their corners; false if no two are equal.
  bool bring_equal_together(const std::vector<Triangle>& sorted, std::vector<int>& order) const {
    std::vector<int> begin(m_points.size() + 1, 0), bucket(order.size());
    for (const Triangle& t : sorted) ++begin[t[0] + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> end(begin.begin(), begin.end() - 1);
    for (int f : order) bucket[end[sorted[f][0]]++] = f;
    bool any = false;
    for (int v = 0; v < number_of_points(); ++v) {
      std::sort(bucket.begin() + begin[v], bucket.begin() + begin[v + 1],
                [&](int f, int g) { return sorted[f] != sorted[g] ? sorted[f] < sorted[g] : f < g; });
      for (int i = begin[v] + 1; i < begin[v + 1]; ++i) any |= sorted[bucket[i]] == sorted[bucket[i - 1]];
    }
    order.swap(bucket);
    return any;
  }

  /// For each first copy whether it belongs to a sheet inside a surface. Marks pillows by a negative number
  /// of copies.
  std::vector<char> inner_sheets(const std::vector<int>& first_of, std::vector<int>& copies) const {
    const int n = int(m_triangles.size());
    std::vector<Triangle> unique;
    std::vector<int> id;
    for (int f = 0; f < n; ++f)
      if (first_of[f] == f) {
        unique.push_back(m_triangles[f]);
        id.push_back(f);
      }
    const Corner_mesh mesh = corner_mesh(unique);
    const Edge_groups edges = group_edges(mesh, number_of_points());
    Disjoint_sets patches(n);
    std::vector<char> touches(n, 0), alone(n, 1), sheet(n, 0);
    for (int e = 0; e < edges.number_of_edges(); ++e)
      for (int i = edges.begin[e]; i < edges.begin[e + 1]; ++i) {
        const int f = id[edges.side[i] / 3], g = id[edges.first(e) / 3];
        if (edges.size(e) > 1) alone[f] = 0;
        if (edges.size(e) == 2 && copies[f] > 1 && copies[g] > 1) patches.join(f, g);
        if (edges.size(e) > 2) touches[f] = 1;
      }
    std::vector<char> touching_patch(n, 0);
    for (int f : id)
      if (touches[f]) touching_patch[patches.find(f)] = 1;
    for (int f : id) sheet[f] = copies[f] > 1 && touching_patch[patches.find(f)];
    for (int f = 0; f < n; ++f) {
      const int first = first_of[f];
      if (f != first && copies[first] == 2 && alone[first] && !same_sense(m_triangles[first], m_triangles[f]))
        copies[first] = -2;
    }
    return sheet;
  }

  static bool same_sense(const Triangle& s, const Triangle& t) {
    const int i = int(std::find(t.begin(), t.end(), s[0]) - t.begin());
    return t[(i + 1) % 3] == s[1];
  }

  // ---- components, fans, orientation ----

  void split_into_components() {
    m_mesh = corner_mesh(m_triangles);
    m_edges = group_edges(m_mesh, number_of_points());
    const int n = int(m_triangles.size());
    Disjoint_sets sets(n);
    for (int e = 0; e < m_edges.number_of_edges(); ++e)
      for (int i = m_edges.begin[e] + 1; i < m_edges.begin[e + 1]; ++i)
        if (m_edges.size(e) == 2 || !m_options.cut_non_manifold_edges)
          sets.join(m_edges.first(e) / 3, m_edges.side[i] / 3);
    m_component.assign(n, -1);
    for (int f = 0; f < n; ++f)
      m_component[f] = sets.find(f) == f ? m_components++ : m_component[sets.find(f)];
    m_faces_begin.assign(m_components + 1, 0);
    for (int c : m_component) ++m_faces_begin[c + 1];
    std::partial_sum(m_faces_begin.begin(), m_faces_begin.end(), m_faces_begin.begin());
    std::vector<int> end(m_faces_begin.begin(), m_faces_begin.end() - 1);
    m_faces.resize(n);
    for (int f = 0; f < n; ++f) m_faces[end[m_component[f]]++] = f;
    m_refusal.assign(m_components, Error{});
    find_non_manifold_edges();
    find_fans();
    orient();
  }

  void refuse(int component, std::string text, Element_kind kind, int element) {
    Error& error = m_refusal[component];
    if (error.message.empty())
      error = make_error(Error_code::not_a_surface,
                         "Component " + std::to_string(component) + ": " + text + ".", kind, element);
  }

  std::string place(int v) const {
    const std::string name =
        m_point_of[v] < 0 ? "the middle of a polygon" : "point " + std::to_string(m_point_of[v]);
    return name + " at " + text_of(m_points[v]);
  }

  void find_non_manifold_edges() {
    for (int e = 0; e < m_edges.number_of_edges(); ++e) {
      if (m_edges.size(e) <= 2) continue;
      ++m_cut_edges;
      if (m_options.cut_non_manifold_edges) continue;
      const int s = m_edges.first(e), a = m_mesh.source[s], b = m_mesh.target(s);
      refuse(m_component[s / 3],
             "the edge from " + place(a) + " to " + place(b) + " has " + std::to_string(m_edges.size(e)) +
                 " faces",
             Element_kind::face, m_face_of[s / 3]);
    }
  }

  void find_fans() {
    Disjoint_sets fans = join_fans(m_mesh, m_edges, [&](int e) { return m_edges.size(e) == 2; });
    m_fan.resize(m_mesh.number_of_corners());
    for (int c = 0; c < m_mesh.number_of_corners(); ++c) m_fan[c] = fans.find(c);
  }

  // From the smallest face of each component over the edges with two faces.
  void orient() {
    const int n = int(m_triangles.size());
    std::vector<int> edge_of(3 * std::size_t(n), -1), stack;
    for (int e = 0; e < m_edges.number_of_edges(); ++e)
      if (m_edges.size(e) == 2) edge_of[m_edges.first(e)] = edge_of[m_edges.second(e)] = e;
    m_turned.assign(n, -1);
    for (int first = 0; first < n; ++first) {
      if (m_turned[first] >= 0) continue;
      m_turned[first] = 0;
      stack.push_back(first);
      while (!stack.empty()) {
        const int f = stack.back();
        stack.pop_back();
        for (int s = 3 * f; s < 3 * f + 3; ++s) {
          if (edge_of[s] < 0) continue;
          const int o = m_edges.first(edge_of[s]) + m_edges.second(edge_of[s]) - s, g = o / 3;
          const int turned = m_turned[f] ^ int(m_mesh.source[s] == m_mesh.source[o]);
          if (m_turned[g] < 0) {
            m_turned[g] = turned;
            stack.push_back(g);
          } else if (m_turned[g] != turned) {
            refuse(m_component[f],
                   "the surface has only one side, as a Moebius band has; face " +
                       std::to_string(m_face_of[f]) + " and its neighbours cannot be oriented alike",
                   Element_kind::face, m_face_of[f]);
          }
        }
      }
    }
  }

  // ---- one component ----

  void build(int c) {
    const int begin = m_faces_begin[c], end = m_faces_begin[c + 1];
    look_at_points(c, std::size_t(end - begin),
                   [&](std::size_t i) { return std::size_t(m_faces[begin + int(i)]); });
    if (end - begin == 2 && is_pillow(m_faces[begin], m_faces[begin + 1])) refuse_pillow(c, m_faces[begin]);
    if (!m_refusal[c].message.empty()) {
      m_result.refused.push_back(m_refusal[c]);
      return;
    }
    Mended_component component = take(c);
    if (Result<void> connected = component.surface.connect(); !connected) m_refusal[c] = connected.error();
    accept(c, std::move(component));
  }

  /// The last steps for a component that is a connected surface, unless it was refused already.
  void accept(int c, Mended_component component) {
    if (m_refusal[c].message.empty())
      if (Result<void> done = finish(component); !done) m_refusal[c] = done.error();
    if (m_refusal[c].message.empty())
      m_result.components.push_back(std::move(component));
    else
      m_result.refused.push_back(m_refusal[c]);
  }

  Result<void> finish(Mended_component& component) {
    Triangle_surface& surface = component.surface;
    Result<void> done;
    if (const Flat_face_counts counts = remove_flat_faces(component); counts.any()) {
      if (counts.kept == surface.number_of_faces())
        return make_error(Error_code::not_a_surface,
                          "The component with face " + std::to_string(component.face_of_triangle[0]) +
                              " has no area.",
                          Element_kind::face, component.face_of_triangle[0]);
      m_flat += counts;
      if (done = surface.connect(); !done) return done;
    }
    if (const int filled = m_options.fill_holes > 0 ? fill_holes(component, m_options.fill_holes) : 0;
        filled > 0) {
      m_filled += filled;
      if (done = surface.connect(); !done) return done;
    }
    if (m_options.orient_outward && is_closed(surface) && volume(surface) < 0) {
      for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
      ++m_outward;
      return surface.connect();
    }
    return done;
  }

  static bool is_closed(const Triangle_surface& surface) {
    return std::find(surface.opposite.begin(), surface.opposite.end(), -1) == surface.opposite.end();
  }

  bool is_pillow(int f, int g) const {
    Triangle s = m_triangles[f], t = m_triangles[g];
    std::sort(s.begin(), s.end());
    std::sort(t.begin(), t.end());
    return s == t;
  }

  void refuse_pillow(int c, int f) {
    refuse(c, "two triangles are glued to each other along all three edges; they enclose nothing",
           Element_kind::face, m_face_of[f]);
  }

  /// Refuses component `c`, with the `count` triangles `face(i)`, for points that cannot be computed with.
  template <class Face> void look_at_points(int c, std::size_t count, Face face) {
    for (std::size_t i = 0; i < count; ++i)
      for (int v : m_triangles[face(i)]) {
        if (!m_points[v].allFinite()) {
          refuse(c, place(v) + " is not finite", Element_kind::vertex, m_point_of[v]);
          return;
        }
        // Products of four coordinates must neither overflow.
        if (m_points[v].cwiseAbs().maxCoeff() > 1e70) {
          refuse(c, place(v) + " is too far away to compute with", Element_kind::vertex, m_point_of[v]);
          return;
        }
      }
  }

  /// The faces of a component, oriented alike as most of them are, with one vertex for each fan, in the order
  /// of points.
  Mended_component take(int c) {
    Mended_component result;
    const int begin = m_faces_begin[c], end = m_faces_begin[c + 1];
    int turned = 0;
    for (int i = begin; i < end; ++i) turned += m_turned[m_faces[i]];
    const bool other_way = 2 * turned > end - begin;
    m_turned_faces += other_way ? end - begin - turned : turned;

    std::vector<int> corners;
    for (int i = begin; i < end; ++i)
      for (int k = 3 * m_faces[i]; k < 3 * m_faces[i] + 3; ++k)
        if (m_fan[k] == k) corners.push_back(k);
    std::sort(corners.begin(), corners.end(), [&](int k, int l) {
      return m_mesh.source[k] != m_mesh.source[l] ? m_mesh.source[k] < m_mesh.source[l] : k < l;
    });
    m_vertex_of_fan.resize(m_fan.size());
    for (int k : corners) {
      const int v = m_mesh.source[k];
      m_vertex_of_fan[k] = result.surface.number_of_vertices();
      result.surface.points.push_back(m_points[v]);
      result.point_of_vertex.push_back(m_point_of[v]);
    }
    m_vertices += std::int64_t(corners.size());
    for (int i = begin; i < end; ++i) {
      const int f = m_faces[i];
      Triangle t;
      for (int k = 0; k < 3; ++k) t[k] = m_vertex_of_fan[m_fan[3 * f + k]];
      if (bool(m_turned[f]) != other_way) std::swap(t[1], t[2]);
      result.surface.triangles.push_back(t);
      result.face_of_triangle.push_back(m_face_of[f]);
    }
    return result;
  }

  // Six times the volume, from a corner so that a far origin does not spoil it.
  static double volume(const Triangle_surface& surface) {
    const Point origin = surface.points[0];
    double sum = 0;
    for (const Triangle& t : surface.triangles)
      sum += (surface.points[t[0]] - origin)
                 .dot((surface.points[t[1]] - origin).cross(surface.points[t[2]] - origin));
    return sum;
  }

  void say_totals() {
    if (m_options.cut_non_manifold_edges)
      say(m_cut_edges, "edge with more than two faces was cut open",
          "edges with more than two faces were cut open");
    say(m_vertices - used_points(), "point was added where several fans of faces meet",
        "points were added where several fans of faces meet");
    say(m_turned_faces, "face was turned to agree with its neighbours",
        "faces were turned to agree with their neighbours");
    say(m_flat.collapsed, "edge without length was collapsed", "edges without length were collapsed");
    say(m_flat.flipped, "edge was flipped to remove a face without area",
        "edges were flipped to remove faces without area");
    say(m_flat.removed, "face without area was removed at a boundary",
        "faces without area were removed at a boundary");
    say(m_flat.kept, "face without area was kept, since removing it would tear the surface",
        "faces without area were kept, since removing them would tear the surface");
    say(m_filled, "hole was filled", "holes were filled");
    say(m_outward, "closed component was turned outward", "closed components were turned outward");
    std::vector<char> used = m_merged;
    used.resize(m_points.size(), 0);
    for (const Triangle& t : m_triangles)
      for (int v : t) used[v] = 1;
    const std::int64_t unused = std::count(used.begin(), used.end(), 0);
    say(unused, "point without faces was dropped", "points without faces were dropped");
  }

  /// The number of points that the faces of the accepted components use.
  std::int64_t used_points() const {
    std::vector<char> used(m_points.size(), 0);
    for (std::size_t f = 0; f < m_triangles.size(); ++f)
      if (m_refusal[m_component[f]].message.empty())
        for (int v : m_triangles[f]) used[v] = 1;
    return std::count(used.begin(), used.end(), 1);
  }

  const Mend_options m_options;
  std::vector<Point> m_points;
  std::vector<char> m_merged;  ///< per point, or empty: it was merged into another
  std::vector<int> m_point_of; ///< per point: in the soup, or -1
  std::vector<Triangle> m_triangles;
  std::vector<int> m_face_of; ///< per triangle: its polygon of the soup
  Corner_mesh m_mesh;
  Edge_groups m_edges;
  std::vector<int> m_component, m_turned;  ///< per triangle
  std::vector<int> m_faces_begin, m_faces; ///< the triangles of each component
  std::vector<int> m_fan;                  ///< per corner: the smallest corner of its fan
  std::vector<int> m_vertex_of_fan;
  std::vector<Error> m_refusal; ///< per component; without a message where there is none
  int m_components = 0;
  std::int64_t m_cut_edges = 0, m_vertices = 0, m_turned_faces = 0, m_outward = 0, m_filled = 0;
  Flat_face_counts m_flat;
  Mended_surface m_result;
};

} // namespace

Result<Mended_surface> mend_surface(const Polygon_soup& soup, const Mend_options& options) {
  return Mender(soup, options).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
