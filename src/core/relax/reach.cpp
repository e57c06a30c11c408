// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices go to where the surface lies far from all quads: into the ends of limbs, onto ridges and folds.
#include "relax/reach.h"

#include "relax/defects.h"
#include "relax/mesh_quality.h"
#include "relax/relax_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

namespace {

// Lengths are in edges of the quads: square roots of the area for each. What lies farther is far; what is
// nearer than `near` is not measured again before something around it has moved.
constexpr double far_away = 0.5, near = 0.25;

// A vertex may not make a quad worse than this for a place that is far, or than the second for one that is
// farther than an edge.
constexpr double good_quad = 0.5, fair_quad = 0.35;

// By how much the sum of the distances' fourth powers around a vertex falls at least, relative to what it
// was.
constexpr double worth_it = 0.05;

// Each round moves vertices that have no quad in common; the last ones hardly find any.
constexpr int reach_rounds = 8;

// Rings of quads that give way around moved vertices, how often, and how good they should get.
constexpr int reach_rings = 2, sweeps = 2, untangling = 2;
constexpr double wanted = 0.6;

// Of the surface's vertices about so many are samples, for each quad, and large triangles are divided until
// their samples are so near to each other.
constexpr double vertices_per_quad = 8, spacing = 0.5;
constexpr int finest = 64;

// So often vertices are taken back where quads got defects, each time with more around them.
constexpr int reach_withdrawals = 4;

struct Sample {
  Point point;
  int face = -1; // of the surface
  int quad = -1; // the nearest
  double distance = std::numeric_limits<double>::infinity();
};

double fourth_power(double x) {
  return x * x * x * x;
}

double squared_distance(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const auto to_segment = [](const Point& from, const Point& along) {
    const double l = along.squaredNorm(), t = l > 0 ? std::clamp(from.dot(along) / l, 0.0, 1.0) : 0;
    return (from - t * along).squaredNorm();
  };
  const Point n = ab.cross(ac);
  const double size = n.squaredNorm();
  const bool above =
      size > 0 && ab.cross(ap).dot(n) >= 0 && (c - b).cross(bp).dot(n) >= 0 && ac.cross(cp).dot(n) <= 0;
  if (above) return ap.dot(n) * ap.dot(n) / size;
  return std::min({to_segment(ap, ab), to_segment(bp, c - b), to_segment(ap, ac)});
}

// The corner where the shorter diagonal begins, 0 or 1.
std::size_t shorter_diagonal(const std::array<Point, 4>& x) {
  return (x[2] - x[0]).squaredNorm() <= (x[3] - x[1]).squaredNorm() ? 0 : 1;
}

class Reach {
public:
  explicit Reach(State& state) : m_state(state) {
    double whole = 0;
    for (int f = 0; f < state.input.number_of_faces(); ++f) whole += area(state.input, f);
    m_edge = std::sqrt(whole / double(std::max<std::size_t>(1, state.mesh.quads.size())));
    add_vertices();
    for (int f = 0; f < state.input.number_of_faces(); ++f) divide(f);
  }

  // Whether anything was moved.
  bool run(Observer* observer) {
    bool moved = false;
    std::vector<char> pulled(std::size_t(m_state.number_of_vertices()), 0);
    for (int round = 0; round < reach_rounds && !(observer && observer->cancelled()); ++round) {
      measure();
      std::vector<char> busy(m_state.mesh.quads.size(), 0);
      bool any = false;
      for (const Sample& place : far_places()) any = pull(place, busy, pulled) || any;
      if (!any) break;
      moved = true;
      give_way(pulled);
    }
    return moved;
  }

private:
  void add_vertices() {
    const Triangle_surface& surface = m_state.input;
    const double most = vertices_per_quad * double(m_state.mesh.quads.size());
    const int step = 1 + int(surface.number_of_vertices() / std::max(1.0, most));
    for (int v = 0; v < surface.number_of_vertices(); v += step)
      if (surface.outgoing[v] >= 0) m_samples.push_back({surface.points[v], surface.outgoing[v] / 3});
  }

  void divide(int f) {
    const Triangle& t = m_state.input.triangles[f];
    const std::vector<Point>& p = m_state.input.points;
    const Point &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const int n = int(std::min(double(finest), longest / (spacing * m_edge)));
    for (int i = 0; i <= n && n > 1; ++i)
      for (int j = 0; i + j <= n; ++j)
        if (i % n != 0 || j % n != 0) // the corners are vertices
          m_samples.push_back({(double(n - i - j) * a + double(i) * b + double(j) * c) / double(n), f});
  }

