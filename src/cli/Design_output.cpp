// SPDX-License-Identifier: GPL-3.0-or-later
#include "Design_output.h"

#include "Failure.h"
#include "Guides_output.h"
#include "Mirror_output.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/picture_scene.h>
#include <CGAL/Reeb_quadrangulation/render.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

Design_output::Design_output(const Editor& editor, const Design_quads& made, const Triangle_surface& input)
    : m_editor(editor), m_made(made), m_quads(made.quads), m_fans(made.fans),
      m_statistics(quad_statistics(made.quads.mesh, &input)) {
  const Stitched_mesh closed = with_paired_fans(m_quads, m_fans);
  m_certificate = certify({closed.mesh, &input, closed.valences, closed.components});
  if (made.mirror) m_mirror = check_mirror(m_quads.mesh, made.mirror->mirror.plane, made.mirror->image);
}

bool Design_output::passed() const {
  return m_certificate.passed && (!m_mirror || is_kept(*m_made.mirror, *m_mirror));
}

Polygon_soup Design_output::polygons() const {
  return with_fans(m_quads.mesh, m_fans);
}

std::string Design_output::text() const {
  const std::string fans = fan_sentence(m_fans);
  return to_text(m_certificate) + (fans.empty() ? "" : fans + "\n") + "\n" + to_text(m_statistics) +
         guides_text(m_made.guides) + (m_mirror ? mirror_text(*m_made.mirror, *m_mirror) : "");
}

std::string Design_output::report(const std::string& input, const std::string& output) const {
  const Design& design = m_editor.design();
  Json out;
  out["schema"] = 1;
  out["version"] = REEBQUAD_VERSION;
  out["input"] = input;
  out["output"] = output.empty() ? Json(nullptr) : Json(output);
  out["edits"] = Json::array();
  for (int i = 0; i < m_editor.position(); ++i) out["edits"].push_back(name(m_editor.edits()[i]));
  int discs = 0, edited = 0;
  for (const auto& chart : design.charts) {
    discs += chart->chart->kind == Chart_kind::disc;
    edited += chart->edited;
  }
  out["design"] = {{"charts", design.charts.size()},
                   {"discs", discs},
                   {"extrema", design.extrema.size()},
                   {"edge_length", design.edge_length}};
  out["textures"] = {{"edited", edited},
                     {"t_junctions", m_quads.t_junctions},
                     {"extraordinary_vertices", m_quads.extraordinary},
                     {"holes", with_paired_fans(m_quads, m_fans).holes}};
  out["predicted_valences"] = Json::object();
  for (const auto& [valence, number] : m_quads.valences)
    out["predicted_valences"][std::to_string(valence)] = number;
  out["all_quad"] = m_fans.empty();
  out["fans"] = Json::array();
  for (const Pole_fan& fan : m_fans)
    out["fans"].push_back(
        {{"pole", {fan.pole.x(), fan.pole.y(), fan.pole.z()}}, {"triangles", fan.ring.size()}});
  out["certificate"] = Json::parse(to_json(m_certificate));
  out["statistics"] = Json::parse(to_json(m_statistics));
  out["guides"] = guides_json(m_made.guides);
  out["mirror"] = m_mirror ? mirror_json(*m_made.mirror, *m_mirror) : Json(nullptr);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

void add_contours(Scene& scene, const std::vector<Point>& points, const Design& design) {
  for (const Contour_edge& edge : design.network.edges)
    for (std::size_t i = 1; i < edge.vertices.size(); ++i)
      scene.lines.push_back({points[edge.vertices[i - 1]], points[edge.vertices[i]], {24, 24, 30}, 2.5});
  for (const Design_extremum& e : design.extrema)
    scene.dots.push_back({points[e.vertex], e.is_maximum ? Colour{196, 64, 48} : Colour{40, 90, 160}});
}

} // namespace

void Design_output::write_pictures(const std::string& folder) const {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw Failure(Exit_code::other_failure, folder + ": the folder cannot be made: " + failed.message());
  constexpr int width = 960, height = 720;
  const auto write = [&](const Scene& scene, const char* file_name) {
    const std::string file = (std::filesystem::path(folder) / file_name).string();
    succeed_or_fail(write_png(render(scene, camera(View::three_quarter, Up_axis::z), width, height), file),
                    file);
  };
  const Design& design = m_editor.design();
  const Embedded_design embedded = embed_design(m_editor.working_surface(), design);
  Scene charts = face_colour_scene(embedded.embedding.surface, embedded.chart_of_face);
  add_contours(charts, embedded.embedding.surface.points, design);
  write(charts, "charts.png");
  write(quad_scene(polygons()), "quads.png");
}

} // namespace reebquad
