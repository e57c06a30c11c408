// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_FAILURE_H
#define REEBQUAD_CLI_FAILURE_H

#include "Exit_code.h"

#include <stdexcept>
#include <string>

namespace reebquad {

/// Ends a subcommand; main() prints "reebquad: " and the sentence and returns the code.
struct Failure : std::runtime_error {
  Failure(Exit_code code_, const std::string& sentence) : std::runtime_error(sentence), code(code_) {}
  Exit_code code;
};

/// What the user typed cannot be meant.
struct Usage_error : Failure {
  explicit Usage_error(const std::string& sentence) : Failure(Exit_code::usage, sentence) {}
};

/// The error in one sentence that begins with the file, unless its message names it already.
std::string sentence(const std::string& file, const CGAL::Reeb_quadrangulation::Error& error);

/// Throws the error of a result about `file`, if there is one; otherwise hands its value on.
template <class T> T value_or_fail(CGAL::Reeb_quadrangulation::Result<T> result, const std::string& file) {
  if (!result) throw Failure(exit_code(result.error().code), sentence(file, result.error()));
  return std::move(*result);
}
inline void succeed_or_fail(const CGAL::Reeb_quadrangulation::Result<void>& result, const std::string& file) {
  if (!result) throw Failure(exit_code(result.error().code), sentence(file, result.error()));
}

} // namespace reebquad

#endif // REEBQUAD_CLI_FAILURE_H
