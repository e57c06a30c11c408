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

/// Edits and operators of textures whose words in the page are not their names.
struct Word {
  const char* name;
  const char* word;
};
constexpr std::array renamed{
    Word{"suggest", "suggest a design"},
    Word{"remove_extremum", "delete extremum"},
    Word{"subdivide_chart", "add contour"},
    Word{"set_target", "set number"},
    Word{"set_columns", "set number around"},
    Word{"set_rows", "set number along"},
    Word{"set_shift", "twist chart"},
    Word{"set_grading", "set density"},
    Word{"pin_corners", "make regular"},
    Word{"move_corner", "turn corners"},
    Word{"collapse_thin_charts", "collapse thin charts"},
    Word{"drag_vertices", "drag vertex"},
    Word{"snap_vertices", "snap vertex"},
    Word{"relax_texture", "smooth texture"},
    Word{"reset_texture", "make texture regular"},
    Word{"subdivide", "refine texture"},
    Word{"coarsen", "coarsen texture"},
    Word{"insert_polychord", "insert strip"},
    Word{"delete_polychord", "delete strip"},
    Word{"inset_quads", "inset quad"},
    Word{"rotate_edge", "turn edge left"},
    Word{"rotate_edge_back", "turn edge right"},
    Word{"rotate_vertex", "turn vertex"},
    Word{"insert_doublet", "add doublet"},
    Word{"delete_quads", "make hole"},
    Word{"restore_quads", "fill hole"},
};

std::string in_words(const std::string& name) {
  for (const Word& each : renamed)
    if (name == each.name) return each.word;
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

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
  const auto operation = edit.find("operator");
  const bool is_operator = *name == "edit_texture" && operation != edit.end() && operation->is_string();
  std::string text = in_words(is_operator ? *operation : *name);
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
