// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_RECIPE_H
#define CGAL_REEB_QUADRANGULATION_IO_RECIPE_H

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/find_mirror_planes.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A design as the list of edits that lead to it. Applied to the same surface it gives the same bytes; on
/// another triangulation of the same shape, the same design.
struct Recipe {
  Editor_options options; ///< without the number of threads
  /// Of a file with several connected components, the one that the design is for, counted from 1 in the order
  /// of `mend_surface()`; 0: the file has one only.
  int component = 0;
  /// The largest number of edges of the holes that are filled first, see `Mend_options::fill_holes`; 0: none
  /// are.
  int fill_holes = 0;
  /// If there is a mirror: the design is one of the half on the side of its plane that the normal points to,
  /// see `halve_surface()`, and its finished quads are doubled by `mirror_design()`. So every edit is made on
  /// both sides, and `Editor_options::quads` counts those of one.
  std::optional<Mirror> mirror{};
  std::vector<Edit> edits;
  /// How the quads of the design become the result. Kept are `relax`, the angle and the lines of `features`,
  /// the ratio and the number of quads of `adaptive`, and the marks.
  Finish_options finish;
};

/// The text of a recipe: JSON, as doc/Reeb_quadrangulation/recipes.md describes it. Numbers have 17 digits,
/// so that it is read back to the same values. Fields that have their defaults are written too.
std::string to_json(const Recipe& recipe);

/// Reads a recipe. Fails with `malformed_file`, naming the line or the edit, where the text is not JSON, the
/// format or version is another one, an edit or a field is unknown, a field is missing or of the wrong type,
/// or a number is not finite.
Result<Recipe> recipe_from_json(const std::string& text);

/// One edit as a JSON object: {"edit": "subdivide_chart", "at": {"point": [x, y, z], "vertex": 17}}.
std::string to_json(const Edit& edit);
Result<Edit> edit_from_json(const std::string& text);

/// The name that recipes have for it.
const char* name(Pole_kind kind);

/// The recipe of a session up to its present state, with the usual finish.
Recipe recipe_of(const Editor& editor);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_RECIPE_H
