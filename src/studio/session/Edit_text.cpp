// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Edit_text.h"

#include <CGAL/Reeb_quadrangulation/Edit.h>

#include <algorithm>
#include <array>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

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
    Word{Suggest::edit_name, "suggest a design"},
    Word{Remove_extremum::edit_name, "delete extremum"},
    Word{Subdivide_chart::edit_name, "add contour"},
    Word{Set_target::edit_name, "set number"},
    Word{Set_columns::edit_name, "set number around"},
    Word{Set_rows::edit_name, "set number along"},
    Word{Add_dislocation::edit_name, "end columns"},
    Word{Balance_columns::edit_name, "balance numbers around"},
    Word{Remove_dislocation::edit_name, "let columns go on"},
    Word{Set_shift::edit_name, "twist chart"},
    Word{Set_grading::edit_name, "set density"},
    Word{Pin_corners::edit_name, "make regular"},
    Word{Move_corner::edit_name, "turn corners"},
    Word{Collapse_thin_charts::edit_name, "collapse thin charts"},
    Word{Drag_vertices::edit_name, "drag vertex"},
    Word{Snap_vertices::edit_name, "snap vertex"},
    Word{Relax_texture::edit_name, "smooth texture"},
    Word{Reset_texture::edit_name, "make texture regular"},
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
  const bool is_operator =
      *name == Edit_texture::edit_name && operation != edit.end() && operation->is_string();
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
