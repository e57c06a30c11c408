// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_REEB_CHART_TRAITS_H
#define CGAL_REEB_QUADRANGULATION_REEB_CHART_TRAITS_H

#include <CGAL/Reeb_quadrangulation/Chart_parameterization.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The default model of `ReebChartTraits`: cotangent weights moved into [low, high]. \pre 0 < low <= high
class Reeb_chart_traits {
public:
  using FT = double;
  class Edge_weight {
  public:
    explicit Edge_weight(Edge_weights weights) : m_weights(std::move(weights)) {}
    FT operator()(const Triangle_surface&, int halfedge) const { return m_weights.of_halfedge[halfedge]; }

  private:
    Edge_weights m_weights;
  };

  explicit Reeb_chart_traits(double low = 1e-2, double high = 1e2) : m_low(low), m_high(high) {}
  Edge_weight edge_weight_object(const Chart& chart) const {
    return Edge_weight(clamped_cotangent_weights(chart.mesh, m_low, m_high));
  }

private:
  double m_low, m_high;
};

/// A model of `ReebChartTraits` that sees the triangulation only: all weights are one (Tutte).
struct Uniform_chart_traits {
  using FT = double;
  struct Edge_weight {
    FT operator()(const Triangle_surface&, int) const { return 1; }
  };
  Edge_weight edge_weight_object(const Chart&) const { return {}; }
};

/// A model of `ReebChartTraits` with the mean of the two mean-value weights (Floater 2003) of an edge:
/// positive on every triangulation without clamping. Tangents of half angles stop at 1e3 and lengths at 1e-9
/// of the chart's longest edge.
class Mean_value_chart_traits {
public:
  using FT = double;
  class Edge_weight {
  public:
    explicit Edge_weight(double longest_edge) : m_longest(longest_edge) {}
    FT operator()(const Triangle_surface& mesh, int halfedge) const {
      const int o = mesh.opposite[halfedge];
      const double tangents =
          half_angle_tangents(mesh, halfedge) + (o < 0 ? 0 : half_angle_tangents(mesh, o));
      return 0.5 * tangents / std::max(1e-9, length(mesh, halfedge) / m_longest);
    }

  private:
    static double length(const Triangle_surface& mesh, int h) {
      return (mesh.points[mesh.target(h)] - mesh.points[mesh.source(h)]).norm();
    }
    // tan(a / 2) + tan(b / 2) for the angles at the ends of a halfedge in its face.
    static double half_angle_tangents(const Triangle_surface& mesh, int h) {
      const int next = Triangle_surface::next(h), previous = Triangle_surface::previous(h);
      return half_angle_tangent(mesh, h, previous) + half_angle_tangent(mesh, next, h);
    }
    // Of the angle between a halfedge and the one before it.
    static double half_angle_tangent(const Triangle_surface& mesh, int h, int previous) {
      const Point& p = mesh.points[mesh.source(h)];
      const Point a = mesh.points[mesh.target(h)] - p, b = mesh.points[mesh.source(previous)] - p;
      if (!(a.norm() > 0) || !(b.norm() > 0)) return 1; // no angle: as of a right one
      const Point c = a / a.norm(), d = b / b.norm();
      // tan(x / 2) = sin x / (1 + cos x); the floor keeps the weight positive in a triangle without area.
      const double tangent = c.cross(d).norm() / (1 + c.dot(d));
      return tangent < 1e3 ? std::max(1e-6, tangent) : 1e3; // a quotient 0 / 0 counts as a flat angle
    }

    double m_longest;
  };

  Edge_weight edge_weight_object(const Chart& chart) const {
    double longest = 0;
    for (const Triangle& t : chart.mesh.triangles)
      for (int i = 0; i < 3; ++i)
        longest = std::max(longest, (chart.mesh.points[t[(i + 1) % 3]] - chart.mesh.points[t[i]]).norm());
    return Edge_weight(longest > 0 ? longest : 1.0);
  }
};

/// The weights that a model of `ReebChartTraits` gives the edges of a chart; each edge is asked once.
template <class ReebChartTraits>
Edge_weights chart_weights(const Chart& chart, const ReebChartTraits& traits) {
  const Triangle_surface& mesh = chart.mesh;
  const typename ReebChartTraits::Edge_weight weight = traits.edge_weight_object(chart);
  Edge_weights weights;
  weights.of_halfedge.resize(mesh.number_of_halfedges());
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    if (mesh.edge(h) != h) continue;
    const typename ReebChartTraits::FT w = weight(mesh, h);
    weights.of_halfedge[h] = static_cast<double>(w);
    if (!mesh.is_boundary(h)) weights.of_halfedge[mesh.opposite[h]] = weights.of_halfedge[h];
  }
  return weights;
}

/// `Chart_parameterization::prepare()` with the weights of a model of `ReebChartTraits`.
template <class ReebChartTraits = Reeb_chart_traits>
Result<Chart_parameterization> prepare_chart(const Chart& chart,
                                             const ReebChartTraits& traits = ReebChartTraits()) {
  return Chart_parameterization::prepare(chart, chart_weights(chart, traits));
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_REEB_CHART_TRAITS_H
