// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a run as JSON; doc/Reeb_quadrangulation/report_schema.md describes it.
#include "Guides_output.h"
#include "Mirror_output.h"
#include "Run.h"
#include "Sizes_output.h"

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

Json json_of(const Error& error) {
  Json out{{"message", error.message}, {"description", description(error.code)}};
  if (error.element != Element_kind::none) {
    out["element"] = name(error.element);
    out["index"] = error.index;
  }
  return out;
}

Json extrema_json(const Editor& editor) {
  Json list = Json::array();
  for (const bool is_maximum : {false, true})
    for (const Design_extremum& e : editor.design().extrema)
      if (e.is_maximum == is_maximum)
        list.push_back({{"kind", is_maximum ? "maximum" : "minimum"},
                        {"position", coordinates(editor.working_surface().points[e.vertex])}});
  return list;
}

Json charts_json(const Design& design, const Reeb_graph& graph) {
  Json list = Json::array();
  for (std::size_t c = 0; c < design.charts.size(); ++c) {
    const Design_chart& chart = *design.charts[c];
    list.push_back({{"kind", chart.chart->kind == Chart_kind::disc ? "disc" : "annulus"},
                    {"triangles", chart.chart->mesh.number_of_faces()},
                    {"height", chart.height},
                    {"grid", chart.grid},
                    {"low_node", graph.arcs[c].low},
                    {"high_node", graph.arcs[c].high}});
  }
  return list;
}

/// The charts that are thinner than half an edge of the quads.
Json thin_charts_json(const Design& design) {
  Json list = Json::array();
  for (std::size_t c = 0; c < design.charts.size(); ++c)
    if (design.charts[c]->chart->kind == Chart_kind::annulus &&
        design.charts[c]->height < 0.5 * design.edge_length)
      list.push_back(c);
  return list;
}

Json layout_json(const Quadrangulation& result) {
  const Design& design = result.editor.design();
  const Reeb_graph graph = reeb_graph(design.atlas, design.network);
  const auto maxima = std::count_if(design.extrema.begin(), design.extrema.end(),
                                    [](const Design_extremum& e) { return e.is_maximum; });
  return {
      {"minima", design.extrema.size() - std::size_t(maxima)},
      {"maxima", maxima},
      {"saddles", std::count_if(design.network.nodes.begin(), design.network.nodes.end(),
                                [](const Contour_node& n) { return n.kind == Node_kind::saddle; })},
      {"cleanup_rounds", design.field->cleanup_rounds},
      {"lost_extrema", design.field->lost_extrema.size()},
      {"reeb_nodes", graph.number_of_nodes()},
      {"reeb_arcs", graph.arcs.size()},
      {"reeb_loops", graph.loops()},
      {"contour_edges", std::count_if(design.network.edges.begin(), design.network.edges.end(),
                                      [&](const Contour_edge& e) { return !design.network.is_removed(e); })},
      {"collapsed_thin_charts", result.collapsed_charts},
      {"thin_charts", thin_charts_json(design)},
      {"flipped_triangles", result.flipped_triangles},
      {"charts", charts_json(design, graph)}};
}

Json sampling_json(const Design& design) {
  return {{"edge_length", design.edge_length},      {"quads", design.counts.quads},
          {"target_met", design.counts.target_met}, {"worst_count_ratio", design.counts.worst_ratio},
          {"worst_edge", design.counts.worst_edge}, {"counts", design.samples.counts}};
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
  out["extrema"] = extrema_json(result.editor);
  out["layout"] = layout_json(result);
  out["sampling"] = sampling_json(result.editor.design());
  out["adaptive"] = {{"subdivided_quads", result.subdivided_quads}, {"t_junctions", result.t_junctions}};
  out["base_patches"] = {{"before_alignment", result.base_patches[0]}, {"after", result.base_patches[1]}};
  out["search"] = Json::array();
  for (const Search_step& step : result.search)
    out["search"].push_back({{"reason", step.reason}, {"energy", step.energy}});
  out["relaxation"] = relaxation_json(result.relaxation);
  out["features"] = features_json(result.features);
  out["marks"] = component.marks ? marks_json(*component.marks) : Json(nullptr);
  out["guides"] = guides_json(result.guides);
  out["sizes"] = component.met_sizes ? sizes_json(*component.met_sizes) : Json(nullptr);
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
  out["output"] = run.is_written() ? Json(options.output) : Json(nullptr);
  out["notes"] = run.notes;
  out["mends"] = Json::array();
  for (const Mend& mend : run.mends) out["mends"].push_back({{"count", mend.count}, {"text", mend.text}});
  out["refused"] = Json::array();
  for (const Error& error : run.refused) out["refused"].push_back(json_of(error));
  out["components"] = Json::array();
  for (const Component_run& component : run.components)
    out["components"].push_back(component_json(component));
  out["certificate"] = run.certificate ? Json::parse(to_json(*run.certificate)) : Json(nullptr);
  out["statistics"] = run.statistics ? Json::parse(to_json(*run.statistics)) : Json(nullptr);
  out["mirror"] = run.mirror ? mirror_json(*run.mirror_report(), *run.mirror) : Json(nullptr);
  out["stages"] = json_of(run.stages);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace reebquad
