// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_HARMONIC_FIELD_H
#define CGAL_REEB_QUADRANGULATION_HARMONIC_FIELD_H

#include <CGAL/Reeb_quadrangulation/Field_solver_options.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>

#include <map>
#include <memory>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Which edge weights a harmonic field uses; see laplacian.h.
enum class Weight_kind { cotangent, clamped_cotangent, uniform };

/// What `Harmonic_field::solve_with_local_clamping()` did besides the field itself.
struct Locally_clamped_field {
  std::vector<double> values; ///< one for each vertex
  int rounds = 0;             ///< solves after the first
  int raised_edges = 0;       ///< edges whose weight was raised
  int spurious_extrema = 0;   ///< that remain; none of them has a negative weight, or the rounds are used up
  bool clamped_everywhere = false; ///< whether the fallback was taken
};

/// A harmonic function on a surface with prescribed values at some vertices (points, contours, boundary
/// loops).
///
/// Free boundaries have natural conditions. Vertices without a face get the value 0. The solver's analysis is
/// made once a surface.
class Harmonic_field {
public:
  /// Keeps a reference: `surface` must outlive the field and stay as it is. \pre It is connected by
  /// `connect()`.
  explicit Harmonic_field(const Triangle_surface& surface, const Field_solver_options& options = {});
  ~Harmonic_field();
  Harmonic_field(Harmonic_field&&) noexcept;
  Harmonic_field& operator=(Harmonic_field&&) noexcept;

  void set_weights(Weight_kind kind);        ///< default: cotangent
  void set_weights(Edge_weights weights);    ///< any symmetric weights. \pre one for each halfedge
  void set_method(Constraint_method method); ///< instead of that of the options
  /// Of the solver, if it can use more than one.
  void set_threads(int threads);

  /// Whether the next solve after a change of few constraints or weights reuses most of the factorization,
  /// for about twice the memory and the same bits. Off at first; see `Multifrontal_solver::set_incremental()`
  /// and, for penalties, `Cholmod_solver::set_incremental()`. Other solvers begin anew.
  void set_incremental(bool incremental);

  /// Adds a constraint, or changes its value. Fails with `impossible_request` where the vertex does not exist
  /// or the value is not finite.
  Result<void> set_constraint(int vertex, double value);
  /// Returns whether there was one.
  bool remove_constraint(int vertex);
  void clear_constraints();
  const std::map<int, double>& constraints() const;

  /// The values at the vertices. Fails with `impossible_request`, naming a vertex, where a component of the
  /// surface has no constraint, and with `solver_failure` where the system is not positive definite or the
  /// residual is too large.
  Result<std::vector<double>> solve();

  /// Solves, raises the weights below `low` to `low` at the extrema that are not constrained, and solves
  /// again, in at most `most_rounds` rounds. Uses clamped weights everywhere if afterwards a vertex of
  /// `wanted_extrema` is not an extremum any more, or a value leaves the constraints' range by more than 1e-6
  /// of it. The field's own weights stay.
  Result<Locally_clamped_field> solve_with_local_clamping(const std::vector<int>& wanted_extrema,
                                                          int most_rounds = 3, double low = 1e-2,
                                                          double high = 1e2);

  /// Of the last solve; see `relative_residual()`. Rows with a penalty count divided by it.
  double residual() const;

  /// The vertices as the last solution eliminated them; it depends on the surface's triangles and the solver
  /// alone. None where the solver does not tell.
  const std::vector<int>& elimination_order() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_HARMONIC_FIELD_H