  std::array<Point, 4> corners(int q, int v, const Point& at) const {
    std::array<Point, 4> x;
    for (std::size_t i = 0; i < 4; ++i) {
      const int w = m_state.mesh.quads[std::size_t(q)][i];
      x[i] = w == v ? at : m_state.mesh.points[std::size_t(w)];
    }
    return x;
  }

  int face_near(int q) const {
    return m_state.sites[std::size_t(m_state.mesh.quads[std::size_t(q)][0])].face;
  }

  Closest_point below_centre(int q, int v, const Point& at) const {
    const std::array<Point, 4> x = corners(q, v, at);
    return m_state.projector.closest(0.25 * (x[0] + x[1] + x[2] + x[3]), face_near(q));
  }

  void measure() {
    Triangle_surface quads;
    quads.points = m_state.mesh.points;
    for (int q = 0; q < int(m_state.mesh.quads.size()); ++q) {
      const Quad& v = m_state.mesh.quads[std::size_t(q)];
      const std::size_t c = shorter_diagonal(corners(q, -1, {}));
      quads.triangles.push_back({v[c], v[c + 1], v[c + 2]});
      quads.triangles.push_back({v[c], v[c + 2], v[(c + 3) % 4]});
    }
    const Surface_projector onto(quads);
    m_samples_of.assign(m_state.mesh.quads.size(), {});
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
      Sample& s = m_samples[i];
      if (s.distance > near * m_edge) {
        const Closest_point c = onto.closest(s.point);
        s.distance = std::sqrt(c.squared_distance);
        s.quad = c.face / 2;
      }
      m_samples_of[std::size_t(s.quad)].push_back(i);
    }
    m_gaps.clear();
    for (int q = 0; q < int(m_state.mesh.quads.size()); ++q)
      m_gaps.push_back(std::sqrt(below_centre(q, -1, {}).squared_distance));
  }

  // The farthest first: parts of the surface, and those below quads that lie far from it.
  std::vector<Sample> far_places() const {
    std::vector<Sample> places;
    for (const Sample& s : m_samples)
      if (s.distance > far_away * m_edge) places.push_back(s);
    for (int q = 0; q < int(m_gaps.size()); ++q)
      if (m_gaps[std::size_t(q)] > far_away * m_edge) {
        const Closest_point c = below_centre(q, -1, {});
        places.push_back({c.point, c.face, q, m_gaps[std::size_t(q)]});
      }
    std::stable_sort(places.begin(), places.end(),
                     [](const Sample& a, const Sample& b) { return a.distance > b.distance; });
    return places;
  }

  std::vector<int> fan(int v) const {
    std::vector<int> quads;
    for (int k = m_state.first[v]; k < m_state.first[v + 1]; ++k) quads.push_back(m_state.corners[k] / 4);
    return quads;
  }

  // The quads of a fan and those around them.
  std::vector<int> patch(const std::vector<int>& fan_of_vertex) const {
    std::vector<int> quads;
    for (int q : fan_of_vertex)
      for (int w : m_state.mesh.quads[std::size_t(q)])
        for (int o : fan(w)) quads.push_back(o);
    std::sort(quads.begin(), quads.end());
    quads.erase(std::unique(quads.begin(), quads.end()), quads.end());
    return quads;
  }

  double squared_distance_of(const Point& p, const std::vector<int>& quads, int v, const Point& at) const {
    double best = std::numeric_limits<double>::infinity();
    for (int q : quads) {
      const std::array<Point, 4> x = corners(q, v, at);
      const std::size_t c = shorter_diagonal(x);
      best = std::min({best, squared_distance(p, x[c], x[c + 1], x[c + 2]),
                       squared_distance(p, x[c], x[c + 2], x[(c + 3) % 4])});
    }
    return best;
  }

  // What the distances around a vertex cost.
  double cost(const std::vector<int>& fan_of_vertex) const {
    double sum = 0;
    for (int q : fan_of_vertex) {
      sum += fourth_power(m_gaps[std::size_t(q)] / m_edge);
      for (std::size_t i : m_samples_of[std::size_t(q)]) sum += fourth_power(m_samples[i].distance / m_edge);
    }
    return sum;
  }

  // The same with the vertex elsewhere; more than `most` may be told as anything above it.
  double cost(const std::vector<int>& fan_of_vertex, const std::vector<int>& around, int v, const Point& at,
              double most) const {
    double sum = 0;
    for (int q : fan_of_vertex)
      for (std::size_t i : m_samples_of[std::size_t(q)]) {
        const double d = squared_distance_of(m_samples[i].point, around, v, at) / (m_edge * m_edge);
        if ((sum += d * d) > most) return sum;
      }
    for (int q : fan_of_vertex) {
      const double d = below_centre(q, v, at).squared_distance / (m_edge * m_edge);
      if ((sum += d * d) > most) return sum;
    }
    return sum;
  }

