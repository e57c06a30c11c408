// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/surface_intersections.h>

#include "certificate/input_surface.h"
#include "certificate/intersections.h"
#include "certificate/tree.h"

namespace CGAL {
namespace Reeb_quadrangulation {

Surface_intersections surface_intersections(const Triangle_surface& surface, int most,
                                            const Observer* observer) {
  using namespace certification;
  const Input_surface input = read_input(surface);
  const Triangle_tree tree(input.points(), input.triangles);
  Surface_intersections result;
  const auto pairs = intersecting_triangles(input.points(), input.triangles, tree, most, observer);
  result.is_complete = pairs && int(pairs->size()) < most;
  if (!pairs) return result;
  const auto component = [&](int t) { return input.topology.component[input.triangles[t][0]]; };
  for (const auto& [s, t] : *pairs) {
    ++(component(s) == component(t) ? result.within : result.between);
    result.pairs.emplace_back(input.index[s], input.index[t]);
  }
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
