// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/rubber_band.h"

#include "atlas/region_curve.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

class Rubber_band {
public:
  Rubber_band(const Triangle_surface& mesh, Band band, const std::vector<char>& is_wall)
      : m_surface(mesh), m_band(std::move(band)), m_is_wall(is_wall) {}

  Band tighten(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      for (int sweep = 0; sweep < 8; ++sweep) slide();
      if (!hop() && round > 4) break;
    }
    slide();
    return std::move(m_band);
  }

private:
  int size() const { return int(m_band.exit.size()); }
  bool is_closed() const { return m_band.from < 0; }
  Point point(int i) const {
    if (!is_closed() && (i < 0 || i >= size())) return m_surface.points[i < 0 ? m_band.from : m_band.to];
    i = (i % size() + size()) % size();
    const Point &p = m_surface.points[m_surface.source(m_band.exit[i])],
                &q = m_surface.points[m_surface.target(m_band.exit[i])];
    return p + m_band.t[i] * (q - p);
  }

  bool is_wall(int v) const { return !m_is_wall.empty() && m_is_wall[v]; }
  double margin_at(int v) const { return is_wall(v) ? 0.2 : band_margin; }

  // Each crossing goes where the line between its neighbours crosses the edge when the two faces are
  // unfolded.
  void slide() {
    for (int i = 0; i < size(); ++i) {
      const int a = m_surface.source(m_band.exit[i]), b = m_surface.target(m_band.exit[i]);
      if (!((m_surface.points[b] - m_surface.points[a]).squaredNorm() > 0)) continue;
      const double t =
          straight_crossing(m_surface.points[a], m_surface.points[b], point(i - 1), point(i + 1));
      m_band.t[i] = std::min(1 - margin_at(b), std::max(margin_at(a), t));
    }
  }

  // The vertex that a crossing is held by, or -1.
  int held_by(int i) const {
    const int a = m_surface.source(m_band.exit[i]), b = m_surface.target(m_band.exit[i]);
    if (m_band.t[i] <= margin_at(a)) return a;
    if (m_band.t[i] >= 1 - margin_at(b)) return b;
    return -1;
  }

  // Where a run of crossings turns around a vertex by less than half of its angle, the way on the other side
  // is shorter.
  bool hop() {
    bool hopped = false;
    for (int i = 0; i < size(); ++i) {
      const int v = held_by(i);
      if (v < 0 || v == m_band.from || v == m_band.to || is_wall(v) ||
          m_surface.is_boundary(m_surface.outgoing[v]))
        continue;
      const int first = begin_of_run(i, v);
      int run = 1;
      while (run < size() && (is_closed() || first + run < size()) && touches((first + run) % size(), v))
        ++run;
      if (is_closed() && run >= size() - 2) continue;
      if (angle(v, first, run) < total_angle(v) - angle(v, first, run))
        continue; // the near side is the shorter one already
      hopped = cross_over(v, first, run) || hopped;
      i = 0;
      if (++m_hops > 20 * (size() + 50)) return false;
    }
    return hopped;
  }
  bool touches(int i, int v) const {
    return m_surface.source(m_band.exit[i]) == v || m_surface.target(m_band.exit[i]) == v;
  }
  // A closed band is turned so that the run begins at 0.
  int begin_of_run(int i, int v) {
    int first = i;
    for (int k = 0; k < size(); ++k) {
      if (!is_closed() && first == 0) break;
      const int before = (first - 1 + size()) % size();
      if (!touches(before, v)) break;
      first = before;
    }
    if (!is_closed()) return first;
    std::rotate(m_band.exit.begin(), m_band.exit.begin() + first, m_band.exit.end());
    std::rotate(m_band.t.begin(), m_band.t.begin() + first, m_band.t.end());
    return 0;
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
  // Of the faces before, between and after the run, which the band passes around v: on the far side of v lies
  // the rest.
  double angle(int v, int first, int run) const {
    double sum = corner_at(v, m_band.exit[first] / 3);
    for (int i = first; i < first + run; ++i) sum += corner_at(v, m_surface.opposite[m_band.exit[i]] / 3);
    return sum;
  }
  double corner_at(int v, int face) const {
    for (int h = 3 * face; h < 3 * face + 3; ++h)
      if (m_surface.source(h) == v) return corner_angle(h);
    return 0;
  }

  // Replaces the spokes of v that the run crosses by the others.
  bool cross_over(int v, int first, int run) {
    const int first_face = m_band.exit[first] / 3,
              last_face = m_surface.opposite[m_band.exit[first + run - 1]] / 3;
    if (first_face == last_face) return false;
    // Turn around v from the first face away from the run.
    const bool ccw_run =
        m_surface.target(m_band.exit[first]) == v; // the spoke runs to v: the band turns around it ccw
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
    m_band.exit.erase(m_band.exit.begin() + first, m_band.exit.begin() + first + run);
    m_band.t.erase(m_band.t.begin() + first, m_band.t.begin() + first + run);
    m_band.exit.insert(m_band.exit.begin() + first, exits.begin(), exits.end());
    m_band.t.insert(m_band.t.begin() + first, t.begin(), t.end());
    remove_returns();
    return true;
  }

  void erase(int i) {
    m_band.exit.erase(m_band.exit.begin() + i);
    m_band.t.erase(m_band.t.begin() + i);
  }

  // A crossing that is followed by one of the same edge goes there and back; one of an edge at the band's own
  // end goes around nothing.
  void remove_returns() {
    const int least = is_closed() ? 3 : 0;
    for (bool again = true; again && size() > least;) {
      again = false;
      while (!is_closed() && size() > 0 && touches(0, m_band.from)) erase(0);
      while (!is_closed() && size() > 0 && touches(size() - 1, m_band.to)) erase(size() - 1);
      for (int i = 0; i + (is_closed() ? 0 : 1) < size() && size() > least; ++i) {
        const int j = (i + 1) % size();
        if (m_surface.edge(m_band.exit[i]) != m_surface.edge(m_band.exit[j])) continue;
        erase(std::max(i, j));
        erase(std::min(i, j));
        again = true;
      }
    }
  }

  const Triangle_surface& m_surface;
  Band m_band;
  const std::vector<char>& m_is_wall;
  int m_hops = 0;
};

} // namespace

Band tightened(const Triangle_surface& mesh, Band band, int rounds, const std::vector<char>& is_wall) {
  return Rubber_band(mesh, std::move(band), is_wall).tighten(rounds);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
