// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/fit_texture.h>

#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include "base/sharp_edge.h"
#include "textures/texture_plane.h"

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

Feature_edges features_inside(const Chart& chart, const Triangle_surface& surface, double angle) {
  const Triangle_surface& mesh = chart.mesh;
  const double cosine = internal::cosine_of(angle);
  std::vector<char> sharp(mesh.number_of_halfedges(), 0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    const int o = mesh.opposite[h];
    if (o < h) continue;
    const int f = chart.face_origin[mesh.face(h)], g = chart.face_origin[mesh.face(o)];
    if (f == g) continue;
    sharp[h] = sharp[o] =
        internal::is_sharp(internal::area_normal(surface, f), internal::area_normal(surface, g), cosine);
  }
  Feature_edges features = feature_edges(mesh, std::move(sharp));
  features.corners.erase(std::remove_if(features.corners.begin(), features.corners.end(),
                                        [&](int v) { return mesh.is_boundary(mesh.outgoing[v]); }),
                         features.corners.end());
  return features;
}

namespace {

constexpr int rings = 4; // around what lies on sharp edges are relaxed, as many as give way to lines
constexpr double worst_jacobian = 0.2; // no quad becomes worse, or than it was

class Fitter {
public:
  Fitter(const Placed_texture& placed, const Chart& chart, const Chart_parameterization& map)
      : m_placed(placed), m_chart(chart), m_map(map), m_projector(chart.mesh),
        m_plane(placed.texture.sides.size() == 2), m_held(placed.texture.v.size(), 0) {
    for (const std::vector<int>& side : placed.texture.sides)
      for (int v : side) m_held[v] = 1;
    for (int v : anchored_vertices(placed)) m_held[v] = 1;
    for (const Chart_location& l : placed.location) {
      m_before.points.push_back(position(chart, l));
      m_face.push_back(l.face);
    }
    m_before.quads = placed.texture.quads;
    m_after = m_before;
    m_on_corner = m_on_edge = m_moved = std::vector<char>(m_held.size(), 0);
  }

  Fitted_texture run(const Feature_edges& features) {
    snap(features);
    Fitted_texture out;
    out.texture = m_placed;
    Quad_texture& texture = out.texture.texture;
    into_plane(texture);
    take_back(texture);
    relocate(out.texture);
    for (std::size_t v = 0; v < m_held.size(); ++v) {
      if (!m_on_corner[v] && !m_on_edge[v]) continue;
      out.texture.anchors.emplace_back(texture.v[v], texture.u[v]);
      ++(m_on_corner[v] ? out.corners : out.vertices);
    }
    return out;
  }

private:
  void snap(const Feature_edges& features) {
    Snap_options options;
    options.lines = true;
    options.crossings = false; // edges are wanted, not diagonals
    Vertex_constraints onto(m_held);
    snap_to_features(m_after, m_projector, features, options, onto);
    for (std::size_t v = 0; v < m_held.size(); ++v) m_on_corner[v] = onto.fixed[v] && !m_held[v];
    for (const Vertex_constraints::Place& place : onto.places)
      m_on_edge[place.vertex] = !m_held[place.vertex];
    relax(std::move(onto));
  }

  void relax(Vertex_constraints constraints) {
    std::vector<char> region(m_held.size());
    for (std::size_t v = 0; v < region.size(); ++v) region[v] = m_on_corner[v] || m_on_edge[v];
    for (int r = 0; r < rings; ++r) {
      const std::vector<char> inner = region;
      for (const Quad& q : m_after.quads)
        for (int i = 0; i < 4; ++i)
          if (inner[q[i]]) region[q[(i + 1) % 4]] = region[q[(i + 3) % 4]] = 1;
    }
    for (std::size_t v = 0; v < region.size(); ++v)
      if (!region[v]) constraints.fixed[v] = 1;
    Relax_options options;
    options.untangle = false; // which may take vertices off the surface
    options.more_iterations = 0;
    const Result<Relax_report> relaxed = relax_quads(m_after, m_projector, constraints, options);
    CGAL_assertion(bool(relaxed)); // the constraints fit, and nobody cancels
    CGAL_USE(relaxed);
  }

