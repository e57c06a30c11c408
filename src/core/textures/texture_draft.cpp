// SPDX-License-Identifier: GPL-3.0-or-later
#include "textures/texture_draft.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

Texture_draft::Texture_draft(const Quad_texture& texture, const Texture_limits& limits,
                             const Observer* observer)
    : m_before(texture), m_observer(observer), m_limits(limits), m_plane(texture.sides.size() == 2),
      m_after(texture) {}

Result<void> Texture_draft::connect() {
  const int n = int(m_before.v.size()), quads = int(m_before.quads.size());
  if (m_before.u.size() != m_before.v.size() || m_before.sides.empty() || m_before.sides.size() > 2 ||
      (!m_before.holes.empty() && int(m_before.holes.size()) != quads))
    return refused("the texture's arrays do not belong together");
  for (int f = 0; f < quads; ++f)
    for (int v : m_before.quads[f])
      if (v < 0 || v >= n) return refused("a quad has a vertex that does not exist", Element_kind::face, f);
  if (const int bad = connect_quads(m_before.quads, n, m_opposite); bad >= 0)
    return refused("a quad has an edge that another passes in the same direction", Element_kind::face, bad);
  m_side.assign(n, -1);
  m_entry.assign(n, -1);
  m_kept.assign(n, 0);
  m_moved.assign(n, 0);
  m_name.resize(n);
  for (int v = 0; v < n; ++v) m_name[v] = v;
  m_removed.assign(quads, 0);
  m_added.assign(quads, 0);
  m_hole = m_before.holes;
  m_hole.resize(quads, 0);
  if (Result<void> found = find_sides(); !found) return found;
  keep_limits();
  return {};
}

// Notes the side and the entry of each side vertex.
Result<void> Texture_draft::find_sides() {
  m_sides.resize(m_before.sides.size());
  for (std::size_t w = 0; w < m_sides.size(); ++w) {
    if (m_before.sides[w].size() < 2) return refused("a side has less than two vertices");
    for (std::size_t i = 0; i < m_before.sides[w].size(); ++i) {
      const int v = m_before.sides[w][i];
      if (v < 0 || v >= int(m_side.size()) || m_side[v] >= 0)
        return refused("a side names a vertex that does not exist, or one twice", Element_kind::vertex, v);
      m_side[v] = int(w);
      m_entry[v] = int(i);
      m_sides[w].push_back({double(i), v});
    }
  }
  for (int h = 0; h < int(m_opposite.size()); ++h)
    if (m_opposite[h] < 0 && (m_side[source(h)] < 0 || m_side[source(h)] != m_side[target(h)]))
      return refused("the texture has a boundary that is not its sides", Element_kind::face, quad_of(h));
  return {};
}

// Which side vertices must stay: the caller's, entry 0 of an annulus' sides, the corners of a disc's
// rectangle.
void Texture_draft::keep_limits() {
  for (std::size_t w = 0; w < m_sides.size() && w < m_limits.kept.size(); ++w)
    for (int i : m_limits.kept[w])
      if (i >= 0 && i < int(m_sides[w].size())) m_kept[m_before.sides[w][i]] = 1;
  for (const std::vector<int>& side : m_before.sides) {
    if (m_plane.is_periodic()) {
      m_kept[side[0]] = 1;
      continue;
    }
    const std::size_t n = side.size();
    for (std::size_t i = 0; i < n; ++i)
      if (orientation(point(side[(i + n - 1) % n]), point(side[i]), point(side[(i + 1) % n])) != 0)
        m_kept[side[i]] = 1;
  }
}

std::vector<int> Texture_draft::fan(int h) const {
  int first = h;
  while (m_opposite[first] >= 0) { // clockwise until the boundary or around
    first = next(m_opposite[first]);
    if (first == h) break;
  }
  std::vector<int> out;
  int k = first;
  do {
    out.push_back(k);
    k = m_opposite[previous(k)];
  } while (k >= 0 && k != first);
  return out;
}

int Texture_draft::add_vertex(const Plane_point& p) {
  m_after.v.push_back(p.v);
  m_after.u.push_back(p.u);
  m_side.push_back(-1);
  m_entry.push_back(-1);
  m_kept.push_back(0);
  m_moved.push_back(1);
  m_name.push_back(int(m_name.size()));
  return int(m_name.size()) - 1;
}

void Texture_draft::move_vertex(int vertex, const Plane_point& p) {
  m_after.v[vertex] = p.v;
  m_after.u[vertex] = p.u;
  m_moved[vertex] = 1;
}

void Texture_draft::add_quad(const Quad& quad, int parent) {
  m_after.quads.push_back(quad);
  m_removed.push_back(0);
  m_added.push_back(1);
  m_hole.push_back(m_hole[parent]);
}

void Texture_draft::split_side_edge(int a, int b, int vertex, double fraction) {
  const int w = m_side[a], n = int(m_before.sides[w].size());
  if ((m_entry[a] + 1) % n != m_entry[b]) {
    std::swap(a, b);
    fraction = 1 - fraction;
  }
  m_side[vertex] = w;
  m_sides[w].push_back({m_entry[a] + fraction, vertex});
}

