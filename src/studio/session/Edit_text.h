// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_EDIT_TEXT_H
#define REEBQUAD_SESSION_EDIT_TEXT_H

#include "view/Json.h"

namespace reebquad {
namespace studio {

/// An edit in the words of the page's tools and lists: "add contour", "set number: 3000 quads", "insert
/// strip".
std::string edit_text(const Json& edit);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_EDIT_TEXT_H
