// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quad_connectivity.h"
#include <CGAL/Reeb_quadrangulation/base_domain.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::across;
using internal::next;
using internal::previous;

class Cutter {
public:
  explicit Cutter(const Quad_mesh& mesh) : m_quads(mesh.quads), m_marked(4 * mesh.quads.size(), 0) {}

  Result<Base_domain> run(const Quad_mesh& mesh, Base_cut cut) {
    if (Result<void> connected = connect(int(mesh.points.size())); !connected) return connected.error();
    for (int h = 0; h < int(m_opposite.size()); ++h)
      if (m_opposite[h] < 0 || cut == Base_cut::everywhere) m_marked[h] = 1;
    if (cut == Base_cut::separatrices)
      for (int h = 0; h < int(m_opposite.size()); ++h)
        if (m_extraordinary[internal::source(m_quads, h)]) trace(h);
    for (;;) {
      Base_domain domain;
      const int failed = collect(domain);
      if (failed < 0) return domain;
      for (int h = 4 * failed; h < 4 * failed + 4; ++h)
        if (!m_marked[h]) { // a quad of four marked edges is a rectangle
          trace_all(h);
          break;
        }
    }
  }

private:
  Result<void> connect(int vertices) {
    for (std::size_t q = 0; q < m_quads.size(); ++q)
      for (int v : m_quads[q])
        if (v < 0 || v >= vertices)
          return make_error(Error_code::not_a_surface, "a quad names a vertex that does not exist",
                            Element_kind::face, std::int64_t(q));
    if (const int bad = internal::connect_quads(m_quads, vertices, m_opposite); bad >= 0)
      return make_error(Error_code::not_a_surface,
                        "the quads are not an oriented manifold mesh: an edge of quad " +
                            std::to_string(bad) +
                            " is passed twice in the same direction, or joins a vertex to itself",
                        Element_kind::face, bad);
    std::vector<int> number(vertices, 0), fan(vertices, 0), ends(vertices, 0);
    std::vector<char> begun(vertices, 0);
    for (int h = 0; h < int(m_opposite.size()); ++h) {
      const int v = internal::source(m_quads, h);
      ++number[v];
      ends[v] += m_opposite[h] < 0;
      if (begun[v] && m_opposite[h] >= 0) continue;
      begun[v] = 1; // of a boundary vertex from the halfedge on the boundary
      fan[v] = 0;
      int g = h;
      do {
        ++fan[v];
        g = m_opposite[previous(g)];
      } while (g >= 0 && g != h);
    }
    m_extraordinary.assign(vertices, 0);
    for (int v = 0; v < vertices; ++v) {
      if (number[v] != fan[v] || ends[v] > 1)
        return make_error(Error_code::not_a_surface,
                          "the quads at vertex " + std::to_string(v) + " are not one fan",
                          Element_kind::vertex, v);
      m_extraordinary[v] = number[v] != (ends[v] > 0 ? 2 : 4);
    }
    return {};
  }

  void mark(int h) {
    m_marked[h] = 1;
    if (m_opposite[h] >= 0) m_marked[m_opposite[h]] = 1;
  }

  // Marks the straight line of edges that begins with h, to an extraordinary vertex, the boundary, or itself.
  void trace(int h) {
    for (bool first = true; first || !m_marked[h]; first = false) {
      mark(h);
      const int turn = m_opposite[next(h)];
      if (m_extraordinary[internal::target(m_quads, h)] || turn < 0) return;
      h = next(turn);
    }
  }

  // The lines of all edges that leave the source of h.
  void trace_all(int h) {
    int g = h;
    do {
      trace(g);
      g = m_opposite[previous(g)];
    } while (g >= 0 && g != h);
    for (g = h; m_opposite[g] >= 0;) {
      g = next(m_opposite[g]);
      if (g == h) return;
      trace(g);
    }
  }

  // Returns the first quad of a part that is not a rectangle, or -1.
  int collect(Base_domain& domain) const {
    domain.patch_of_quad.assign(m_quads.size(), -1);
    for (int q = 0; q < int(m_quads.size()); ++q) {
      if (domain.patch_of_quad[q] >= 0) continue;
      const int patch = int(domain.patches.size());
      std::vector<int> part{q};
      domain.patch_of_quad[q] = patch;
      int corner = -1; // the smallest halfedge that begins a side
      for (std::size_t i = 0; i < part.size(); ++i)
        for (int h = 4 * part[i]; h < 4 * part[i] + 4; ++h) {
          if (m_marked[h] && m_marked[previous(h)] && (corner < 0 || h < corner)) corner = h;
          if (m_marked[h] || domain.patch_of_quad[m_opposite[h] / 4] >= 0) continue;
          domain.patch_of_quad[m_opposite[h] / 4] = patch;
          part.push_back(m_opposite[h] / 4);
        }
      Base_patch rectangle;
      if (corner < 0 || !walk(corner, part.size(), rectangle)) return q;
      domain.patches.push_back(std::move(rectangle));
    }
    return -1;
  }

