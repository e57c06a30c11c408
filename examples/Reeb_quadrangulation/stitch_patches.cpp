// SPDX-License-Identifier: GPL-3.0-or-later
// One watertight mesh of patches of quads that were made separately and share no samples.
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/stitch_patches.h>

#include <cmath>
#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// A tube of n quads around that closes to a half of a torus; vertices and quads are appended.
void add_half(Quad_mesh& mesh, bool other, int n) {
  const int rows = 10, first = int(mesh.points.size());
  const double pi = std::acos(-1.0);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < n; ++i) {
      const double a = pi * (other + double(j) / rows), b = -2 * pi * i / n;
      mesh.points.emplace_back((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b));
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < n; ++i) {
      const int low = first + j * n, k = (i + 1) % n;
      mesh.quads.push_back({low + i, low + k, low + n + k, low + n + i});
    }
}

} // namespace

int main() {
  Quad_mesh patches;
  add_half(patches, false, 12);
  add_half(patches, true, 17);
  const Result<Stitched_patches> stitched = stitch_patches(patches);
  if (!stitched) {
    std::cerr << stitched.error().message << "\n";
    return 1;
  }
  std::cout << stitched->t_junctions << " T-junctions taken away, " << stitched->mesh.quads.size()
            << " quads, " << stitched->extraordinary.size() << " extraordinary vertices\n";
  return certify({stitched->mesh}).passed && stitched->t_junctions == 10 ? 0 : 1;
}
