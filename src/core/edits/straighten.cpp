// SPDX-License-Identifier: GPL-3.0-or-later
// Straightening: a contour is pulled tight like a rubber band.
#include "edits/redraw.h"
#include "edits/rubber_band.h"
#include "edits/steps.h"

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A contour's crossings as a band; it goes around the vertices that the contour passes on their right.
Result<Band> band_of(const Draft& draft, const Contour_edge& edge) {
  const Triangle_surface& s = draft.surface();
  Band band;
  const int n = int(edge.faces.size());
  for (int face : edge.faces)
    if (face < 0) return refuse("the contour runs along edges of the surface");
  for (int i = 0; i < n; ++i) {
    const int v = edge.vertices[i], before = edge.faces[(i + n - 1) % n], after = edge.faces[i];
    if (draft.network.is_crossing(v)) {
      const int e = draft.network.crossing(v).halfedge;
      const int exit = e / 3 == before ? e : s.opposite[e];
      band.exit.push_back(exit);
      band.t.push_back(exit == e ? draft.network.crossing(v).t : 1 - draft.network.crossing(v).t);
      continue;
    }
    int face = before;
    for (int steps = 0; face != after; ++steps) {
      if (steps > 1000) return refuse("the contour runs along edges of the surface");
      int h = 3 * face;
      while (s.source(h) != v) ++h;
      const int exit = Triangle_surface::previous(h);
      band.exit.push_back(exit);
      band.t.push_back(1 - band_margin);
      if (s.opposite[exit] < 0) return refuse("the contour runs along edges of the surface");
      face = s.opposite[exit] / 3;
    }
  }
  return band;
}

// As short as the surface allows, if no other contour is in the way.
Result<void> straighten_free_loop(Draft& draft, int e) {
  Result<Band> loose = band_of(draft, draft.network.edges[e]);
  if (!loose) return loose.error();
  const Band band = tightened(draft.surface(), std::move(*loose), 200);
  if (band.exit.size() < 3) return refuse("the contour would shrink to a point");
  Contour_edge fresh;
  for (std::size_t i = 0; i < band.exit.size(); ++i) {
    const int h = band.exit[i], r = draft.surface().edge(h);
    fresh.vertices.push_back(add_crossing(draft.network, {r, h == r ? band.t[i] : 1 - band.t[i]}));
    fresh.faces.push_back(draft.surface().opposite[h] / 3);
  }
  fresh.vertices.push_back(fresh.vertices.front());
  fresh.from = fresh.to = add_node(draft.network, fresh.vertices.front());
  return replace_edge(draft, e, std::move(fresh));
}

} // namespace

Result<void> apply_edit(Draft& draft, const Straighten_contour& edit) {
  const int e = draft.contour_at(edit.at.point);
  if (e < 0) return refuse("there is no contour");
  if (draft.is_free_loop(e)) {
    Draft trial = draft;
    if (straighten_free_loop(trial, e)) {
      draft.take(std::move(trial));
      return {};
    }
  }
  Result<Redrawing> redrawing = Redrawing::of(draft, {e});
  if (!redrawing) return redrawing.error();
  if (Result<void> drawn = redrawing->draw_short(e); !drawn) return drawn;
  return redrawing->finish();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
