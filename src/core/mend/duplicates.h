// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_MEND_DUPLICATES_H
#define REEBQUAD_MEND_DUPLICATES_H

#include "mend/loose_triangles.h"

namespace CGAL {
namespace Reeb_quadrangulation {

/// Of faces with the same corners the first is kept. Patches of such faces whose whole rim lies on edges of
/// two other, single faces are walls inside a surface and are dropped.
void drop_duplicate_faces(Loose_triangles& soup, std::vector<Mend>& mends);

/// Drops faces whose height is at most `height` and that hang on others: none of their edges has two faces,
/// and one has more.
void drop_flaps(Loose_triangles& soup, double height, std::vector<Mend>& mends);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_MEND_DUPLICATES_H
