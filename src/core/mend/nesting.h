// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_MEND_NESTING_H
#define REEBQUAD_MEND_NESTING_H

#include <CGAL/Reeb_quadrangulation/surface_check.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Whether `surface` has no boundary. \pre it is connected by `connect()`.
bool is_closed(const Triangle_surface& surface);

/// The volume that a closed surface encloses, negative if it faces inward.
double signed_volume(const Triangle_surface& surface);

/// For each component in how many others it lies; 0 for components that are open. A component lies in
/// another if its box does, and all of a few of its vertices that do not touch the other.
std::vector<int> nesting_depths(const std::vector<Mended_component>& components);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_NESTING_H
