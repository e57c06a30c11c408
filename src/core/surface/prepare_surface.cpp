// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/prepare_surface.h>

#include "base/diagonal.h"
#include "base/pi.h"
#include "surface/Surface_editor.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::Surface_editor;

// The squared cotangent of a triangle's smallest angle, infinite if it has no area. It grows as the triangle
// gets worse, and, unlike a cosine, tells needles apart.
double badness(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - b, w = a - c;
  const double area = u.cross(v).squaredNorm();
  const double dot = std::max({-u.dot(v), -v.dot(w), -w.dot(u)});
  return area > 0 ? dot * dot / area : std::numeric_limits<double>::infinity();
}

double badness(const Triangle_surface& s, int f) {
  const Triangle& t = s.triangles[f];
  return badness(s.points[t[0]], s.points[t[1]], s.points[t[2]]);
}

double badness_of_angle(double degrees) {
  return 1 / std::pow(std::tan(degrees * pi / 180), 2);
}
double angle_of(double badness) {
  return std::atan(1 / std::sqrt(badness)) * 180 / pi;
}

struct Long_edge {
  double squared_length;
  int halfedge;
  bool operator<(const Long_edge& other) const {
    return squared_length != other.squared_length ? squared_length < other.squared_length
                                                  : halfedge > other.halfedge;
  }
};

class Preparation {
public:
  Preparation(Triangle_surface surface, const Prepare_options& options, Observer* observer)
      : m_surface(std::move(surface)), m_options(options), m_observer(observer), m_editor(m_surface),
        m_poor_badness(badness_of_angle(options.poor_angle)),
        m_sliver_badness(badness_of_angle(options.sliver_angle)) {}

  Result<Prepared_surface> run() {
    m_inputs = m_surface.number_of_vertices();
    m_report.faces_before = m_surface.number_of_faces();
    scan();
    m_report.min_angle_before = m_report.min_angle_after = angle_of(m_worst);
    bool alive = true;
    if (m_has_short) alive = collapse_short_edges();
    if (alive && m_options.flip && !m_poor.empty()) alive = flip_edges(m_poor, nullptr);
    if (alive && m_has_long) alive = bisect_long_edges();
    if (alive && m_options.split_chords) alive = split_chords();
    if (!alive) return make_error(Error_code::cancelled, "the preparation of the surface was cancelled");
    return finish();
  }

private:
  const Point& point(int v) const { return m_surface.points[v]; }
  double squared_length(int h) const {
    return (point(m_surface.target(h)) - point(m_surface.source(h))).squaredNorm();
  }
  bool go_on() {
    if (!m_observer || ++m_steps % 4096 != 0) return true;
    return !m_observer->cancelled();
  }

  void scan();
  std::vector<int> poor_faces() const;
  bool collapse_short_edges();
  bool keeps_normals(int h) const;
  bool flip_edges(const std::vector<int>& faces, std::vector<int>* changed);
  bool is_flip_good(int h) const;
  bool bisect_long_edges();
  bool split_chords();
  Prepared_surface finish();

  Triangle_surface m_surface;
  const Prepare_options& m_options;
  Observer* m_observer;
  Surface_editor m_editor;
  Prepare_report m_report;
  int m_inputs = 0;
  unsigned m_steps = 0;
  double m_poor_badness, m_sliver_badness;
  double m_worst = 0; // badness
  bool m_has_short = false, m_has_long = false, m_has_dead = false;
  std::vector<int> m_poor, m_queue;
  std::vector<char> m_queued;
  double m_diagonal = 0;             // computed when flips need it
  std::vector<int> m_collapsed_into; // per input vertex, -1 = still there; empty without collapses
};

// One pass finds whether anything is to be done: this is all that a good mesh costs.
void Preparation::scan() {
  const double infinity = std::numeric_limits<double>::infinity();
  const double longest = m_options.max_edge > 0 ? m_options.max_edge * m_options.max_edge : infinity;
  const double shortest = m_options.min_edge * m_options.min_edge;
  for (int f = 0; f < m_surface.number_of_faces(); ++f) {
    const Triangle& t = m_surface.triangles[f];
    const Point &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    const double bad = badness(a, b, c);
    m_worst = std::max(m_worst, bad);
    if (bad > m_poor_badness) m_poor.push_back(f);
    const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
    m_has_long = m_has_long || std::max({ab, bc, ca}) > longest;
    m_has_short = m_has_short || std::min({ab, bc, ca}) < shortest;
  }
}

std::vector<int> Preparation::poor_faces() const {
  std::vector<int> faces;
  for (int f = 0; f < m_surface.number_of_faces(); ++f)
    if (!m_editor.is_dead(f) && badness(m_surface, f) > m_poor_badness) faces.push_back(f);
  return faces;
}

