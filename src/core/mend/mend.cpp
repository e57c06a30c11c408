// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include "base/diagonal.h"
#include "base/equal_points.h"
#include "mend/corners.h"
#include "mend/duplicates.h"
#include "mend/flat_faces.h"
#include "mend/junctions.h"
#include "mend/loops.h"
#include "mend/nesting.h"
#include "mend/non_manifold.h"
#include "mend/weld.h"

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

class Mender {
public:
  Mender(const Polygon_soup& soup, const Mend_options& options) : m_options(options) {
    m_soup.points = soup.points;
    m_soup.point_of.resize(soup.points.size());
    std::iota(m_soup.point_of.begin(), m_soup.point_of.end(), 0);
    m_weld = weld_distance(soup.points, soup.corner, options.weld);
    Triangulated_polygons all = triangulate_polygons(soup, m_soup.points);
    m_soup.point_of.resize(m_soup.points.size(), -1);
    m_soup.triangles = std::move(all.triangles);
    m_soup.face_of = std::move(all.face_of_triangle);
    say(all.polygons, "polygon was triangulated", "polygons were triangulated");
    say(all.dropped, "face with fewer than three different corners was dropped",
        "faces with fewer than three different corners were dropped");
  }

  Result<Mended_surface> run() {
    if (m_soup.triangles.empty())
      return make_error(Error_code::not_a_surface,
                        "There are " + std::to_string(m_soup.points.size()) +
                            " points, but no faces with three different corners; a cloud of points is to be "
                            "turned into triangles first.");
    say(m_soup.drop_repeated_corners(), "face with a repeated corner was dropped",
        "faces with a repeated corner were dropped");
    if (!take_whole()) {
      weld(m_soup, m_weld, m_merged, m_result.mends);
      if (m_weld > 0) mend_junctions(m_soup, m_weld, m_result.mends);
      drop_duplicate_faces(m_soup, m_result.mends);
      drop_flaps(m_soup, m_weld, m_result.mends);
      split_into_components();
      for (int c = 0; c < m_components; ++c) build(c);
    }
    drop_small_components();
    orient_components();
    say_totals();
    if (!m_result.components.empty()) return std::move(m_result);
    if (!m_result.refused.empty()) return m_result.refused.front();
    if (m_small > 0)
      return make_error(Error_code::not_a_surface, "All components are smaller than what is to be kept; keep "
                                                   "smaller ones.");
    return make_error(Error_code::not_a_surface, "No face is left after mending: none of them has an area.");
  }

private:
  void say(std::int64_t count, const char* one, const char* many) {
    Reeb_quadrangulation::say(m_result.mends, count, one, many);
  }

  int number_of_points() const { return m_soup.number_of_points(); }

  /// The short way for what nearly all files hold: one component that is a surface already. False, with
  /// nothing changed, if it is not so.
  bool take_whole() {
    Mended_component whole;
    whole.surface.points = m_soup.points;
    whole.surface.triangles = m_soup.triangles;
    Triangle_surface& surface = whole.surface;
    if (!surface.connect() || connected_components(surface).second != 1) return false;
    // Two triangles that are a closed surface lie on each other.
    if (m_soup.triangles.size() == 2 && is_closed(surface)) return false;
    if (std::find(surface.outgoing.begin(), surface.outgoing.end(), -1) != surface.outgoing.end() ||
        !has_quiet_border(surface))
      return false;
    m_components = 1;
    m_component.assign(m_soup.triangles.size(), 0);
    m_refusal.assign(1, Error{});
    look_at_points(0, m_soup.triangles.size(), [](std::size_t i) { return i; });
    whole.point_of_vertex = m_soup.point_of;
    whole.face_of_triangle = m_soup.face_of;
    m_vertices = std::int64_t(m_soup.points.size());
    accept(0, std::move(whole));
    return true;
  }

  /// Whether no border point is equal or near to another or lies on an edge of the border.
  bool has_quiet_border(const Triangle_surface& surface) const {
    std::vector<int> sides;
    std::vector<Point> points;
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (surface.is_boundary(h)) {
        sides.push_back(h);
        points.push_back(surface.points[surface.source(h)]);
      }
    if (sides.empty()) return true;
    const std::vector<int> into = first_near_points(points, m_weld);
    for (std::size_t i = 0; i < into.size(); ++i)
      if (into[i] != int(i)) return false;
    return m_weld == 0 ||
           find_junctions(surface.points, corner_mesh(surface.triangles), sides, m_weld).empty();
  }

