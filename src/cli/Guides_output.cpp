// SPDX-License-Identifier: GPL-3.0-or-later
#include "Guides_output.h"

#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

Json guides_json(const std::vector<Guide_outcome>& guides) {
  Json list = Json::array();
  for (const Guide_outcome& guide : guides)
    list.push_back({{"kept", guide.kept},
                    {"reason", guide.reason},
                    {"length", guide.after.length},
                    {"vertices", guide.vertices},
                    {"on", guide.after.on},
                    {"angle", guide.after.angle},
                    {"angle_before", guide.before.angle},
                    {"distance", guide.after.distance},
                    {"distance_before", guide.before.distance},
                    {"jacobian_elsewhere", guide.jacobian_after},
                    {"jacobian_elsewhere_before", guide.jacobian_before}});
  return list;
}

std::string guides_text(const std::vector<Guide_outcome>& guides) {
  std::ostringstream text;
  text.precision(3);
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const Guide_outcome& guide = guides[i];
    text << "guide " << i + 1 << ": edges of quads make an angle of " << guide.after.angle
         << " degrees with it in the mean, and lie on " << 100 * guide.after.on << " % of it";
    if (guide.kept)
      text << " (" << guide.before.angle << " degrees before)\n";
    else
      text << "; not kept: " << guide.reason << '\n';
  }
  return text.str();
}

std::string guides_warning(const std::vector<Guide_outcome>& guides, double edge_length) {
  std::ostringstream text;
  text.precision(2);
  const auto begin = [&](std::size_t i) -> std::ostream& {
    return text << (text.tellp() > 0 ? "; " : "") << "guide " << i + 1;
  };
  for (std::size_t i = 0; i < guides.size(); ++i)
    if (guides[i].after.length < least_guide_length * edge_length && guides[i].after.length > 0)
      begin(i) << " is " << guides[i].after.length / edge_length << " edges of quads long: it hardly matters";
    else if (!guides[i].kept)
      begin(i) << " is not kept: " << guides[i].reason;
  return text.str();
}

} // namespace reebquad