int Texture_draft::merged(int vertex) const {
  while (m_name[vertex] != vertex) vertex = m_name[vertex];
  return vertex;
}

void Texture_draft::merge(int keep, int gone) {
  keep = merged(keep);
  gone = merged(gone);
  if (keep == gone) return;
  m_name[gone] = keep;
  m_moved[gone] = m_moved[keep] = 1;
}

void Texture_draft::remove_folded_quads() {
  for (bool found = true; found;) {
    found = false;
    std::vector<int> uses(m_name.size(), 0);
    for (std::size_t f = 0; f < m_after.quads.size(); ++f)
      for (int v : m_after.quads[f]) uses[merged(v)] += !m_removed[f];
    for (std::size_t f = 0; f < m_after.quads.size(); ++f) {
      if (m_removed[f]) continue;
      Quad q = m_after.quads[f];
      for (int& v : q) v = merged(v);
      for (int i = 0; i < 2; ++i) {
        // A fold at q[i] and q[i + 2], which are the same vertex, around one of the other two that no other
        // quad has.
        const bool fold = q[i] == q[i + 2] && ((uses[q[1 - i]] == 1 && is_inside(q[1 - i])) ||
                                               (uses[q[3 - i]] == 1 && is_inside(q[3 - i])));
        if (!fold || m_removed[f]) continue;
        m_removed[f] = 1;
        found = true;
      }
    }
  }
}

// Carries out what was noted; `changed` tells for each quad that is left whether it is new or has a vertex
// that moved.
void Texture_draft::compress(std::vector<char>& changed) {
  std::vector<int> number(m_name.size(), -1);
  std::vector<Quad> quads;
  std::vector<char> holes;
  for (std::size_t f = 0; f < m_after.quads.size(); ++f) {
    if (m_removed[f]) continue;
    Quad q = m_after.quads[f];
    char moved = m_added[f];
    for (int& v : q) {
      moved |= m_moved[v];
      v = merged(v);
      moved |= m_moved[v];
      number[v] = 0;
    }
    quads.push_back(q);
    holes.push_back(m_hole[f]);
    changed.push_back(moved);
  }
  int count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    m_after.v[count] = m_after.v[v];
    m_after.u[count] = m_after.u[v];
    number[v] = count++;
  }
  m_after.v.resize(count);
  m_after.u.resize(count);
  for (Quad& q : quads)
    for (int& v : q) v = number[v];
  m_after.quads = std::move(quads);
  if (std::find(holes.begin(), holes.end(), 1) == holes.end()) holes.clear();
  m_after.holes = std::move(holes);
  for (std::vector<Side_entry>& side : m_sides) {
    side.erase(
        std::remove_if(side.begin(), side.end(), [&](const Side_entry& e) { return number[e.vertex] < 0; }),
        side.end());
    std::sort(side.begin(), side.end(),
              [](const Side_entry& a, const Side_entry& b) { return a.step < b.step; });
    for (Side_entry& e : side) e.vertex = number[e.vertex];
  }
}

// The result is a quad mesh, bounded by its sides, whose changed quads are valid in the plane: see
// `check_texture_plane()`.
Result<void> Texture_draft::check(const std::vector<char>& changed) const {
  const Quad_texture& t = m_after;
  std::vector<int> opposite;
  if (connect_quads(t.quads, int(t.v.size()), opposite) >= 0)
    return refused("the edit would join two vertices by two edges");
  std::vector<int> side(t.v.size(), -1);
  std::size_t side_vertices = 0, boundary = 0;
  for (std::size_t w = 0; w < t.sides.size(); ++w)
    for (int v : t.sides[w]) {
      side[v] = int(w);
      ++side_vertices;
    }
  for (int h = 0; h < int(opposite.size()); ++h) {
    const int a = internal::source(t.quads, h), b = internal::target(t.quads, h);
    if (opposite[h] < 0) {
      ++boundary;
      if (side[a] < 0 || side[a] != side[b]) return refused("the edit would take away a part of a side");
    } else if (changed[quad_of(h)] && t.sides.size() == 2 && side[a] >= 0 && side[b] >= 0)
      return refused("the edit would give an annulus an edge from side to side");
  }
  if (boundary != side_vertices) return refused("the edit would take away a part of a side");
  for (int f = 0; f < int(t.quads.size()); ++f)
    if (changed[f] && !m_plane.is_valid(t.v, t.u, t.quads[f]))
      return refused("the edit would invert a quad in the plane");
  return {};
}

Result<Edited_texture> Texture_draft::finish() {
  std::vector<char> changed;
  compress(changed);
  Edited_texture out;
  m_after.sides.clear();
  for (const std::vector<Side_entry>& side : m_sides) {
    m_after.sides.emplace_back();
    out.side_steps.emplace_back();
    for (const Side_entry& e : side) {
      m_after.sides.back().push_back(e.vertex);
      out.side_steps.back().push_back(e.step);
    }
  }
  if (Result<void> checked = check(changed); !checked) return checked.error();
  out.texture = std::move(m_after);
  return out;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
