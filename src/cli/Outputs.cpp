// SPDX-License-Identifier: GPL-3.0-or-later
#include "Outputs.h"

#include <CGAL/Reeb_quadrangulation/render.h>

#include <filesystem>

namespace reebquad {

namespace fs = std::filesystem;

namespace {

/// Also where a link leads from one to the other, and, for files that do not exist yet, where the paths do.
bool are_same(const std::string& a, const std::string& b) {
  std::error_code failed;
  if (fs::equivalent(a, b, failed)) return true;
  const fs::path first = fs::weakly_canonical(a, failed), second = fs::weakly_canonical(b, failed);
  return !failed && first == second;
}

void keep_input(const std::string& input, const std::string& output) {
  if (input.empty() || !are_same(input, output)) return;
  throw Usage_error(output + ": this is the input " + (input == output ? "itself" : input) +
                    ", which would be overwritten; give another name, or --force");
}

} // namespace

void declare_force(Command_line& line) {
  line.options.add_options()("force", "also write over a file that is read");
}

void keep_inputs(const Command_line& line, const Files& files) {
  for (const char* option : {"pictures", "picture", "thumbnail"})
    if (line.has(option) && !CGAL::Reeb_quadrangulation::can_write_png())
      throw Usage_error(std::string("--") + option + ": this reebquad was built without libpng");
  std::vector<std::string> outputs;
  for (const std::string& output : files.outputs) {
    if (output.empty()) continue;
    for (const std::string& other : outputs)
      if (are_same(output, other))
        throw Usage_error(output + ": two outputs would be written into this file");
    outputs.push_back(output);
  }
  if (line.has("force")) return;
  std::error_code ignored;
  if (!files.pictures.empty())
    for (const fs::directory_entry& entry : fs::directory_iterator(files.pictures, ignored))
      if (entry.path().extension() == ".png") outputs.push_back(entry.path().string());
  for (const std::string& output : outputs)
    for (const std::string& input : files.inputs) keep_input(input, output);
}

} // namespace reebquad
