// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_HINTS_H
#define CGAL_REEB_QUADRANGULATION_IO_HINTS_H

#include <CGAL/Reeb_quadrangulation/suggest_edits.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Hints as a JSON array: [{"kind": "uncovered_limb", "reason": "...", "place": [x, y, z], "before": 5.3,
/// "after": 0.4, "edit": {"edit": "add_extremum", ...}}], the edits as recipes have them.
std::string to_json(const std::vector<Hint>& hints);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_HINTS_H
