// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_RUN_H
#define REEBQUAD_CLI_RUN_H

#include "Marks_output.h"
#include "Run_options.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/mirror_check.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/sized_quads.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <optional>
#include <string>
#include <vector>

namespace reebquad {

/// One component of the input and what became of it.
struct Component_run {
  CGAL::Reeb_quadrangulation::Triangle_surface surface;
  std::optional<CGAL::Reeb_quadrangulation::Quadrangulation> result; ///< none if it failed
  CGAL::Reeb_quadrangulation::Error error;                           ///< why it failed
  std::optional<Marks_outcome> marks;
  std::vector<double> sizes{}; ///< at the vertices of the surface, if they are asked for
  std::optional<CGAL::Reeb_quadrangulation::Size_report> met_sizes{}; ///< if there are marks
};

/// Everything about a run that the screen, the report and the pictures show.
struct Run {
  int input_points = 0;
  int input_faces = 0;
  std::vector<std::string> notes; ///< what the reader passed over
  std::vector<CGAL::Reeb_quadrangulation::Mend> mends;
  std::vector<CGAL::Reeb_quadrangulation::Error> refused; ///< components that are not surfaces
  std::vector<Component_run> components;
  CGAL::Reeb_quadrangulation::Triangle_surface as_read; ///< the file, with what filled its holes
  CGAL::Reeb_quadrangulation::Triangle_surface surface; ///< all components that were meshed
  CGAL::Reeb_quadrangulation::Quad_mesh quads;          ///< of all of them
  std::optional<CGAL::Reeb_quadrangulation::Certificate> certificate;
  std::optional<CGAL::Reeb_quadrangulation::Mesh_statistics> statistics;
  std::optional<CGAL::Reeb_quadrangulation::Mirror_check> mirror; ///< if the quads are mirrored
  std::vector<CGAL::Reeb_quadrangulation::Stage_time> stages;     ///< outside the components' own
  Exit_code status = Exit_code::success;
  /// How the quads are mirrored, or null.
  const CGAL::Reeb_quadrangulation::Mirror_report* mirror_report() const {
    return components.size() == 1 && components[0].result && components[0].result->mirror
               ? &*components[0].result->mirror
               : nullptr;
  }
  /// Whether quads are written: of all components, or of some.
  bool is_written() const { return status == Exit_code::success || status == Exit_code::in_part; }
};

/// The report, as doc/Reeb_quadrangulation/report_schema.md describes it.
std::string report_json(const Run& run, const Run_options& options);

/// The same as one HTML file with an interactive view. A `Failure` says if the program was built without it.
std::string report_html(const Run& run, const Run_options& options);

/// Writes the pictures of a run into `options.pictures`; a `Failure` names the file that cannot be written.
void write_pictures(const Run& run, const Run_options& options);

/// Writes the small picture `options.thumbnail`: of the quads; of the surface where there are none.
void write_thumbnail(const Run& run, const Run_options& options);

} // namespace reebquad

#endif // REEBQUAD_CLI_RUN_H
