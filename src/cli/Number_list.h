// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_NUMBER_LIST_H
#define REEBQUAD_CLI_NUMBER_LIST_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <optional>
#include <string>

namespace reebquad {

/// Three finite numbers separated by `separator` (a blank stands for any white space) and nothing else.
std::optional<CGAL::Reeb_quadrangulation::Point> parse_point(std::string text, char separator);

} // namespace reebquad

#endif // REEBQUAD_CLI_NUMBER_LIST_H
