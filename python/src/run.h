// SPDX-License-Identifier: GPL-3.0-or-later
// From points and faces to certified quads, as `reebquad run` makes them of a file.
#ifndef REEBQUAD_PYTHON_RUN_H
#define REEBQUAD_PYTHON_RUN_H

#include "Python_observer.h"

#include "arrays.h"

#include "Run.h"

#include <array>
#include <string>
#include <vector>

namespace reebquad {
namespace python {

/// What a run is asked for. What is given for vertices or edges has the numbers of the user's points.
struct Request {
  Run_options options;
  bool certify = true;
  std::vector<double> sizes; ///< one a point; empty: none
  std::vector<std::array<int, 2>> feature_edges;
  std::vector<int> feature_points;
  bool has_features() const { return !feature_edges.empty() || !feature_points.empty(); }
};

/// Where the vertices of the quads lie on the user's faces.
struct Places {
  std::vector<int> face;                  ///< -1: on a triangle that fills a hole
  std::vector<std::array<int, 3>> points; ///< the corners of a triangle there; -1: a point that was added
  std::vector<CGAL::Reeb_quadrangulation::Point> weights; ///< of these corners
};

/// All that a run has made. The numbers of quads and vertices count through all components.
struct Outcome {
  Run run;
  std::vector<int> component_number; ///< per component of `run`, counted from 1; 0: the mesh has no other
  std::vector<int> component_of_quad, chart_of_quad;
  std::vector<std::array<double, 8>> uv; ///< (U, V) of the four corners; empty where quads were subdivided
  Places places;
  std::vector<std::string> warnings;
};

/// Fails with the first error where no component, or with `all_or_nothing` not each, can be meshed.
CGAL::Reeb_quadrangulation::Result<Outcome> run(const Polygon_soup& soup, const Request& request,
                                                Python_observer& observer);

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_RUN_H
