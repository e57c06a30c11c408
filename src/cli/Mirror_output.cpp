// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mirror_output.h"

#include "Failure.h"
#include "Number_list.h"

#include <cstdio>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

nlohmann::ordered_json coordinates(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

namespace {

std::string percent(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * fraction);
  return text;
}

} // namespace

std::optional<Mirror_request> mirror_request(const std::string& text) {
  if (text == "none") return std::nullopt;
  Mirror_request request;
  if (text == "auto") return request;
  const std::string axis = text.size() == 2 && text[0] == '-' ? text.substr(1) : text;
  if (axis.size() == 1 && axis >= "x" && axis <= "z") {
    request.choice = Mirror_choice(int(Mirror_choice::across_x) + (axis[0] - 'x'));
    request.is_turned = axis != text;
    return request;
  }
  std::size_t third = std::string::npos; // the comma between point and normal
  for (int i = 0; i < 3; ++i) third = text.find(',', third + 1);
  const std::optional<Point> point = parse_point(text.substr(0, third), ','),
                             normal = third == std::string::npos ? std::nullopt
                                                                 : parse_point(text.substr(third + 1), ',');
  if (!point || !normal)
    throw Usage_error("--mirror is auto, x, y, z, -x, -y, -z, none, or a point and a normal as "
                      "0,0,0,1,0,0; it got '" +
                      text + "'");
  request.choice = Mirror_choice::given;
  request.plane = {*point, *normal};
  if (request.plane.normal.isZero(0)) throw Usage_error("--mirror: the normal has no direction");
  return request;
}

bool is_kept(const Mirror_report& report, const Mirror_check& check) {
  const bool is_promised =
      report.mirror.positions == Mirror_positions::exact && report.mirror.plane.axis() >= 0;
  return check.is_symmetric && (check.is_exact || !is_promised);
}

std::string mirror_text(const Mirror_report& report, const Mirror_check& check) {
  std::string text = "mirror: " + to_text(check, report.mirror.plane) +
                     "; the surface deviates from its own by " + percent(report.deviation.largest) +
                     " of the diagonal, " + percent(report.deviation.mean) + " on average";
  if (report.mirror.positions == Mirror_positions::projected)
    text += "; vertices were moved onto it by up to " + percent(report.largest_shift);
  return text + "\n";
}

Json mirror_json(const Mirror_report& report, const Mirror_check& check) {
  const Mirror_plane& plane = report.mirror.plane;
  Json json{{"plane", {{"point", coordinates(plane.point)}, {"normal", coordinates(plane.normal)}}},
            {"text", to_text(plane)},
            {"positions", report.mirror.positions == Mirror_positions::exact ? "exact" : "projected"},
            {"surface_deviation",
             {{"largest", report.deviation.largest},
              {"mean", report.deviation.mean},
              {"at", coordinates(report.deviation.at)}}},
            {"symmetric", check.is_symmetric},
            {"exact", check.is_exact},
            {"deviation", check.deviation},
            {"largest_shift", report.largest_shift},
            {"vertices_on_plane", report.on_plane},
            {"ring_quads", report.ring_quads}};
  if (!check.message.empty()) json["message"] = check.message;
  json["image"] = report.image;
  return json;
}

} // namespace reebquad
