// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_OUTPUTS_H
#define REEBQUAD_CLI_OUTPUTS_H

#include "Command.h"

#include <string>
#include <vector>

namespace reebquad {

/// Declares --force.
void declare_force(Command_line& line);

/// The files that a command reads and those that it will write; empty names are none.
struct Files {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  std::string pictures; ///< a folder that pictures are written into
};

/// Throws a usage error if an output is also an input, by whatever name or link, unless the user gave
/// --force; and always if two outputs are the same file, or if there are pictures among them but no libpng.
/// To be called before anything is read.
void keep_inputs(const Command_line& line, const Files& files);

} // namespace reebquad

#endif // REEBQUAD_CLI_OUTPUTS_H
