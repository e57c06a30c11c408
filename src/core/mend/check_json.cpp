// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}
Json json_of(const Point& p) {
  return Json::array({json_of(p[0]), json_of(p[1]), json_of(p[2])});
}

Json json_of(const Component_check& c) {
  Json json = {{"first_face", c.first_face},
               {"faces", c.faces},
               {"edges", c.edges},
               {"vertices", c.vertices},
               {"boundary_loops", c.boundary_loops},
               {"euler_characteristic", c.euler_characteristic},
               {"manifold", c.manifold},
               {"orientable", c.orientable},
               {"closed", c.closed()}};
  json["genus"] = c.genus() < 0 ? Json(nullptr) : Json(c.genus());
  return json;
}

Json json_of(const Defect& d) {
  Json json = {{"kind", name(d.kind)}, {"points", d.points}, {"faces", d.faces}, {"where", json_of(d.where)}};
  if (d.kind == Defect_kind::boundary_loop) json["length"] = json_of(d.length);
  json["text"] = d.text;
  return json;
}

} // namespace

std::string to_json(const Surface_check& check) {
  Json json = {{"points", check.points},
               {"faces", check.faces},
               {"triangles", check.triangles},
               {"bounding_box", {json_of(check.lowest), json_of(check.highest)}},
               {"clean", check.is_clean()}};
  for (const Component_check& c : check.components) json["components"].push_back(json_of(c));
  if (check.components.empty()) json["components"] = Json::array();
  for (int k = 0; k < number_of_defect_kinds; ++k)
    json["counts"][name(Defect_kind(k))] = check.counts[std::size_t(k)];
  json["defects"] = Json::array();
  for (const Defect& d : check.defects) json["defects"].push_back(json_of(d));
  return json.dump(2) + "\n";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
