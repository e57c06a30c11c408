// SPDX-License-Identifier: GPL-3.0-or-later
// The one place that knows which CGAL it is compiled with: 5.5 (Debian 12) or 6.x.
#ifndef REEBQUAD_BASE_COMPATIBILITY_H
#define REEBQUAD_BASE_COMPATIBILITY_H

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#endif

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Traits and primitives of a CGAL::AABB_tree; CGAL 6 renamed them.
#if CGAL_VERSION_NR >= 1060000000
template <class Kernel, class Primitive, class Box_map = CGAL::Default>
using Aabb_traits = CGAL::AABB_traits_3<Kernel, Primitive, Box_map>;
template <class Kernel, class Iterator>
using Aabb_segment_primitive = CGAL::AABB_segment_primitive_3<Kernel, Iterator>;
#else
template <class Kernel, class Primitive, class Box_map = CGAL::Default>
using Aabb_traits = CGAL::AABB_traits<Kernel, Primitive, Box_map>;
template <class Kernel, class Iterator>
using Aabb_segment_primitive = CGAL::AABB_segment_primitive<Kernel, Iterator>;
#endif

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_COMPATIBILITY_H
