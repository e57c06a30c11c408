// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SURFACE_POINT_H
#define CGAL_REEB_QUADRANGULATION_SURFACE_POINT_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A point on the surface. `vertex` is a hint: it is taken if it is a vertex at exactly this point; else the
/// nearest one is.
struct Surface_point {
  Point point = Point::Zero();
  int vertex = -1;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SURFACE_POINT_H