  // ---- components, fans, orientation ----

  void split_into_components() {
    connect_faces();
    if (m_options.cut_non_manifold_edges) {
      m_cuts = cut_edges(m_soup, m_mesh, m_edges);
      find_fans();
      // Halves of an edge are cut as the edge was, and have an end of their own.
      while (divide_cut_edges(m_soup, m_mesh, m_edges, m_fan)) {
        connect_faces();
        cut_edges(m_soup, m_mesh, m_edges);
        find_fans();
      }
    }
    const int n = m_soup.number_of_triangles();
    Disjoint_sets sets(n);
    for (int e = 0; e < m_edges.number_of_edges(); ++e)
      for (int i = m_edges.begin[e] + 1; i < m_edges.begin[e + 1]; ++i)
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
    refuse_non_manifold_edges();
    find_fans();
    orient();
  }

  void connect_faces() {
    m_mesh = corner_mesh(m_soup.triangles);
    m_edges = group_edges(m_mesh, number_of_points());
  }

  /// The first reason of a component counts. `advice` is what to do about it.
  void refuse(int component, const std::string& text, const char* advice, Element_kind kind, int element) {
    Error& error = m_refusal[component];
    if (error.message.empty())
      error = make_error(Error_code::not_a_surface,
                         "Component " + std::to_string(component) + ": " + text + "; " + advice + ".", kind,
                         element);
  }

  std::string place(int v) const {
    const std::string name =
        m_soup.point_of[v] < 0 ? "the middle of a polygon" : "point " + std::to_string(m_soup.point_of[v]);
    return name + " at " + text_of(m_soup.points[v]);
  }

  void refuse_non_manifold_edges() {
    for (int e = 0; e < m_edges.number_of_edges(); ++e) {
      if (m_edges.size(e) <= 2) continue;
      const int s = m_edges.first(e), a = m_mesh.source[s], b = m_mesh.target(s);
      refuse(m_component[s / 3],
             "the edge from " + place(a) + " to " + place(b) + " has " + std::to_string(m_edges.size(e)) +
                 " faces",
             "let it be cut there, or give each of the surfaces that meet an edge of its own",
             Element_kind::face, m_soup.face_of[s / 3]);
    }
  }

  void find_fans() {
    Disjoint_sets fans = join_fans(m_mesh, m_edges, [&](int e) { return m_edges.size(e) == 2; });
    m_fan.resize(m_mesh.number_of_corners());
    for (int c = 0; c < m_mesh.number_of_corners(); ++c) m_fan[c] = fans.find(c);
  }

