// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_INPUT_H
#define REEBQUAD_CLI_INPUT_H

#include "Command.h"

#include <CGAL/Reeb_quadrangulation/IO/mesh_attributes.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <string>
#include <vector>

namespace reebquad {

/// Declares --fill-holes, --hole-edges, --weld, --drop-components-below and --refuse-non-manifold.
void declare_mending(Command_line& line);
CGAL::Reeb_quadrangulation::Mend_options mending(const Command_line& line);

/// Throws a usage error unless the extension of `file` names a format that we write.
void require_writable_format(const std::string& file);

/// Reads a mesh file; a `Failure` names file and line or byte. What was passed over is appended to `notes`,
/// or printed as warnings if there are none. What the file tells beside the surface goes into `attributes`,
/// unless that is null.
CGAL::Reeb_quadrangulation::Polygon_soup
read_soup(const std::string& file, std::vector<std::string>* notes = nullptr,
          CGAL::Reeb_quadrangulation::Mesh_attributes* attributes = nullptr);

/// The quads of a soup; a `Failure` names the first face that is not a quad.
CGAL::Reeb_quadrangulation::Quad_mesh quads_of(const CGAL::Reeb_quadrangulation::Polygon_soup& soup,
                                               const std::string& file);

/// All components as one surface (points and triangles only), in their order.
CGAL::Reeb_quadrangulation::Triangle_surface joined(const CGAL::Reeb_quadrangulation::Mended_surface& mended);

} // namespace reebquad

#endif // REEBQUAD_CLI_INPUT_H
