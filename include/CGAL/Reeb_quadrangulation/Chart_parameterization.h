// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CHART_PARAMETERIZATION_H
#define CGAL_REEB_QUADRANGULATION_CHART_PARAMETERIZATION_H

#include <CGAL/Reeb_quadrangulation/Atlas.h>
#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// How high an annulus is and how long its level lines are, tabulated over U.
struct Height_profile {
  std::vector<double> height; ///< B + 1 entries: distance from the LOW walk of level i / B, increasing
  std::vector<double> length; ///< B + 1 entries: length of that level line
  double total() const { return height.back(); }
  /// The U at which the distance from the LOW walk is `fraction` of the total.
  double level_at(double fraction) const;
};

/// The map of a chart to the plane, by harmonic functions with positive weights, which cannot fold (a
/// discrete one-form has no zero inside; Gortler, Gotsman and Thurston 2006; Tutte and Floater for discs).
///
/// An annulus goes to the cylinder of height 1 and circumference 1: U is 0 on the LOW walk and 1 on the HIGH
/// walk, V grows eastward by 1 around. V is multivalued: `jump[h]` is added to the V of the target of
/// halfedge `h` as seen from its source; it is non-zero only across a strip of faces from walk to walk, and
/// no result depends on which strip. Copies share the factorization. A disc goes to the rectangle [0, a] x
/// [0, b], counterclockwise; then U is the second coordinate and V the first.
class Chart_parameterization {
public:
  /// Prepares the system of the chart and, for an annulus, solves for U, the natural V on the walks and the
  /// profile. The chart is only read, and only by this function and by `solve_*`, which must be given the
  /// same one.
  static Result<Chart_parameterization> prepare(const Chart& chart, const Field_solver_options& options = {});

  /// The same with other weights of the chart's edges than clamped cotangents; see `prepare_chart()`. Fails
  /// with `impossible_request`, naming the edge by a halfedge, where a weight is not positive and finite or
  /// the two halfedges of an edge differ: only symmetric positive weights keep the map from folding.
  ///
  /// `elimination_order` may list vertices of the chart, each once, in an order in which the solver does well
  /// to eliminate them, as `elimination_order()` gives it; vertices that it leaves out follow. Without it an
  /// order is searched for. With penalties the walks keep the places that they are given, and the inside is
  /// off by what the penalties leave.
  static Result<Chart_parameterization> prepare(const Chart& chart, Edge_weights weights,
                                                const std::vector<int>& elimination_order = {},
                                                const Field_solver_options& options = {});

  /// \name Annuli
  /// @{
  const Height_profile& profile() const { return m_profile; }
  /// Measures the profile anew, where lengths at each vertex of the chart count so many times. O(F)
  void weigh_profile(const Chart& chart, const std::vector<double>& density);
  /// V of the walk's vertices as the flux of U gives it (the harmonic conjugate), one more entry than
  /// vertices: from first vertex to first vertex, increasing by 1.
  const std::vector<double>& natural(Side side) const { return m_natural[side == Side::low ? 0 : 1]; }
  /// Solves for V given on the vertices of the walks, as `natural()` is given; the second walk's values count
  /// from the same lift as `natural()`: the mean of the differences to it should be alike on both walks.
  Result<void> solve_columns(const Chart& chart, const std::vector<double>& low,
                             const std::vector<double>& high);
  /// @}

  /// Disc: solves with the rectangle's border positions given for the walk's vertices in the order of
  /// `Walk::vertices`.
  Result<void> solve_rectangle(const Chart& chart, const std::vector<double>& x,
                               const std::vector<double>& y);

  const std::vector<double>& u() const { return m_u; }
  const std::vector<double>& v() const { return m_v; }
  double jump(int halfedge) const { return m_jump.empty() ? 0.0 : m_jump[halfedge]; }

  /// The number of triangles with no positive area in the plane: 0 but for rounding.
  int flipped(const Chart& chart) const;

private:
  Result<void> solve_u(const Chart& chart);
  void choose_seam(const Chart& chart);
  void integrate_flux(const Chart& chart);
  void measure_profile(const Chart& chart, const std::vector<double>* density);
  std::vector<double> lifted(const Chart& chart, int walk, const std::vector<double>& values) const;

  Dirichlet_problem m_problem; // shared by copies, which differ in V alone
  std::vector<double> m_u, m_v;
  std::vector<signed char> m_jump;
  std::array<int, 2> m_seam_vertex{{0, 0}}; // per walk: index of the first vertex east of the seam
  std::array<std::vector<double>, 2> m_natural;
  Height_profile m_profile;
};

/// The inner vertices of a chart that are vertices of the surface, in the surface's order of elimination,
/// where vertex `v` has the place `place[v]`: the charts' systems are parts of the field's, so that the order
/// found for it serves them too. O(n log n).
std::vector<int> elimination_order(const Chart& chart, const std::vector<int>& place);

/// The inverse of an order, which lists all vertices, such as `Harmonic_field::elimination_order()`.
std::vector<int> places_in(const std::vector<int>& order);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CHART_PARAMETERIZATION_H
