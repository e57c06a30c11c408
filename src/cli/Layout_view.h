// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_LAYOUT_VIEW_H
#define REEBQUAD_CLI_LAYOUT_VIEW_H

#include <CGAL/Reeb_quadrangulation/Editor.h>

#include "view/Layers.h"

namespace reebquad {

/// A session's design as pictures show it: on the surface with its contours cut in. It refers to the session.
/// \pre The design has charts.
struct Layout_view {
  explicit Layout_view(const CGAL::Reeb_quadrangulation::Editor& editor);
  Layout_view(const Layout_view&) = delete;
  Layout_view& operator=(const Layout_view&) = delete;

  CGAL::Reeb_quadrangulation::Embedded_design embedded;
  CGAL::Reeb_quadrangulation::Reeb_graph graph;
  std::vector<double> values; ///< the field; vertices that contours added have their contour's value
  studio::Charted_surface charted;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_LAYOUT_VIEW_H