// Whether the faces around source(h) keep their normals when it moves to target(h). Faces that are lower than
// min_edge have no normal worth keeping.
bool Preparation::keeps_normals(int h) const {
  const int a = m_surface.source(h), b = m_surface.target(h);
  const double least = std::cos(m_options.sharp_angle * pi / 180);
  int x = m_surface.outgoing[a];
  do {
    const int v = m_surface.target(x), w = m_surface.source(Triangle_surface::previous(x));
    if (v != b && w != b) {
      const Point before = (point(v) - point(a)).cross(point(w) - point(a));
      const Point after = (point(v) - point(b)).cross(point(w) - point(b));
      const double side = std::max((point(v) - point(a)).norm(), (point(w) - point(a)).norm());
      const bool flat = before.norm() < side * m_options.min_edge;
      if (!flat && before.dot(after) < least * before.norm() * after.norm()) return false;
      if (after.norm() <= 0 ||
          (flat && badness(point(v), point(w), point(b)) > badness(point(v), point(w), point(a))))
        return false;
    }
    x = m_surface.rotate_ccw(x);
  } while (x >= 0 && x != m_surface.outgoing[a]);
  return true;
}

bool Preparation::collapse_short_edges() {
  const double shortest = m_options.min_edge * m_options.min_edge;
  m_collapsed_into.assign(m_inputs, -1);
  for (int h = 0; h < m_surface.number_of_halfedges(); ++h) {
    if (!go_on()) return false;
    if (m_editor.is_dead(h / 3) || squared_length(h) >= shortest) continue;
    int chosen = -1;
    for (int x : {h, m_surface.opposite[h]})
      if (chosen < 0 && x >= 0 && m_editor.can_collapse(x) && keeps_normals(x)) chosen = x;
    if (chosen < 0) continue;
    m_collapsed_into[m_surface.source(chosen)] = m_surface.target(chosen);
    m_editor.collapse(chosen);
    ++m_report.collapses;
  }
  m_has_dead = m_report.collapses > 0;
  m_poor = poor_faces();
  return true;
}

// A flip is good if the smaller of the smallest angles grows, the surface stays where it is up to a tolerance
// (the distance of the two diagonals), and no normal turns by more than the angle of a sharp edge.
bool Preparation::is_flip_good(int h) const {
  const int o = m_surface.opposite[h];
  if (o < 0) return false;
  const Point &a = point(m_surface.source(h)), &b = point(m_surface.target(h));
  const Point& c = point(m_surface.target(Triangle_surface::next(h)));
  const Point& d = point(m_surface.target(Triangle_surface::next(o)));
  const double before = std::max(badness(a, b, c), badness(b, a, d));
  if (before <= m_poor_badness) return false;
  const double after = std::max(badness(c, a, d), badness(d, b, c));
  if (!(after < before * (1 - 1e-9))) return false;
  const Point cross = (b - a).cross(d - c);
  const double deviation = std::abs(cross.dot(c - a)), width = cross.norm();
  const double allowed =
      before > m_sliver_badness ? std::max(flat_tolerance, m_options.max_deviation) : flat_tolerance;
  if (!(deviation <= allowed * m_diagonal * width)) return false;
  // A face that is lower than the tolerance takes the normal of the other.
  Point normal_f = (b - a).cross(c - a), normal_g = (d - a).cross(b - a);
  const double low = allowed * m_diagonal * (b - a).norm();
  if (normal_f.norm() <= low) normal_f = normal_g;
  if (normal_g.norm() <= low) normal_g = normal_f;
  const double least = std::cos(m_options.sharp_angle * pi / 180);
  const auto close = [least](const Point& m, const Point& n) {
    return m.dot(n) >= least * m.norm() * n.norm();
  };
  if (!close(normal_f, normal_g)) return false;
  const Point sum = normal_f.normalized() + normal_g.normalized();
  return close((a - c).cross(d - c), sum) && close((b - d).cross(c - d), sum) && m_editor.can_flip(h);
}

// Flips edges of the given faces, and then of those that flips changed. Each flip makes the sorted list of
// all smallest angles larger, so this ends; the limit is for rounding. Faces that changed are appended to
// `changed`.
bool Preparation::flip_edges(const std::vector<int>& faces, std::vector<int>* changed) {
  if (m_diagonal == 0) m_diagonal = internal::diagonal_of(m_surface.points);
  m_queued.resize(m_surface.number_of_faces(), 0);
  m_queue.clear();
  const auto enqueue = [&](int f) {
    if (m_queued[f] || m_editor.is_dead(f)) return;
    m_queued[f] = 1;
    m_queue.push_back(f);
  };
  for (int f : faces) enqueue(f);
  const std::size_t limit = 100 * faces.size() + 1000;
  bool alive = true;
  for (std::size_t i = 0; i < m_queue.size(); ++i) {
    const int f = m_queue[i];
    m_queued[f] = 0;
    alive = alive && go_on();
    if (i > limit || !alive || badness(m_surface, f) <= m_poor_badness) continue;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      if (!is_flip_good(h)) continue;
      const int g = m_surface.opposite[h] / 3;
      m_editor.flip(h);
      ++m_report.flips;
      for (int x : {3 * f, 3 * f + 1, 3 * g, 3 * g + 1})
        if (m_surface.opposite[x] >= 0) enqueue(m_surface.opposite[x] / 3);
      for (int x : {f, g}) {
        enqueue(x);
        if (changed) changed->push_back(x);
      }
      break;
    }
  }
  return alive;
}

