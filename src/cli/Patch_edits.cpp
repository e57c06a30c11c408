// SPDX-License-Identifier: GPL-3.0-or-later
#include "Patch_edits.h"

#include "Command.h"
#include "Failure.h"

#include <CGAL/Reeb_quadrangulation/texture_operator.h>

#include <locale>
#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr std::pair<const char*, Texture_operator> operators[] = {
    {"subdivide_texture", Texture_operator::subdivide},
    {"coarsen_texture", Texture_operator::coarsen},
    {"insert_polychord", Texture_operator::insert_polychord},
    {"delete_polychord", Texture_operator::delete_polychord},
    {"inset_quads", Texture_operator::inset_quads},
    {"open_quad", Texture_operator::open_quad},
    {"close_quad", Texture_operator::close_quad},
    {"rotate_edge", Texture_operator::rotate_edge},
    {"rotate_edge_back", Texture_operator::rotate_edge_back},
    {"rotate_vertex", Texture_operator::rotate_vertex},
    {"insert_doublet", Texture_operator::insert_doublet},
    {"remove_doublet", Texture_operator::remove_doublet},
    {"delete_quads", Texture_operator::delete_quads},
    {"restore_quads", Texture_operator::restore_quads}};

Error wrong_number(const char* message) {
  return make_error(Error_code::impossible_request, message);
}

// The edit of a name, its points and its fraction.
Result<Edit> named_edit(const std::string& name, const std::vector<Surface_point>& points, double at) {
  for (const auto& [text, operation] : operators) {
    if (name != text) continue;
    const Edit_texture edit{operation, points, at, Edit_scope::chart};
    const Result<Texture_edit> fits = texture_operator(edit, std::vector<Texture_place>(points.size()));
    if (!fits) return fits.error();
    return Edit(edit);
  }
  if (name == "move_vertices") {
    if (points.size() != 2) return wrong_number("two points are needed, from where and to where");
    Drag_vertices drag;
    drag.points = {points[0]};
    drag.to = points[1];
    drag.steps = 3;
    return Edit(drag);
  }
  if (name == "relax_vertices") {
    if (points.size() != 1) return wrong_number("exactly one point is needed");
    Relax_texture relax;
    relax.at = points[0];
    return Edit(relax);
  }
  return make_error(Error_code::impossible_request, "there is no operator '" + name + "'");
}

} // namespace

Edit parse_patch_edit(const std::string& text) {
  const auto fail = [&](const std::string& why) { return Usage_error("the edit '" + text + "': " + why); };
  std::istringstream words(text);
  std::string name;
  std::vector<Surface_point> points;
  double at = 0.5;
  if (!(words >> name)) throw fail("it is empty");
  for (std::string word; words >> word;) {
    const bool fraction = word.rfind("at=", 0) == 0;
    std::string numbers = fraction ? word.substr(3) : word;
    for (char& c : numbers)
      if (c == ',') c = ' ';
    std::istringstream stream(numbers);
    stream.imbue(std::locale::classic());
    Point p = Point::Zero();
    const bool read = fraction ? bool(stream >> at) : bool(stream >> p.x() >> p.y() >> p.z());
    if (!read || !(stream >> std::ws).eof() || !p.allFinite())
      throw fail("'" + word + "' is neither a point x,y,z nor at=FRACTION");
    if (!fraction) points.push_back({p, -1});
  }
  Result<Edit> edit = named_edit(name, points, at);
  if (!edit) throw fail(edit.error().message);
  return std::move(*edit);
}

Patch_edits::Patch_edits(const Quad_mesh& mesh, const Base_domain& domain)
    : m_domain(domain), m_locator(mesh, domain), m_edge(domain.patches.size(), 0) {
  for (std::size_t p = 0; p < domain.patches.size(); ++p) {
    for (int q : domain.patches[p].quads)
      for (int i = 0; i < 4; ++i)
        m_edge[p] += (mesh.points[mesh.quads[q][(i + 1) % 4]] - mesh.points[mesh.quads[q][i]]).norm();
    m_edge[p] /= 4.0 * double(domain.patches[p].quads.size());
  }
}

void Patch_edits::apply(const Edit& edit, const std::string& called) {
  int patch = -1;
  const Result<Texture_edit> made = texture_edit(edit, patch);
  if (!made) throw Failure(exit_code(made.error().code), called + ": " + made.error().message);
  const auto entry = m_textures.try_emplace(patch, patch_texture(m_domain.patches[patch])).first;
  Result<Patch_texture> edited = edit_texture(entry->second, *made);
  if (!edited)
    throw Failure(exit_code(edited.error().code), called + " does not apply: " + edited.error().message);
  entry->second = std::move(*edited);
}

// The patch is that of the first point; -1 if another lies in another one.
Patch_edits::Places Patch_edits::places(const Points& points, int& patch) const {
  Places all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Base_locator::Place place = m_locator.locate(points[i].point);
    if (i == 0 && patch < 0) patch = place.patch;
    if (place.patch != patch) throw Usage_error("the points of an edit lie in different patches");
    all.push_back({place.v, place.u});
  }
  return all;
}

Result<Texture_edit> Patch_edits::texture_edit(const Edit& edit, int& patch) const {
  const auto of_one_patch = [](Edit_scope scope) { return scope == Edit_scope::chart; };
  const Error too_far = make_error(Error_code::impossible_request, "the scope of an edit is one patch");
  if (const auto* e = std::get_if<Edit_texture>(&edit)) {
    if (!of_one_patch(e->scope)) return too_far;
    return texture_operator(*e, places(e->points, patch));
  }
  if (const auto* e = std::get_if<Drag_vertices>(&edit)) {
    Move_vertices move;
    move.vertices = places(e->points, patch);
    if (patch < 0) return make_error(Error_code::impossible_request, "no points are given");
    const Places to = places({e->to}, patch);
    move.dv = to[0].v - move.vertices[0].v;
    move.du = to[0].u - move.vertices[0].u;
    move.anchors = places(e->anchors, patch);
    move.radius = e->radius / m_edge[patch];
    move.falloff = e->falloff;
    move.rings = e->rings;
    move.steps = e->steps;
    return Texture_edit(move);
  }
  if (const auto* e = std::get_if<Relax_texture>(&edit)) {
    if (!of_one_patch(e->scope)) return too_far;
    if (e->radius > 0)
      return make_error(Error_code::impossible_request, "in a patch the whole texture is relaxed: no radius");
    places({e->at}, patch);
    return Texture_edit(Relax_vertices{{}, e->steps, places(e->anchors, patch)});
  }
  return make_error(Error_code::impossible_request,
                    "it is no edit of a texture: edit_texture, drag_vertices or relax_texture");
}

} // namespace reebquad
