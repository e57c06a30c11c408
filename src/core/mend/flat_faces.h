// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_MEND_FLAT_FACES_H
#define REEBQUAD_MEND_FLAT_FACES_H

#include <CGAL/Reeb_quadrangulation/surface_check.h>

namespace CGAL {
namespace Reeb_quadrangulation {

struct Flat_face_counts {
  std::int64_t collapsed = 0; ///< edges without length
  std::int64_t flipped = 0;   ///< long edges of caps
  std::int64_t removed = 0;   ///< caps at a boundary
  std::int64_t kept = 0;      ///< faces that could not be removed
  bool any() const { return collapsed + flipped + removed + kept > 0; }
  Flat_face_counts& operator+=(const Flat_face_counts& other) {
    collapsed += other.collapsed;
    flipped += other.flipped;
    removed += other.removed;
    kept += other.kept;
    return *this;
  }
};

/// Removes the faces whose corners lie exactly on a line, without changing the set of points that the surface
/// covers nor its topology. `component.surface` is connected before; `connect()` is due afterwards. O(F) if
/// there are none.
Flat_face_counts remove_flat_faces(Mended_component& component);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_FLAT_FACES_H
