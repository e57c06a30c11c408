// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_COMMAND_H
#define REEBQUAD_CLI_COMMAND_H

#include "Failure.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/positional_options.hpp>
#include <boost/program_options/variables_map.hpp>

#include <string>
#include <vector>

namespace reebquad {

/// The arguments after the name of the subcommand.
using Arguments = std::vector<std::string>;

/// A subcommand: a row of the table in main.cpp.
struct Command {
  const char* name;
  const char* summary; ///< one line of `reebquad help`
  Exit_code (*execute)(const Arguments&);
};

/// The options and positional arguments of one subcommand.
struct Command_line {
  explicit Command_line(std::string usage_) : usage(std::move(usage_)) {}

  /// Parses; prints the help and returns false if `--help` is among the arguments. Throws `Usage_error`.
  bool parse(const Arguments& arguments);
  /// Declares the next positional argument.
  void take(const char* name);
  bool has(const char* option) const { return values.count(option) > 0; }
  std::string text(const char* option) const { return values[option].as<std::string>(); }

  /// The positional argument of that name, or a usage error that says it is missing.
  std::string required(const char* name) const;

  std::string usage; ///< "run FILE -o QUADS [options]"
  boost::program_options::options_description options;
  boost::program_options::options_description hidden; ///< the positional arguments' names
  boost::program_options::positional_options_description positional;
  boost::program_options::variables_map values;
};

Exit_code execute_batch(const Arguments& arguments);
Exit_code execute_polygons(const Arguments& arguments);
Exit_code execute_run(const Arguments& arguments);
Exit_code execute_check(const Arguments& arguments);
Exit_code execute_replay(const Arguments& arguments);
Exit_code execute_stats(const Arguments& arguments);
Exit_code execute_shape(const Arguments& arguments);
Exit_code execute_stitch(const Arguments& arguments);
Exit_code execute_suggest(const Arguments& arguments);
Exit_code execute_studio(const Arguments& arguments);
Exit_code execute_texture(const Arguments& arguments);
Exit_code execute_version(const Arguments& arguments);

} // namespace reebquad

#endif // REEBQUAD_CLI_COMMAND_H
