// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quad_connectivity.h"
#include <CGAL/Reeb_quadrangulation/base_domain.h>
#include <CGAL/Reeb_quadrangulation/polygon_mesh.h>

#include <algorithm>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

Point centre(const Polygon_soup& mesh, int p) {
  Point sum = Point::Zero();
  for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) sum += mesh.points[mesh.corner[c]];
  return sum / mesh.size_of_polygon(p);
}

// Corners of an oriented manifold polygon mesh as halfedges: corner c of polygon p stands for the edge from
// it to the next.
class Corners {
public:
  explicit Corners(const Polygon_soup& mesh) : m_mesh(mesh) {
    for (int p = 0; p < mesh.number_of_polygons(); ++p)
      for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) {
        polygon.push_back(p);
        m_edges.push_back({{mesh.corner[c], mesh.corner[next(c)]}, c});
      }
    std::sort(m_edges.begin(), m_edges.end());
  }
  int next(int c) const { return c + 1 == m_mesh.begin[polygon[c] + 1] ? m_mesh.begin[polygon[c]] : c + 1; }
  int previous(int c) const {
    return c == m_mesh.begin[polygon[c]] ? m_mesh.begin[polygon[c] + 1] - 1 : c - 1;
  }
  /// The halfedge the other way, or -1 at the boundary.
  int opposite(int c) const {
    const std::array<int, 2> wanted{m_mesh.corner[next(c)], m_mesh.corner[c]};
    const auto found = std::lower_bound(m_edges.begin(), m_edges.end(), std::pair(wanted, -1));
    return found != m_edges.end() && found->first == wanted ? found->second : -1;
  }

  std::vector<int> polygon; ///< of each corner

private:
  const Polygon_soup& m_mesh;
  std::vector<std::pair<std::array<int, 2>, int>> m_edges;
};

// A polygon around every vertex.
class Dual {
public:
  explicit Dual(const Polygon_soup& mesh) : m_mesh(mesh), m_corners(mesh) {}

  Polygon_soup run() {
    for (int p = 0; p < m_mesh.number_of_polygons(); ++p) m_out.points.push_back(centre(m_mesh, p));
    m_middle.assign(m_mesh.corner.size(), -1);
    std::vector<int> first(m_mesh.points.size(), -1); // corner: at the boundary the one whose edge is on it
    for (int c = 0; c < int(m_mesh.corner.size()); ++c) {
      const bool boundary = m_corners.opposite(c) < 0;
      if (boundary || first[m_mesh.corner[c]] < 0) first[m_mesh.corner[c]] = c;
      if (!boundary) continue;
      m_middle[c] = int(m_out.points.size());
      m_out.points.push_back(
          0.5 * (m_mesh.points[m_mesh.corner[c]] + m_mesh.points[m_mesh.corner[m_corners.next(c)]]));
    }
    for (int c : first)
      if (c >= 0) add_polygon(c);
    return std::move(m_out);
  }

private:
  void add_polygon(int c) {
    if (m_middle[c] >= 0) {
      m_out.points.push_back(m_mesh.points[m_mesh.corner[c]]);
      m_out.corner.push_back(int(m_out.points.size()) - 1);
      m_out.corner.push_back(m_middle[c]);
    }
    for (int k = c; k >= 0;) {
      m_out.corner.push_back(m_corners.polygon[k]);
      const int before = m_corners.previous(k);
      k = m_corners.opposite(before);
      if (k < 0) m_out.corner.push_back(m_middle[before]);
      if (k == c) break;
    }
    m_out.close_polygon();
  }

  const Polygon_soup& m_mesh;
  const Corners m_corners;
  std::vector<int> m_middle; ///< per corner: the middle of its edge, on the boundary
  Polygon_soup m_out;
};

Polygon_soup diagonal_quads(const Quad_mesh& mesh, const std::vector<int>& opposite) {
  Polygon_soup out;
  out.points = mesh.points;
  const int first = int(mesh.points.size());
  for (const Quad& q : mesh.quads)
    out.points.push_back(0.25 *
                         (mesh.points[q[0]] + mesh.points[q[1]] + mesh.points[q[2]] + mesh.points[q[3]]));
  for (int h = 0; h < int(opposite.size()); ++h) {
    if (opposite[h] > h) continue;
    out.corner.push_back(internal::source(mesh.quads, h));
    if (opposite[h] >= 0) out.corner.push_back(first + opposite[h] / 4);
    out.corner.push_back(internal::target(mesh.quads, h));
    out.corner.push_back(first + h / 4);
    out.close_polygon();
  }
  return out;
}

// Triangles, two a quad. From quad to quad in breadth: of an edge's two ends, the diagonal of the one quad
// takes one and that of the other the other.
Polygon_soup parallel_triangles(const Quad_mesh& mesh, const std::vector<int>& opposite) {
  std::vector<int> from(mesh.quads.size(), -1); // the diagonal begins at this corner, 0 or 1
  std::vector<int> queue;
  for (int start = 0; start < int(mesh.quads.size()); ++start) {
    if (from[start] >= 0) continue;
    from[start] = 0;
    queue.assign(1, start);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int h = 4 * queue[i]; h < 4 * queue[i] + 4; ++h) {
        const int o = opposite[h];
        if (o < 0 || from[o / 4] >= 0) continue;
        // If the diagonal takes the source of h, the other one takes its target, the source of o.
        const bool takes_source = (h & 1) == from[queue[i]];
        from[o / 4] = takes_source ? o & 1 : 1 - (o & 1);
        queue.push_back(o / 4);
      }
  }
  Polygon_soup out;
  out.points = mesh.points;
  for (std::size_t f = 0; f < mesh.quads.size(); ++f)
    for (int half : {0, 2}) {
      for (int i : {0, 1, 2}) out.corner.push_back(mesh.quads[f][(from[f] + half + i) % 4]);
      out.close_polygon();
    }
  return out;
}

} // namespace

const char* name(Polygon_kind kind) {
  switch (kind) {
  case Polygon_kind::dual: return "dual";
  case Polygon_kind::diagonal: return "diagonal";
  case Polygon_kind::hexagons: return "hex";
  }
  return "";
}

Result<Polygon_soup> polygon_mesh(const Quad_mesh& mesh, Polygon_kind kind) {
  if (const Result<Base_domain> sound = base_domain(mesh, Base_cut::everywhere); !sound) return sound.error();
  std::vector<int> opposite;
  internal::connect_quads(mesh.quads, int(mesh.points.size()), opposite);
  switch (kind) {
  case Polygon_kind::dual: return Dual(polygon_soup(mesh)).run();
  case Polygon_kind::diagonal: return diagonal_quads(mesh, opposite);
  case Polygon_kind::hexagons: return Dual(parallel_triangles(mesh, opposite)).run();
  }
  return make_error(Error_code::internal_error, "a kind of polygons is unknown");
}

std::map<int, int> polygon_sizes(const Polygon_soup& mesh) {
  std::map<int, int> sizes;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) ++sizes[mesh.size_of_polygon(p)];
  return sizes;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
