// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Embedding.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

struct Chord {
  int face, from, to; // network vertices
};

// The points on the border of a face in counterclockwise order: its corners and the crossings of its edges.
// `sides` has bit i set if the point lies on edge i: three points that share a bit are collinear.
struct Border {
  std::vector<int> vertex;
  std::vector<int> sides;

  void clear() {
    vertex.clear();
    sides.clear();
  }
  int find(int v) const { return int(std::find(vertex.begin(), vertex.end(), v) - vertex.begin()); }
};

double shape(const Point& a, const Point& b, const Point& c) {
  const double area = (b - a).cross(c - a).norm();
  const double edges = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return edges > 0 ? area / edges : 0;
}

// Triangulates polygons of border points (positions in increasing order) by dynamic programming: the best
// worst shape among the triangulations without a collinear triangle. Such a one exists, for no polygon has
// all points on one edge.
class Polygon_triangulator {
public:
  Polygon_triangulator(const Border& border, const std::vector<Point>& points)
      : m_border(border), m_points(points) {}

  bool operator()(const std::vector<int>& polygon, std::vector<Triangle>& out) {
    const int n = int(polygon.size());
    if (n < 3) return false;
    m_best.assign(n * n, 1e300);
    m_apex.assign(n * n, -1);
    for (int length = 2; length < n; ++length)
      for (int i = 0; i + length < n; ++i) {
        const int j = i + length;
        double best = -1;
        for (int k = i + 1; k < j; ++k) {
          const double value =
              std::min({m_best[i * n + k], m_best[k * n + j], quality(polygon[i], polygon[k], polygon[j])});
          if (value > best) {
            best = value;
            m_apex[i * n + j] = k;
          }
        }
        m_best[i * n + j] = best;
      }
    if (m_best[n - 1] < 0) return false;
    emit(polygon, n, 0, n - 1, out);
    return true;
  }

private:
  // Negative for collinear points, which no triangulation may use; otherwise non-negative even if rounding
  // made it 0.
  double quality(int i, int j, int k) const {
    if (m_border.sides[i] & m_border.sides[j] & m_border.sides[k]) return -2;
    return shape(m_points[m_border.vertex[i]], m_points[m_border.vertex[j]], m_points[m_border.vertex[k]]);
  }
  void emit(const std::vector<int>& polygon, int n, int i, int j, std::vector<Triangle>& out) const {
    if (j - i < 2) return;
    const int k = m_apex[i * n + j];
    emit(polygon, n, i, k, out);
    out.push_back({m_border.vertex[polygon[i]], m_border.vertex[polygon[k]], m_border.vertex[polygon[j]]});
    emit(polygon, n, k, j, out);
  }

  const Border& m_border;
  const std::vector<Point>& m_points;
  std::vector<double> m_best;
  std::vector<int> m_apex;
};

// Cuts the border cycle along chords into polygons; false if two chords cross.
bool cut_along_chords(const Border& border, const Chord* first, const Chord* last,
                      std::vector<std::vector<int>>& polygons) {
  polygons.assign(1, {});
  for (int i = 0; i < int(border.vertex.size()); ++i) polygons[0].push_back(i);
  for (const Chord* chord = first; chord != last; ++chord) {
    int i = border.find(chord->from), j = border.find(chord->to);
    if (i > j) std::swap(i, j);
    bool cut = false;
    for (std::size_t p = 0; p < polygons.size() && !cut; ++p) {
      const auto at = [&](int x) { return std::lower_bound(polygons[p].begin(), polygons[p].end(), x); };
      const auto a = at(i), b = at(j);
      if (a == polygons[p].end() || b == polygons[p].end() || *a != i || *b != j) continue;
      std::vector<int> inner(a, b + 1), outer(polygons[p].begin(), a + 1);
      outer.insert(outer.end(), b, polygons[p].end());
      polygons[p] = std::move(outer);
      polygons.push_back(std::move(inner));
      cut = true;
    }
    if (!cut) return false;
  }
  return true;
}

