// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_DESIGN_POLE_TEXTURE_H
#define REEBQUAD_DESIGN_POLE_TEXTURE_H

#include <CGAL/Reeb_quadrangulation/Design.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The texture of a disc with a whole pole: rings around the middle, the last vertex, whose fan stands as a
/// hole of half as many quads.
Quad_texture pole_texture(int a, int b, bool clockwise);

/// Whether the quads of a design leave a hole that a fan fills at every whole pole whose texture the user has
/// not edited.
bool has_all_fans(const Design& design, const Stitched_mesh& quads);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DESIGN_POLE_TEXTURE_H
