// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CERTIFICATE_H
#define CGAL_REEB_QUADRANGULATION_CERTIFICATE_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/shape_kept.h>

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file
/// The certificate of a quad mesh: named checks, each with what was measured, what was expected and, when it
/// fails, a sentence with the element. The checker shares no code with the stages that make quad meshes: it
/// reads plain arrays and derives connectivity, components, distances and intersections itself, so that a
/// defect of the mesher cannot hide itself. It never throws away a bad mesh: whatever the arrays hold, the
/// answer is a certificate.

namespace CGAL {
namespace Reeb_quadrangulation {

/// What to certify.
struct Certificate_input {
  const Quad_mesh& quads;
  /// The surface that the quads stand for, or null. Only `points` and `triangles` are read. It may have
  /// boundary loops and several components; it is taken to be manifold. Without it the quads are expected to
  /// be watertight, and the checks that compare with it are `not_checked`.
  const Triangle_surface* input = nullptr;
  /// How many interior vertices have which number of edges, if that was predicted. Valence 4 is compared only
  /// if the prediction names it, for the number of regular vertices depends on the sampling; every other
  /// valence is compared, so an empty map predicts that there is no extraordinary interior vertex.
  std::optional<std::map<int, int>> predicted_valences{};
  /// If the quads are meant to have holes that the input has not: the Euler characteristic and the number of
  /// boundary loops of each component, which are then expected in place of the input's.
  std::vector<std::pair<int, int>> predicted_components{};
  /// The surface as it was read, before anything was mended, or null; then `input` stands for it. Any
  /// triangles: points that are equal are taken as one. The shape is compared with it, so that what mending
  /// dropped counts as lost.
  const Triangle_surface* as_read = nullptr;
  int quads_asked = 0; ///< 0: no number of quads was asked for
};

/// Which of the costly parts to run, and their limits.
///
/// With both flags off, no search tree is built over the input and no exact predicate is evaluated: the cost
/// is linear in the input with a small constant (connectivity only), and the outward check takes a bounded
/// number of samples. Use that at a million triangles when seconds count.
struct Certificate_options {
  bool measure_shape = true;           ///< fills `Certificate::shape`; builds a tree over the input
  bool find_self_intersections = true; ///< exact tests of the quads whose boxes meet
  /// The distance check fails above this fraction of the input's bounding box diagonal; infinity: only
  /// measure.
  double maximum_distance = std::numeric_limits<double>::infinity();
  /// By how much, relative to itself, the distance told may be less than the true one. `Area_distance::bound`
  /// tells how near it came, which is farther only if `distance_queries` nearest points did not suffice.
  double distance_error = 0.01;
  std::int64_t distance_queries = 2000000; ///< in each direction, after one for each vertex
  int area_samples = 5000;                 ///< of the input, for means and parts of the area
  Shape_limits limits{};                   ///< what exceeds them becomes a warning
  /// Intersecting pairs are listed up to this number; the check then says that there are at least so many.
  int maximum_intersections = 100000;
  /// May be null. If it cancels, the costly parts that are not finished are left `not_checked`.
  const Observer* observer = nullptr;
};

enum class Check_status { passed, failed, not_checked };

/// One named check.
struct Certificate_check {
  std::string name; ///< a fixed identifier, see `certify()`
  Check_status status = Check_status::not_checked;
  double measured = 0; ///< what `certify()` says under the name; NaN if not measured
  double expected = 0; ///< NaN if nothing was expected
  std::string message; ///< failed: a sentence with the element; not checked: why; passed: empty
  Element_kind element = Element_kind::none;
  std::int64_t index = -1;
};

/// The counts of one connected component; faces are connected when they share a vertex.
struct Component_counts {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int boundary_loops = 0;
  int euler_characteristic() const { return vertices - edges + faces; }
};

/// The outcome of `certify()`.
struct Certificate {
  bool passed = false;         ///< no check failed among those of topology, points, valences and orientation
  bool strictly_valid = false; ///< `passed`, and shown to have no inverted quad and no self-intersection
  bool valid_as_input = false; ///< the same, but for self-intersections where the input has some
  std::vector<Certificate_check> checks; ///< always the same names in the same order

