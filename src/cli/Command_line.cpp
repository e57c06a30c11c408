// SPDX-License-Identifier: GPL-3.0-or-later
#include "Command.h"

#include <boost/program_options/cmdline.hpp>
#include <boost/program_options/parsers.hpp>

#include <iostream>

namespace reebquad {

namespace po = boost::program_options;

void Command_line::take(const char* name) {
  hidden.add_options()(name, po::value<std::string>());
  positional.add(name, 1);
}

std::string Command_line::required(const char* name) const {
  if (!has(name)) throw Usage_error(std::string(name) + " is missing\nUsage: reebquad " + usage);
  return text(name);
}

bool Command_line::parse(const Arguments& arguments) {
  options.add_options()("help,h", "print this help");
  po::options_description all;
  all.add(options).add(hidden);
  try {
    // Abbreviated options are not accepted: a later option must not change what an old script means.
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments).options(all).positional(positional).style(style).run(),
              values);
    if (values.count("help") > 0) {
      std::cout << "Usage: reebquad " << usage << "\n\n" << options;
      return false;
    }
    po::notify(values);
  } catch (const po::error& error) {
    throw Usage_error(std::string(error.what()) + "\nUsage: reebquad " + usage);
  }
  return true;
}

} // namespace reebquad
