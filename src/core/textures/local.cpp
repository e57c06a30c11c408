// SPDX-License-Identifier: GPL-3.0-or-later
// The operators on one vertex, one edge or one quad.
#include "textures/operators.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

Error inner_only(const char* what, int vertex) {
  return refused(std::string(what) + " applies only inside of the texture, not on a side",
                 Element_kind::vertex, vertex);
}

// The halfedge that leaves the vertex of a place.
Result<int> vertex_halfedge(const Texture_draft& draft, const Texture_place& place) {
  const Result<Quad_corner> found = find_vertex(draft.before(), place);
  if (!found) return found.error();
  return halfedge(*found);
}

Result<int> edge_halfedge(const Texture_draft& draft, const Texture_place& place) {
  const Result<Quad_corner> found = find_edge(draft.before(), place);
  if (!found) return found.error();
  return halfedge(*found);
}

Result<void> check_holes_agree(const Texture_draft& draft, const std::vector<int>& halfedges) {
  for (int h : halfedges)
    if (draft.is_hole(quad_of(h)) != draft.is_hole(quad_of(halfedges.front())))
      return refused("the edit would change the border of a hole", Element_kind::face, quad_of(h));
  return {};
}

} // namespace

Result<void> draw(Texture_draft& draft, const Close_quad& edit) {
  if (!(edit.at >= 0 && edit.at <= 1)) return refused("the fraction is not between 0 and 1");
  const Result<int> h = vertex_halfedge(draft, edit.corner);
  if (!h) return h.error();
  const int a = draft.source(*h), b = draft.source(across(*h));
  if (!draft.is_inside(a) && !draft.is_inside(b))
    return refused("closing the quad would join two vertices of the sides", Element_kind::face, quad_of(*h));
  draft.remove_quad(quad_of(*h));
  if (draft.is_inside(a) && draft.is_inside(b)) {
    draft.move_vertex(a, draft.plane().between(draft.point(a), draft.point(b), edit.at));
    draft.merge(a, b);
  } else
    draft.merge(draft.is_inside(a) ? b : a, draft.is_inside(a) ? a : b);
  draft.remove_folded_quads();
  return {};
}

Result<void> draw(Texture_draft& draft, const Rotate_edge& edit) {
  const Result<int> found = edge_halfedge(draft, edit.edge);
  if (!found) return found.error();
  const int h = *found, o = draft.opposite(h);
  if (o < 0) return inner_only("turning an edge", draft.source(h));
  if (Result<void> agree = check_holes_agree(draft, {h, o}); !agree) return agree;
  if (quad_of(h) == quad_of(o)) return refused("the edge is folded into one quad");
  // The hexagon: a, e, f, b, c, d.
  const int a = draft.source(h), b = draft.target(h), c = draft.source(across(h)),
            d = draft.source(previous(h)), e = draft.source(across(o)), f = draft.source(previous(o));
  draft.remove_quad(quad_of(h));
  draft.remove_quad(quad_of(o));
  if (edit.counterclockwise) {
    draft.add_quad({c, d, a, e}, quad_of(h));
    draft.add_quad({e, f, b, c}, quad_of(h));
  } else {
    draft.add_quad({d, a, e, f}, quad_of(h));
    draft.add_quad({f, b, c, d}, quad_of(h));
  }
  return {};
}

Result<void> draw(Texture_draft& draft, const Rotate_vertex& edit) {
  const Result<int> h = vertex_halfedge(draft, edit.vertex);
  if (!h) return h.error();
  const int v = draft.source(*h);
  if (!draft.is_inside(v)) return inner_only("turning a vertex", v);
  const std::vector<int> fan = draft.fan(*h);
  if (Result<void> agree = check_holes_agree(draft, fan); !agree) return agree;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const int g = fan[(i + 1) % fan.size()], neighbour = draft.target(g);
    if (draft.is_inside(neighbour) && draft.fan(next(g)).size() < 3)
      return refused("turning the vertex would leave a neighbour with one edge", Element_kind::vertex,
                     neighbour);
    draft.remove_quad(quad_of(fan[i]));
    draft.add_quad({v, draft.source(across(fan[i])), neighbour, draft.source(across(g))}, quad_of(g));
  }
  return {};
}