  void into_plane(Quad_texture& texture) {
    for (std::size_t v = 0; v < m_held.size(); ++v) {
      if (m_held[v] || m_after.points[v] == m_before.points[v]) continue;
      const Closest_point at = m_projector.closest(m_after.points[v]);
      const Eigen::Vector2d p = plane_point(m_chart, m_map, {at.face, weights(at)});
      texture.v[v] = m_plane.wrapped(p.x());
      texture.u[v] = p.y();
      m_face[v] = at.face;
      m_moved[v] = 1;
    }
  }

  std::array<double, 3> weights(const Closest_point& at) const {
    const Triangle& t = m_chart.mesh.triangles[at.face];
    const Point &a = m_chart.mesh.points[t[0]], b = m_chart.mesh.points[t[1]] - a,
                c = m_chart.mesh.points[t[2]] - a, p = at.point - a;
    const Point n = b.cross(c);
    const double area = n.squaredNorm();
    if (!(area > 0)) return {1, 0, 0};
    const double wb = std::clamp(p.cross(c).dot(n) / area, 0.0, 1.0);
    const double wc = std::clamp(b.cross(p).dot(n) / area, 0.0, 1 - wb);
    return {1 - wb - wc, wb, wc};
  }

  // Vertices of bad quads go back until no quad is bad: at the latest when all have, and all is as before.
  void take_back(Quad_texture& texture) {
    for (bool found = true; found;) {
      found = false;
      for (const Quad& q : texture.quads) {
        if (!std::any_of(q.begin(), q.end(), [&](int v) { return m_moved[v] != 0; }) || is_good(texture, q))
          continue;
        found = true;
        for (int v : q)
          if (m_moved[v]) take_back(texture, v);
      }
    }
  }

  void take_back(Quad_texture& texture, int v) {
    m_moved[v] = m_on_corner[v] = m_on_edge[v] = 0;
    texture.v[v] = m_placed.texture.v[v];
    texture.u[v] = m_placed.texture.u[v];
    m_after.points[v] = m_before.points[v];
    m_face[v] = m_placed.location[v].face;
  }

  bool is_good(const Quad_texture& texture, const Quad& q) const {
    if (!m_plane.is_valid(texture.v, texture.u, q)) return false;
    Point old_outward = Point::Zero(), outward = Point::Zero();
    for (int v : q) {
      old_outward += m_projector.normal(m_placed.location[v].face);
      outward += m_projector.normal(m_face[v]);
    }
    if (!faces(m_after, q, outward) && faces(m_before, q, old_outward)) return false;
    const double jacobian = jacobian_of(m_after, q);
    return jacobian >= worst_jacobian || jacobian >= jacobian_of(m_before, q);
  }

  static bool faces(const Quad_mesh& mesh, const Quad& q, const Point& outward) {
    const std::vector<Point>& p = mesh.points;
    return (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]).dot(outward) > 0;
  }
  static double jacobian_of(const Quad_mesh& mesh, const Quad& q) {
    const std::vector<Point>& p = mesh.points;
    return scaled_jacobian(p[q[0]], p[q[1]], p[q[2]], p[q[3]]);
  }

  void relocate(Placed_texture& placed) const {
    std::vector<int> vertices;
    std::vector<double> v, u;
    for (std::size_t i = 0; i < m_moved.size(); ++i) {
      if (!m_moved[i]) continue;
      vertices.push_back(int(i));
      v.push_back(placed.texture.v[i]);
      u.push_back(placed.texture.u[i]);
    }
    const std::vector<Chart_location> found = locate(m_chart, m_map, v, u);
    for (std::size_t i = 0; i < vertices.size(); ++i) placed.location[vertices[i]] = found[i];
  }

  const Placed_texture& m_placed;
  const Chart& m_chart;
  const Chart_parameterization& m_map;
  Surface_projector m_projector;
  internal::Texture_plane m_plane;
  std::vector<char> m_held; ///< on sides, or anchored
  Quad_mesh m_before, m_after;
  std::vector<int> m_face;                           ///< of the chart, where each vertex is
  std::vector<char> m_on_corner, m_on_edge, m_moved; ///< what has been done with each vertex
};

} // namespace

Fitted_texture fit_texture(const Placed_texture& placed, const Chart& chart,
                           const Chart_parameterization& map, const Feature_edges& features) {
  return Fitter(placed, chart, map).run(features);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
