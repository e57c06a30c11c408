// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PARAMETERS_H
#define CGAL_REEB_QUADRANGULATION_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <iterator>
#include <type_traits>
#include <vector>

/// \file
/// The words of the functions on face graphs, chained as CGAL's named parameters are:
/// `parameters::number_of_quads(2000).vertex_point_map(points)`. A chain of CGAL's parameters may be given
/// instead, or continued with `combine()`. Each function says which words it reads; any other word is an
/// error of the compiler.

namespace CGAL {
namespace Reeb_quadrangulation {

class Observer;
class Linear_solver_factory;
enum class Constraint_method;

namespace parameters {

/// \name Tags, one for each word that CGAL has not
/// @{
struct options_t {};
struct number_of_quads_t {};
struct edge_length_t {};
struct sizing_field_t {};
struct minima_t {};
struct maxima_t {};
struct vertex_field_map_t {};
struct number_of_threads_t {};
struct observer_t {};
struct constraint_method_t {};
struct chart_traits_t {};
struct texture_traits_t {};
struct quad_chart_map_t {};
struct vertex_arc_map_t {};
struct face_arc_map_t {};
struct vertex_location_map_t {};
struct halfedge_uv_map_t {};
/// @}

/// A named parameter and those that were given before it. The member functions are the words.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
class Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base> {
  using Self = CGAL::Named_function_parameters<T, Tag, Base>;

public:
  explicit Named_parameters(const T& value) : Self(value) {}
  Named_parameters(const T& value, const Base& others) : Self(value, others) {}

  /// The chain with one parameter more.
  template <class Other_tag, class U> auto with(const U& value) const {
    return Named_parameters<U, Other_tag, Self>(value, static_cast<const Self&>(*this));
  }

  /// \name Words of CGAL
  /// @{
  /// The points of the vertices; the property map `CGAL::vertex_point` of the mesh if not given.
  template <class VertexPointMap> auto vertex_point_map(const VertexPointMap& map) const {
    return with<CGAL::internal_np::vertex_point_t>(map);
  }
  /// A kernel, or traits with the same functors: `compute_x_3_object()` and its like read points,
  /// `construct_point_3_object()` makes them. If not given, `p.x()` and the constructor of the map's points
  /// do.
  template <class Traits> auto geom_traits(const Traits& traits) const {
    return with<CGAL::internal_np::geom_traits_t>(traits);
  }
  /// A readable map from the edges to whether edges of quads shall lie on them.
  template <class EdgeBoolMap> auto edge_is_constrained_map(const EdgeBoolMap& map) const {
    return with<CGAL::internal_np::edge_is_constrained_t>(map);
  }
  /// A readable map from the faces to patches, by any value that compares with `==`: edges between two
  /// patches are constrained.
  template <class FacePatchMap> auto face_patch_map(const FacePatchMap& map) const {
    return with<CGAL::internal_np::face_patch_t>(map);
  }
  /// A readable map from the vertices: of a triangle mesh, to whether a vertex of quads shall lie there; of
  /// quads, to whether they stay where they are.
  template <class VertexBoolMap> auto vertex_is_constrained_map(const VertexBoolMap& map) const {
    return with<CGAL::internal_np::vertex_is_constrained_t>(map);
  }
  /// @}

  /// \name What quads are asked for
  /// @{
  /// Everything else that a function can be told; the other parameters override it.
  template <class Options> auto options(const Options& value) const { return with<options_t>(value); }
  /// About how many quads.
  auto number_of_quads(int value) const { return with<number_of_quads_t>(value); }
  /// The length of the quads' edges, instead of their number.
  auto edge_length(double value) const { return with<edge_length_t>(value); }
  /// Ranges of vertices that are to be the field's minima and maxima; suggested if neither is given.
  template <class Range> auto minima(const Range& range) const { return with<minima_t>(list_of(range)); }
  template <class Range> auto maxima(const Range& range) const { return with<maxima_t>(list_of(range)); }
  /// A readable map from the vertices to the values of a function whose extrema and critical contours are to
  /// be those of the design.
  template <class VertexFieldMap> auto vertex_field_map(const VertexFieldMap& map) const {
    return with<vertex_field_map_t>(map);
  }
  /// A readable map from the vertices to the lengths that edges of quads shall have there.
  template <class VertexLengthMap> auto sizing_field(const VertexLengthMap& map) const {
    return with<sizing_field_t>(map);
  }
  /// A model of `ReebChartTraits`.
  template <class Traits> auto chart_traits(const Traits& traits) const {
    return with<chart_traits_t>(traits);
  }
  /// A model of `QuadTextureTraits`.
  template <class Traits> auto texture_traits(const Traits& traits) const {
    return with<texture_traits_t>(traits);
  }
  /// @}

