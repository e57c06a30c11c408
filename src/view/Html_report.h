// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_HTML_REPORT_H
#define REEBQUAD_VIEW_HTML_REPORT_H

#include "view/Layers.h"

#include <CGAL/Reeb_quadrangulation/Result.h>

namespace reebquad {
namespace studio {

/// What a report shows: words and numbers, and the geometry of each connected part.
struct Html_report {
  std::string title; ///< the mesh file's name
  /// Members of the report of a run, as doc/Reeb_quadrangulation/run_report.md describes it, as far as they
  /// are known: `version`, `input`, `mends`, `components`, `certificate`, `statistics`, `stages`; and
  /// `edits`: `text`, `milliseconds` of each.
  Json facts = Json::object();
  std::vector<Layers> parts; ///< all with the same origin
};

/// One file that shows the report in any browser, without a network and without this program: the viewer, the
/// facts, and the layers as base64 of the studio's binary messages. A part's surface, field and charts are
/// left out where they would take more than 8 MB. Fails with `impossible_request` if the program was built
/// without the page of the studio. O(size of the layers).
CGAL::Reeb_quadrangulation::Result<std::string> html_text(const Html_report& report);

/// RFC 4648, section 4.
std::string base64(const std::string& bytes);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_HTML_REPORT_H
