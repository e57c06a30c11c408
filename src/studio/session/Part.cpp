// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Part.h"

#include "session/Edit_text.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <chrono>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

void append(Quad_mesh& all, const Quad_mesh& mesh) {
  const int first = int(all.points.size());
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  for (const Quad& q : mesh.quads)
    all.quads.push_back({q[0] + first, q[1] + first, q[2] + first, q[3] + first});
}

/// Points and triangles only.
void append(Triangle_surface& all, const Triangle_surface& surface) {
  const int first = all.number_of_vertices();
  all.points.insert(all.points.end(), surface.points.begin(), surface.points.end());
  for (const Triangle& t : surface.triangles)
    all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

void append(Polygon_soup& all, const Polygon_soup& soup) {
  const int first = all.number_of_points();
  all.points.insert(all.points.end(), soup.points.begin(), soup.points.end());
  for (int p = 0; p < soup.number_of_polygons(); ++p) {
    for (int i = soup.begin[p]; i < soup.begin[p + 1]; ++i) all.corner.push_back(soup.corner[i] + first);
    all.close_polygon();
  }
}

Certificate_options certificate_options(bool wholly, const Observer* observer) {
  Certificate_options options;
  options.measure_shape = options.find_self_intersections = wholly;
  options.observer = observer;
  return options;
}

} // namespace

Part::Part(Triangle_surface surface, const Point& origin) : m_surface(std::move(surface)), m_origin(origin) {
  const int loops = int(boundary_loops(m_surface).size()), chi = euler_characteristic(m_surface);
  m_facts = {{"points", m_surface.number_of_vertices()},
             {"triangles", m_surface.number_of_faces()},
             {"euler_characteristic", chi},
             {"genus", (2 - chi - loops) / 2},
             {"boundary_loops", loops}};
}

Result<void> Part::begin(Observer* observer) {
  if (m_work) return {};
  Result<std::unique_ptr<Workpiece>> work = Workpiece::create(m_surface, m_origin, observer);
  if (!work) return work.error();
  m_work = std::move(*work);
  m_surface = Triangle_surface();
  return {};
}

