// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sizes_output.h"

#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

nlohmann::ordered_json sizes_json(const Size_report& report) {
  return {{"met_within_20_percent", report.met},
          {"mean", report.mean},
          {"percentiles", {{"5", report.least}, {"50", report.median}, {"95", report.greatest}}}};
}

std::string sizes_text(const Size_report& report) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << "sizes: edges are " << report.mean << " times as long as asked in the mean, " << report.least
       << " to " << report.greatest << " on nine tenths of the area; met within 20 % on " << 100 * report.met
       << " % of it\n";
  return text.str();
}

} // namespace reebquad
