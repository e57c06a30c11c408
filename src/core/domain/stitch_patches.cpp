// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/stitch_patches.h>

#include "base/place.h"
#include "base/quad_connectivity.h"
#include "base/quad_cut.h"
#include "base/segments.h"
#include "domain/patches.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::Oriented_patches;
using internal::Rim_edge;

Error impossible(const std::string& message, Element_kind kind, int index) {
  return make_error(Error_code::impossible_request, message, kind, index);
}

std::string length(double d) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", d);
  return text;
}

Point normal_of(const std::vector<Point>& points, const Quad& q) {
  return 0.5 * (points[q[2]] - points[q[0]]).cross(points[q[3]] - points[q[1]]);
}

Point middle_of(const std::vector<Point>& points, const Quad& q) {
  return 0.25 * (points[q[0]] + points[q[1]] + points[q[2]] + points[q[3]]);
}

// The component of each quad, numbered by the smallest quad.
std::vector<int> components_of(const std::vector<Quad>& quads, int vertices) {
  std::vector<int> opposite, component(quads.size(), -1);
  internal::connect_quads(quads, vertices, opposite);
  int number = 0;
  for (std::size_t first = 0; first < quads.size(); ++first) {
    if (component[first] >= 0) continue;
    component[first] = number;
    std::vector<int> list{int(first)};
    for (std::size_t i = 0; i < list.size(); ++i)
      for (int h = 4 * list[i]; h < 4 * list[i] + 4; ++h)
        if (opposite[h] >= 0 && component[opposite[h] / 4] < 0) {
          component[opposite[h] / 4] = number;
          list.push_back(opposite[h] / 4);
        }
    ++number;
  }
  return component;
}

class Stitching {
public:
  Stitching(const Quad_mesh& mesh, const Stitch_patches_options& options, const Surface_projector* surface)
      : m_in(mesh), m_options(options), m_surface(surface) {}

  Result<Stitched_patches> run() {
    Result<Oriented_patches> patches = internal::orient_patches(m_in);
    if (!patches) return patches.error();
    m_patches = std::move(*patches);
    Result<Merged_patches> merged = merge_patches(m_patches.mesh, m_options.alpha);
    if (!merged) return of_input(merged.error());
    m_merged = std::move(*merged);
    if (!m_merged.open.empty() && !m_options.may_stay_open) return open_rim();
    Result<Resolved_mesh> resolved =
        resolve_t_junctions(m_merged.mesh, m_merged.hanging, m_options.t_junctions);
    if (!resolved) return of_merged(resolved.error());
    m_resolved = std::move(*resolved);
    if (const int f = internal::find_fault(m_resolved.mesh.quads, int(m_resolved.mesh.points.size())); f >= 0)
      return touching(f);
    tell();
    turn_outward();
    if (Result<void> relaxed = relax(); !relaxed) return relaxed.error();
    return std::move(m_out);
  }

private:
  Error of_input(Error error) const {
    if (error.element == Element_kind::vertex && error.index >= 0) {
      error.message += ", at " + place(m_patches.mesh.points[std::size_t(error.index)]);
      error.index = m_patches.vertex_origin[std::size_t(error.index)];
    } else if (error.element == Element_kind::face && error.index >= 0)
      error.message +=
          ", at " + place(m_patches.mesh.points[m_patches.mesh.quads[std::size_t(error.index)][0]]);
    return error;
  }

  Error of_merged(Error error) const {
    if (error.element != Element_kind::vertex || error.index < 0) return error;
    const auto found = std::find(m_merged.vertex.begin(), m_merged.vertex.end(), int(error.index));
    error.message += ", at " + place(m_merged.mesh.points[std::size_t(error.index)]);
    error.index = m_patches.vertex_origin[std::size_t(found - m_merged.vertex.begin())];
    return error;
  }

  Error touching(int quad) const {
    return impossible("patches would touch in single vertices or edges, beside which they do not meet, at " +
                          place(m_resolved.mesh.points[m_resolved.mesh.quads[quad][0]]),
                      Element_kind::face, m_resolved.parent[quad]);
  }

  // Names the place where the open rims are farthest from all others.
  Error open_rim() const {
    const std::vector<Rim_edge> rims = internal::rim_edges(m_patches);
    const std::vector<Point>& points = m_patches.mesh.points;
    constexpr std::size_t samples = 200;
    double farthest = -1, reach = 0;
    int vertex = -1;
    for (std::size_t i = 0; i < m_merged.open.size(); i += m_merged.open.size() / samples + 1) {
      const auto [a, b] = m_merged.open[i];
      const double length_here = (points[b] - points[a]).norm();
      double nearest = std::numeric_limits<double>::infinity(), reach_here = length_here;
      for (const Rim_edge& e : rims) {
        // Neighbours on the same rim are no other rim.
        if (points[e.a] == points[a] || points[e.b] == points[a] || points[e.a] == points[b] ||
            points[e.b] == points[b])
          continue;
        if ((points[e.b] - points[e.a]).dot(points[b] - points[a]) >= 0) continue;
        const double d =
            std::sqrt(squared_distance_to_segment(0.5 * (points[a] + points[b]), points[e.a], points[e.b]));
        if (d < nearest) {
          nearest = d;
          reach_here = std::max(length_here, (points[e.b] - points[e.a]).norm());
        }
      }
      if (nearest > farthest) farthest = nearest, vertex = a, reach = reach_here;
    }
    std::string message = "a rim meets no other, at " + place(points[vertex]);
    if (farthest == std::numeric_limits<double>::infinity())
      message += ": none is there";
    else
      message += ": the nearest that runs against it is " + length(farthest) +
                 " away, and gaps are closed up to the length of an edge, here " + length(reach) +
                 ", between vertices that lie nearer still";
    return impossible(message, Element_kind::vertex, m_patches.vertex_origin[vertex]);
  }

