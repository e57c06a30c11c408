// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_ATTRIBUTES_H
#define REEBQUAD_CLI_ATTRIBUTES_H

#include "Run.h"

#include <CGAL/Reeb_quadrangulation/IO/mesh_attributes.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <string>
#include <vector>

namespace reebquad {

/// A mesh as it was read, with what its file tells beside the surface.
struct Attributed_soup {
  CGAL::Reeb_quadrangulation::Polygon_soup soup;
  CGAL::Reeb_quadrangulation::Mesh_attributes attributes;
};

/// Reads a mesh file as `read_soup()` does.
Attributed_soup read_attributed_soup(const std::string& file, std::vector<std::string>* notes);

/// Gives the quads of the components, one after the other, their charts: as names, and as texture
/// coordinates in which each chart fills a square of its own, instead of those that there are.
void add_charts(const std::vector<Component_run>& components,
                CGAL::Reeb_quadrangulation::Mesh_attributes& attributes);

/// Writes quads with attributes. Prints warnings and, unless it is `quiet`, one line of what was dropped.
void write_quads(const std::string& file, const CGAL::Reeb_quadrangulation::Polygon_soup& quads,
                 const CGAL::Reeb_quadrangulation::Mesh_attributes& attributes, bool quiet);

} // namespace reebquad

#endif // REEBQUAD_CLI_ATTRIBUTES_H
