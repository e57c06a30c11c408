// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/certificate.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Json = nlohmann::ordered_json;

// Counts are written as integers; what is not finite as null.
Json number(double x) {
  if (!std::isfinite(x)) return nullptr;
  if (x == std::floor(x) && std::abs(x) < 1e15) return std::int64_t(x);
  return x;
}

Json json(const std::map<int, int>& histogram) {
  Json result = Json::object();
  for (const auto& [valence, count] : histogram) result[std::to_string(valence)] = count;
  return result;
}

Json json(const Certificate_check& check) {
  Json result{{"name", check.name},
              {"status", name(check.status)},
              {"measured", number(check.measured)},
              {"expected", number(check.expected)}};
  if (!check.message.empty()) result["message"] = check.message;
  if (check.element != Element_kind::none) {
    result["element"] = name(check.element);
    result["index"] = check.index;
  }
  return result;
}

Json json(const std::vector<Component_counts>& components) {
  Json result = Json::array();
  for (const Component_counts& c : components)
    result.push_back({{"vertices", c.vertices},
                      {"edges", c.edges},
                      {"faces", c.faces},
                      {"boundary_loops", c.boundary_loops},
                      {"euler_characteristic", c.euler_characteristic()}});
  return result;
}

Json json(const Point& p) {
  return {number(p.x()), number(p.y()), number(p.z())};
}

Json json(const Area_distance& distance) {
  return {{"maximum", number(distance.maximum)},
          {"bound", number(distance.bound)},
          {"mean", number(distance.mean)},
          {"at", json(distance.at)}};
}

Json json(const std::optional<double>& x) {
  return x ? number(*x) : Json(nullptr);
}

Json json(const Shape_kept& shape) {
  Json result{
      {"summary", shape_summary(shape)},        {"diagonal", number(shape.diagonal)},
      {"distance", number(shape.distance())},   {"bound", number(shape.bound())},
      {"from_quads", json(shape.from_quads)},   {"from_input", json(shape.from_input)},
      {"input_area", number(shape.input_area)}, {"quad_area", number(shape.quad_area)},
      {"lost_area", number(shape.lost_area)},   {"undersampled_area", number(shape.undersampled_area)},
      {"box_shift", number(shape.box_shift)},   {"corners", shape.corners},
      {"missed_corners", shape.missed_corners}};
  result["missed_corner"] = shape.missed_corners > 0 ? json(shape.missed_corner) : Json(nullptr);
  result["covered_sharp_lines"] = json(shape.covered_sharp_lines);
  result["covered_sharp_edges"] = json(shape.covered_sharp_edges);
  result["folded_sharp_edges"] = json(shape.folded_sharp_edges);
  result["components"] = shape.components;
  result["lost_components"] = shape.lost_components;
  result["quads"] = shape.quads;
  result["quads_asked"] = shape.quads_asked > 0 ? Json(shape.quads_asked) : Json(nullptr);
  return result;
}

Json json(const std::vector<Shape_warning>& warnings) {
  Json result = Json::array();
  for (const Shape_warning& w : warnings)
    result.push_back(
        {{"name", w.name}, {"measured", number(w.measured)}, {"limit", number(w.limit)}, {"text", w.text}});
  return result;
}

std::string cell(double x) {
  if (std::isnan(x)) return "-";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", x);
  return buffer;
}

std::string padded(std::string s, std::size_t width) {
  return s.append(width - std::min(width, s.size()), ' ');
}

std::string right(const std::string& s, std::size_t width) {
  return std::string(width - std::min(width, s.size()), ' ') + s;
}

const char* mark(Check_status status) {
  switch (status) {
  case Check_status::passed: return "ok";
  case Check_status::failed: return "FAIL";
  case Check_status::not_checked: return "-";
  }
  return "";
}

} // namespace

std::string to_json(const Certificate& certificate) {
  Json result{{"passed", certificate.passed},
              {"strictly_valid", certificate.strictly_valid},
              {"valid_as_input", certificate.valid_as_input}};
  Json& checks = result["checks"] = Json::array();
  for (const Certificate_check& check : certificate.checks) checks.push_back(json(check));
  result["vertices"] = certificate.vertices;
  result["edges"] = certificate.edges;
  result["quads"] = certificate.quads;
  result["components"] = json(certificate.components);
  result["input_components"] = json(certificate.input_components);
  result["interior_valences"] = json(certificate.interior_valences);
  result["boundary_valences"] = json(certificate.boundary_valences);
  result["inverted_quads"] = certificate.inverted_quads;
  result["intersecting_quads"] = certificate.intersecting_quads;
  result["input_intersections"] = certificate.input_intersections;
  result["shape"] = certificate.shape ? json(*certificate.shape) : Json(nullptr);
  result["warnings"] = json(certificate.warnings);
  return result.dump(2);
}

std::string to_text(const Certificate& certificate) {
  std::string text = padded("certificate", 30) + right("measured", 12) + right("expected", 12) + "\n";
  for (const Certificate_check& check : certificate.checks) {
    std::string label = check.name;
    std::replace(label.begin(), label.end(), '_', ' ');
    text += padded(mark(check.status), 5) + padded(label, 25) + right(cell(check.measured), 12) +
            right(cell(check.expected), 12);
    if (!check.message.empty()) text += "  " + check.message;
    text += "\n";
  }
  text += certificate.passed ? "passed" : "FAILED";
  if (certificate.passed)
    text += certificate.strictly_valid   ? ", strictly valid"
            : certificate.valid_as_input ? ", strictly valid but where the input intersects itself"
                                         : ", not shown to be strictly valid";
  text += "\n";
  if (certificate.shape) text += "kept: " + shape_summary(*certificate.shape) + "\n";
  for (const Shape_warning& warning : certificate.warnings) text += "warning: " + warning.text + "\n";
  return text;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
