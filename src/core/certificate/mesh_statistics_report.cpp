// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json json(const Value_range& range) {
  return {
      {"minimum", number(range.minimum)}, {"mean", number(range.mean)}, {"maximum", number(range.maximum)}};
}

Json json(const std::map<int, int>& histogram) {
  Json result = Json::object();
  for (const auto& [valence, count] : histogram) result[std::to_string(valence)] = count;
  return result;
}

std::string words(const std::map<int, int>& histogram) {
  std::string result;
  for (const auto& [valence, count] : histogram)
    result += (result.empty() ? "" : "  ") + std::to_string(valence) + ":" + std::to_string(count);
  return result.empty() ? "none" : result;
}

std::string words(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", x);
  return buffer;
}

std::string words(const Value_range& range) {
  return "mean " + words(range.mean) + ", " + words(range.minimum) + " to " + words(range.maximum);
}

std::string line(std::string label, const std::string& value) {
  label.resize(28, ' ');
  return label + value + "\n";
}

} // namespace

std::string to_json(const Mesh_statistics& s) {
  Json result{{"vertices", s.vertices},
              {"edges", s.edges},
              {"quads", s.quads},
              {"skipped_quads", s.skipped_quads},
              {"extraordinary_vertices", s.extraordinary_vertices},
              {"largest_valence_difference", s.largest_valence_difference},
              {"interior_valences", json(s.interior_valences)},
              {"boundary_valences", json(s.boundary_valences)},
              {"angle", json(s.angle)},
              {"angle_deviation", json(s.angle_deviation)},
              {"angle_histogram", s.angle_histogram},
              {"scaled_jacobian", json(s.scaled_jacobian)},
              {"inverted_quads", s.inverted_quads},
              {"scaled_jacobian_histogram", s.scaled_jacobian_histogram},
              {"edge_length", json(s.edge_length)},
              {"quad_area", json(s.quad_area)},
              {"quad_area_ratio", number(s.quad_area_ratio)}};
  result["undersampled_area"] = s.undersampled_area ? number(*s.undersampled_area) : Json(nullptr);
  result["covered_sharp_edges"] = s.covered_sharp_edges ? number(*s.covered_sharp_edges) : Json(nullptr);
  result["folded_sharp_edges"] = s.folded_sharp_edges ? number(*s.folded_sharp_edges) : Json(nullptr);
  return result.dump(2);
}

std::string to_text(const Mesh_statistics& s) {
  std::string text = line("vertices, quads", std::to_string(s.vertices) + ", " + std::to_string(s.quads));
  if (s.skipped_quads > 0) text += line("quads not measured", std::to_string(s.skipped_quads));
  text += line("extraordinary vertices", std::to_string(s.extraordinary_vertices) + ", valence at most " +
                                             std::to_string(s.largest_valence_difference) + " off");
  text += line("interior valences", words(s.interior_valences));
  if (!s.boundary_valences.empty()) text += line("boundary valences", words(s.boundary_valences));
  text += line("angle (degrees)", words(s.angle));
  text += line("angle off 90 degrees", words(s.angle_deviation));
  text += line("scaled Jacobian", words(s.scaled_jacobian));
  text += line("inverted quads", std::to_string(s.inverted_quads));
  text += line("edge length", words(s.edge_length));
  text += line("quad area", words(s.quad_area) + ", ratio " + words(s.quad_area_ratio));
  if (s.undersampled_area) text += line("undersampled area", words(100 * *s.undersampled_area) + " %");
  if (s.covered_sharp_edges)
    text += line("sharp edges covered", words(100 * *s.folded_sharp_edges) + " %, by edges of quads " +
                                            words(100 * *s.covered_sharp_edges) + " %");
  return text;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
