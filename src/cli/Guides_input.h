// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_GUIDES_INPUT_H
#define REEBQUAD_CLI_GUIDES_INPUT_H

#include "Command.h"

#include <CGAL/Reeb_quadrangulation/Guide.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <string>
#include <vector>

namespace reebquad {

/// Declares --guides.
void declare_guides(Command_line& line);

/// Reads the guides of a file; a `Failure` says what is wrong with it. `mesh` has the points that the file
/// may number.
std::vector<CGAL::Reeb_quadrangulation::Guide>
read_guides(const std::string& file, const CGAL::Reeb_quadrangulation::Polygon_soup& mesh);

/// Guides from a text: JSON, {"guides": [{"points": [[x, y, z], ...], "closed": true, ...}, ...]} with the
/// fields of `Add_guide`, and "vertices" with numbers of points of the mesh, from 0, in place of "points";
/// or the lines of an OBJ file, each a guide of strength 1, closed if it ends where it begins.
CGAL::Reeb_quadrangulation::Result<std::vector<CGAL::Reeb_quadrangulation::Guide>>
parse_guides(const std::string& text, const CGAL::Reeb_quadrangulation::Polygon_soup& mesh);

} // namespace reebquad

#endif // REEBQUAD_CLI_GUIDES_INPUT_H