  Step step_to(int v, const Point& target, int face) const {
    const Closest_point c = m_state.projector.closest_nearby(target, face);
    Step step;
    step.point = c.point;
    step.face = c.face;
    step.normal = m_state.projector.normal(c.face);
    if (step.normal.isZero()) step.normal = m_state.normal(v);
    return step;
  }

  // Moves that corner of the nearest quad to a far place, or some of the way, which helps most.
  bool pull(const Sample& place, std::vector<char>& busy, std::vector<char>& pulled) {
    double gained = 0;
    int best = -1;
    Step best_step;
    for (int v : m_state.mesh.quads[std::size_t(place.quad)]) {
      if (m_state.sites[v].freedom != Freedom::surface) continue;
      const std::vector<int> own = fan(v);
      if (std::any_of(own.begin(), own.end(), [&](int q) { return busy[std::size_t(q)] != 0; })) continue;
      const std::vector<int> around = patch(own);
      const double before = cost(own);
      const double least = std::min(m_state.worst_around(v), place.distance > m_edge ? fair_quad : good_quad);
      for (const double part : {1.0, 0.75, 0.5, 0.25}) {
        const Point& from = m_state.mesh.points[v];
        const Step step = step_to(v, from + part * (place.point - from), place.face);
        if (m_state.worst_around(v, step) < least) continue;
        const double needed = std::max(gained, worth_it * before);
        const double gain = before - cost(own, around, v, step.point, before - needed);
        if (gain <= needed) continue;
        gained = gain;
        best = v;
        best_step = step;
      }
    }
    if (best < 0) return false;
    m_state.move(best, best_step);
    pulled[std::size_t(best)] = 1;
    for (int q : fan(best)) {
      busy[std::size_t(q)] = 1;
      forget(q);
    }
    return true;
  }

  // Distances around a quad are to be measured anew.
  void forget(int q) {
    for (std::size_t i : m_samples_of[std::size_t(q)])
      m_samples[i].distance = std::numeric_limits<double>::infinity();
  }

  void give_way(const std::vector<char>& pulled) {
    std::vector<char> mask = pulled;
    add_rings(m_state.mesh, reach_rings, mask);
    for (std::size_t v = 0; v < mask.size(); ++v)
      if (pulled[v]) mask[v] = 0;
    for (int i = 0; i < sweeps; ++i) smooth(m_state, {}, {good_quad, false, &mask});
    untangle(m_state, wanted, untangling, &mask, nullptr);
    for (int q = 0; q < int(m_state.mesh.quads.size()); ++q) {
      const Quad& v = m_state.mesh.quads[std::size_t(q)];
      if (mask[v[0]] || mask[v[1]] || mask[v[2]] || mask[v[3]]) forget(q);
    }
  }

  State& m_state;
  double m_edge = 0;
  std::vector<Sample> m_samples;
  std::vector<double> m_gaps;                         // per quad: how far its centre is from the surface
  std::vector<std::vector<std::size_t>> m_samples_of; // per quad
};

void bring_up_to_date(const Quad_mesh& mesh, const std::vector<int>& defects, Relax_report& report) {
  const Mesh_quality quality = mesh_quality(mesh);
  report.worst_after = quality.worst;
  report.mean_after = quality.mean;
  report.inverted_after = quality.inverted;
  report.intersections_after = 0;
  if (std::any_of(defects.begin(), defects.end(), [](int n) { return n > 0; }))
    report.intersections_after = int(intersecting_quads(mesh).size());
}

} // namespace

void reach(Quad_mesh& mesh, const Surface_projector& projector, Vertex_constraints constraints,
           const Relax_options& options, Relax_report& report, Observer* observer) {
  if (mesh.quads.empty()) return;
  const std::vector<Point> original = mesh.points;
  constraints.fixed.resize(mesh.points.size(), 0);
  for (int v : report.off_surface) constraints.fixed[std::size_t(v)] = 1;
  State state(mesh, projector, constraints, options.threads);
  bind_boundary(state);
  bind_to_curves(state, constraints);
  state.colour_vertices();
  const State::Snapshot snapshot = state.snapshot();
  const std::vector<int> defects = count_defects(state);
  if (!Reach(state).run(observer)) {
    mesh.points = original;
    return;
  }
  bring_up_to_date(mesh, without_new_defects(state, snapshot, defects, reach_withdrawals), report);
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