  // From the smallest face of each component over the edges with two faces.
  void orient() {
    const int n = int(m_soup.triangles.size());
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
                       std::to_string(m_soup.face_of[f]) + " and its neighbours cannot be oriented alike",
                   "cut it open across, or give it a thickness", Element_kind::face, m_soup.face_of[f]);
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
                              " has no area; remove it.",
                          Element_kind::face, component.face_of_triangle[0]);
      m_flat += counts;
      if (done = surface.connect(); !done) return done;
    }
    if (const int filled = m_options.fill_holes > 0 ? fill_holes(component, m_options.fill_holes) : 0;
        filled > 0) {
      m_filled += filled;
      if (done = surface.connect(); !done) return done;
    }
    return done;
  }

  /// Refuses component `c`, with the `count` triangles `face(i)`, for points that cannot be computed with.
  template <class Face> void look_at_points(int c, std::size_t count, Face face) {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < count; ++i)
      for (int v : m_soup.triangles[face(i)]) {
        const Point& p = m_soup.points[v];
        if (!p.allFinite())
          return refuse(c, place(v) + " is not finite", "move it, or remove its faces", Element_kind::vertex,
                        m_soup.point_of[v]);
        if (p.cwiseAbs().maxCoeff() > largest_coordinate)
          return refuse(c, place(v) + " is too far away to compute with", "move it, or scale the mesh down",
                        Element_kind::vertex, m_soup.point_of[v]);
        box.extend(p);
      }
    if (box.diagonal().norm() * largest_coordinate < 1)
      refuse(c, "it is too small to compute with", "scale the mesh up", Element_kind::face,
             m_soup.face_of[face(0)]);
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
      result.surface.points.push_back(m_soup.points[v]);
      result.point_of_vertex.push_back(m_soup.point_of[v]);
    }
    m_vertices += std::int64_t(corners.size());
    for (int i = begin; i < end; ++i) {
      const int f = m_faces[i];
      Triangle t;
      for (int k = 0; k < 3; ++k) t[k] = m_vertex_of_fan[m_fan[3 * f + k]];
      if (bool(m_turned[f]) != other_way) std::swap(t[1], t[2]);
      result.surface.triangles.push_back(t);
      result.face_of_triangle.push_back(m_soup.face_of[f]);
    }
    return result;
  }

  // ---- all components ----

  void drop_small_components() {
    Eigen::AlignedBox3d all;
    for (const Mended_component& c : m_result.components)
      for (const Point& p : c.surface.points) all.extend(p);
    const double whole = all.isEmpty() ? 0 : all.diagonal().norm();
    const double least = std::max(m_options.smallest_diagonal, m_options.smallest_part * whole);
    if (!(least > 0) && m_options.fewest_triangles <= 0) return;
    std::int64_t faces = 0;
    const auto is_small = [&](const Mended_component& c) {
      const bool small = internal::diagonal_of(c.surface.points) < least ||
                         c.surface.number_of_faces() < m_options.fewest_triangles;
      m_small += small;
      faces += small ? c.surface.number_of_faces() : 0;
      return small;
    };
    std::vector<Mended_component>& components = m_result.components;
    components.erase(std::remove_if(components.begin(), components.end(), is_small), components.end());
    if (m_small > 0)
      m_result.mends.push_back({m_small, text_of_count(m_small, "small component was dropped (",
                                                       "small components were dropped (") +
                                             text_of_count(faces, "face)", "faces)")});
  }

  void orient_components() {
    if (!m_options.orient_outward) return;
    const std::vector<int> depth = nesting_depths(m_result.components);
    for (std::size_t c = 0; c < m_result.components.size(); ++c) {
      Triangle_surface& surface = m_result.components[c].surface;
      const bool inward = depth[c] % 2 == 1;
      const double volume = is_closed(surface) ? signed_volume(surface) : 0;
      if (inward ? volume <= 0 : volume >= 0) continue;
      ++(inward ? m_inward : m_outward);
      for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
      const bool connected = bool(surface.connect());
      CGAL_assertion(connected); // as it was before
      CGAL_USE(connected);
    }
  }

  void say_totals() {
    say(m_cuts.solids, "edge along which solids touch was cut, so that they come apart",
        "edges along which solids touch were cut, so that they come apart");
    say(m_cuts.sheets, "edge where three sheets or more meet was cut, so that they come apart",
        "edges where three sheets or more meet were cut, so that they come apart");
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
    say(m_inward, "closed component inside another was turned inward",
        "closed components inside others were turned inward");
    std::vector<char> used = m_merged;
    used.resize(m_soup.points.size(), 0);
    for (const Triangle& t : m_soup.triangles)
      for (int v : t) used[v] = 1;
    const std::int64_t unused = std::count(used.begin(), used.end(), 0);
    say(unused, "point without faces was dropped", "points without faces were dropped");
  }

  /// The number of points that the faces of the accepted components use.
  std::int64_t used_points() const {
    std::vector<char> used(m_soup.points.size(), 0);
    for (std::size_t f = 0; f < m_soup.triangles.size(); ++f)
      if (m_refusal[m_component[f]].message.empty())
        for (int v : m_soup.triangles[f]) used[v] = 1;
    return std::count(used.begin(), used.end(), 1);
  }

  const Mend_options m_options;
  Loose_triangles m_soup;
  double m_weld = 0;
  std::vector<char> m_merged; ///< per point, or empty: it was merged into another
  Corner_mesh m_mesh;
  Edge_groups m_edges;
  std::vector<int> m_component, m_turned;  ///< per triangle
  std::vector<int> m_faces_begin, m_faces; ///< the triangles of each component
  std::vector<int> m_fan;                  ///< per corner: the smallest corner of its fan
  std::vector<int> m_vertex_of_fan;
  std::vector<Error> m_refusal; ///< per component; without a message where there is none
  int m_components = 0;
  std::int64_t m_vertices = 0, m_turned_faces = 0, m_outward = 0, m_inward = 0, m_filled = 0, m_small = 0;
  Edge_cuts m_cuts;
  Flat_face_counts m_flat;
  Mended_surface m_result;
};

} // namespace

Result<Mended_surface> mend_surface(const Polygon_soup& soup, const Mend_options& options) {
  return Mender(soup, options).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
