// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_SHAPE_MEASURE_H
#define REEBQUAD_CERTIFICATE_SHAPE_MEASURE_H

#include "certificate/coverage.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// Measures all of `Shape_kept` but the counts of quads. `tree` is over the split quads. Nothing if the
/// observer cancels.
/// \pre neither side is empty
std::optional<Shape_kept> measure_shape(const Quad_mesh& mesh, const std::vector<char>& usable,
                                        const Split_quads& split, const Triangle_tree& tree,
                                        const Input_surface& input, const Certificate_options& options);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_SHAPE_MEASURE_H
