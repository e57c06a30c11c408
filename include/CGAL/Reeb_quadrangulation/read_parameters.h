// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_READ_PARAMETERS_H
#define CGAL_REEB_QUADRANGULATION_READ_PARAMETERS_H

#include <CGAL/Reeb_quadrangulation/parameters.h>

#include <CGAL/boost/graph/properties.h>

#include <type_traits>

/// \file
/// How a function takes named parameters: it asks for those that it reads and refuses, when it is compiled,
/// all others.

namespace CGAL {
namespace Reeb_quadrangulation {
namespace parameters {

/// Whether a chain has the parameter with this tag.
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

/// The points of a graph's vertices. The graph need not have any of its own where a map is given.
template <class NamedParameters, class Graph> auto vertex_points(const NamedParameters& np, Graph& graph) {
  if constexpr (has_parameter<CGAL::internal_np::vertex_point_t, NamedParameters>)
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point_t());
  else
    return get(CGAL::vertex_point, graph);
}

/// The observer, or null.
template <class NamedParameters> Observer* observer_of(const NamedParameters& np) {
  return parameter_or<observer_t>(np, static_cast<Observer*>(nullptr));
}

/// Tags of the parameters that a function reads.
template <class... Tags> struct Tag_list {};

/// The tags of both lists.
template <class... A, class... B> constexpr Tag_list<A..., B...> operator+(Tag_list<A...>, Tag_list<B...>) {
  return {};
}

/// The parameters that tell where the vertices of a mesh are.
using Point_tags = Tag_list<CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t>;

/// And those that tell which of its edges and vertices are to be kept.
using Feature_tags = Tag_list<CGAL::internal_np::edge_is_constrained_t,
                              CGAL::internal_np::vertex_is_constrained_t, CGAL::internal_np::face_patch_t>;

namespace internal {

// The compiler names the tag where it says that the assertion failed.
template <class Tag, bool is_read> struct Named_parameter {
  static_assert(is_read, "a named parameter that this function does not read");
  static constexpr bool value = is_read;
};

template <class... Read>
constexpr bool all_are_read(Tag_list<Read...>, const CGAL::internal_np::No_property*) {
  return true;
}

template <class... Read, class T, class Tag, class Base>
constexpr bool all_are_read(Tag_list<Read...> list, const CGAL::Named_function_parameters<T, Tag, Base>*) {
  constexpr bool is_read =
      std::is_same<Tag, CGAL::internal_np::all_default_t>::value || (std::is_same<Tag, Read>::value || ...);
  return Named_parameter<Tag, is_read>::value && all_are_read(list, static_cast<const Base*>(nullptr));
}

} // namespace internal

/// Does not compile if a chain has a parameter whose tag is not in the list:
/// `static_assert(reads_all<NamedParameters>(Tags()))`.
template <class NamedParameters, class... Read> constexpr bool reads_all(Tag_list<Read...> list) {
  return internal::all_are_read(list, static_cast<const NamedParameters*>(nullptr));
}

} // namespace parameters
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_READ_PARAMETERS_H
