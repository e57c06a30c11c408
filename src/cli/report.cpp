// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a run as JSON; doc/Reeb_quadrangulation/report_schema.md describes it.
#include "Run.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

namespace {

Json json_of(const std::vector<Stage_time>& stages) {
  Json list = Json::array();
  for (const Stage_time& stage : stages)
    list.push_back({{"name", stage.name},
                    {"seconds", stage.seconds},
                    {"cpu_seconds", stage.cpu_seconds},
                    {"peak_megabytes", stage.peak_megabytes}});
  return list;
}

Json json_of(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

Json json_of(const Error& error) {
  Json out{{"message", error.message}, {"description", description(error.code)}};
  if (error.element != Element_kind::none) {
    out["element"] = name(error.element);
    out["index"] = error.index;
  }
  return out;
}

Json extrema_json(const Quadrangulation& result) {
  Json list = Json::array();
  for (const bool is_maximum : {false, true})
    for (const int v : is_maximum ? result.field.maxima : result.field.minima)
      list.push_back({{"kind", is_maximum ? "maximum" : "minimum"},
                      {"position", json_of(result.working_surface.points[v])}});
  return list;
}

Json charts_json(const Quadrangulation& result) {
  Json list = Json::array();
  const Reeb_layout& layout = result.layout;
  for (std::size_t c = 0; c < layout.atlas.charts.size(); ++c) {
    const Chart& chart = *layout.atlas.charts[c];
    list.push_back({{"kind", chart.kind == Chart_kind::disc ? "disc" : "annulus"},
                    {"triangles", chart.mesh.number_of_faces()},
                    {"height", result.chart_height[c]},
                    {"grid", result.sampling.grid[c]},
                    {"low_node", layout.graph.arcs[c].low},
                    {"high_node", layout.graph.arcs[c].high}});
  }
  return list;
}

/// The charts that are thinner than half an edge of the quads.
Json thin_charts_json(const Quadrangulation& result) {
  Json list = Json::array();
  for (std::size_t c = 0; c < result.chart_height.size(); ++c)
    if (result.layout.atlas.charts[c]->kind == Chart_kind::annulus &&
        result.chart_height[c] < 0.5 * result.sampling.edge_length)
      list.push_back(c);
  return list;
}

Json layout_json(const Quadrangulation& result) {
  const Reeb_layout& layout = result.layout;
  return {{"minima", layout.critical.minima.size()},
          {"maxima", layout.critical.maxima.size()},
          {"saddles", layout.critical.saddles.size()},
          {"cleanup_rounds", layout.cleanup_rounds},
          {"lost_extrema", layout.lost_extrema.size()},
          {"reeb_nodes", layout.graph.number_of_nodes()},
          {"reeb_arcs", layout.graph.arcs.size()},
          {"reeb_loops", layout.graph.loops()},
          {"contour_edges", layout.network.edges.size()},
          {"collapsed_thin_charts", result.collapsed_charts},
          {"thin_charts", thin_charts_json(result)},
          {"flipped_triangles", result.flipped_triangles},
          {"charts", charts_json(result)}};
}

Json sampling_json(const Sampling& sampling) {
  return {{"edge_length", sampling.edge_length}, {"quads", sampling.quads},
          {"target_met", sampling.target_met},   {"worst_count_ratio", sampling.worst_ratio},
          {"worst_edge", sampling.worst_edge},   {"counts", sampling.counts}};
}

Json relaxation_json(const Relax_report& relaxation) {
  return {{"moved_vertices", relaxation.moved_vertices},
          {"worst_before", relaxation.worst_before},
          {"worst_after", relaxation.worst_after},
          {"mean_before", relaxation.mean_before},
          {"mean_after", relaxation.mean_after},
          {"inverted_before", relaxation.inverted_before},
          {"inverted_after", relaxation.inverted_after},
          {"intersections_after", relaxation.intersections_after},
          {"off_surface_vertices", relaxation.off_surface.size()},
          {"largest_offset", relaxation.largest_offset}};
}

Json features_json(const Snap_report& features) {
  return {{"corners", features.corners},
          {"missed_corners", features.missed_corners},
          {"missed_crossings", features.missed_crossings},
          {"vertices", features.vertices},
          {"on_lines", features.on_lines}};
}

Json component_json(const Component_run& component) {
  Json out{{"vertices", component.surface.number_of_vertices()},
           {"triangles", component.surface.number_of_faces()},
           {"status", component.result ? "meshed" : "failed"}};
  if (!component.result) {
    if (!component.error.message.empty())
      out["error"] = json_of(component.error);
    else
      out["status"] = "not_meshed";
    return out;
  }
  const Quadrangulation& result = *component.result;
  out["genus"] = result.genus;
  out["quads"] = result.mesh.quads.size();
  out["extrema"] = extrema_json(result);
  out["layout"] = layout_json(result);
  out["sampling"] = sampling_json(result.sampling);
  out["adaptive"] = {{"subdivided_quads", result.subdivided_quads}, {"t_junctions", result.t_junctions}};
  out["relaxation"] = relaxation_json(result.relaxation);
  out["features"] = features_json(result.features);
  out["predicted_valences"] = Json::object();
  for (const auto& [valence, number] : result.valences)
    out["predicted_valences"][std::to_string(valence)] = number;
  out["stages"] = json_of(result.stages);
  return out;
}

} // namespace

std::string report_json(const Run& run, const Run_options& options) {
  Json out;
  out["schema"] = 1;
  out["version"] = REEBQUAD_VERSION;
  out["status"] = static_cast<int>(run.status);
  out["input"] = {{"file", options.input}, {"points", run.input_points}, {"faces", run.input_faces}};
  out["output"] = run.status == Exit_code::success ? Json(options.output) : Json(nullptr);
  out["mends"] = Json::array();
  for (const Mend& mend : run.mends) out["mends"].push_back({{"count", mend.count}, {"text", mend.text}});
  out["refused"] = Json::array();
  for (const Error& error : run.refused) out["refused"].push_back(json_of(error));
  out["components"] = Json::array();
  for (const Component_run& component : run.components)
    out["components"].push_back(component_json(component));
  out["certificate"] = run.certificate ? Json::parse(to_json(*run.certificate)) : Json(nullptr);
  out["statistics"] = run.statistics ? Json::parse(to_json(*run.statistics)) : Json(nullptr);
  out["stages"] = json_of(run.stages);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace reebquad
