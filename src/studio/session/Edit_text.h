// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_EDIT_TEXT_H
#define REEBQUAD_SESSION_EDIT_TEXT_H

#include "view/Json.h"

namespace reebquad {
namespace studio {

/// An edit in the words of the history list: "subdivide chart", "set target (3000 quads)".
std::string edit_text(const Json& edit);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_EDIT_TEXT_H