class Embedder {
public:
  Embedder(const Triangle_surface& surface, const Contour_network& network)
      : m_surface(surface), m_network(network) {
    m_result.surface = m_surface;
    for (int f = 0; f < m_surface.number_of_faces(); ++f) m_result.base_face.push_back(f);
    m_local = m_result.base_face;
  }

  Embedder(const Triangle_surface& surface, const Contour_network& network, const std::vector<int>& faces)
      : m_surface(surface), m_network(network), m_local(surface.number_of_faces(), -1) {
    Triangle_surface& s = m_result.surface;
    s.points.reserve(m_surface.points.size() + m_network.crossings.size());
    s.points = m_surface.points;
    m_result.base_face = faces;
    for (std::size_t i = 0; i < faces.size(); ++i) m_local[faces[i]] = int(i);
    s.outgoing.assign(s.points.size(), -1);
    for (int f : faces) {
      s.triangles.push_back(m_surface.triangles[f]);
      for (int h = 3 * f; h < 3 * f + 3; ++h) s.opposite.push_back(local(m_surface.opposite[h]));
    }
  }

  Result<Embedding> run() {
    for (int c = 0; c < int(m_network.crossings.size()); ++c)
      m_result.surface.points.push_back(m_network.position(m_surface, m_network.surface_vertices + c));
    m_result.surface.outgoing.resize(m_result.surface.points.size(), -1);
    sort_crossings();
    collect_chords();
    if (Result<void> cut = cut_faces(); !cut) return cut.error();
    connect_pieces();
    if (Result<void> labelled = label_walls(); !labelled) return labelled.error();
    return std::move(m_result);
  }

private:
  // The halfedge of the result that a halfedge of the surface is, before faces are cut; -1 outside.
  int local(int h) const { return h < 0 || m_local[h / 3] < 0 ? -1 : 3 * m_local[h / 3] + h % 3; }

  void sort_crossings() {
    for (int c = 0; c < int(m_network.crossings.size()); ++c) {
      const int h = m_network.crossings[c].halfedge;
      if (h >= 0 && (local(h) >= 0 || local(m_surface.opposite[h]) >= 0)) m_by_edge.push_back(c);
    }
    std::sort(m_by_edge.begin(), m_by_edge.end(), [&](int a, int b) {
      const Edge_crossing &x = m_network.crossings[a], &y = m_network.crossings[b];
      return x.halfedge != y.halfedge ? x.halfedge < y.halfedge : x.t < y.t;
    });
    for (int c : m_by_edge) {
      const int h = m_network.crossings[c].halfedge;
      if (local(h) >= 0) m_cut_faces.push_back(h / 3);
      if (local(m_surface.opposite[h]) >= 0) m_cut_faces.push_back(m_surface.opposite[h] / 3);
    }
  }

  void collect_chords() {
    for (const Contour_edge& edge : m_network.edges)
      for (std::size_t i = 0; i < edge.faces.size(); ++i)
        if (edge.faces[i] >= 0 && m_local[edge.faces[i]] >= 0)
          m_chords.push_back({edge.faces[i], edge.vertices[i], edge.vertices[i + 1]});
    std::stable_sort(m_chords.begin(), m_chords.end(),
                     [](const Chord& a, const Chord& b) { return a.face < b.face; });
    for (const Chord& chord : m_chords) m_cut_faces.push_back(chord.face);
    std::sort(m_cut_faces.begin(), m_cut_faces.end());
    m_cut_faces.erase(std::unique(m_cut_faces.begin(), m_cut_faces.end()), m_cut_faces.end());
  }

