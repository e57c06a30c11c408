// SPDX-License-Identifier: GPL-3.0-or-later
// Polychords: strips of quads that meet in opposite edges.
#include "textures/operators.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// A cross edge, directed as the edge that the polychord was asked for; a halfedge of it, in that direction or
// not.
struct Cross_edge {
  int from, to;
  int halfedge;
};

struct Polychord {
  std::vector<Cross_edge> edges; ///< along the strip, to the left of the edges' direction
  bool closed = false;
};

Polychord trace(const Texture_draft& draft, int start) {
  const auto forward = [&](int h) { return Cross_edge{draft.source(h), draft.target(h), h}; };
  Polychord chord;
  chord.edges.push_back(forward(start));
  int h = start;
  for (;;) {
    const int far = across(h);
    h = draft.opposite(far);
    if (h == start) {
      chord.closed = true;
      return chord;
    }
    if (h < 0) {
      chord.edges.push_back({draft.target(far), draft.source(far), far});
      break;
    }
    chord.edges.push_back(forward(h));
  }
  std::vector<Cross_edge> behind;
  for (h = start; draft.opposite(h) >= 0;) {
    h = across(draft.opposite(h));
    behind.push_back(forward(h));
  }
  chord.edges.insert(chord.edges.begin(), behind.rbegin(), behind.rend());
  return chord;
}

Result<Polychord> trace(const Texture_draft& draft, const Texture_place& place) {
  const Result<Quad_corner> edge = find_edge(draft.before(), place);
  if (!edge) return edge.error();
  return trace(draft, halfedge(*edge));
}

// Replaces a quad whose edges have new vertices (-1: none): by two where a strip crosses it, by four where
// two do.
void split_quad(Texture_draft& draft, int f, const std::array<int, 4>& middle) {
  if (middle[0] >= 0 && middle[1] >= 0) return split_in_four(draft, f, middle);
  const Quad& q = draft.before().quads[f];
  draft.remove_quad(f);
  const int i = middle[0] >= 0 ? 0 : 1;
  const int a = q[i], b = q[i + 1], c = q[i + 2], d = q[(i + 3) % 4], m = middle[i], n = middle[i + 2];
  draft.add_quad({a, m, n, d}, f);
  draft.add_quad({m, b, c, n}, f);
}

} // namespace

Result<void> check_fraction(double at) {
  if (at > 0 && at < 1) return {};
  return refused("the fraction is not between 0 and 1");
}

Result<void> draw(Texture_draft& draft, const Insert_polychord& edit) {
  if (Result<void> checked = check_fraction(edit.at); !checked) return checked;
  const Result<Polychord> chord = trace(draft, edit.edge);
  if (!chord) return chord.error();
  std::vector<int> middle(4 * draft.before().quads.size(), -1);
  std::vector<int> crossed;
  for (const Cross_edge& e : chord->edges) {
    const int m = draft.add_vertex(draft.plane().between(draft.point(e.from), draft.point(e.to), edit.at));
    for (int h : {e.halfedge, draft.opposite(e.halfedge)}) {
      if (h < 0) {
        draft.split_side_edge(e.from, e.to, m, edit.at);
        continue;
      }
      middle[h] = m;
      crossed.push_back(quad_of(h));
    }
  }
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  for (int f : crossed)
    split_quad(draft, f, {middle[4 * f], middle[4 * f + 1], middle[4 * f + 2], middle[4 * f + 3]});
  return {};
}

namespace {

// Which end of a cross edge gives the merged vertex its place, and at which fraction from that end it lies.
Result<std::pair<int, double>> place_of_merged(const Texture_draft& draft, const Cross_edge& e, double at) {
  const bool from_inside = draft.is_inside(e.from), to_inside = draft.is_inside(e.to);
  if (from_inside && to_inside) return std::pair(0, at);
  if (from_inside) return std::pair(1, 0.0);
  if (to_inside) return std::pair(0, 0.0);
  if (draft.opposite(e.halfedge) >= 0)
    return refused("deleting the polychord would join two vertices of the sides", Element_kind::vertex,
                   e.from);
  if (draft.is_kept(e.from) && draft.is_kept(e.to))
    return refused("deleting the polychord would join two side vertices that must stay", Element_kind::vertex,
                   e.from);
  if (draft.is_kept(e.from)) return std::pair(0, 0.0);
  if (draft.is_kept(e.to)) return std::pair(1, 0.0);
  return std::pair(at <= 0.5 ? 0 : 1, 0.0);
}

} // namespace

Result<void> draw(Texture_draft& draft, const Delete_polychord& edit) {
  if (!(edit.at >= 0 && edit.at <= 1)) return refused("the fraction is not between 0 and 1");
  const Result<Polychord> chord = trace(draft, edit.edge);
  if (!chord) return chord.error();
  std::vector<char> used(draft.before().v.size(), 0);
  for (const Cross_edge& e : chord->edges)
    for (int v : {e.from, e.to})
      if (used[v]++) return refused("the polychord touches or crosses itself", Element_kind::vertex, v);
  for (const Cross_edge& e : chord->edges) {
    const Result<std::pair<int, double>> place = place_of_merged(draft, e, edit.at);
    if (!place) return place.error();
    const auto [end, at] = *place;
    const int keep = end == 0 ? e.from : e.to, gone = end == 0 ? e.to : e.from;
    if (at > 0) draft.move_vertex(keep, draft.plane().between(draft.point(keep), draft.point(gone), at));
    draft.merge(keep, gone);
    draft.remove_quad(quad_of(e.halfedge));
  }
  draft.remove_folded_quads();
  return {};
}

Polychord_tracer::Polychord_tracer(const Quad_texture& texture)
    : m_draft(texture, m_limits), m_connected(m_draft.connect()) {}

Result<Polychord_tracer::Strip> Polychord_tracer::strip(const Insert_polychord& edit) const {
  if (!m_connected) return m_connected.error();
  const Result<Polychord> chord = trace(m_draft, edit.edge);
  if (!chord) return chord.error();
  Strip strip{{}, int(chord->edges.size()) - 1};
  if (chord->closed) return strip;
  for (const Cross_edge& e : {chord->edges.back(), chord->edges.front()}) {
    const int w = m_draft.side(e.from);
    const std::vector<int>& side = m_draft.before().sides[w];
    const int n = int(side.size());
    const int from = int(std::find(side.begin(), side.end(), e.from) - side.begin());
    const bool along = side[(from + 1) % n] == e.to;
    strip.ends.push_back({w, along ? from : (from + n - 1) % n, along ? edit.at : 1 - edit.at});
  }
  return strip;
}

} // namespace internal

Result<std::vector<Polychord_end>> polychord_ends(const Quad_texture& texture, const Insert_polychord& edit) {
  const auto strip = internal::Polychord_tracer(texture).strip(edit);
  if (!strip) return strip.error();
  return strip->ends;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
