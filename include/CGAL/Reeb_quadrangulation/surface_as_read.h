// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SURFACE_AS_READ_H
#define CGAL_REEB_QUADRANGULATION_SURFACE_AS_READ_H

#include <CGAL/Reeb_quadrangulation/surface_check.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The polygons of a soup as triangles (a quad by the better diagonal, others by least area), nothing mended,
/// for `Certificate_input::as_read`. Only `points` and `triangles` are filled. Triangles that filled holes in
/// `mended` are added, for whoever asks for them wants them to be kept. O(n) for triangles.
Triangle_surface surface_as_read(const Polygon_soup& soup, const Mended_surface& mended = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SURFACE_AS_READ_H
