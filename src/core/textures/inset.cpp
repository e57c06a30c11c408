// SPDX-License-Identifier: GPL-3.0-or-later
// Cube subdivision of a region, and holes.
#include "textures/operators.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

Result<std::vector<int>> find_quads(const Quad_texture& texture, const std::vector<Texture_place>& places) {
  std::vector<int> quads;
  for (const Texture_place& place : places) {
    const Result<Quad_corner> found = find_quad(texture, place);
    if (!found) return found.error();
    quads.push_back(found->quad);
  }
  if (quads.empty()) return refused("no quads are named");
  std::sort(quads.begin(), quads.end());
  quads.erase(std::unique(quads.begin(), quads.end()), quads.end());
  return quads;
}

Plane_point inward(const Texture_draft& draft, int vertex, const std::vector<int>& quads, double at) {
  const Plane_point p = draft.point(vertex);
  if (quads.empty()) return p;
  double dv = 0, du = 0;
  for (int f : quads)
    for (int w : draft.before().quads[f]) {
      dv += draft.plane().step(p.v, draft.point(w).v);
      du += draft.point(w).u - p.u;
    }
  const double scale = at / (4.0 * double(quads.size()));
  return {draft.plane().wrapped(p.v + scale * dv), p.u + scale * du};
}

namespace {

// The halfedges of the region's quads whose other side is not in the region.
std::vector<int> region_border(const Texture_draft& draft, const std::vector<int>& quads) {
  std::vector<int> border;
  for (int f : quads)
    for (int h = 4 * f; h < 4 * f + 4; ++h)
      if (draft.opposite(h) < 0 ||
          !std::binary_search(quads.begin(), quads.end(), quad_of(draft.opposite(h))))
        border.push_back(h);
  return border;
}

struct Vector {
  double v = 0, u = 0;
};

double cross(const Vector& a, const Vector& b) {
  return a.v * b.u - a.u * b.v;
}

Vector from_to(const Texture_draft& draft, int a, int b) {
  const Plane_point p = draft.point(a), q = draft.point(b);
  return {draft.plane().step(p.v, q.v), q.u - p.u};
}

// From the middle of a border edge towards the middle of its quad, by the fraction `at` of the way.
Vector edge_offset(const Texture_draft& draft, int h, double at) {
  // Four times the way from the edge's source, to the edge's middle (taken away) and to the middle of the
  // quad's corners.
  const Vector along = from_to(draft, draft.source(h), draft.target(h));
  Vector sum{-2 * along.v, -2 * along.u};
  for (int k = next(h); k != h; k = next(k)) {
    const Vector w = from_to(draft, draft.source(h), draft.source(k));
    sum.v += w.v;
    sum.u += w.u;
  }
  return {at * sum.v / 4, at * sum.u / 4};
}

// Where a border vertex goes: to where its two border edges meet after each was moved by its offset.
Plane_point inset_corner(const Texture_draft& draft, int incoming, int outgoing, double at) {
  const Plane_point p = draft.point(draft.source(outgoing));
  const Vector e1 = from_to(draft, draft.source(incoming), draft.target(incoming)),
               e2 = from_to(draft, draft.source(outgoing), draft.target(outgoing)),
               o1 = edge_offset(draft, incoming, at), o2 = edge_offset(draft, outgoing, at);
  Vector d{(o1.v + o2.v) / 2, (o1.u + o2.u) / 2};
  const double size = (std::abs(e1.v) + std::abs(e1.u)) * (std::abs(e2.v) + std::abs(e2.u));
  // Nearly parallel edges meet anywhere: their mean offset will do, and so it does where they would meet far
  // away.
  if (std::abs(cross(e1, e2)) > 1e-3 * size) {
    const double s = cross({o2.v - o1.v, o2.u - o1.u}, e2) / cross(e1, e2);
    if (std::abs(s) <= 1) d = {o1.v + s * e1.v, o1.u + s * e1.u};
  }
  return {draft.plane().wrapped(p.v + d.v), p.u + d.u};
}

} // namespace

Result<void> draw(Texture_draft& draft, const Inset_quads& edit) {
  if (Result<void> checked = check_fraction(edit.at); !checked) return checked;
  const Result<std::vector<int>> region = find_quads(draft.before(), edit.quads);
  if (!region) return region.error();
  const std::vector<int> border = region_border(draft, *region);
  std::map<int, int> outgoing, inner; // of each border vertex
  for (int h : border)
    if (!outgoing.insert({draft.source(h), h}).second)
      return refused("the region's border touches itself", Element_kind::vertex, draft.source(h));
  for (int h : border)
    inner[draft.target(h)] = draft.add_vertex(inset_corner(draft, h, outgoing.at(draft.target(h)), edit.at));
  for (int f : *region) {
    Quad q = draft.before().quads[f];
    for (int& v : q)
      if (const auto at = inner.find(v); at != inner.end()) v = at->second;
    draft.remove_quad(f);
    draft.add_quad(q, f);
  }
  for (int h : border) {
    const int a = draft.source(h), b = draft.target(h);
    draft.add_quad({a, b, inner[b], inner[a]}, quad_of(h));
  }
  return {};
}

namespace {

// Whether the quads around each vertex that are no holes are one fan.
Result<void> check_fans(const Texture_draft& draft, const std::vector<int>& changed) {
  for (int f : changed)
    for (int h = 4 * f; h < 4 * f + 4; ++h) {
      const std::vector<int> fan = draft.fan(h);
      const int n = int(fan.size());
      const bool around = draft.is_inside(draft.source(h));
      int starts = 0;
      for (int i = 0; i < n; ++i) {
        const bool before =
            i > 0 ? draft.is_hole(quad_of(fan[i - 1])) : !around || draft.is_hole(quad_of(fan[n - 1]));
        starts += before && !draft.is_hole(quad_of(fan[i]));
      }
      if (starts > 1)
        return refused("the quads at a vertex would not be one fan", Element_kind::vertex, draft.source(h));
    }
  return {};
}

Result<void> set_holes(Texture_draft& draft, const std::vector<Texture_place>& places, bool hole) {
  const Result<std::vector<int>> quads = find_quads(draft.before(), places);
  if (!quads) return quads.error();
  for (int f : *quads) {
    if (draft.is_hole(f) == hole)
      return refused(hole ? "a quad is a hole already" : "a quad is no hole", Element_kind::face, f);
    draft.set_hole(f, hole);
  }
  return check_fans(draft, *quads);
}

} // namespace

Result<void> draw(Texture_draft& draft, const Delete_quads& edit) {
  if (Result<void> set = set_holes(draft, edit.quads, true); !set) return set;
  for (int f = 0; f < int(draft.before().quads.size()); ++f)
    if (!draft.is_hole(f)) return {};
  return refused("no quad of the texture would be left");
}

Result<void> draw(Texture_draft& draft, const Restore_quads& edit) {
  return set_holes(draft, edit.quads, false);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
