// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_QUAD_PARAMETERS_H
#define CGAL_REEB_QUADRANGULATION_QUAD_PARAMETERS_H

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The (V, U) of the four corners of a quad in the parameter domain of its chart, in the order of its
/// vertices.
using Quad_parameters = std::array<Eigen::Vector2d, 4>;

/// The parameters of each quad of a run, as its chart's texture has them: U from 0 to 1 up an annulus and V
/// around it, 1 a turn, unwrapped, so that a quad that steps over V = 1 has corners beyond it; of a disc, V
/// in [0, a] and U in [0, b]. Corners at the same vertex agree within a chart, but for whole turns, and
/// differ between charts. O(quads). Fails with `impossible_request` if quads were subdivided or split, since
/// those have no place in a texture.
Result<std::vector<Quad_parameters>> quad_parameters(const Quadrangulation& quads);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_QUAD_PARAMETERS_H