// Bisects the longest edge of all, again and again: it is then the longest of its two triangles. Flips follow
// at once, or else the needles of a fan would all be bisected side by side.
bool Preparation::bisect_long_edges() {
  const double longest = m_options.max_edge * m_options.max_edge;
  std::priority_queue<Long_edge> queue;
  const auto enqueue = [&](int h) {
    h = m_surface.edge(h);
    const double length = squared_length(h);
    if (length > longest) queue.push({length, h});
  };
  for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
    if (!m_editor.is_dead(h / 3) && m_surface.edge(h) == h) enqueue(h);
  std::vector<int> faces;
  while (!queue.empty() && m_surface.number_of_faces() + 2 <= m_options.max_faces) {
    if (!go_on()) return false;
    const Long_edge top = queue.top();
    const int h = top.halfedge;
    queue.pop();
    // A halfedge whose edge was halved or flipped meanwhile has another length, or stands for another edge.
    if (m_surface.edge(h) != h || squared_length(h) != top.squared_length) continue;
    const int m = m_editor.split_edge(h, 0.5 * (point(m_surface.source(h)) + point(m_surface.target(h))));
    ++m_report.bisections;
    faces.clear();
    int x = m_surface.outgoing[m];
    do {
      faces.push_back(x / 3);
      x = m_surface.rotate_ccw(x);
    } while (x >= 0 && x != m_surface.outgoing[m]);
    if (m_options.flip && !flip_edges(std::vector<int>(faces), &faces)) return false;
    for (int f : faces)
      for (int i = 0; i < 3; ++i) enqueue(3 * f + i);
  }
  return true;
}

bool Preparation::split_chords() {
  const int halfedges = m_surface.number_of_halfedges();
  bool closed = true;
  for (int h = 0; h < halfedges && closed; ++h)
    closed = m_surface.opposite[h] >= 0 || m_editor.is_dead(h / 3);
  if (closed) return true;
  // Splitting moves old edges to new faces and adds no chord: a pass over old and new halfedges finds every
  // one.
  for (int h = 0; h < m_surface.number_of_halfedges(); ++h) {
    if (!go_on()) return false;
    if (m_editor.is_dead(h / 3) || m_surface.opposite[h] < 0) continue;
    const int a = m_surface.source(h), b = m_surface.target(h);
    if (!m_editor.is_boundary_vertex(a) || !m_editor.is_boundary_vertex(b)) continue;
    m_editor.split_edge(h, 0.5 * (point(a) + point(b)));
    ++m_report.chords;
  }
  for (int f = 0; f < halfedges / 3; ++f) {
    if (m_editor.is_dead(f)) continue;
    const Triangle t = m_surface.triangles[f];
    if (!std::all_of(t.begin(), t.end(), [&](int v) { return m_editor.is_boundary_vertex(v); })) continue;
    m_editor.split_face(f, (point(t[0]) + point(t[1]) + point(t[2])) / 3);
    ++m_report.chords;
  }
  return true;
}

Prepared_surface Preparation::finish() {
  const bool changed = m_report.collapses + m_report.flips + m_report.bisections + m_report.chords > 0;
  std::vector<int> index;
  if (m_has_dead) index = m_editor.compact();
  Prepared_surface result;
  result.input_vertex.assign(m_surface.number_of_vertices(), -1);
  result.working_vertex.resize(m_inputs);
  for (int v = 0; v < m_inputs; ++v) {
    int w = v;
    while (m_has_dead && m_collapsed_into[w] >= 0) w = m_collapsed_into[w];
    const int now = m_has_dead ? index[w] : w;
    result.working_vertex[v] = now;
    if (w == v && now >= 0) result.input_vertex[now] = v;
  }
  m_report.faces_after = m_surface.number_of_faces();
  if (changed) m_report.min_angle_after = smallest_angle(m_surface);
  result.surface = std::move(m_surface);
  result.report = m_report;
  return result;
}

} // namespace

Result<Prepared_surface> prepare_surface(Triangle_surface surface, const Prepare_options& options,
                                         Observer* observer) {
  CGAL_precondition(surface.opposite.size() == 3 * surface.triangles.size());
  CGAL_precondition(options.poor_angle > 0 && options.poor_angle < 60);
  CGAL_precondition(options.max_edge >= 0 && options.min_edge >= 0);
  return Preparation(std::move(surface), options, observer).run();
}

double smallest_angle(const Triangle_surface& surface) {
  if (surface.triangles.empty()) return 180;
  double worst = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f) worst = std::max(worst, badness(surface, f));
  return angle_of(worst);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
