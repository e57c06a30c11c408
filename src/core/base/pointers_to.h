// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_POINTERS_TO_H
#define REEBQUAD_BASE_POINTERS_TO_H

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The addresses of a vector's elements, valid as long as it does not change.
template <class T> std::vector<const T*> pointers_to(const std::vector<T>& values) {
  std::vector<const T*> pointers;
  pointers.reserve(values.size());
  for (const T& value : values) pointers.push_back(&value);
  return pointers;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_POINTERS_TO_H
