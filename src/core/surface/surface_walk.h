// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SURFACE_SURFACE_WALK_H
#define REEBQUAD_SURFACE_SURFACE_WALK_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Calls `visit(w)` for every neighbour of `v`, counterclockwise, each once. \pre `v` has a face.
template <class Visit> void for_each_neighbor(const Triangle_surface& surface, int v, Visit visit) {
  const int first = surface.outgoing[v];
  int h = first;
  do {
    visit(surface.target(h));
    const int incoming = Triangle_surface::previous(h);
    h = surface.opposite[incoming];
    if (h < 0) visit(surface.source(incoming));
  } while (h >= 0 && h != first);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SURFACE_SURFACE_WALK_H
