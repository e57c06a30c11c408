// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_MARKS_OUTPUT_H
#define REEBQUAD_CLI_MARKS_OUTPUT_H

#include <CGAL/Reeb_quadrangulation/kept_features.h>
#include <CGAL/Reeb_quadrangulation/marks.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace reebquad {

/// What became of marks on one component, and of the edges that are sharp there.
struct Marks_outcome {
  std::vector<CGAL::Reeb_quadrangulation::Kept_chain>
      chains;                  ///< of marked and sharp edges, without the boundary
  std::vector<char> is_closed; ///< one entry a chain
  std::vector<double> found;   ///< per mark, the part that the surface has

  /// Chains that edges of quads lie on from end to end, nearly.
  int kept_chains() const;
};

/// Measures quads against the marks of their surface. \pre `marked_features()` does not fail
Marks_outcome marks_outcome(const CGAL::Reeb_quadrangulation::Quad_mesh& mesh,
                            const CGAL::Reeb_quadrangulation::Triangle_surface& surface,
                            const CGAL::Reeb_quadrangulation::Marks& marks, double feature_angle);

nlohmann::ordered_json marks_json(const Marks_outcome& outcome);

/// Two sentences at most: how much is kept, and where the longest stretch is missed.
std::string marks_text(const Marks_outcome& outcome);

/// A sentence for marks of which less than 98 % are kept or that no component has, or nothing. `outcomes` are
/// those of all components.
std::string marks_warning(const std::vector<const Marks_outcome*>& outcomes,
                          const CGAL::Reeb_quadrangulation::Marks& marks);

} // namespace reebquad

#endif // REEBQUAD_CLI_MARKS_OUTPUT_H
