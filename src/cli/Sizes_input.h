// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_SIZES_INPUT_H
#define REEBQUAD_CLI_SIZES_INPUT_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/Result.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <string>
#include <vector>

namespace reebquad {

/// Sizes at the points of a mesh, which need not be the one that they are for.
struct Given_sizes {
  CGAL::Reeb_quadrangulation::Triangle_surface surface; ///< only points and triangles
  std::vector<double> sizes;                            ///< one for each point

  /// At the vertices of a surface: those of the nearest points, linear in triangles.
  std::vector<double> on(const CGAL::Reeb_quadrangulation::Triangle_surface& other) const;
};

/// Reads sizes: a text with one number for each point of `mesh`, or a PLY file with the property `size` (else
/// `quality`) of its points. A `Failure` names the line, or says what is missing.
Given_sizes read_sizes(const std::string& file, const CGAL::Reeb_quadrangulation::Polygon_soup& mesh);

/// Sizes from such a text or file.
CGAL::Reeb_quadrangulation::Result<Given_sizes>
parse_sizes(const std::string& text, const CGAL::Reeb_quadrangulation::Polygon_soup& mesh);

} // namespace reebquad

#endif // REEBQUAD_CLI_SIZES_INPUT_H