  int vertices = 0; ///< points of the quad mesh
  int edges = 0;
  int quads = 0;
  std::vector<Component_counts> components;       ///< of the quads, by smallest vertex
  std::vector<Component_counts> input_components; ///< of the input, by smallest vertex; empty without input
  std::map<int, int> interior_valences;           ///< valence -> number of interior vertices
  std::map<int, int> boundary_valences;           ///< valence -> number of boundary vertices
  std::vector<int> inverted_quads;                ///< ascending
  std::vector<std::pair<int, int>> intersecting_quads; ///< ascending pairs i < j
  int input_intersections = 0;     ///< how many of these lie where the input intersects itself
  std::optional<Shape_kept> shape; ///< if it was measured
  std::vector<Shape_warning>
      warnings; ///< of `shape`, and if the input intersects itself; they do not touch `passed`

  /// The check of that name. \pre `name` is one of those in `certify()`.
  const Certificate_check& check(const std::string& name) const;
};

/// Certifies a quad mesh.
///
/// The valence of a vertex is the number of its edges. The checks, in order, with what `measured` counts;
/// unless said otherwise 0 is expected:
/// - `all_quads`: faces that are no quads (an index out of range, a repeated vertex, the vertices of an
/// earlier
///   quad); they are left out of everything that follows. A mesh without a quad fails.
/// - `finite_points`: points with a coordinate that is not finite.
/// - `no_unreferenced_vertices`: points of no quad.
/// - `manifold_edges`: edges of more than two quads.
/// - `manifold_vertices`: vertices whose quads are not one fan.
/// - `oriented`: edges that their two quads use in the same direction.
/// - `watertight`: boundary loops; the input's number is expected, or 0 without an input.
/// - `components`: components; the input's number is expected.
/// - `euler_characteristic`: V - E + F; the input's is expected, and for each component the pair of Euler
///   characteristic and boundary loops that one component of the input has.
/// - `valences`: vertices too many or too few, summed over the compared valences.
/// - `valence_sum`: sum of 4 - valence over interior plus 3 - valence over boundary vertices; 4 (V - E + F)
/// is
///   expected. (With V_b = E_b on the boundary this follows from counting the sides, 4 F = 2 E - E_b.)
/// - `outward`: the part of the sampled input area whose normal agrees with that of the nearest quad;
///   passes if the agreeing area is the greater one on every component (1 is expected). Area from which the
///   quads are farther than they are large is left out, and so is area that has quads of both sides about as
///   near; a closed component of which nearly all is left out is judged by the signs of its volume and the
///   input's. `not_checked` where that tells nothing either.
/// - `no_inverted_quads`: quads whose scaled Jacobian is not positive. Definition of the Verdict library
/// (Stimpson
///   et al., "The Verdict geometric quality library", SAND2007-1751): the least of the four corners'
///   N . (e_i x e_(i-1)) / (|e_i| |e_(i-1)|), where the e are the edges that leave the corner
///   counterclockwise and clockwise, and N is the unit cross product of the principal axes; 0 where an edge
///   or N vanishes.
/// - `no_self_intersections`: pairs of quads that meet in more than what they share, but for those where
///   triangles of the input do (`Certificate::input_intersections`). Quads are split at the shorter diagonal
///   (at equal lengths at the one with the smaller index); decided by exact predicates. Triangles without
///   area are left out: their quads have a corner of scaled Jacobian 0.
/// - `distance`: the greatest distance over the areas to and from the input as it was read, as a fraction
///   of the bounding box diagonal. `measured` is the bound that is proved. `maximum_distance` is expected not
///   to be exceeded, and with infinity the check is `not_checked`.
///
/// The last three are not part of `passed`. Takes O(n + m log m) without the costly parts, for n input
/// triangles and m quads. The answer depends on the arrays alone.
Certificate certify(const Certificate_input& input, const Certificate_options& options = {});

/// "passed", "failed" or "not_checked".
const char* name(Check_status status);

/// The certificate as one JSON object (schema: doc/Reeb_quadrangulation/report_schema.md); numbers that are
/// not finite become null.
std::string to_json(const Certificate& certificate);

/// The certificate as an aligned table for the terminal, one line a check, ended by a line break.
std::string to_text(const Certificate& certificate);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CERTIFICATE_H
