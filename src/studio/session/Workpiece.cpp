// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Workpiece.h"

#include <CGAL/Reeb_quadrangulation/IO/hints.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/deviation.h>
#include <CGAL/Reeb_quadrangulation/offer_after.h>

#include <algorithm>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

Json json_of(const Edit_report& report) {
  return {{"new_charts", report.new_charts},           {"removed_charts", report.removed_charts},
          {"remeshed_charts", report.remeshed_charts}, {"lost_textures", report.lost_textures},
          {"new_contours", report.new_contours},       {"removed_contours", report.removed_contours},
          {"changed_counts", report.changed_counts},   {"seconds", report.seconds}};
}

Result<Edit> parse_edit(const Json& edit) {
  return edit_from_json(edit.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// The contours of a design that another one does not have, each as x, y, z of its points relative to
/// `origin`.
Json new_contours(const Triangle_surface& surface, const Contour_network& before,
                  const Contour_network& after, const Point& origin) {
  Json contours = Json::array();
  for (std::size_t e = 0; e < after.edges.size(); ++e) {
    const Contour_edge& edge = after.edges[e];
    if (after.is_removed(edge) || (e < before.edges.size() && !before.is_removed(before.edges[e]))) continue;
    std::vector<float> points;
    for (const int v : edge.vertices) {
      const Point p = after.position(surface, v) - origin;
      points.insert(points.end(), {float(p.x()), float(p.y()), float(p.z())});
    }
    contours.push_back(std::move(points));
  }
  return contours;
}

/// Adds points on the surface by which edits name the quads, edges and corners of a texture.
void add_names(Frame& frame, const Design_chart& chart, const Point& origin) {
  const Quad_texture& texture = chart.texture.texture;
  const auto add = [&](const char* name, const std::vector<Texture_place>& places) {
    std::vector<double> v, u;
    for (const Texture_place& place : places) {
      v.push_back(place.v);
      u.push_back(place.u);
    }
    std::vector<Point> points;
    for (const Chart_location& location : locate(*chart.chart, *chart.map, v, u))
      points.push_back(position(*chart.chart, location));
    frame.add_points(name, points, origin);
  };
  std::vector<Texture_place> quads, edges, corners;
  for (int q = 0; q < int(texture.quads.size()); ++q) {
    quads.push_back(quad_place(texture, q));
    for (int c = 0; c < 4; ++c) {
      edges.push_back(edge_place(texture, {q, c}));
      corners.push_back(vertex_place(texture, {q, c}));
    }
  }
  add("quad_point", quads);
  add("edge_point", edges);
  add("corner_point", corners);
}

/// Quads and fans as they are drawn: a triangle is a quad whose last corner stands twice.
Quad_mesh drawn(const Quad_mesh& quads, const std::vector<Pole_fan>& fans) {
  Quad_mesh mesh = quads;
  for (const Pole_fan& fan : fans) {
    const int pole = int(mesh.points.size());
    mesh.points.push_back(fan.pole);
    for (std::size_t i = 0; i < fan.ring.size(); ++i) {
      const int next = fan.ring[(i + 1) % fan.ring.size()];
      mesh.quads.push_back({pole, fan.ring[i], next, next});
    }
  }
  return mesh;
}

/// The chart in which a fan lies: that of the quads around it.
int chart_of(const Pole_fan& fan, const Stitched_mesh& quads) {
  for (std::size_t q = 0; q < quads.mesh.quads.size(); ++q)
    for (const int v : quads.mesh.quads[q])
      if (v == fan.ring[0]) return quads.chart_of_quad[q];
  return -1;
}

/// Points relative to `origin`.
Json deviation_json(const Deviation& deviation, const Point& origin) {
  const auto place = [&](const Point& p) {
    return Json{p.x() - origin.x(), p.y() - origin.y(), p.z() - origin.z()};
  };
  Json worst = Json::array(), corners = Json::array();
  for (const Deviation_place& each : deviation.worst)
    worst.push_back({{"place", place(each.point)},
                     {"distance", each.distance},
                     {"of", each.on_surface ? "surface" : "quads"}});
  for (const Point& p : deviation.lost_corners) corners.push_back(place(p));
  return {{"diagonal", deviation.diagonal},
          {"of_surface", deviation.greatest_of_surface},
          {"of_quads", deviation.greatest_of_quads},
          {"worst", worst},
          {"corners", deviation.corners},
          {"lost_corners", corners},
          {"sharp_length", deviation.sharp_length},
          {"lost_sharp_length", deviation.lost_sharp_length}};
}

/// An error as pages can show it: they know saddles by their vertices.
Error shown(Error error, const Editor& editor) {
  const std::vector<Contour_node>& nodes = editor.design().network.nodes;
  if (error.element != Element_kind::node || error.index < 0 || error.index >= std::int64_t(nodes.size()))
    return error;
  const int vertex = nodes[std::size_t(error.index)].vertex;
  if (vertex >= editor.working_surface().number_of_vertices()) return error;
  error.element = Element_kind::vertex;
  error.index = vertex;
  return error;
}

Json chart_json(const Design_chart& chart) {
  return {{"id", chart.id},
          {"kind", chart.chart->kind == Chart_kind::disc ? "disc" : "annulus"},
          {"columns", chart.grid[0]},
          {"columns_high", chart.grid[0] + chart.settings.columns_gained()},
          {"rows", chart.grid[1]},
          {"height", chart.height},
          {"set_columns", chart.settings.columns},
          {"set_rows", chart.settings.rows},
          {"shift", chart.settings.shift},
          {"grading", chart.settings.grading},
          {"locked", chart.settings.locked},
          {"edited", chart.edited}};
}

} // namespace

Workpiece::Workpiece(Editor editor, const Point& origin, const Finish_options& finish)
    : m_editor(std::move(editor)), m_finish(finish), m_drawing(m_editor.working_surface()), m_origin(origin) {
  Layer_source source;
  source.surface = &m_editor.working_surface();
  source.origin = m_origin;
  m_surface = make_layers(source);
}

Result<std::unique_ptr<Workpiece>> Workpiece::create(Triangle_surface surface, const Point& origin,
                                                     Observer* observer, const Recipe& base) {
  Result<Editor> editor = Editor::create(std::move(surface), base.options, observer);
  if (!editor) return editor.error();
  return std::unique_ptr<Workpiece>(new Workpiece(std::move(*editor), origin, base.finish));
}

Result<Json> Workpiece::apply(const Json& edit, Observer* observer, bool live) {
  Result<Edit> parsed = parse_edit(edit);
  if (!parsed) return parsed.error();
  Result<Edit_report> report = m_editor.apply(*parsed, observer);
  if (!report) return shown(report.error(), m_editor);
  if (!live && observer && observer->cancelled()) {
    // The user was told that everything stays as it was.
    m_editor.undo();
    m_edits.resize(std::size_t(applied()));
    return make_error(Error_code::cancelled, "cancelled");
  }
  m_edits.resize(std::size_t(applied() - 1));
  m_edits.push_back(Json::parse(to_json(*parsed)));
  stitch();
  return json_of(*report);
}

Result<Json> Workpiece::preview(const Json& edit, Observer* observer) const {
  Result<Edit> parsed = parse_edit(edit);
  if (!parsed) return parsed.error();
  Result<Design> design = m_editor.preview(*parsed, observer);
  if (!design) return shown(design.error(), m_editor);
  return Json{{"charts", design->charts.size()},
              {"contours", new_contours(m_editor.working_surface(), m_editor.design().network,
                                        design->network, m_origin)}};
}

Result<Json> Workpiece::offer(const Json& edit, Observer* observer) const {
  Result<Edit> parsed = parse_edit(edit);
  if (!parsed) return parsed.error();
  const Result<Design> design = m_editor.preview(*parsed, observer);
  if (design) return Json(nullptr);
  if (design.error().code == Error_code::cancelled) return design.error();
  const Result<std::optional<Offer>> offer = offer_after(m_editor, *parsed, design.error(), observer);
  if (!offer) return offer.error();
  if (!*offer) return Json(nullptr);
  const Point& p = (*offer)->place;
  return Json{{"edit", Json::parse(to_json((*offer)->edit))},
              {"words", (*offer)->words},
              {"place", {p.x(), p.y(), p.z()}}};
}

Result<Json> Workpiece::hints(Observer* observer) const {
  Hint_options options; // also about what is lost, once the quads are what they will be
  if (m_quads && m_finished) options.finished = &m_quads->mesh;
  Result<std::vector<Hint>> found = suggest_edits(m_editor, options, observer);
  if (!found) return found.error();
  return Json::parse(to_json(*found));
}

void Workpiece::take_back() {
  m_editor.undo();
  forget_undone();
  stitch();
}

Result<void> Workpiece::undo() {
  if (!m_editor.can_undo()) return make_error(Error_code::impossible_request, "there is nothing to undo");
  m_editor.undo();
  stitch();
  return {};
}

Result<void> Workpiece::redo() {
  if (!m_editor.can_redo() || m_editor.position() >= int(edits().size()))
    return make_error(Error_code::impossible_request, "there is nothing to redo");
  m_editor.redo();
  stitch();
  return {};
}

void Workpiece::stitch() {
  m_finished = false;
  m_designed.clear();
  if (m_editor.design().charts.empty())
    m_quads.reset();
  else
    m_quads = m_editor.quads();
  m_fans = m_quads ? pole_fans(m_editor.design(), *m_quads) : std::vector<Pole_fan>();
  m_stitched = m_quads ? drawn(m_quads->mesh, m_fans) : Quad_mesh();
}

Result<void> Workpiece::finish(Observer* observer) {
  if (is_finished()) return {};
  Result<Finished_design> finished = m_editor.finished_quads(m_finish, observer);
  if (!finished) return finished.error();
  m_quads = std::move(finished->quads);
  m_fans = pole_fans(m_editor.design(), *m_quads);
  m_finished = true;
  return {};
}

Recipe Workpiece::recipe() const {
  Recipe recipe = recipe_of(m_editor);
  recipe.finish = m_finish;
  return recipe;
}

Layers Workpiece::layers() {
  const Design& design = m_editor.design();
  Layers layers = m_surface;
  if (design.charts.empty()) return layers;
  Layer_source source;
  source.origin = m_origin;
  for (const auto& chart : design.charts) source.chart_ids.push_back(chart->id);
  if (m_designed.empty()) {
    const Reeb_graph graph = reeb_graph(design.atlas, design.network);
    m_drawing.update(design);
    const Charted_surface charted = m_drawing.charted(design, graph);
    source.charted = &charted;
    source.extrema = design.extrema;
    source.counts = design.samples.counts;
    if (m_quads) source.textures = &m_stitched;
    m_designed = make_layers(source);
    source.charted = nullptr;
    source.textures = nullptr;
  }
  layers.insert(m_designed.begin(), m_designed.end());
  if (m_quads) {
    const Quad_mesh quads = drawn(m_quads->mesh, m_fans);
    source.quads = &quads;
    source.chart_of_quad = m_quads->chart_of_quad;
    for (const Pole_fan& fan : m_fans)
      source.chart_of_quad.insert(source.chart_of_quad.end(), fan.ring.size(), chart_of(fan, *m_quads));
    layers.merge(make_layers(source));
  }
  return layers;
}

Json Workpiece::facts() const {
  const Design& design = m_editor.design();
  Json charts = Json::array(), extrema = Json::array();
  for (const auto& chart : design.charts) charts.push_back(chart_json(*chart));
  for (const Design_extremum& e : design.extrema)
    extrema.push_back(
        {{"vertex", e.vertex}, {"maximum", e.is_maximum}, {"value", e.value}, {"pole", name(e.pole)}});
  return {{"charts", charts},
          {"extrema", extrema},
          {"target_quads", design.target_quads},
          {"edge_length", design.edge_length},
          {"fans", fan_sentence(m_fans)}};
}

Result<std::shared_ptr<const std::string>> Workpiece::deviation(const Observer* observer) const {
  if (!m_quads) return make_error(Error_code::impossible_request, "there are no quads yet");
  Deviation_options options;
  options.observer = observer;
  const Stitched_mesh paired = with_paired_fans(*m_quads, m_fans);
  Result<Deviation> measured = measure_deviation(paired.mesh, m_editor.working_surface(), options);
  if (!measured) return measured.error();
  // As they are drawn, two triangles for each pair.
  std::vector<float> of_quads;
  for (std::size_t q = 0; q < measured->of_quads.size(); ++q)
    of_quads.insert(of_quads.end(), q < m_quads->mesh.quads.size() ? 1 : 2, float(measured->of_quads[q]));
  Frame frame("deviation");
  frame.data = deviation_json(*measured, m_origin);
  frame.add("surface", std::vector<float>(measured->of_surface.begin(), measured->of_surface.end()));
  frame.add("quads", of_quads);
  std::vector<Point> ends;
  for (const auto& edge : measured->lost_sharp_edges) ends.insert(ends.end(), edge.begin(), edge.end());
  frame.add_points("lost_edges", ends, m_origin);
  return frame.encode();
}

Result<std::shared_ptr<const std::string>> Workpiece::chart(int id) const {
  const Design& design = m_editor.design();
  const int index = design.index_of(id);
  if (index < 0)
    return make_error(Error_code::impossible_request, "there is no chart of that number", Element_kind::chart,
                      id);
  const Design_chart& chart = *design.charts[index];
  const Quad_texture& texture = chart.texture.texture;
  Frame frame("chart");
  std::vector<float> plane;
  double width = 1, height = 1;
  for (std::size_t i = 0; i < texture.v.size(); ++i) {
    plane.push_back(float(texture.v[i]));
    plane.push_back(float(texture.u[i]));
    width = std::max(width, texture.v[i]);
    height = std::max(height, texture.u[i]);
  }
  std::vector<Point> points;
  for (const Chart_location& location : chart.texture.location)
    points.push_back(position(*chart.chart, location));
  frame.add("plane", plane);
  frame.add_points("position", points, m_origin);
  frame.add_indices("quad", texture.quads);
  std::vector<std::uint8_t> holes;
  for (int q = 0; q < int(texture.quads.size()); ++q) holes.push_back(texture.is_hole(q));
  frame.add("hole", holes);
  add_names(frame, chart, m_origin);
  const bool disc = chart.chart->kind == Chart_kind::disc;
  frame.data = {{"id", id}, {"kind", disc ? "disc" : "annulus"}, {"width", width}, {"height", height}};
  return frame.encode();
}

} // namespace studio
} // namespace reebquad
