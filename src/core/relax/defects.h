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

/// Takes vertices back to the snapshot around quads that have more defects than `before`: up to so many
/// times, each time with more around them, and then all. Returns the defects that are left.
std::vector<int> without_new_defects(State& state, const State::Snapshot& snapshot,
                                     const std::vector<int>& before, int times);

/// Marks the vertices within so many rings of quads around those that are marked, too.
void add_rings(const Quad_mesh& mesh, int rings, std::vector<char>& mask);

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