Result<void> draw(Texture_draft& draft, const Insert_doublet& edit) {
  const Result<int> h = vertex_halfedge(draft, edit.corner);
  if (!h) return h.error();
  const Quad& q = draft.before().quads[quad_of(*h)];
  const int i = *h & 3, a = q[i], b = q[(i + 1) % 4], c = q[(i + 2) % 4], d = q[(i + 3) % 4];
  const int m = draft.add_vertex(draft.plane().between(draft.point(a), draft.point(c), 0.5));
  draft.remove_quad(quad_of(*h));
  draft.add_quad({a, b, c, m}, quad_of(*h));
  draft.add_quad({a, m, c, d}, quad_of(*h));
  return {};
}

Result<void> draw(Texture_draft& draft, const Remove_doublet& edit) {
  const Result<int> h = vertex_halfedge(draft, edit.vertex);
  if (!h) return h.error();
  const int v = draft.source(*h);
  if (!draft.is_inside(v)) return inner_only("removing a doublet", v);
  const std::vector<int> fan = draft.fan(*h);
  if (fan.size() != 2) return refused("the vertex is no doublet", Element_kind::vertex, v);
  if (Result<void> agree = check_holes_agree(draft, fan); !agree) return agree;
  for (int k : fan) draft.remove_quad(quad_of(k));
  draft.add_quad({draft.target(fan[0]), draft.source(across(fan[0])), draft.target(fan[1]),
                  draft.source(across(fan[1]))},
                 quad_of(fan[0]));
  return {};
}

namespace {

// The neighbours of the vertex whose fan it is, counterclockwise; at a side vertex one more than quads.
std::vector<int> spokes(const Texture_draft& draft, const std::vector<int>& fan) {
  std::vector<int> out;
  for (int h : fan) out.push_back(draft.target(h));
  if (!draft.is_inside(draft.source(fan[0]))) out.push_back(draft.source(previous(fan.back())));
  return out;
}

// A halfedge that leaves the vertex that two edges share, and its two neighbours.
struct Path {
  int leaving = -1;
  std::array<int, 2> ends{{-1, -1}};
};

Result<Path> path_of(const Texture_draft& draft, const Open_quad& edit) {
  const Result<int> g = edge_halfedge(draft, edit.first), h = edge_halfedge(draft, edit.second);
  if (!g) return g.error();
  if (!h) return h.error();
  const std::array<int, 2> p{draft.source(*g), draft.target(*g)}, q{draft.source(*h), draft.target(*h)};
  Path path;
  int shared = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      if (p[i] == q[j]) {
        ++shared;
        path = {i == 0 ? *g : next(*g), {p[1 - i], q[1 - j]}};
      }
  if (shared != 1) return refused("the two edges do not meet in one vertex", Element_kind::vertex, p[0]);
  return path;
}

} // namespace

Result<void> draw(Texture_draft& draft, const Open_quad& edit) {
  if (Result<void> checked = check_fraction(edit.at); !checked) return checked;
  const Result<Path> path = path_of(draft, edit);
  if (!path) return path.error();
  const std::vector<int> fan = draft.fan(path->leaving), spoke = spokes(draft, fan);
  if (Result<void> agree = check_holes_agree(draft, fan); !agree) return agree;
  const int v = draft.source(fan[0]), n = int(fan.size());
  int i = int(std::find(spoke.begin(), spoke.end(), path->ends[0]) - spoke.begin());
  int j = int(std::find(spoke.begin(), spoke.end(), path->ends[1]) - spoke.begin());
  if (i > j) std::swap(i, j);
  // The quads from spoke i to spoke j get the new vertex; the others keep the old one.
  std::vector<int> moved, kept;
  for (int k = 0; k < n; ++k) (i <= k && k < j ? moved : kept).push_back(quad_of(fan[k]));
  const Plane_point old = draft.point(v);
  const int fresh = draft.add_vertex(old);
  std::vector<Quad> quads{{spoke[i], fresh, spoke[j], v}};
  for (int f : kept) quads.push_back(draft.before().quads[f]);
  draft.add_quad(quads[0], moved[0]);
  for (int f : moved) {
    Quad q = draft.before().quads[f];
    std::replace(q.begin(), q.end(), v, fresh);
    quads.push_back(q);
    draft.remove_quad(f);
    draft.add_quad(q, f);
  }
  double at = edit.at;
  for (int trial = 0; trial < 7; ++trial, at /= 2) {
    draft.move_vertex(v, old);
    const Plane_point to = inward(draft, v, moved, at), back = inward(draft, v, kept, at);
    draft.move_vertex(fresh, to);
    if (draft.is_inside(v)) draft.move_vertex(v, back);
    if (std::all_of(quads.begin(), quads.end(), [&](const Quad& q) { return draft.is_valid(q); })) break;
  }
  return {};
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
