// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_GUIDES_OUTPUT_H
#define REEBQUAD_CLI_GUIDES_OUTPUT_H

#include <CGAL/Reeb_quadrangulation/followed_guide.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace reebquad {

nlohmann::ordered_json guides_json(const std::vector<CGAL::Reeb_quadrangulation::Guide_outcome>& guides);

/// What became of guides, a line each; nothing without guides.
std::string guides_text(const std::vector<CGAL::Reeb_quadrangulation::Guide_outcome>& guides);

/// A sentence for guides that are not kept or too short to matter for quads with edges of this length, or
/// nothing.
std::string guides_warning(const std::vector<CGAL::Reeb_quadrangulation::Guide_outcome>& guides,
                           double edge_length);

} // namespace reebquad

#endif // REEBQUAD_CLI_GUIDES_OUTPUT_H
