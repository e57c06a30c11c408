// SPDX-License-Identifier: GPL-3.0-or-later
#include "Edit_text.h"

#include <algorithm>

namespace reebquad {
namespace studio {

std::string edit_text(const Json& edit) {
  const auto name = edit.find("edit");
  if (name == edit.end() || !name->is_string()) return "edit";
  std::string text = *name;
  std::replace(text.begin(), text.end(), '_', ' ');
  for (const auto& [key, value] : edit.items())
    if (key != "edit" && (value.is_number() || value.is_string() || value.is_boolean()))
      text += ", " + key + " " + (value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

} // namespace studio
} // namespace reebquad
