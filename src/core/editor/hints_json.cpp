// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/hints.h>

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <nlohmann/json.hpp>

namespace CGAL {
namespace Reeb_quadrangulation {

const char* name(Hint_kind kind) {
  switch (kind) {
  case Hint_kind::uncovered_limb: return "uncovered_limb";
  case Hint_kind::thin_chart: return "thin_chart";
  case Hint_kind::sharp_edge: return "sharp_edge";
  case Hint_kind::saddle: return "saddle";
  case Hint_kind::lost_place: return "lost_place";
  case Hint_kind::lost_edge: return "lost_edge";
  case Hint_kind::lost_corner: return "lost_corner";
  }
  return "";
}

std::string to_json(const std::vector<Hint>& hints) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Hint& hint : hints)
    list.push_back({{"kind", name(hint.kind)},
                    {"reason", hint.reason},
                    {"place", {hint.place.x(), hint.place.y(), hint.place.z()}},
                    {"before", hint.before},
                    {"after", hint.after},
                    {"edit", Json::parse(to_json(hint.edit))}});
  return list.dump(2) + "\n";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
