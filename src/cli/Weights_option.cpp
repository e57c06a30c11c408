// SPDX-License-Identifier: GPL-3.0-or-later
#include "Weights_option.h"

#include "Failure.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>

namespace reebquad {

using CGAL::Reeb_quadrangulation::Energy_weights;

namespace {

struct Named_weight {
  const char* name;
  double Energy_weights::*weight;
};

constexpr Named_weight named_weights[] = {
    {"shape", &Energy_weights::shape},       {"farthest", &Energy_weights::farthest},
    {"angle", &Energy_weights::angle},       {"size", &Energy_weights::size},
    {"vertices", &Energy_weights::vertices}, {"patches", &Energy_weights::patches},
    {"features", &Energy_weights::features}};

} // namespace

std::string names_of_weights() {
  std::ostringstream text;
  const char* between = "";
  for (const Named_weight& w : named_weights) {
    text << between << w.name << " (" << Energy_weights().*w.weight << ")";
    between = ", ";
  }
  return text.str();
}

Energy_weights energy_weights(const std::string& text) {
  Energy_weights result;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t name_ends = std::min(part.find('='), part.size());
    const auto found =
        std::find_if(std::begin(named_weights), std::end(named_weights),
                     [&](const Named_weight& w) { return part.substr(0, name_ends) == w.name; });
    if (found == std::end(named_weights))
      throw Usage_error("--weights: '" + part + "' names no weight; there are " + names_of_weights());
    double value = -1;
    const char *first = part.data() + std::min(name_ends + 1, part.size()), *last = part.data() + part.size();
    const std::from_chars_result parsed = std::from_chars(first, last, value);
    if (parsed.ec != std::errc() || parsed.ptr != last || !(value >= 0) || !std::isfinite(value))
      throw Usage_error("--weights: '" + part + "' is not a name, '=' and a number that is not negative");
    result.*found->weight = value;
  }
  return result;
}

} // namespace reebquad
