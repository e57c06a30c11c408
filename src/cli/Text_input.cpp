// SPDX-License-Identifier: GPL-3.0-or-later
#include "Text_input.h"

#include "Failure.h"
#include "Number_list.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

#include <algorithm>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {
constexpr std::uint64_t largest_text = std::uint64_t(64) << 20;
}

std::vector<Text_line> lines_of(const std::string& text) {
  std::vector<Text_line> lines;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    line.erase(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back({number, std::move(line)});
  }
  return lines;
}

std::vector<Text_line> read_lines(const std::string& file) {
  return lines_of(value_or_fail(read_file(file, largest_text), file));
}

Result<std::vector<Placed_extremum>> parse_extrema(const std::vector<Text_line>& lines) {
  std::vector<Placed_extremum> extrema;
  for (const Text_line& line : lines) {
    const std::size_t begin = line.text.find_first_not_of(" \t\r");
    const std::size_t end = std::min(line.text.find_first_of(" \t\r", begin), line.text.size());
    const std::string kind = line.text.substr(begin, end - begin);
    const std::optional<Point> p = parse_point(line.text.substr(end), ' ');
    if ((kind != "min" && kind != "max") || !p)
      return make_error(Error_code::malformed_file,
                        "line " + std::to_string(line.number) + ": expected 'min x y z' or 'max x y z'");
    extrema.push_back({*p, kind == "max"});
  }
  if (extrema.empty()) return make_error(Error_code::malformed_file, "it places no extremum");
  return extrema;
}

} // namespace reebquad
