// SPDX-License-Identifier: GPL-3.0-or-later
#include "contours/plane_path.h"

#include "base/refusal.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

struct Path {
  std::vector<int> exits; // halfedges that are crossed
  std::vector<int> faces; // one more
};

class Path_tracer {
public:
  Path_tracer(const Triangle_surface& surface, const Contour_network& network, std::vector<char> is_above,
              int from, int to)
      : m_surface(surface), m_network(network), m_above(std::move(is_above)), m_from(from), m_to(to) {}

  std::vector<Path> paths(std::optional<Loop_sense> sense) const {
    std::vector<Path> found;
    for (int exit : prongs()) {
      const bool above_on_left = m_above[m_surface.target(exit)] != 0;
      if (sense && m_from == m_to && above_on_left != (*sense == Loop_sense::above_on_left)) continue;
      Path path;
      if (follow(exit, path)) found.push_back(std::move(path));
    }
    return found;
  }

private:
  bool differ(int h) const { return m_above[m_surface.source(h)] != m_above[m_surface.target(h)]; }
  int edge_of(int vertex) const {
    return m_network.is_crossing(vertex) ? m_network.crossing(vertex).halfedge : -1;
  }

  // The halfedges, seen from the first faces, over which paths leave these.
  std::vector<int> prongs() const {
    std::vector<int> exits;
    if (!m_network.is_crossing(m_from)) {
      const int first = m_surface.outgoing[m_from];
      int h = first;
      do {
        if (differ(Triangle_surface::next(h))) exits.push_back(Triangle_surface::next(h));
        h = m_surface.rotate_ccw(h);
      } while (h >= 0 && h != first);
      return exits;
    }
    const int e = edge_of(m_from);
    for (int h : {e, m_surface.opposite[e]})
      if (h >= 0 && differ(h)) exits.push_back(exit_after(h));
    return exits;
  }

  // The other edge of the face of h that the plane meets.
  int exit_after(int h) const {
    const int next = Triangle_surface::next(h);
    return differ(next) ? next : Triangle_surface::previous(h);
  }

  bool follow(int exit, Path& path) const {
    const int last_edge = edge_of(m_to);
    for (int steps = 0; steps <= m_surface.number_of_faces(); ++steps) {
      path.faces.push_back(exit / 3);
      if (last_edge >= 0 && m_surface.edge(exit) == last_edge) return true;
      const int entry = m_surface.opposite[exit];
      if (entry < 0) return false;
      path.exits.push_back(exit);
      if (last_edge < 0 && m_surface.target(Triangle_surface::next(entry)) == m_to) {
        path.faces.push_back(entry / 3);
        return true;
      }
      exit = exit_after(entry);
    }
    return false;
  }

  const Triangle_surface& m_surface;
  const Contour_network& m_network;
  std::vector<char> m_above;
  int m_from, m_to;
};

Edge_crossing crossing_of(const Triangle_surface& s, const Cutting_plane& plane, int exit) {
  constexpr double margin = 0.03;
  const Eigen::Vector3d normal = plane.unit_normal();
  const int e = s.edge(exit);
  const double from = std::abs(normal.dot(s.points[s.source(e)] - plane.point())),
               to = std::abs(normal.dot(s.points[s.target(e)] - plane.point())), t = from / (from + to);
  return {e, std::isfinite(t) ? std::min(1 - margin, std::max(margin, t)) : 0.5};
}

} // namespace

Result<Contour_edge> plane_path(const Triangle_surface& surface, Contour_network& network, int from, int to,
                                const Cutting_plane& plane, const Point& at,
                                std::optional<Loop_sense> sense) {
  Result<std::vector<char>> above = classify_vertices(surface, plane);
  if (!above) return above.error();
  const std::vector<Path> paths = Path_tracer(surface, network, std::move(*above), from, to).paths(sense);
  const Path* best = nullptr;
  double least = 0;
  for (const Path& path : paths)
    for (int exit : path.exits) {
      const Edge_crossing c = crossing_of(surface, plane, exit);
      const Point &p = surface.points[surface.source(c.halfedge)],
                  &q = surface.points[surface.target(c.halfedge)];
      const double d = (p + c.t * (q - p) - at).squaredNorm();
      if (best && d >= least) continue;
      best = &path;
      least = d;
    }
  if (!best) return refuse("the plane's curve does not join the ends of the contour");
  Contour_edge edge;
  edge.vertices.push_back(from);
  edge.faces = best->faces;
  for (int exit : best->exits) {
    edge.vertices.push_back(add_crossing(network, crossing_of(surface, plane, exit)));
  }
  edge.vertices.push_back(to);
  return edge;
}

Result<Contour_edge> plane_path(const Triangle_surface& surface, Contour_network& network, int from, int to,
                                const Eigen::Vector3d& normal, const Point& at,
                                std::optional<Loop_sense> sense) {
  const Point a = network.position(surface, from), b = network.position(surface, to);
  Eigen::Vector3d upright = normal;
  if (a != b) upright -= normal.dot(b - a) / (b - a).squaredNorm() * (b - a);
  if (!(upright.norm() > 1e-9 * normal.norm()))
    return refuse("the plane's normal is parallel to the line between the anchors");
  return plane_path(surface, network, from, to, Cutting_plane::at(a, upright), at, sense);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
