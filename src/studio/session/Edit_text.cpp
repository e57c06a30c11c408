// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Edit_text.h"

#include <algorithm>
#include <array>

namespace reebquad {
namespace studio {

namespace {

/// The members that are worth telling, and the words around them.
struct Told {
  const char* member;
  const char* before;
  const char* after;
};
constexpr std::array told{
    Told{"quads", ": ", " quads"}, Told{"columns", ": ", ""}, Told{"rows", ": ", ""},
    Told{"shift", ": ", ""},       Told{"ratio", ": ", ""},   Told{"kind", ": ", ""},
    Told{"value", ": ", ""},
};

std::string words(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) {
    std::string digits = value.dump();
    return digits.substr(0, digits.find('.') + 3);
  }
  return value.dump();
}

} // namespace

std::string edit_text(const Json& edit) {
  const auto name = edit.find("edit");
  if (name == edit.end() || !name->is_string()) return "edit";
  std::string text = *name;
  std::replace(text.begin(), text.end(), '_', ' ');
  if (text == "lock chart" && edit.value("locked", Json(true)) == false) text = "unlock chart";
  if (text == "add extremum" && edit.contains("maximum"))
    text = edit["maximum"] == true ? "add maximum" : "add minimum";
  for (const Told& t : told) {
    const auto member = edit.find(t.member);
    if (member != edit.end() && member->is_primitive() && *member != 0)
      text += t.before + words(*member) + t.after;
  }
  return text;
}

} // namespace studio
} // namespace reebquad
