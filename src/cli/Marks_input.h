// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_MARKS_INPUT_H
#define REEBQUAD_CLI_MARKS_INPUT_H

#include "Command.h"

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/marks.h>

#include <optional>
#include <string>

namespace reebquad {

struct Attributed_soup;
struct Text_line;

/// Where the marks of a command come from.
struct Marks_request {
  std::string file;    ///< empty: none
  bool groups = false; ///< the borders of groups and materials of the mesh file
  bool seams = false;  ///< its seams of texture coordinates
  bool any() const { return !file.empty() || groups || seams; }
};

/// Declares --marks, --mark-groups and --mark-seams.
void declare_marks(Command_line& line);

/// What the user asks for with these.
Marks_request marks_request(const Command_line& line);

/// Reads marks: of a text with lines 'mark A B' and 'unmark A B', or of the lines of an OBJ file. A `Failure`
/// names the line that cannot be read. `mesh` is the file `input` as it was read, whose points the lines
/// of a text number.
CGAL::Reeb_quadrangulation::Marks read_marks(const Marks_request& request, const std::string& input,
                                             const Attributed_soup& mesh);

/// Marks from such a text, or from the lines of an OBJ text.
CGAL::Reeb_quadrangulation::Result<CGAL::Reeb_quadrangulation::Marks>
parse_marks(const std::string& text, const CGAL::Reeb_quadrangulation::Polygon_soup& soup);

/// The polylines of an OBJ text: its own points, and lines through these.
CGAL::Reeb_quadrangulation::Result<std::vector<std::vector<CGAL::Reeb_quadrangulation::Point>>>
polylines_of_obj(const std::vector<Text_line>& lines);

/// The edges of polygons between two groups, objects or materials, or with texture coordinates that differ on
/// their two sides. Fails with `unsupported_format` where the mesh has nothing of the kind.
CGAL::Reeb_quadrangulation::Result<std::vector<CGAL::Reeb_quadrangulation::Mark>>
borders_of_attributes(const Attributed_soup& mesh, bool groups, bool seams);

} // namespace reebquad

#endif // REEBQUAD_CLI_MARKS_INPUT_H
