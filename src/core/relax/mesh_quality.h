// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_RELAX_MESH_QUALITY_H
#define REEBQUAD_RELAX_MESH_QUALITY_H

#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

/// The scaled Jacobians of all quads, and how many of them are not positive.
struct Mesh_quality {
  double worst = 1, mean = 0;
  int inverted = 0;
};

inline Mesh_quality mesh_quality(const Quad_mesh& mesh) {
  Mesh_quality result;
  for (const Quad& q : mesh.quads) {
    const double s =
        scaled_jacobian(mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]);
    result.worst = std::min(result.worst, s);
    result.mean += s;
    result.inverted += s <= 0;
  }
  if (!mesh.quads.empty()) result.mean /= double(mesh.quads.size());
  return result;
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_RELAX_MESH_QUALITY_H
