// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_SIZES_OUTPUT_H
#define REEBQUAD_CLI_SIZES_OUTPUT_H

#include <CGAL/Reeb_quadrangulation/sized_quads.h>

#include <nlohmann/json.hpp>

#include <string>

namespace reebquad {

/// How well sizes are met, for reports and for people.
nlohmann::ordered_json sizes_json(const CGAL::Reeb_quadrangulation::Size_report& report);
std::string sizes_text(const CGAL::Reeb_quadrangulation::Size_report& report);

} // namespace reebquad

#endif // REEBQUAD_CLI_SIZES_OUTPUT_H
