// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_MIRROR_OUTPUT_H
#define REEBQUAD_CLI_MIRROR_OUTPUT_H

#include <CGAL/Reeb_quadrangulation/mirror_check.h>
#include <CGAL/Reeb_quadrangulation/mirror_quads.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace reebquad {

/// The three coordinates, as reports list them.
nlohmann::ordered_json coordinates(const CGAL::Reeb_quadrangulation::Point& p);

/// What `--mirror` takes: auto, x, y, z, -x, -y, -z or PX,PY,PZ,NX,NY,NZ. Nothing for none; a `Failure` for
/// anything else.
std::optional<CGAL::Reeb_quadrangulation::Mirror_request> mirror_request(const std::string& text);

/// Whether the quads are what was asked for: symmetric, and exactly so if their positions are those of a
/// reflection across an axis.
bool is_kept(const CGAL::Reeb_quadrangulation::Mirror_report& report,
             const CGAL::Reeb_quadrangulation::Mirror_check& check);

/// A line for people, ended by a line break.
std::string mirror_text(const CGAL::Reeb_quadrangulation::Mirror_report& report,
                        const CGAL::Reeb_quadrangulation::Mirror_check& check);

/// As doc/Reeb_quadrangulation/report_schema.md describes it.
nlohmann::ordered_json mirror_json(const CGAL::Reeb_quadrangulation::Mirror_report& report,
                                   const CGAL::Reeb_quadrangulation::Mirror_check& check);

} // namespace reebquad

#endif // REEBQUAD_CLI_MIRROR_OUTPUT_H
