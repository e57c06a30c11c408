// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/base_domain.h>
#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The vertices of the patch's border as its texture's side passes them.
std::vector<int> border(const Base_patch& p) {
  const auto id = [&](int x, int y) { return p.vertices[y * (p.columns + 1) + x]; };
  std::vector<int> out;
  for (int x = 0; x < p.columns; ++x) out.push_back(id(x, 0));
  for (int y = 0; y < p.rows; ++y) out.push_back(id(p.columns, y));
  for (int x = p.columns; x > 0; --x) out.push_back(id(x, p.rows));
  for (int y = p.rows; y > 0; --y) out.push_back(id(0, y));
  return out;
}

// From a patch's domain to the surface.
class Patch_map {
public:
  Patch_map(const Quad_mesh& mesh, const Base_patch& patch, const Surface_projector& projector)
      : m_mesh(mesh), m_patch(patch), m_projector(projector) {}

  // The vertex of the patch's own grid at a point, or -1.
  int vertex(double v, double u) const {
    if (v != std::floor(v) || u != std::floor(u)) return -1;
    return m_patch.vertices[int(u) * (m_patch.columns + 1) + int(v)];
  }

  Point at(double v, double u) const {
    const int x = std::clamp(int(v), 0, m_patch.columns - 1), y = std::clamp(int(u), 0, m_patch.rows - 1);
    const double s = v - x, t = u - y;
    const Point &a = corner(x, y), &b = corner(x + 1, y), &c = corner(x + 1, y + 1), &d = corner(x, y + 1);
    return project((1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * d + s * c),
                   ((1 - t) * (b - a) + t * (c - d)).cross((1 - s) * (d - a) + s * (c - b)));
  }

  // The nearest point of the surface that faces the same way, if there is one.
  Point project(const Point& p, const Point& normal) const {
    const double length = normal.norm();
    if (length > 0) {
      const Closest_point found = m_projector.closest_compatible(p, normal / length, 0.2);
      if (found.face >= 0) return found.point;
    }
    return m_projector.closest(p).point;
  }

private:
  const Point& corner(int x, int y) const {
    return m_mesh.points[m_patch.vertices[y * (m_patch.columns + 1) + x]];
  }

  const Quad_mesh& m_mesh;
  const Base_patch& m_patch;
  const Surface_projector& m_projector;
};

class Assembly {
public:
  Assembly(const Quad_mesh& mesh, const Base_domain& domain, const std::map<int, Patch_texture>& textures,
           const Surface_projector& projector)
      : m_mesh(mesh), m_domain(domain), m_textures(textures), m_projector(projector) {}

  Result<Textured_base> run(const Relax_options& relaxation) {
    if (Result<void> checked = check(); !checked) return checked.error();
    keep_others();
    for (const auto& [patch, texture] : m_textures) add_patch(patch, texture);
    if (!m_hanging.empty())
      if (Result<void> resolved = resolve(); !resolved) return resolved.error();
    if (m_has_holes)
      if (Result<void> left_out = leave_out_holes(); !left_out) return left_out.error();
    if (relaxation.iterations > 0 || relaxation.untangle)
      if (Result<void> relaxed = relax(relaxation); !relaxed) return relaxed.error();
    return std::move(m_out);
  }

private:
  Result<void> check() const {
    if (m_domain.patch_of_quad.size() != m_mesh.quads.size())
      return make_error(Error_code::impossible_request, "the patches are not those of the mesh");
    for (const auto& [patch, texture] : m_textures) {
      if (patch < 0 || patch >= int(m_domain.patches.size()))
        return make_error(Error_code::impossible_request,
                          "a texture is given for a patch that does not exist", Element_kind::chart, patch);
      const int size = int(texture.steps.size());
      if (Result<void> checked = check_texture(texture.texture, {size}, false); !checked)
        return make_error(Error_code::impossible_request, checked.error().message, Element_kind::chart,
                          patch);
      const Base_patch& p = m_domain.patches[patch];
      double wanted = 0;
      for (double step : texture.steps)
        if (step == std::floor(step) && step != wanted++) wanted = -1e9;
      if (wanted != 2.0 * (p.columns + p.rows) || !std::is_sorted(texture.steps.begin(), texture.steps.end()))
        return make_error(Error_code::impossible_request,
                          "the side of a texture does not have the vertices of its patch's border",
                          Element_kind::chart, patch);
      for (std::size_t i = 0; i < texture.texture.v.size(); ++i)
        if (!(texture.texture.v[i] >= 0 && texture.texture.v[i] <= p.columns && texture.texture.u[i] >= 0 &&
              texture.texture.u[i] <= p.rows))
          return make_error(Error_code::impossible_request, "a texture reaches out of its patch's domain",
                            Element_kind::chart, patch);
    }
    return {};
  }

