// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/kept_features.h>

#include "base/segment_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::Segment_tree;

// How near an edge of quads lies to a chain that it is on, or beside, in units of its own length.
constexpr std::array<double, 2> tolerance = {0.1, 0.5};

// Chains are measured at so many points for each edge of the quads.
constexpr double points_per_edge = 8;

// The distance in lengths of the segment that is nearest.
double relative_distance(const Segment_tree& segments, const Point& p) {
  const Segment_tree::Nearest nearest = segments.nearest(p);
  return std::sqrt(nearest.squared_distance / segments.squared_length(nearest.segment));
}

double length_of(const Triangle_surface& s, int h) {
  return (s.points[s.target(h)] - s.points[s.source(h)]).norm();
}

// The edges of quads that run along the features, by the two tolerances.
class Edges_along {
public:
  Edges_along(const Quad_mesh& mesh, const Segment_tree& features) {
    double sum = 0;
    for (const Quad& q : mesh.quads)
      for (std::size_t i = 0; i < 4; ++i) {
        const Point &a = mesh.points[std::size_t(q[i])], &b = mesh.points[std::size_t(q[(i + 1) % 4])];
        const double squared = (b - a).squaredNorm();
        sum += std::sqrt(squared);
        if (!(squared > 0)) continue;
        double farthest = 0;
        for (const Point& p : {a, b, Point(0.5 * (a + b))})
          farthest = std::max(farthest, features.squared_distance(p));
        for (std::size_t k = 0; k < 2; ++k)
          if (farthest <= tolerance[k] * tolerance[k] * squared) m_edges[k].add(a, b);
      }
    m_mean = mesh.quads.empty() ? 0 : sum / (4 * double(mesh.quads.size()));
    for (Segment_tree& edges : m_edges)
      if (!edges.empty()) edges.build();
  }

  double mean_length() const { return m_mean; }
  bool have(std::size_t k, const Point& p) const {
    return !m_edges[k].empty() && relative_distance(m_edges[k], p) <= tolerance[k];
  }

private:
  std::array<Segment_tree, 2> m_edges;
  double m_mean = 0;
};

Kept_chain measure(const Triangle_surface& s, const Feature_chain& chain, const Edges_along& edges) {
  Kept_chain result;
  double missed = 0;
  std::vector<std::pair<Point, double>> stretch; // that is missed, as far as it was followed
  const auto end_stretch = [&] {
    if (missed > result.missed) {
      result.missed = missed;
      double at = 0.5 * missed;
      std::size_t i = 0;
      for (; i + 1 < stretch.size() && at > stretch[i].second; ++i) at -= stretch[i].second;
      result.missed_at = stretch[i].first;
    }
    missed = 0;
    stretch.clear();
  };
  const double step = edges.mean_length() / points_per_edge;
  for (int h : chain.halfedges) {
    const double l = length_of(s, h);
    const int n = step > 0 ? std::max(1, int(std::min(1e4, std::ceil(l / step)))) : 1;
    for (int i = 0; i < n; ++i) {
      const Point p = s.points[s.source(h)] + (i + 0.5) / n * (s.points[s.target(h)] - s.points[s.source(h)]);
      result.length += l / n;
      if (edges.have(0, p)) {
        result.on += l / n;
        end_stretch();
        continue;
      }
      if (edges.have(1, p)) result.near += l / n;
      missed += l / n;
      stretch.push_back({p, l / n});
    }
  }
  end_stretch();
  return result;
}

} // namespace

std::vector<Kept_chain> kept_chains(const Quad_mesh& mesh, const Triangle_surface& surface,
                                    const Feature_edges& features) {
  Segment_tree lines;
  for (const Feature_chain& chain : features.chains)
    for (int h : chain.halfedges)
      if (length_of(surface, h) > 0)
        lines.add(surface.points[surface.source(h)], surface.points[surface.target(h)]);
  std::vector<Kept_chain> result;
  if (lines.empty()) return std::vector<Kept_chain>(features.chains.size());
  lines.build();
  const Edges_along edges(mesh, lines);
  for (const Feature_chain& chain : features.chains) result.push_back(measure(surface, chain, edges));
  return result;
}

double kept_part(const std::vector<Kept_chain>& chains) {
  double on = 0, length = 0;
  for (const Kept_chain& chain : chains) {
    on += chain.on;
    length += chain.length;
  }
  return length > 0 ? on / length : 1;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
