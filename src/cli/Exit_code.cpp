// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exit_code.h"

#include "Failure.h"

namespace reebquad {

using CGAL::Reeb_quadrangulation::Error;
using CGAL::Reeb_quadrangulation::Error_code;

Exit_code exit_code(Error_code code) {
  switch (code) {
  case Error_code::unreadable_file:
  case Error_code::malformed_file:
  case Error_code::unsupported_format: return Exit_code::unreadable_file;
  case Error_code::not_a_surface: return Exit_code::not_a_surface;
  case Error_code::impossible_request:
  case Error_code::infeasible_sampling:
  case Error_code::refused_edit: return Exit_code::usage;
  case Error_code::certificate_failure: return Exit_code::certificate_failed;
  case Error_code::cancelled: return Exit_code::interrupted;
  case Error_code::unwritable_file:
  case Error_code::solver_failure:
  case Error_code::internal_error: return Exit_code::other_failure;
  }
  return Exit_code::other_failure;
}

std::string sentence(const std::string& file, const Error& error) {
  return error.message.find(file) == std::string::npos ? file + ": " + error.message : error.message;
}

} // namespace reebquad
