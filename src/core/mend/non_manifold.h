// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_MEND_NON_MANIFOLD_H
#define REEBQUAD_MEND_NON_MANIFOLD_H

#include "mend/corners.h"
#include "mend/loose_triangles.h"

namespace CGAL {
namespace Reeb_quadrangulation {

struct Edge_cuts {
  std::int64_t solids = 0; ///< edges cut so that solids come apart
  std::int64_t sheets = 0; ///< edges cut so that sheets come apart
};

/// Divides each group of more than two sides into pairs that stay neighbours and single sides.
///
/// Where as many faces run through the edge one way as the other, the two faces of each wedge of solid are
/// a pair: solids that touch along the edge come apart. Otherwise faces of one patch (connected elsewhere)
/// are paired, then the flattest, if they bend by less than 45 degrees: a fin comes off what it stands on.
Edge_cuts cut_edges(const Loose_triangles& soup, const Corner_mesh& mesh, Edge_groups& edges);

/// Cut edges whose parts would still share both ends, because the cut ends at them, get points in their
/// middles, one for each part; `fan` holds the fan of each corner. Whether there were any: then all is to
/// be looked at anew.
bool divide_cut_edges(Loose_triangles& soup, const Corner_mesh& mesh, const Edge_groups& edges,
                      const std::vector<int>& fan);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_NON_MANIFOLD_H