  void make_border(int f, Border& border) const {
    border.clear();
    for (int i = 0; i < 3; ++i) {
      border.vertex.push_back(m_surface.triangles[f][i]);
      border.sides.push_back((1 << i) | (1 << ((i + 2) % 3)));
      const int h = 3 * f + i, e = m_surface.edge(h);
      const auto first = std::lower_bound(m_by_edge.begin(), m_by_edge.end(), e, [&](int c, int edge) {
        return m_network.crossings[c].halfedge < edge;
      });
      auto last = first;
      while (last != m_by_edge.end() && m_network.crossings[*last].halfedge == e) ++last;
      const auto push = [&](int c) {
        border.vertex.push_back(m_network.surface_vertices + c);
        border.sides.push_back(1 << i);
      };
      if (h == e)
        for (auto c = first; c != last; ++c) push(*c);
      else
        for (auto c = last; c != first;) push(*--c);
    }
  }

  Result<void> cut_faces() {
    Border border;
    std::vector<std::vector<int>> polygons;
    std::vector<Triangle> pieces;
    std::size_t chord = 0;
    Triangle_surface& s = m_result.surface;
    for (int f : m_cut_faces) {
      make_border(f, border);
      std::size_t last = chord;
      while (last < m_chords.size() && m_chords[last].face == f) ++last;
      pieces.clear();
      Polygon_triangulator triangulate(border, s.points);
      bool good = cut_along_chords(border, m_chords.data() + chord, m_chords.data() + last, polygons);
      for (std::size_t p = 0; good && p < polygons.size(); ++p) good = triangulate(polygons[p], pieces);
      if (!good)
        return make_error(Error_code::internal_error, "contours cross inside a face", Element_kind::face, f);
      chord = last;
      m_piece_faces.push_back(m_local[f]);
      s.triangles[m_local[f]] = pieces[0];
      for (std::size_t i = 1; i < pieces.size(); ++i) {
        m_piece_faces.push_back(s.number_of_faces());
        s.triangles.push_back(pieces[i]);
        m_result.base_face.push_back(f);
      }
    }
    return {};
  }

