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

Json json(const Distance_summary& summary) {
  return {
      {"maximum", number(summary.maximum)}, {"mean", number(summary.mean)}, {"farthest", summary.farthest}};
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
  Json result{{"passed", certificate.passed}, {"strictly_valid", certificate.strictly_valid}};
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
  if (const auto& distance = certificate.distance)
    result["distance"] = {{"diagonal", number(distance->diagonal)},
                          {"vertices", json(distance->vertices)},
                          {"centres", json(distance->centres)},
                          {"input_vertices", json(distance->input_vertices)}};
  else
    result["distance"] = nullptr;
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
    text += certificate.strictly_valid ? ", strictly valid" : ", not shown to be strictly valid";
  return text + "\n";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
