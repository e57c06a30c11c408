// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_COMBINE_PARAMETERS_H
#define CGAL_REEB_QUADRANGULATION_COMBINE_PARAMETERS_H

#include <CGAL/Reeb_quadrangulation/parameters.h>

#include <type_traits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace parameters {

namespace internal {

// The parameters of `more` behind those of `chain`, the first given first.
template <class Chain, class T, class Tag, class Base>
auto appended(const Chain& chain, const CGAL::Named_function_parameters<T, Tag, Base>& more) {
  const auto earlier = [&] {
    if constexpr (std::is_same<Base, CGAL::internal_np::No_property>::value)
      return chain;
    else
      return appended(chain, static_cast<const Base&>(more));
  }();
  if constexpr (std::is_same<Tag, CGAL::internal_np::all_default_t>::value)
    return earlier;
  else
    return earlier.template with<Tag>(CGAL::parameters::get_parameter(more, Tag()));
}

template <class Chain> Chain joined(const Chain& chain) {
  return chain;
}

template <class Chain, class First, class... Others>
auto joined(const Chain& chain, const First& first, const Others&... others) {
  return joined(appended(chain, first), others...);
}

} // namespace internal

/// The parameters of several chains, CGAL's or ours, as one chain that can be continued:
/// `combine(CGAL::parameters::vertex_point_map(points).geom_traits(kernel)).number_of_quads(2000)`. Of a word
/// that is given twice the last one counts.
template <class... Chains> auto combine(const Chains&... chains) {
  return internal::joined(default_values(), chains...);
}

} // namespace parameters
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_COMBINE_PARAMETERS_H
