// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/geometry.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

Split_quads split_quads(const Quad_mesh& mesh, const std::vector<char>& usable) {
  Split_quads result;
  result.triangles.reserve(2 * mesh.quads.size());
  result.quad.reserve(2 * mesh.quads.size());
  for (int q = 0; q < int(mesh.quads.size()); ++q) {
    if (!usable[q]) continue;
    const Quad_corners p = corners(mesh, q);
    if (!is_finite(p)) continue;
    const Quad& v = mesh.quads[q];
    const double even = (p[2] - p[0]).squaredNorm(), odd = (p[3] - p[1]).squaredNorm();
    const bool at_even = even != odd ? even < odd : std::min(v[0], v[2]) < std::min(v[1], v[3]);
    const int s = at_even ? 0 : 1; // the diagonal runs from corner s to corner s + 2
    result.triangles.push_back({v[s], v[s + 1], v[s + 2]});
    result.triangles.push_back({v[s], v[s + 2], v[(s + 3) % 4]});
    result.quad.insert(result.quad.end(), 2, q);
  }
  return result;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
