// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Bounded_json.h"

namespace reebquad {
namespace studio {

Json parse_bounded(std::string_view text, int deepest, bool* too_deep) {
  bool is_deep = false;
  const Json::parser_callback_t watch = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest) is_deep = true;
    return !is_deep;
  };
  Json value = Json::parse(text.begin(), text.end(), watch, false);
  if (too_deep) *too_deep = is_deep;
  return is_deep ? Json(Json::value_t::discarded) : value;
}

} // namespace studio
} // namespace reebquad
