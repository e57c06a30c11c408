// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_DOMAIN_MIRROR_REPORT_H
#define REEBQUAD_DOMAIN_MIRROR_REPORT_H

#include <CGAL/Reeb_quadrangulation/mirror_quads.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What is told of a mirrored design.
inline Mirror_report mirror_report(const Mirror& mirror, const Mirror_deviation& deviation,
                                   const Mirrored_design& design) {
  return {mirror, deviation, design.image, design.on_plane, design.ring_quads, design.largest_shift};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DOMAIN_MIRROR_REPORT_H
