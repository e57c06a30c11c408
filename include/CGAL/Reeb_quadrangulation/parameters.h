// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PARAMETERS_H
#define CGAL_REEB_QUADRANGULATION_PARAMETERS_H

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <CGAL/Named_function_parameters.h>

#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Named parameters of the functions on face graphs, chained like CGAL's:
/// `parameters::number_of_quads(2000).vertex_point_map(points)`. CGAL's own parameters may be given instead.
namespace parameters {

/// \name Tags, one for each parameter
/// @{
struct options_t {};
struct number_of_quads_t {};
struct edge_length_t {};
struct minima_t {};
struct maxima_t {};
struct number_of_threads_t {};
struct observer_t {};
struct chart_traits_t {};
struct texture_traits_t {};
struct quad_chart_map_t {};
/// @}

/// A named parameter and those that were given before it.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
class Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base> {
  using Self = CGAL::Named_function_parameters<T, Tag, Base>;
  template <class Other_tag, class U> auto with(const U& value) const {
    return Named_parameters<U, Other_tag, Self>(value, static_cast<const Self&>(*this));
  }

public:
  explicit Named_parameters(const T& value) : Self(value) {}
  Named_parameters(const T& value, const Base& others) : Self(value, others) {}

  /// The points of the vertices of the triangle mesh; the property map `CGAL::vertex_point` if not given.
  template <class VertexPointMap> auto vertex_point_map(const VertexPointMap& map) const {
    return with<CGAL::internal_np::vertex_point_t>(map);
  }
  /// Everything else that the pipeline can be told; the other parameters override it.
  auto options(const Quadrangulation_options& value) const { return with<options_t>(value); }
  /// About how many quads.
  auto number_of_quads(int value) const { return with<number_of_quads_t>(value); }
  /// The length of the quads' edges, instead of their number.
  auto edge_length(double value) const { return with<edge_length_t>(value); }
  /// Ranges of vertices that are to be the field's minima and maxima; suggested if neither is given.
  template <class Range> auto minima(const Range& range) const { return with<minima_t>(list_of(range)); }
  template <class Range> auto maxima(const Range& range) const { return with<maxima_t>(list_of(range)); }
  /// How many threads; 0 = as many as the machine has. Changes no bit of the result.
  auto number_of_threads(int value) const { return with<number_of_threads_t>(value); }
  /// Receives progress and may cancel.
  auto observer(Observer* value) const { return with<observer_t>(value); }
  /// A model of `ReebChartTraits`.
  template <class Traits> auto chart_traits(const Traits& traits) const {
    return with<chart_traits_t>(traits);
  }
  /// A model of `QuadTextureTraits`.
  template <class Traits> auto texture_traits(const Traits& traits) const {
    return with<texture_traits_t>(traits);
  }
  /// A writable property map from the quads (faces of the output) to the index of their chart.
  template <class FaceChartMap> auto quad_chart_map(const FaceChartMap& map) const {
    return with<quad_chart_map_t>(map);
  }

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
  return Named_parameters<VertexPointMap, CGAL::internal_np::vertex_point_t>(map);
}
inline auto options(const Quadrangulation_options& value) {
  return Named_parameters<Quadrangulation_options, options_t>(value);
}
inline auto number_of_quads(int value) {
  return Named_parameters<int, number_of_quads_t>(value);
}
inline auto edge_length(double value) {
  return Named_parameters<double, edge_length_t>(value);
}
template <class Range> auto minima(const Range& range) {
  return default_values().minima(range);
}
template <class Range> auto maxima(const Range& range) {
  return default_values().maxima(range);
}
inline auto number_of_threads(int value) {
  return Named_parameters<int, number_of_threads_t>(value);
}
inline auto observer(Observer* value) {
  return Named_parameters<Observer*, observer_t>(value);
}
template <class Traits> auto chart_traits(const Traits& traits) {
  return Named_parameters<Traits, chart_traits_t>(traits);
}
template <class Traits> auto texture_traits(const Traits& traits) {
  return Named_parameters<Traits, texture_traits_t>(traits);
}
template <class FaceChartMap> auto quad_chart_map(const FaceChartMap& map) {
  return Named_parameters<FaceChartMap, quad_chart_map_t>(map);
}
/// @}

/// Whether a list of named parameters has the one with this tag.
template <class Tag, class NamedParameters>
constexpr bool has_parameter =
    !std::is_same<decltype(CGAL::parameters::get_parameter(std::declval<const NamedParameters&>(), Tag())),
                  CGAL::internal_np::Param_not_found>::value;

/// The parameter with this tag, or the default.
template <class Tag, class NamedParameters, class Default>
auto parameter_or(const NamedParameters& np, const Default& value) {
  if constexpr (has_parameter<Tag, NamedParameters>)
    return CGAL::parameters::get_parameter(np, Tag());
  else
    return value;
}

} // namespace parameters
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PARAMETERS_H
