// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_REFUSAL_H
#define REEBQUAD_BASE_REFUSAL_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The refusal of an edit: `reason` is one of few sentences, so that refusals can be counted; `details`
/// follow it.
Error refuse(const std::string& reason, const std::string& details = {},
             Element_kind element = Element_kind::none, int index = -1);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_REFUSAL_H
