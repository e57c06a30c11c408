// SPDX-License-Identifier: GPL-3.0-or-later
// Global subdivision and its reverse.
#include "textures/operators.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

void split_in_four(Texture_draft& draft, int quad, const std::array<int, 4>& middle) {
  const Quad q = draft.before().quads[quad];
  const auto between = [&](const Plane_point& a, const Plane_point& b) {
    return draft.plane().between(a, b, 0.5);
  };
  const auto at = [&](int v) { return draft.point(v); };
  const int c =
      draft.add_vertex(between(between(at(middle[0]), at(middle[2])), between(at(middle[1]), at(middle[3]))));
  const auto part = [&](int i) { return Quad{q[i], middle[i], c, middle[(i + 3) % 4]}; };
  const auto are_valid = [&] {
    return draft.is_valid(part(0)) && draft.is_valid(part(1)) && draft.is_valid(part(2)) &&
           draft.is_valid(part(3));
  };
  // The mean of a concave quad may lie outside it; the middle of its diagonal does not.
  for (int i = 0; i < 2 && !are_valid(); ++i) draft.move_vertex(c, between(at(q[i]), at(q[i + 2])));
  draft.remove_quad(quad);
  for (int i = 0; i < 4; ++i) draft.add_quad(part(i), quad);
}

Result<void> draw(Texture_draft& draft, const Subdivide_texture&) {
  const std::vector<Quad>& quads = draft.before().quads;
  if (quads.size() > std::size_t(1) << 26) return refused("the texture is too large to be subdivided");
  std::vector<int> middle(4 * quads.size(), -1);
  for (int h = 0; h < int(middle.size()); ++h) {
    if (middle[h] >= 0) continue;
    const int a = draft.source(h), b = draft.target(h), o = draft.opposite(h);
    middle[h] = draft.add_vertex(draft.plane().between(draft.point(a), draft.point(b), 0.5));
    if (o >= 0)
      middle[o] = middle[h];
    else
      draft.split_side_edge(a, b, middle[h], 0.5);
  }
  for (int f = 0; f < int(quads.size()); ++f)
    split_in_four(draft, f, {middle[4 * f], middle[4 * f + 1], middle[4 * f + 2], middle[4 * f + 3]});
  return {};
}

namespace {

enum Vertex_class : char { unknown, corner, middle, centre };

// The classes that the vertices of a subdivided texture have if the source of `seed` is a corner; empty if
// that contradicts itself. `first` gets, per quad, the halfedge that leaves its corner.
std::vector<Vertex_class> classify(const Texture_draft& draft, int seed, std::vector<int>& first) {
  std::vector<Vertex_class> of(draft.before().v.size(), unknown);
  first.assign(draft.before().quads.size(), -1);
  first[quad_of(seed)] = seed;
  std::vector<int> queue{seed};
  for (std::size_t k = 0; k < queue.size(); ++k) {
    int h = queue[k];
    const std::array<Vertex_class, 4> expected{corner, middle, centre, middle};
    for (int i = 0; i < 4; ++i, h = next(h)) {
      Vertex_class& c = of[draft.source(h)];
      if (c == unknown) c = expected[i];
      if (c != expected[i]) return {};
      const int o = draft.opposite(h);
      if (o < 0 || first[quad_of(o)] >= 0) continue;
      const std::array<int, 4> corners{next(o), across(o), previous(o), o};
      first[quad_of(o)] = corners[i];
      queue.push_back(corners[i]);
    }
  }
  return queue.size() == first.size() ? of : std::vector<Vertex_class>();
}

// Whether centres have four quads, and middles two coarse edges.
bool are_regular(const Texture_draft& draft, const std::vector<Vertex_class>& of) {
  std::vector<int> quads(of.size(), 0);
  for (const Quad& q : draft.before().quads)
    for (int v : q) ++quads[v];
  for (std::size_t v = 0; v < of.size(); ++v) {
    const bool inside = draft.is_inside(int(v));
    if (of[v] == centre && (!inside || quads[v] != 4)) return false;
    if (of[v] == middle && (quads[v] != (inside ? 4 : 2) || draft.is_kept(int(v)))) return false;
  }
  return true;
}

} // namespace

Result<void> draw(Texture_draft& draft, const Coarsen_texture&) {
  const std::vector<Quad>& quads = draft.before().quads;
  const int seed_vertex = draft.before().sides[0][0];
  int seed = 0;
  while (seed < 4 * int(quads.size()) && draft.source(seed) != seed_vertex) ++seed;
  std::vector<int> first;
  std::vector<Vertex_class> of;
  if (seed < 4 * int(quads.size())) of = classify(draft, seed, first);
  if (of.empty() || !are_regular(draft, of))
    return refused("the texture has not the connectivity of a subdivided one whose side keeps its vertices");
  std::vector<char> done(quads.size(), 0);
  for (int f = 0; f < int(quads.size()); ++f) {
    if (done[f]) continue;
    Quad coarse;
    for (int i = 0, h = first[f]; i < 4; ++i) {
      coarse[i] = draft.source(h);
      done[quad_of(h)] = 1;
      if (draft.is_hole(quad_of(h)) != draft.is_hole(f))
        return refused("a hole covers only a part of four quads", Element_kind::face, f);
      draft.remove_quad(quad_of(h));
      h = across(draft.opposite(next(h)));
    }
    draft.add_quad(coarse, f);
  }
  return {};
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