  // The rectangle row by row from its first corner; false if it is none.
  bool walk(int corner, std::size_t size, Base_patch& out) const {
    for (int start = corner;; start = m_opposite[across(start)]) {
      int h = start, columns = 1;
      std::vector<int> row{h};
      for (; !m_marked[next(h)] && columns <= int(size); ++columns) {
        h = next(m_opposite[next(h)]);
        row.push_back(h);
      }
      if (out.rows == 0) {
        out.columns = columns;
        add_vertices(row, false, out);
      } else if (columns != out.columns)
        return false;
      for (int g : row) out.quads.push_back(g / 4);
      add_vertices(row, true, out);
      ++out.rows;
      if (out.quads.size() > size) return false;
      if (m_marked[across(start)]) break;
    }
    std::vector<int> each = out.quads;
    std::sort(each.begin(), each.end());
    return each.size() == size && std::adjacent_find(each.begin(), each.end()) == each.end();
  }

  void add_vertices(const std::vector<int>& row, bool above, Base_patch& out) const {
    for (int h : row)
      out.vertices.push_back(above ? internal::target(m_quads, across(h)) : internal::source(m_quads, h));
    const int last = row.back();
    out.vertices.push_back(above ? internal::source(m_quads, across(last)) : internal::target(m_quads, last));
  }

  const std::vector<Quad>& m_quads;
  std::vector<int> m_opposite;
  std::vector<char> m_marked; ///< per halfedge: on the border of a patch
  std::vector<char> m_extraordinary;
};

} // namespace

Result<Base_domain> base_domain(const Quad_mesh& mesh, Base_cut cut) {
  return Cutter(mesh).run(mesh, cut);
}

Patch_texture patch_texture(const Base_patch& patch) {
  Patch_texture out{regular_disc_texture(patch.columns, patch.rows, false), {}};
  for (std::size_t i = 0; i < out.texture.sides[0].size(); ++i) out.steps.push_back(double(i));
  return out;
}

Result<Patch_texture> edit_texture(const Patch_texture& texture, const Texture_edit& edit) {
  Texture_limits limits;
  limits.kept.resize(1);
  const int size = int(texture.steps.size());
  for (int i = 0; i < size; ++i)
    if (texture.steps[i] == std::floor(texture.steps[i])) limits.kept[0].push_back(i);
  const double around = double(limits.kept[0].size());
  Result<Edited_texture> edited = edit_texture(texture.texture, edit, limits);
  if (!edited) return edited.error();
  Patch_texture out{std::move(edited->texture), {}};
  for (double entry : edited->side_steps[0]) {
    const int i = std::min(size - 1, int(entry));
    const double a = texture.steps[i], b = i + 1 < size ? texture.steps[i + 1] : around;
    out.steps.push_back(entry == i ? a : a + (entry - i) * (b - a));
  }
  return out;
}

Base_locator::Base_locator(const Quad_mesh& mesh, const Base_domain& domain)
    : m_patch(domain.patch_of_quad), m_cell(mesh.quads.size()), m_corner(mesh.quads.size(), 0) {
  auto surface = std::make_shared<Triangle_surface>();
  surface->points = mesh.points;
  for (const Quad& q : mesh.quads) {
    surface->triangles.push_back({q[0], q[1], q[2]});
    surface->triangles.push_back({q[0], q[2], q[3]});
  }
  m_surface = surface;
  m_projector = std::make_shared<Surface_projector>(*m_surface);
  m_projector->build();
  for (const Base_patch& p : domain.patches)
    for (int y = 0; y < p.rows; ++y)
      for (int x = 0; x < p.columns; ++x) {
        const int q = p.quads[y * p.columns + x], first = p.vertices[y * (p.columns + 1) + x],
                  second = p.vertices[y * (p.columns + 1) + x + 1];
        m_cell[q] = {x, y};
        // Two corners: a patch that closes on itself may have a quad whose first vertex is in several places.
        for (int i = 0; i < 4; ++i)
          if (mesh.quads[q][i] == first && mesh.quads[q][(i + 1) % 4] == second) m_corner[q] = i;
      }
}

Base_locator::Place Base_locator::locate(const Point& point) const {
  const Closest_point found = m_projector->closest(point);
  const int q = found.face / 2;
  const Triangle& t = m_surface->triangles[found.face];
  const Point a = m_surface->points[t[1]] - m_surface->points[t[0]],
              b = m_surface->points[t[2]] - m_surface->points[t[0]],
              p = found.point - m_surface->points[t[0]];
  const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), det = aa * bb - ab * ab;
  double s = 1.0 / 3, r = 1.0 / 3;
  if (det > 0) {
    s = std::clamp((bb * a.dot(p) - ab * b.dot(p)) / det, 0.0, 1.0);
    r = std::clamp((aa * b.dot(p) - ab * a.dot(p)) / det, 0.0, 1.0 - s);
  }
  // The corners of the cell in the order of the quad's, from the quad's first.
  static const double corner_v[] = {0, 1, 1, 0}, corner_u[] = {0, 0, 1, 1};
  const int first = (4 - m_corner[q]) % 4, second = (first + 1 + found.face % 2) % 4,
            third = (second + 1) % 4;
  const double w = 1 - s - r;
  return {m_patch[q], m_cell[q][0] + w * corner_v[first] + s * corner_v[second] + r * corner_v[third],
          m_cell[q][1] + w * corner_u[first] + s * corner_u[second] + r * corner_u[third]};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
