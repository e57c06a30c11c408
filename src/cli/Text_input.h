// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_TEXT_INPUT_H
#define REEBQUAD_CLI_TEXT_INPUT_H

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <string>
#include <vector>

namespace reebquad {

/// A line of a text file that holds something beside a comment.
struct Text_line {
  int number = 0; ///< from 1
  std::string text;
};

/// The lines of a text without comments, which begin with '#', and without those that are empty then.
std::vector<Text_line> lines_of(const std::string& text);

/// The lines of a file of at most 64 MiB; a `Failure` says why it cannot be read.
std::vector<Text_line> read_lines(const std::string& file);

/// Extrema from lines "min x y z" and "max x y z". Fails with `malformed_file`, naming the line, and where
/// there is none.
CGAL::Reeb_quadrangulation::Result<std::vector<CGAL::Reeb_quadrangulation::Placed_extremum>>
parse_extrema(const std::vector<Text_line>& lines);

} // namespace reebquad

#endif // REEBQUAD_CLI_TEXT_INPUT_H