  // Only the pieces' halfedges are new; one that is alone among them lies on an edge without crossings, or
  // where the result ends.
  void connect_pieces() {
    Triangle_surface& s = m_result.surface;
    s.opposite.resize(s.number_of_halfedges(), -1);
    std::vector<std::pair<Ends, int>>& halfedges = m_piece_halfedges;
    for (int f : m_piece_faces)
      for (int h = 3 * f; h < 3 * f + 3; ++h) halfedges.push_back({ends(s.source(h), s.target(h)), h});
    std::sort(halfedges.begin(), halfedges.end());
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      const int h = halfedges[i].second;
      if (i + 1 < halfedges.size() && halfedges[i + 1].first == halfedges[i].first) {
        const int g = halfedges[++i].second;
        s.opposite[h] = g;
        s.opposite[g] = h;
        continue;
      }
      const Triangle& base = m_surface.triangles[m_result.base_face[h / 3]];
      int side = 0;
      while (side < 3 && !(base[side] == s.source(h) && base[(side + 1) % 3] == s.target(h))) ++side;
      if (side == 3) { // part of an edge where the given faces end
        s.opposite[h] = -1;
        continue;
      }
      const int o = local(m_surface.opposite[3 * m_result.base_face[h / 3] + side]);
      s.opposite[h] = o;
      if (o >= 0) s.opposite[o] = h;
    }
    for (int f : m_piece_faces)
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int v = s.source(h);
        if (s.outgoing[v] < 0 || s.source(s.outgoing[v]) != v || s.opposite[h] < 0) s.outgoing[v] = h;
      }
  }

  Result<void> label_walls() {
    Triangle_surface& s = m_result.surface;
    m_result.wall_of.assign(s.number_of_halfedges(), -1);
    for (int e = 0; e < int(m_network.edges.size()); ++e) {
      const std::vector<int>& v = m_network.edges[e].vertices;
      for (int k = 0; k + 1 < int(v.size()); ++k) {
        const std::array<int, 2> found = find_halfedges(v[k], v[k + 1]);
        if (found[0] < 0 && found[1] < 0) {
          const std::vector<int> beside = faces_beside(m_network.edges[e], k);
          if (beside.empty())
            return make_error(Error_code::internal_error, "a contour leaves the surface",
                              Element_kind::contour, e);
          for (int f : beside)
            if (m_local[f] >= 0)
              return make_error(Error_code::internal_error, "contours cross inside a face",
                                Element_kind::face, f);
          continue; // outside the given faces
        }
        for (int h : found)
          if (h >= 0) {
            m_result.wall_of[h] = int(m_result.walls.size());
            m_result.walls.push_back({e, k, s.source(h) == v[k]});
          }
      }
    }
    return {};
  }

  using Ends = std::pair<int, int>;
  static Ends ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  // The faces of the surface that a segment goes through or along; none if it is not on the surface.
  std::vector<int> faces_beside(const Contour_edge& edge, int segment) const {
    if (edge.faces[segment] >= 0) return {edge.faces[segment]};
    const int a = edge.vertices[segment], b = edge.vertices[segment + 1];
    const int h = m_network.is_crossing(a)   ? m_network.crossing(a).halfedge
                  : m_network.is_crossing(b) ? m_network.crossing(b).halfedge
                                             : halfedge_between(a, b);
    if (h < 0) return {};
    if (m_surface.opposite[h] < 0) return {h / 3};
    return {h / 3, m_surface.opposite[h] / 3};
  }

  // Of the surface, in either direction.
  int halfedge_between(int a, int b) const {
    const int start = m_surface.outgoing[a];
    int h = start;
    do {
      if (m_surface.target(h) == b) return h;
      if (const int back = Triangle_surface::previous(h); m_surface.source(back) == b) return back;
      h = m_surface.rotate_ccw(h);
    } while (h >= 0 && h != start);
    return -1;
  }

  // The two halfedges between two vertices: of pieces, or along an edge between whole faces. None if another
  // contour crosses there.
  std::array<int, 2> find_halfedges(int a, int b) const {
    std::array<int, 2> found{{-1, -1}};
    const std::pair<Ends, int> first{ends(a, b), -1};
    auto piece = std::lower_bound(m_piece_halfedges.begin(), m_piece_halfedges.end(), first);
    for (int i = 0; i < 2 && piece != m_piece_halfedges.end() && piece->first == first.first; ++i, ++piece)
      found[i] = piece->second;
    if (found[0] >= 0) {
      if (found[1] < 0) found[1] = m_result.surface.opposite[found[0]];
      return found;
    }
    if (m_network.is_crossing(a) || m_network.is_crossing(b)) return found;
    const int along = halfedge_between(a, b);
    if (along < 0) return found;
    const Triangle_surface& s = m_result.surface;
    const std::array<int, 2> sides{{local(along), local(m_surface.opposite[along])}};
    for (int i = 0; i < 2; ++i)
      if (sides[i] >= 0 && ends(s.source(sides[i]), s.target(sides[i])) == ends(a, b)) found[i] = sides[i];
    return found;
  }

  const Triangle_surface& m_surface;
  const Contour_network& m_network;
  Embedding m_result;
  std::vector<int> m_local; // face of the result that a face of the surface is, before it is cut; or -1
  std::vector<std::pair<Ends, int>> m_piece_halfedges; // sorted
  std::vector<int> m_by_edge;                          // crossings sorted by (edge, t)
  std::vector<int> m_cut_faces;                        // sorted
  std::vector<int> m_piece_faces;                      // faces of the result that are pieces
  std::vector<Chord> m_chords;                         // sorted by face
};

} // namespace

Result<Embedding> embed(const Triangle_surface& surface, const Contour_network& network) {
  return Embedder(surface, network).run();
}

Result<Embedding> embed(const Triangle_surface& surface, const Contour_network& network,
                        const std::vector<int>& faces) {
  CGAL_precondition(std::is_sorted(faces.begin(), faces.end()));
  return Embedder(surface, network, faces).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
