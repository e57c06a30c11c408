// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_RELAX_DEFECTS_H
#define REEBQUAD_RELAX_DEFECTS_H

#include "relax/relax_state.h"

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

/// Per quad: how often it is inverted (nearly: a scaled Jacobian below 0.01) or meets another one.
std::vector<int> count_defects(const State& state);

/// The surroundings of quads with defects, by connected region.
struct Regions {
  std::vector<int> of_vertex; ///< the region of each vertex within `rings` quads of a defect; -1 elsewhere
  int count = 0;

  Regions(const State& state, const std::vector<int>& defects, int rings);
  std::vector<char> mask() const; ///< per vertex: whether it lies in one of them
  std::vector<int> sum(const State& state, const std::vector<int>& defects) const; ///< per region
};

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_RELAX_DEFECTS_H
