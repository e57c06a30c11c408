// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_RUN_OPTIONS_H
#define REEBQUAD_CLI_RUN_OPTIONS_H

#include "Command.h"
#include "Marks_input.h"

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <optional>
#include <string>

namespace reebquad {

/// What `reebquad run` is asked for.
struct Run_options {
  std::string input;
  std::string output;
  std::string report;    ///< empty: none is written
  std::string html;      ///< empty: none is written
  std::string recipe;    ///< empty: none is written
  std::string pictures;  ///< a folder; empty: none are made
  std::string thumbnail; ///< a PNG file; empty: none is made
  CGAL::Reeb_quadrangulation::Quadrangulation_options pipeline;
  CGAL::Reeb_quadrangulation::Mend_options mending;
  std::string sizes; ///< file; empty: none
  Marks_request marks;
  std::string guides;          ///< a file; empty: none
  int component = 0;           ///< the only one to mesh, counted from 1; 0: all
  bool all_or_nothing = false; ///< write nothing unless every component is meshed
  bool charts = false;         ///< write the charts of the quads as groups and texture coordinates
  bool attributes = true;      ///< carry over what the input tells beside its surface
  bool timings = false;
  bool quiet = false;
  bool strict = false;   ///< warnings about the shape fail
  bool validate = false; ///< demand strict validity: also no inverted quad and no self-intersection
};

/// Nothing if only the help was asked for. Throws `Failure` with a sentence about the option.
std::optional<Run_options> parse_run_options(const Arguments& arguments);

} // namespace reebquad

#endif // REEBQUAD_CLI_RUN_OPTIONS_H
