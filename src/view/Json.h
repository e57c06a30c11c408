// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_JSON_H
#define REEBQUAD_VIEW_JSON_H

#include <nlohmann/json.hpp>

namespace reebquad {
namespace studio {

using Json = nlohmann::json;

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_JSON_H
