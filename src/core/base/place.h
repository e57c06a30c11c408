// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_PLACE_H
#define REEBQUAD_BASE_PLACE_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <cstdio>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A point as sentences tell it.
inline std::string place(const Point& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.4g, %.4g, %.4g)", p.x(), p.y(), p.z());
  return text;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_PLACE_H
