// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_EXIT_CODE_H
#define REEBQUAD_CLI_EXIT_CODE_H

#include <CGAL/Reeb_quadrangulation/Result.h>

namespace reebquad {

/// What `reebquad` returns to the shell. The manual documents these numbers.
enum class Exit_code : int {
  success = 0,
  other_failure = 1, ///< an output cannot be written, memory ran out, or a defect of ours
  usage = 2,
  unreadable_file = 3,
  not_a_surface = 4,
  certificate_failed = 5,
  in_part = 6, ///< some components were left out; the rest is written
  interrupted = 130
};

/// The exit code that tells the shell of an error of the library.
Exit_code exit_code(CGAL::Reeb_quadrangulation::Error_code code);

} // namespace reebquad

#endif // REEBQUAD_CLI_EXIT_CODE_H
