// SPDX-License-Identifier: GPL-3.0-or-later
// fails with: convert|no matching
// A chart and a contour edge that have changed places.
#include <CGAL/Reeb_quadrangulation/Atlas.h>

namespace RQ = CGAL::Reeb_quadrangulation;

int across(const RQ::Atlas& atlas, RQ::Contour_id edge, RQ::Chart_index chart) {
#ifdef REEBQUAD_LEAVE_OUT
  return RQ::chart_across(atlas, chart, edge);
#else
  return RQ::chart_across(atlas, edge, chart);
#endif
}
