// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_BOUNDED_JSON_H
#define REEBQUAD_VIEW_BOUNDED_JSON_H

#include "view/Json.h"

#include <string_view>

namespace reebquad {
namespace studio {

/// Parses text that may come from anyone: `discarded` where it is not JSON, or lists and objects are nested
/// deeper than `deepest`, which functions that walk through it would pay with the stack. `too_deep` tells
/// which.
Json parse_bounded(std::string_view text, int deepest, bool* too_deep = nullptr);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_BOUNDED_JSON_H
