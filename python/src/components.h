// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of the points, edges and the whole of a mesh, dealt out to its components.
#ifndef REEBQUAD_PYTHON_COMPONENTS_H
#define REEBQUAD_PYTHON_COMPONENTS_H

#include "run.h"

namespace reebquad {
namespace python {

/// The options of each component: quads by area, placed extrema to the nearest component.
std::vector<CGAL::Reeb_quadrangulation::Quadrangulation_options>
deal(const CGAL::Reeb_quadrangulation::Quadrangulation_options& asked,
     const std::vector<CGAL::Reeb_quadrangulation::Mended_component>& components);

/// Adds the user's features to the options of the components that have them. Fails with `impossible_request`
/// where one is no edge
/// of any component.
CGAL::Reeb_quadrangulation::Result<void>
deal_features(const Request& request, const Polygon_soup& soup,
              const std::vector<CGAL::Reeb_quadrangulation::Mended_component>& components,
              std::vector<CGAL::Reeb_quadrangulation::Quadrangulation_options>& options);

/// The sizes at a component's vertices.
std::vector<double> sizes_of(const std::vector<double>& sizes, const Polygon_soup& soup,
                             const CGAL::Reeb_quadrangulation::Mended_component& component);

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_COMPONENTS_H
