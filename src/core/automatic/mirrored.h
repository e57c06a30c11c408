// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_AUTOMATIC_MIRRORED_H
#define REEBQUAD_AUTOMATIC_MIRRORED_H

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// `quadrangulate()` of the half of a symmetric surface, doubled. \pre `options.mirror`
Result<Quadrangulation> quadrangulate_mirrored(const Triangle_surface& surface,
                                               const Quadrangulation_options& options, Observer* observer);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_AUTOMATIC_MIRRORED_H