Result<void> Part::follow(const Recipe& recipe, Observer& observer) {
  Result<std::unique_ptr<Workpiece>> work = Workpiece::create(surface(), m_origin, &observer, recipe);
  if (!work) return work.error();
  std::vector<double> milliseconds;
  for (std::size_t i = 0; i < recipe.edits.size(); ++i) {
    const auto start = std::chrono::steady_clock::now();
    const Json edit = Json::parse(to_json(recipe.edits[i]));
    if (const Result<Json> done = (*work)->apply(edit, &observer); !done) {
      Error error = done.error();
      if (error.code == Error_code::cancelled) return error;
      const Result<Json> offer = (*work)->offer(edit, &observer);
      error.message = "step " + std::to_string(i + 1) + " of " + std::to_string(recipe.edits.size()) + " (" +
                      edit_text(edit) + ") cannot be done on this mesh: " + error.message;
      if (offer && !offer->is_null())
        error.message += ". What works: " + (*offer)["words"].get<std::string>();
      return error;
    }
    milliseconds.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  Recipe base = recipe;
  base.edits.clear();
  base.component = base.fill_holes = 0;
  const std::string text = to_json(base);
  m_base = text == to_json(Recipe()) ? Json(nullptr) : Json::parse(text);
  m_work = std::move(*work);
  m_surface = Triangle_surface();
  m_milliseconds = std::move(milliseconds);
  return {};
}

void Part::measure() {
  m_certificate.reset();
  m_statistics.reset();
  if (const Stitched_mesh* quads = m_work->quads()) m_statistics = quad_statistics(quads->mesh);
}

void Part::took(double milliseconds) {
  m_milliseconds.resize(std::size_t(m_work->applied() - 1), 0);
  m_milliseconds.push_back(milliseconds);
}

Result<void> Part::finish(Observer& observer) {
  if (is_finished()) return {};
  observer.progress("relaxing the quads", 0);
  if (Result<void> done = m_work->finish(&observer); !done) return done;
  measure();
  certify(false, nullptr);
  return {};
}

Stitched_mesh Part::paired_quads() const {
  return with_paired_fans(*m_work->quads(), m_work->fans());
}

void Part::certify(bool wholly, const Observer* observer) {
  const Stitched_mesh quads = paired_quads();
  m_certificate = CGAL::Reeb_quadrangulation::certify(
      {quads.mesh, &surface(), quads.valences, quads.components}, certificate_options(wholly, observer));
}

Json Part::facts() const {
  Json facts = m_facts;
  facts["quads"] = has_quads() ? m_work->quads()->mesh.quads.size() : 0;
  facts["edits"] = m_work ? m_work->applied() : 0;
  return facts;
}

Json Part::history() const {
  Json list = Json::array();
  const std::vector<Json>& edits = m_work->edits();
  for (std::size_t i = 0; i < edits.size(); ++i) {
    Json edit = edits[i];
    edit.erase("values"); // a function on the surface: large, and nothing that the page shows
    list.push_back({{"text", edit_text(edit)},
                    {"edit", std::move(edit)},
                    {"milliseconds", i < m_milliseconds.size() ? m_milliseconds[i] : 0.0}});
  }
  return list;
}

// Sum of 4 - valence over interior, of 3 - valence over boundary vertices, is 4 (V - E + F): so the surface
// says how many extraordinary vertices there must be, and the statistics how many there are. Two triangles of
// a fan count as a quad: the sum is the same.
Json Part::budget() const {
  Json interior = Json::object(), boundary = Json::object();
  if (m_statistics) {
    const Mesh_statistics statistics =
        m_work->fans().empty() ? *m_statistics : quad_statistics(paired_quads().mesh);
    for (const auto& [valence, number] : statistics.interior_valences)
      interior[std::to_string(valence)] = number;
    for (const auto& [valence, number] : statistics.boundary_valences)
      boundary[std::to_string(valence)] = number;
  }
  return {{"needed", 4 * m_facts["euler_characteristic"].get<int>()},
          {"interior", interior},
          {"boundary", boundary}};
}

Polygon_soup joined_polygons(const Parts& parts) {
  Polygon_soup all;
  for (const auto& part : parts)
    if (part->has_quads()) append(all, with_fans(part->work()->quads()->mesh, part->work()->fans()));
  return all;
}

std::shared_ptr<const std::string> others_layer(const Parts& parts, std::size_t chosen, const Point& origin) {
  Triangle_surface all;
  std::vector<std::uint32_t> part_of_point;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == chosen) continue;
    append(all, parts[i]->surface());
    part_of_point.resize(all.points.size(), std::uint32_t(i + 1));
  }
  Frame frame("others");
  frame.add_points("position", all.points, origin);
  frame.add_indices("triangle", all.triangles);
  frame.add("part", part_of_point);
  return frame.encode();
}

Measured_parts measure_together(const Parts& parts, const Observer& observer) {
  Quad_mesh quads, paired;
  Triangle_surface surface;
  std::map<int, int> valences;
  std::vector<std::pair<int, int>> components;
  bool has_holes = false;
  for (const auto& part : parts) {
    if (!part->has_quads()) continue;
    const Stitched_mesh mesh = part->paired_quads();
    append(quads, part->work()->quads()->mesh);
    append(paired, mesh.mesh);
    append(surface, part->surface());
    for (const auto& [valence, number] : mesh.valences) valences[valence] += number;
    has_holes = has_holes || !mesh.components.empty();
    const Json facts = part->facts();
    if (mesh.components.empty())
      components.push_back({facts["euler_characteristic"], facts["boundary_loops"]});
    else
      components.insert(components.end(), mesh.components.begin(), mesh.components.end());
  }
  if (!has_holes) components.clear(); // they are the surface's
  return {certify({paired, &surface, valences, components}, certificate_options(true, &observer)),
          quad_statistics(quads)};
}

} // namespace studio
} // namespace reebquad
