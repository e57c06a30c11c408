// SPDX-License-Identifier: GPL-3.0-or-later
#include "automatic/search_curves.h"
#include "base/quad_cut.h"

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// Degrees from which on an edge of quads does not run along a sharp edge.
constexpr double oblique = 25;

// Chains shorter than so many edges of the quads do not count, as when quads are snapped.
constexpr double shortest_chain = 2;

double length(const Triangle_surface& s, const Feature_chain& chain) {
  double sum = 0;
  for (int h : chain.halfedges) sum += (s.points[s.target(h)] - s.points[s.source(h)]).norm();
  return sum;
}

// The angle between a direction and the side of a quad that is nearest to it, in degrees.
double angle_to(const Quad_mesh& mesh, const Quad& q, const Point& direction) {
  double best = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point side = mesh.points[q[(i + 1) % 4]] - mesh.points[q[i]];
    if (const double l = side.norm(); l > 0) best = std::max(best, std::abs(side.dot(direction)) / l);
  }
  return std::acos(std::min(1.0, best)) * 180 / std::acos(-1.0);
}

} // namespace

double missed_features(const Quad_mesh& mesh, const Triangle_surface& surface, double feature_angle) {
  if (mesh.quads.empty()) return 0;
  const double edge = std::sqrt(area(surface) / double(mesh.quads.size()));
  Triangle_surface quads;
  quads.points = mesh.points;
  for (const Quad& q : mesh.quads) {
    const int c =
        first_corner_of_cut(mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]);
    quads.triangles.push_back({q[c], q[c + 1], q[c + 2]});
    quads.triangles.push_back({q[c], q[c + 2], q[(c + 3) % 4]});
  }
  const Surface_projector onto_quads(quads);
  double missed = 0, total = 0;
  for (const Feature_chain& chain : feature_edges(surface, feature_angle).chains) {
    if (chain.boundary || length(surface, chain) < shortest_chain * edge) continue;
    for (int h : chain.halfedges) {
      const Point &a = surface.points[surface.source(h)], &b = surface.points[surface.target(h)];
      const double l = (b - a).norm();
      if (!(l > 0)) continue;
      const int face = onto_quads.closest(0.5 * (a + b)).face;
      const double off = angle_to(mesh, mesh.quads[std::size_t(face / 2)], (b - a) / l) / oblique;
      missed += l * std::min(1.0, off * off);
      total += l;
    }
  }
  return total > 0 ? missed / total : 0;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