  void tell() {
    m_out.mesh = m_resolved.mesh;
    m_out.parent = m_resolved.parent;
    for (int q : m_out.parent) m_out.patch_of_quad.push_back(m_patches.patch_of_quad[q]);
    m_out.greedy_merges = m_merged.greedy_merges;
    m_out.later_merges = m_merged.later_merges;
    for (const Hanging_edge& e : m_merged.hanging) m_out.t_junctions += int(e.vertices.size());
    m_out.lines = m_resolved.lines;
    m_out.templates = m_resolved.templates;
    m_out.boundary_ends = int(m_resolved.boundary_vertices.size());
    m_out.extraordinary = m_resolved.extraordinary;
    for (std::size_t v = 0; v < m_merged.vertex.size(); ++v)
      m_out.largest_step = std::max(
          m_out.largest_step, (m_patches.mesh.points[v] - m_merged.mesh.points[m_merged.vertex[v]]).norm());
    m_out.components = internal::quad_components(m_out.mesh.quads, int(m_out.mesh.points.size()));
  }

  // Closed parts by the surface, or else by the sign of their volume; others as most of their area was.
  void turn_outward() {
    const std::vector<Point>& points = m_out.mesh.points;
    const std::vector<int> component = components_of(m_out.mesh.quads, int(points.size()));
    std::vector<double> side(m_out.components.size(), 0), kept(side);
    for (std::size_t f = 0; f < component.size(); ++f) {
      const Quad& q = m_out.mesh.quads[f];
      const Point normal = normal_of(points, q), middle = middle_of(points, q);
      const int c = component[f];
      if (m_surface)
        side[c] += normal.dot(m_surface->normal(m_surface->closest(middle).face));
      else
        side[c] += middle.dot(normal);
      kept[c] += m_patches.turned[m_out.parent[f]] ? -normal.norm() : normal.norm();
    }
    m_out.turned.assign(m_patches.patches, 0);
    for (std::size_t f = 0; f < component.size(); ++f) {
      const int c = component[f], parent = m_out.parent[f];
      const bool is_closed = m_out.components[c].second == 0;
      const bool turn = (m_surface || is_closed ? side[c] : kept[c]) < 0;
      if (turn) m_out.mesh.quads[f] = internal::turned_around(m_out.mesh.quads[f]);
      m_out.turned[m_out.patch_of_quad[f]] = char(m_patches.turned[parent] ^ char(turn));
    }
  }

  // The vertices that were made or moved far, those that got edges, and the others of their quads.
  std::vector<char> near_seams() const {
    std::vector<char> near(m_out.mesh.points.size(), 0);
    for (std::size_t v = 0; v < near.size(); ++v)
      near[v] = v >= m_merged.mesh.points.size() || m_resolved.added_edges[v] > 0;
    for (const Hanging_edge& e : m_merged.hanging)
      for (int v : e.vertices) near[v] = 1;
    for (const Rim_edge& e : internal::rim_edges(m_patches)) {
      const double step = (m_patches.mesh.points[e.a] - m_merged.mesh.points[m_merged.vertex[e.a]]).norm();
      const double edge = (m_patches.mesh.points[e.a] - m_patches.mesh.points[e.b]).norm();
      if (step > 0.5 * m_options.alpha * edge) near[m_merged.vertex[e.a]] = 1;
    }
    std::vector<char> out = near;
    for (const Quad& q : m_out.mesh.quads)
      if (std::any_of(q.begin(), q.end(), [&](int v) { return near[v]; }))
        for (int v : q) out[v] = 1;
    return out;
  }

  Result<void> relax() {
    if (m_options.relaxation == Stitch_relaxation::none) return {};
    Vertex_constraints constraints;
    if (m_options.relaxation == Stitch_relaxation::seams) {
      constraints.fixed = near_seams();
      if (std::find(constraints.fixed.begin(), constraints.fixed.end(), 1) == constraints.fixed.end())
        return {};
      for (char& c : constraints.fixed) c = !c;
    }
    Triangle_surface own;
    std::optional<Surface_projector> on_own;
    if (!m_surface) {
      own.points = m_out.mesh.points;
      for (const Quad& q : m_out.mesh.quads) {
        const auto& p = own.points;
        const int i = internal::first_corner_of_cut(p[q[0]], p[q[1]], p[q[2]], p[q[3]]);
        own.triangles.push_back({q[i], q[i + 1], q[i + 2]});
        own.triangles.push_back({q[i], q[i + 2], q[(i + 3) % 4]});
      }
      if (Result<void> connected = own.connect(); !connected) return connected.error();
      on_own.emplace(own);
    }
    Result<Relax_report> report =
        relax_quads(m_out.mesh, m_surface ? *m_surface : *on_own, constraints, m_options.relax);
    if (!report) return report.error();
    m_out.relaxation = *report;
    return {};
  }

  const Quad_mesh& m_in;
  const Stitch_patches_options& m_options;
  const Surface_projector* m_surface;
  Oriented_patches m_patches;
  Merged_patches m_merged;
  Resolved_mesh m_resolved;
  Stitched_patches m_out;
};

} // namespace

Result<Stitched_patches> stitch_patches(const Quad_mesh& mesh, const Stitch_patches_options& options,
                                        const Surface_projector* surface) {
  return Stitching(mesh, options, surface).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
