// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_AUTOMATIC_COARSE_COPY_H
#define REEBQUAD_AUTOMATIC_COARSE_COPY_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A surface of the same shape and topology with about so many triangles: the dual of the patches of
/// `decimate()`. Finer where a coarser one would have another topology; nothing if it would have more than a
/// third of the surface's triangles. O(V) for each attempt. \pre `surface` is connected by `connect()`.
std::optional<Triangle_surface> coarse_copy(const Triangle_surface& surface, int triangles);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_AUTOMATIC_COARSE_COPY_H