  /// \name How it is done
  /// @{
  /// How many threads; 0 = as many as the machine has. Changes no bit of the result.
  auto number_of_threads(int value) const { return with<number_of_threads_t>(value); }
  /// What solves the systems of fields and maps: `sparse_linear_solver<Solver>()` of a model of
  /// `LinearSolver`.
  template <class Factory> auto sparse_linear_solver(const Factory& value) const {
    static_assert(std::is_same<Factory, Linear_solver_factory>::value);
    return with<CGAL::internal_np::sparse_linear_solver_t>(value);
  }
  /// How fields and maps meet the values that are given.
  auto constraint_method(Constraint_method value) const { return with<constraint_method_t>(value); }
  /// Receives progress and may cancel.
  auto observer(Observer* value) const { return with<observer_t>(value); }
  /// @}

  /// \name Property maps that are written
  /// @{
  /// From the quads to the index of their chart.
  template <class FaceChartMap> auto quad_chart_map(const FaceChartMap& map) const {
    return with<quad_chart_map_t>(map);
  }
  /// From the quads' vertices to where they lie on the triangle mesh: a `Face_location`.
  template <class VertexLocationMap> auto vertex_location_map(const VertexLocationMap& map) const {
    return with<vertex_location_map_t>(map);
  }
  /// From the quads' halfedges to the parameters, in their quad's chart, of the corner at their target:
  /// points of a plane, (V, U); see quad_parameters.h.
  template <class HalfedgeUvMap> auto halfedge_uv_map(const HalfedgeUvMap& map) const {
    return with<halfedge_uv_map_t>(map);
  }
  /// From the triangle mesh's vertices to the arc of the Reeb graph that they lie on, -1 for critical ones.
  template <class VertexArcMap> auto vertex_arc_map(const VertexArcMap& map) const {
    return with<vertex_arc_map_t>(map);
  }
  /// From the triangle mesh's faces to the arc of the Reeb graph that has the largest part of them.
  template <class FaceArcMap> auto face_arc_map(const FaceArcMap& map) const {
    return with<face_arc_map_t>(map);
  }
  /// @}

private:
  template <class Range> static auto list_of(const Range& range) {
    using Item = std::decay_t<decltype(*std::begin(range))>;
    return std::vector<Item>(std::begin(range), std::end(range));
  }
};

/// No parameters.
inline auto default_values() {
  return Named_parameters<bool, CGAL::internal_np::all_default_t>(true);
}

/// \name The first of a chain: see the member functions of the same names
/// @{
template <class VertexPointMap> auto vertex_point_map(const VertexPointMap& map) {
  return default_values().vertex_point_map(map);
}
template <class Traits> auto geom_traits(const Traits& traits) {
  return default_values().geom_traits(traits);
}
template <class EdgeBoolMap> auto edge_is_constrained_map(const EdgeBoolMap& map) {
  return default_values().edge_is_constrained_map(map);
}
template <class FacePatchMap> auto face_patch_map(const FacePatchMap& map) {
  return default_values().face_patch_map(map);
}
template <class VertexBoolMap> auto vertex_is_constrained_map(const VertexBoolMap& map) {
  return default_values().vertex_is_constrained_map(map);
}
template <class Options> auto options(const Options& value) {
  return default_values().options(value);
}
inline auto number_of_quads(int value) {
  return default_values().number_of_quads(value);
}
inline auto edge_length(double value) {
  return default_values().edge_length(value);
}
template <class VertexLengthMap> auto sizing_field(const VertexLengthMap& map) {
  return default_values().sizing_field(map);
}
template <class Range> auto minima(const Range& range) {
  return default_values().minima(range);
}
template <class Range> auto maxima(const Range& range) {
  return default_values().maxima(range);
}
template <class VertexFieldMap> auto vertex_field_map(const VertexFieldMap& map) {
  return default_values().vertex_field_map(map);
}
template <class Traits> auto chart_traits(const Traits& traits) {
  return default_values().chart_traits(traits);
}
template <class Traits> auto texture_traits(const Traits& traits) {
  return default_values().texture_traits(traits);
}
inline auto number_of_threads(int value) {
  return default_values().number_of_threads(value);
}
template <class Factory> auto sparse_linear_solver(const Factory& value) {
  return default_values().sparse_linear_solver(value);
}
inline auto constraint_method(Constraint_method value) {
  return default_values().constraint_method(value);
}
inline auto observer(Observer* value) {
  return default_values().observer(value);
}
template <class FaceChartMap> auto quad_chart_map(const FaceChartMap& map) {
  return default_values().quad_chart_map(map);
}
template <class VertexLocationMap> auto vertex_location_map(const VertexLocationMap& map) {
  return default_values().vertex_location_map(map);
}
template <class HalfedgeUvMap> auto halfedge_uv_map(const HalfedgeUvMap& map) {
  return default_values().halfedge_uv_map(map);
}
template <class VertexArcMap> auto vertex_arc_map(const VertexArcMap& map) {
  return default_values().vertex_arc_map(map);
}
template <class FaceArcMap> auto face_arc_map(const FaceArcMap& map) {
  return default_values().face_arc_map(map);
}
/// @}

} // namespace parameters
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PARAMETERS_H
