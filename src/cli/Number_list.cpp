// SPDX-License-Identifier: GPL-3.0-or-later
#include "Number_list.h"

#include <locale>
#include <sstream>

namespace reebquad {

using CGAL::Reeb_quadrangulation::Point;

std::optional<Point> parse_point(std::string text, char separator) {
  for (char& c : text)
    if (separator != ' ' && c == separator) c = ' ';
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Point p;
  if (!(stream >> p.x() >> p.y() >> p.z()) || !p.allFinite()) return std::nullopt;
  stream >> std::ws;
  return stream.eof() ? std::optional<Point>(p) : std::nullopt;
}

} // namespace reebquad
