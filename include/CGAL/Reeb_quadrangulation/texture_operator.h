// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_TEXTURE_OPERATOR_H
#define CGAL_REEB_QUADRANGULATION_TEXTURE_OPERATOR_H

#include <CGAL/Reeb_quadrangulation/Edit.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The edit of a texture that an edit of a design stands for, whose points lie at `places` of the texture:
/// one for each. Fails with `impossible_request` if the number of points, the fraction or the scope is not
/// one of the operator.
Result<Texture_edit> texture_operator(const Edit_texture& edit, const std::vector<Texture_place>& places);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_TEXTURE_OPERATOR_H
