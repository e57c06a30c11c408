// SPDX-License-Identifier: GPL-3.0-or-later
// Straightening: a closed contour is pulled tight like a rubber band that slides over the edges and hops over vertices.
#include "edits/steps.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A loop over the edges of the surface: it crosses `exit[i]`, a halfedge of the face that it leaves, at `t[i]` from its source.
struct Band {
  std::vector<int> exit;
  std::vector<double> t;
};

constexpr double margin = 0.02; // of an edge: how near to a vertex the band comes before it hops

class Rubber_band {
public:
  Rubber_band(const Triangle_surface& surface, Band band) : m_surface(surface), m_band(std::move(band)) {}

  Band tighten(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      for (int sweep = 0; sweep < 8; ++sweep) slide();
      if (!hop() && round > 4) break;
    }
    slide();
    return m_band;
  }

private:
  int size() const { return int(m_band.exit.size()); }
  Point point(int i) const {
    i = (i % size() + size()) % size();
    const Point &p = m_surface.points[m_surface.source(m_band.exit[i])],
                &q = m_surface.points[m_surface.target(m_band.exit[i])];
    return p + m_band.t[i] * (q - p);
  }

  // Each crossing goes where the line between its neighbours crosses the edge when the two faces are unfolded.
  void slide() {
    for (int i = 0; i < size(); ++i) {
      const Point &p = m_surface.points[m_surface.source(m_band.exit[i])],
                  &q = m_surface.points[m_surface.target(m_band.exit[i])];
      const Eigen::Vector3d d = q - p;
      const double length = d.squaredNorm();
      if (!(length > 0)) continue;
      const Eigen::Vector3d a = point(i - 1) - p, b = point(i + 1) - p;
      const double sa = a.dot(d) / length, sb = b.dot(d) / length;
      const double ha = (a - sa * d).norm(), hb = (b - sb * d).norm();
      if (!(ha + hb > 0)) continue;
      m_band.t[i] = std::min(1 - margin, std::max(margin, (sa * hb + sb * ha) / (ha + hb)));
    }
  }

  // The vertex that a crossing is held by, or -1.
  int held_by(int i) const {
    if (m_band.t[i] <= margin) return m_surface.source(m_band.exit[i]);
    if (m_band.t[i] >= 1 - margin) return m_surface.target(m_band.exit[i]);
    return -1;
  }

  // Where a run of crossings turns around a vertex by less than half of its angle, the way on the other side is shorter.
  bool hop() {
    bool hopped = false;
    for (int i = 0; i < size(); ++i) {
      const int v = held_by(i);
      if (v < 0 || m_surface.is_boundary(m_surface.outgoing[v])) continue;
      rotate_to_run(i, v);
      int run = 1;
      while (run < size() && touches(run, v)) ++run;
      if (run >= size() - 2) continue;
      if (angle(v, run) < total_angle(v) - angle(v, run))
        continue; // the near side is the shorter one already
      hopped = cross_over(v, run) || hopped;
      i = 0;
      if (++m_hops > 20 * (size() + 50)) return false;
    }
    return hopped;
  }
  bool touches(int i, int v) const {
    return m_surface.source(m_band.exit[i]) == v || m_surface.target(m_band.exit[i]) == v;
  }
  void rotate_to_run(int i, int v) {
    int first = i;
    for (int k = 0; k < size(); ++k) {
      const int before = (first - 1 + size()) % size();
      if (!touches(before, v)) break;
      first = before;
    }
    std::rotate(m_band.exit.begin(), m_band.exit.begin() + first, m_band.exit.end());
    std::rotate(m_band.t.begin(), m_band.t.begin() + first, m_band.t.end());
  }

  double corner_angle(int h) const { // at the source of h
    const Point& p = m_surface.points[m_surface.source(h)];
    const Eigen::Vector3d a = m_surface.points[m_surface.target(h)] - p,
                          b = m_surface.points[m_surface.source(Triangle_surface::previous(h))] - p;
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }
  double total_angle(int v) const {
    double sum = 0;
    int h = m_surface.outgoing[v];
    do {
      sum += corner_angle(h);
      h = m_surface.rotate_ccw(h);
    } while (h != m_surface.outgoing[v]);
    return sum;
  }
  // Of the faces before, between and after the run, which the band passes around v: on the far side of v lies the rest.
  double angle(int v, int run) const {
    double sum = corner_at(v, m_band.exit[0] / 3);
    for (int i = 0; i < run; ++i) sum += corner_at(v, m_surface.opposite[m_band.exit[i]] / 3);
    return sum;
  }
  double corner_at(int v, int face) const {
    for (int h = 3 * face; h < 3 * face + 3; ++h)
      if (m_surface.source(h) == v) return corner_angle(h);
    return 0;
  }

  // Replaces the spokes of v that the run crosses by the others.
  bool cross_over(int v, int run) {
    const int first_face = m_band.exit[0] / 3, last_face = m_surface.opposite[m_band.exit[run - 1]] / 3;
    if (first_face == last_face) return false;
    // Turn around v from the first face away from the run.
    const bool ccw_run =
        m_surface.target(m_band.exit[0]) == v; // the spoke runs to v: the band turns around it ccw
    std::vector<int> exits;
    std::vector<double> t;
    int face = first_face;
    for (int steps = 0; face != last_face; ++steps) {
      if (steps > 1000) return false;
      int h = 3 * face;
      while (m_surface.source(h) != v) ++h;
      const int exit = ccw_run ? h : Triangle_surface::previous(h);
      exits.push_back(exit);
      t.push_back(m_surface.source(exit) == v ? 0.2 : 0.8);
      if (m_surface.opposite[exit] < 0) return false;
      face = m_surface.opposite[exit] / 3;
    }
    m_band.exit.erase(m_band.exit.begin(), m_band.exit.begin() + run);
    m_band.t.erase(m_band.t.begin(), m_band.t.begin() + run);
    m_band.exit.insert(m_band.exit.begin(), exits.begin(), exits.end());
    m_band.t.insert(m_band.t.begin(), t.begin(), t.end());
    remove_returns();
    return true;
  }

  // A crossing that is followed by one of the same edge goes there and back.
  void remove_returns() {
    for (bool again = true; again && size() > 3;) {
      again = false;
      for (int i = 0; i < size() && size() > 3; ++i) {
        const int j = (i + 1) % size();
        if (m_surface.edge(m_band.exit[i]) != m_surface.edge(m_band.exit[j])) continue;
        for (int k : {std::max(i, j), std::min(i, j)}) {
          m_band.exit.erase(m_band.exit.begin() + k);
          m_band.t.erase(m_band.t.begin() + k);
        }
        again = true;
      }
    }
  }

  const Triangle_surface& m_surface;
  Band m_band;
  int m_hops = 0;
};

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
      band.t.push_back(1 - margin);
      if (s.opposite[exit] < 0) return refuse("the contour runs along edges of the surface");
      face = s.opposite[exit] / 3;
    }
  }
  return band;
}

} // namespace

Result<void> apply_edit(Draft& draft, const Straighten_contour& edit) {
  const Result<int> e = free_loop_at(draft, edit.at);
  if (!e) return e.error();
  Result<Band> loose = band_of(draft, draft.network.edges[*e]);
  if (!loose) return loose.error();
  const Band band = Rubber_band(draft.surface(), std::move(*loose)).tighten(200);
  if (band.exit.size() < 3) return refuse("the contour would shrink to a point");
  Contour_edge fresh;
  for (std::size_t i = 0; i < band.exit.size(); ++i) {
    const int h = band.exit[i], r = draft.surface().edge(h);
    fresh.vertices.push_back(add_crossing(draft.network, {r, h == r ? band.t[i] : 1 - band.t[i]}));
    fresh.faces.push_back(draft.surface().opposite[h] / 3);
  }
  fresh.vertices.push_back(fresh.vertices.front());
  fresh.from = fresh.to = add_node(draft.network, fresh.vertices.front());
  return replace_edge(draft, *e, std::move(fresh));
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
