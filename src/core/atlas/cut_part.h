// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_ATLAS_CUT_PART_H
#define REEBQUAD_ATLAS_CUT_PART_H

#include <CGAL/Reeb_quadrangulation/Atlas.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// As `cut_region()` without extrema, for a field that has one value on all walks of a side: edges between
/// two of them are split too, so that none is level.
Result<Chart> cut_part(const Embedding& embedding, const Contour_network& network, int face);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_ATLAS_CUT_PART_H
