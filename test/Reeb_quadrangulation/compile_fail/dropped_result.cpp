// SPDX-License-Identifier: GPL-3.0-or-later
// fails with: nodiscard
// A failure that nobody looks at.
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

namespace RQ = CGAL::Reeb_quadrangulation;

bool is_surface(RQ::Triangle_surface& surface) {
#ifdef REEBQUAD_LEAVE_OUT
  surface.connect();
  return true;
#else
  return bool(surface.connect());
#endif
}
