// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/internal/quad_connectivity.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

int connect_quads(const std::vector<Quad>& quads, int number_of_vertices, std::vector<int>& opposite) {
  // The halfedges that leave each vertex, in the order of their quads.
  std::vector<int> begin(number_of_vertices + 1, 0), leaving(4 * quads.size());
  for (const Quad& q : quads)
    for (int v : q) ++begin[v + 1];
  for (int v = 0; v < number_of_vertices; ++v) begin[v + 1] += begin[v];
  std::vector<int> end(begin.begin(), begin.end() - 1);
  for (int h = 0; h < int(leaving.size()); ++h) leaving[end[source(quads, h)]++] = h;

  opposite.assign(leaving.size(), -1);
  for (int h = 0; h < int(leaving.size()); ++h) {
    const int a = source(quads, h), b = target(quads, h);
    if (a == b) return quad_of(h);
    for (int k = begin[a]; k < begin[a + 1]; ++k)
      if (leaving[k] != h && target(quads, leaving[k]) == b) return quad_of(h);
    for (int k = begin[b]; k < begin[b + 1]; ++k)
      if (target(quads, leaving[k]) == a) opposite[h] = leaving[k];
  }
  return -1;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