  // The quads of all other patches, and the vertices of these and of the borders.
  void keep_others() {
    std::vector<char> used(m_mesh.points.size(), 0);
    for (std::size_t q = 0; q < m_mesh.quads.size(); ++q)
      if (m_textures.count(m_domain.patch_of_quad[q]) == 0)
        for (int v : m_mesh.quads[q]) used[v] = 1;
    for (const auto& entry : m_textures)
      for (int v : border(m_domain.patches[entry.first])) used[v] = 1;
    m_number.assign(m_mesh.points.size(), -1);
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v]) m_number[v] = add_vertex(m_mesh.points[v], int(v));
    for (std::size_t q = 0; q < m_mesh.quads.size(); ++q) {
      Quad quad = m_mesh.quads[q];
      if (m_textures.count(m_domain.patch_of_quad[q]) > 0) continue;
      for (int& v : quad) v = m_number[v];
      add_quad(quad, m_domain.patch_of_quad[q], false, true);
    }
  }

  int add_vertex(const Point& p, int origin) {
    m_out.mesh.points.push_back(p);
    m_out.vertex_origin.push_back(origin);
    return int(m_out.mesh.points.size()) - 1;
  }

  void add_quad(const Quad& quad, int patch, bool hole, bool fixed) {
    m_out.mesh.quads.push_back(quad);
    m_out.patch_of_quad.push_back(patch);
    m_hole.push_back(hole);
    m_fixed.push_back(fixed);
    m_has_holes = m_has_holes || hole;
  }

  void add_patch(int index, const Patch_texture& placed) {
    const Base_patch& patch = m_domain.patches[index];
    const Quad_texture& t = placed.texture;
    const std::vector<int> around = border(patch);
    const bool framed = t.sides[0].size() > around.size();
    const double frame = framed ? std::min({0.5, 0.25 * patch.columns, 0.25 * patch.rows}) : 0;
    const Patch_map map(m_mesh, patch, m_projector);
    std::vector<int> name(t.v.size(), -1);
    for (std::size_t i = 0; !framed && i < around.size(); ++i) name[t.sides[0][i]] = m_number[around[i]];
    for (std::size_t i = 0; i < t.v.size(); ++i) {
      if (name[i] >= 0) continue;
      const double v = framed ? frame + t.v[i] * (1 - 2 * frame / patch.columns) : t.v[i],
                   u = framed ? frame + t.u[i] * (1 - 2 * frame / patch.rows) : t.u[i];
      const int old = map.vertex(v, u);
      name[i] = old >= 0 ? add_vertex(m_mesh.points[old], old) : add_vertex(map.at(v, u), -1);
    }
    if (framed) add_frame(index, placed, around, name);
    for (std::size_t f = 0; f < t.quads.size(); ++f) {
      const Quad& q = t.quads[f];
      add_quad({name[q[0]], name[q[1]], name[q[2]], name[q[3]]}, index, t.is_hole(int(f)), true);
    }
  }

  // A quad for each edge of the patch's border; inside it has the T-junctions.
  void add_frame(int index, const Patch_texture& placed, const std::vector<int>& around,
                 const std::vector<int>& name) {
    const std::vector<int>& side = placed.texture.sides[0];
    std::size_t i = 0;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const int from = name[side[i++]];
      std::vector<int> between;
      while (i < side.size() && placed.steps[i] != std::floor(placed.steps[i]))
        between.push_back(name[side[i++]]);
      const int to = name[side[i % side.size()]];
      add_quad({m_number[around[k]], m_number[around[(k + 1) % around.size()]], to, from}, index, false,
               false);
      if (between.empty()) continue;
      m_out.t_junctions += int(between.size());
      std::reverse(between.begin(), between.end());
      m_hanging.push_back({int(m_out.mesh.quads.size()) - 1, 2, between});
    }
  }

  Result<void> resolve() {
    T_junction_options options;
    options.may_end_on_boundary = false;
    options.fixed = m_fixed;
    Result<Resolved_mesh> resolved = resolve_t_junctions(m_out.mesh, m_hanging, options);
    if (!resolved) return resolved.error();
    const std::size_t before = m_out.mesh.points.size();
    m_out.mesh = std::move(resolved->mesh);
    for (std::size_t v = before; v < m_out.mesh.points.size(); ++v)
      m_out.mesh.points[v] = m_projector.closest(m_out.mesh.points[v]).point;
    m_out.extraordinary = std::move(resolved->extraordinary);
    m_out.vertex_origin.resize(m_out.mesh.points.size(), -1);
    std::vector<int> patch;
    std::vector<char> hole;
    for (int parent : resolved->parent) {
      patch.push_back(m_out.patch_of_quad[parent]);
      hole.push_back(m_hole[parent]);
    }
    m_out.patch_of_quad = std::move(patch);
    m_hole = std::move(hole);
    return {};
  }

  Result<void> leave_out_holes() {
    Textured_base out;
    std::vector<int> number(m_out.mesh.points.size(), -1);
    for (std::size_t f = 0; f < m_hole.size(); ++f)
      if (!m_hole[f])
        for (int v : m_out.mesh.quads[f]) number[v] = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] < 0) continue;
      number[v] = int(out.mesh.points.size());
      out.mesh.points.push_back(m_out.mesh.points[v]);
      out.vertex_origin.push_back(m_out.vertex_origin[v]);
    }
    for (std::size_t f = 0; f < m_hole.size(); ++f) {
      if (m_hole[f]) continue;
      Quad quad = m_out.mesh.quads[f];
      for (int& v : quad) v = number[v];
      out.mesh.quads.push_back(quad);
      out.patch_of_quad.push_back(m_out.patch_of_quad[f]);
    }
    for (int v : m_out.extraordinary)
      if (number[v] >= 0) out.extraordinary.push_back(number[v]);
    out.t_junctions = m_out.t_junctions;
    m_out = std::move(out);
    if (const Result<Base_domain> sound = base_domain(m_out.mesh, Base_cut::everywhere); !sound)
      return make_error(Error_code::refused_edit, "the holes touch: " + sound.error().message,
                        sound.error().element, sound.error().index);
    return {};
  }

  Result<void> relax(const Relax_options& options) {
    std::vector<char> fixed;
    for (int origin : m_out.vertex_origin) fixed.push_back(origin >= 0);
    if (std::find(fixed.begin(), fixed.end(), 0) == fixed.end()) return {};
    Result<Relax_report> report = relax_quads(m_out.mesh, m_projector, fixed, options);
    if (!report) return report.error();
    m_out.relaxation = *report;
    return {};
  }

  const Quad_mesh& m_mesh;
  const Base_domain& m_domain;
  const std::map<int, Patch_texture>& m_textures;
  const Surface_projector& m_projector;
  Textured_base m_out;
  std::vector<int> m_number;         ///< per vertex of the base mesh: in the result, or -1
  std::vector<char> m_hole, m_fixed; ///< per quad
  std::vector<Hanging_edge> m_hanging;
  bool m_has_holes = false;
};

} // namespace

Result<Textured_base> apply_textures(const Quad_mesh& mesh, const Base_domain& domain,
                                     const std::map<int, Patch_texture>& textures,
                                     const Surface_projector& projector, const Relax_options& relaxation) {
  return Assembly(mesh, domain, textures, projector).run(relaxation);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
