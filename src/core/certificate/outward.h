// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_OUTWARD_H
#define REEBQUAD_CERTIFICATE_OUTWARD_H

#include "certificate/geometry.h"
#include "certificate/input_surface.h"
#include "certificate/tree.h"

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// How one component of the quads faces, by the input's area near it.
struct Facing {
  double agreeing = 0, opposed = 0;
  double undecided = 0; ///< where quads that face the other way are about as near
  bool is_turned = false;
  bool is_known = false;
};

/// Compares the normals of samples of the input, at most about so many of each of its components, with those
/// of the nearest quads. A sample farther from these than they are large says nothing, nor does one that
/// quads of both sides are near to. A closed component of which a twentieth or less is decided that way is
/// judged by the sign of its volume and that of the input's component near it; if these are no larger than
/// rounding it stays unknown. `tree` is over the split quads.
std::vector<Facing> compare_facing(const Quad_mesh& mesh, const Soup_topology& topology,
                                   const Split_quads& split, const Triangle_tree& tree,
                                   const Input_surface& input, int per_component);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_OUTWARD_H
