// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgReebQuadrangulationConcepts
\cgalConcept

The concept `ReebChartTraits` chooses the weights of the edges of a chart, hence the harmonic maps that
parameterize it: `prepare_chart()` takes a model, and so does `quadrangulate()` by the named parameter
`chart_traits`.

Harmonic maps cannot fold where weights are symmetric and positive. Symmetry comes by construction, because
every edge is asked for one weight; that a weight is positive and finite is checked, and an
`impossible_request` otherwise. A common factor of all weights of a chart changes nothing but rounding.

Charts are treated by several threads: the member functions of one object are called at the same time.

\cgalHasModel `CGAL::Reeb_quadrangulation::Reeb_chart_traits` (the default: clamped cotangents)
\cgalHasModel `CGAL::Reeb_quadrangulation::Uniform_chart_traits`
\cgalHasModel `CGAL::Reeb_quadrangulation::Mean_value_chart_traits`
*/
class ReebChartTraits {
public:
  /// The number type of weights. It converts to `double` by `static_cast`.
  typedef unspecified_type FT;

  /// A functor with `FT operator()(const Triangle_surface& mesh, int halfedge) const`, where `mesh` is the
  /// mesh of the chart that it was made for and `halfedge` its edge's `mesh.edge(halfedge)`: the weight of
  /// the whole edge, which has one face on the chart's boundary and two inside. It may have been computed
  /// before.
  typedef unspecified_type Edge_weight;

  /// Makes the functor for one chart. The functor is only called while the chart exists.
  Edge_weight edge_weight_object(const Chart& chart) const;
};
