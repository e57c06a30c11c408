// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/relax_state.h"

#include "relax/quad_shape.h"

#include <CGAL/Reeb_quadrangulation/feature_edges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {

double scaled_jacobian(const Point& p0, const Point& p1, const Point& p2, const Point& p3) {
  const std::array<Point, 4> edge = {p1 - p0, p2 - p1, p3 - p2, p0 - p3};
  const Point n = (edge[0] - edge[2]).cross(edge[1] - edge[3]);
  const double area = n.norm();
  if (!(area > 0)) return 0;
  double length[4], worst = 1;
  for (int i = 0; i < 4; ++i) length[i] = edge[i].norm();
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 3) % 4;
    const double scale = length[i] * length[j] * area;
    worst = scale > 0 ? std::min(worst, n.dot(edge[j].cross(edge[i])) / scale) : std::min(worst, 0.0);
  }
  return worst;
}

namespace relaxation {

namespace {

// The mesh's boundary loops as vertices, quads on the left.
std::vector<std::vector<int>> loops_of(const Quad_mesh& mesh) {
  std::vector<std::array<int, 3>> edges; // {smaller, larger, direction}
  for (const Quad& q : mesh.quads)
    for (int i = 0; i < 4; ++i) {
      const int a = q[i], b = q[(i + 1) % 4];
      edges.push_back({std::min(a, b), std::max(a, b), a > b});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<int> next(mesh.points.size(), -1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool first = i > 0 && edges[i - 1][0] == edges[i][0] && edges[i - 1][1] == edges[i][1];
    const bool last =
        i + 1 < edges.size() && edges[i + 1][0] == edges[i][0] && edges[i + 1][1] == edges[i][1];
    if (!first && !last) next[edges[i][edges[i][2]]] = edges[i][1 - edges[i][2]];
  }
  std::vector<std::vector<int>> loops;
  for (int v = 0; v < int(next.size()); ++v) {
    if (next[v] < 0) continue;
    std::vector<int> loop;
    for (int w = v; w >= 0 && next[w] >= 0;) {
      loop.push_back(w);
      const int following = next[w];
      next[w] = -1;
      w = following;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

// Parameters of a loop of vertices on a closed curve, increasing and within one turn. Where the nearest
// points are not in order, the vertices are placed by their chord lengths instead.
std::vector<double> parameters_on(const Surface_curve& curve, const std::vector<int>& loop,
                                  const std::vector<Point>& points) {
  const double total = curve.length();
  const int n = int(loop.size());
  std::vector<double> s(n);
  s[0] = curve.nearest(points[loop[0]], 0, total);
  bool ordered = true;
  for (int i = 1; i < n; ++i) {
    s[i] = curve.nearest(points[loop[i]], 0, total);
    while (s[i] < s[0]) s[i] += total;
    ordered = ordered && s[i] > s[i - 1];
  }
  if (ordered && s[n - 1] < s[0] + total) return s;
  double length = 0;
  std::vector<double> at(n + 1, 0);
  for (int i = 0; i < n; ++i) at[i + 1] = length += (points[loop[(i + 1) % n]] - points[loop[i]]).norm();
  for (int i = 0; i < n; ++i) s[i] = s[0] + total * (length > 0 ? at[i] / length : double(i) / n);
  return s;
}

} // namespace

State::State(Quad_mesh& m, const Surface_projector& pr, const Vertex_constraints& constraints, int t)
    : mesh(m), projector(pr), input(pr.surface()), threads(t), sites(m.points.size()) {
  for (std::size_t v = 0; v < constraints.fixed.size(); ++v)
    if (constraints.fixed[v]) sites[v].freedom = Freedom::fixed;
  const int nv = number_of_vertices();
  first.assign(nv + 1, 0);
  for (const Quad& q : mesh.quads)
    for (int v : q) ++first[v + 1];
  for (int v = 0; v < nv; ++v) first[v + 1] += first[v];
  corners.resize(4 * mesh.quads.size());
  std::vector<int> end(first.begin(), first.end() - 1);
  for (int q = 0; q < int(mesh.quads.size()); ++q)
    for (int i = 0; i < 4; ++i) corners[end[mesh.quads[q][i]]++] = 4 * q + i;

  m_normals.assign(nv, Point::Zero());
  for (const Quad& q : mesh.quads) {
    const auto& p = mesh.points;
    original_lengths.push_back({(0.25 * (p[q[1]] - p[q[0]] + p[q[2]] - p[q[3]])).norm(),
                                (0.25 * (p[q[3]] - p[q[0]] + p[q[2]] - p[q[1]])).norm()});
  }
  place_on_surface();
}

// First-fit in the order of the indices.
void State::colour_vertices() {
  colours.clear();
  std::vector<int> colour(mesh.points.size(), -1), seen;
  const auto see = [&](int w) {
    if (w >= 0 && colour[w] >= 0) seen[colour[w]] = 1;
  };
  for (int v = 0; v < number_of_vertices(); ++v) {
    if (first[v] == first[v + 1]) continue;
    seen.assign(colours.size() + 1, 0);
    for (int k = first[v]; k < first[v + 1]; ++k)
      for (int w : mesh.quads[corners[k] / 4]) see(w);
    see(sites[v].previous);
    see(sites[v].next);
    colour[v] = int(std::find(seen.begin(), seen.end(), 0) - seen.begin());
    if (colour[v] == int(colours.size())) colours.emplace_back();
    colours[colour[v]].push_back(v);
  }
}

// Breadth first, so that each vertex finds its face from a neighbour's.
void State::place_on_surface() {
  std::vector<int> queue;
  std::vector<char> seen(number_of_vertices(), 0);
  for (int start = 0; start < number_of_vertices(); ++start) {
    if (seen[start]) continue;
    seen[start] = 1;
    queue.assign(1, start);
    sites[start].face = projector.closest(mesh.points[start]).face;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int v = queue[i];
      const Closest_point c = projector.closest(mesh.points[v], sites[v].face);
      sites[v].face = c.face;
      if (sites[v].freedom != Freedom::fixed) mesh.points[v] = c.point;
      m_normals[v] = projector.normal(c.face);
      for (int k = first[v]; k < first[v + 1]; ++k)
        for (int w : mesh.quads[corners[k] / 4]) {
          if (seen[w]) continue;
          seen[w] = 1;
          sites[w].face = c.face;
          queue.push_back(w);
        }
    }
  }
}

double State::size_around(int v) const {
  double sum = 0;
  for (int k = first[v]; k < first[v + 1]; ++k) {
    const Quad& q = mesh.quads[corners[k] / 4];
    const int i = corners[k] % 4;
    sum += (mesh.points[q[(i + 1) % 4]] - mesh.points[v]).norm();
    sum += (mesh.points[q[(i + 3) % 4]] - mesh.points[v]).norm();
  }
  return sum / std::max(1, 2 * (first[v + 1] - first[v]));
}

double State::quality(int q, int v, const Step& step) const {
  const Quad& quad = mesh.quads[q];
  std::array<const Point*, 4> x;
  Point outward = Point::Zero();
  for (int i = 0; i < 4; ++i) {
    x[i] = quad[i] == v ? &step.point : &mesh.points[quad[i]];
    outward += quad[i] == v ? step.normal : m_normals[quad[i]];
  }
  const double jacobian = internal::quad_shape(*x[0], *x[1], *x[2], *x[3]);
  const Point n = (*x[2] - *x[0]).cross(*x[3] - *x[1]);
  const double scale = std::sqrt(n.squaredNorm() * outward.squaredNorm());
  return scale > 0 ? std::min(jacobian, 0.3 + n.dot(outward) / scale) : jacobian;
}

double State::worst_around(int v, const Step& step) const {
  double worst = 1;
  for (int k = first[v]; k < first[v + 1]; ++k) worst = std::min(worst, quality(corners[k] / 4, v, step));
  return worst;
}

Step State::constrain(int v, const Point& target) const {
  const Site& site = sites[v];
  if (site.freedom == Freedom::fixed) return here(v);
  Step step;
  step.face = site.face;
  if (site.freedom == Freedom::curve) {
    const Surface_curve& curve = curves[site.curve];
    double low = site.previous >= 0 ? sites[site.previous].parameter : 0;
    double high = site.next >= 0 ? sites[site.next].parameter : curve.length();
    if (curve.closed && low >= site.parameter) low -= curve.length();
    if (curve.closed && high <= site.parameter) high += curve.length();
    // Keep a tenth of the way to each neighbour, so that vertices on a curve never meet.
    low += 0.1 * (site.parameter - low);
    high -= 0.1 * (high - site.parameter);
    return on_curve(v, curve.nearest(target, low, high));
  }
  const Closest_point c = projector.closest_nearby(target, site.face);
  step.point = c.point;
  step.face = c.face;
  step.normal = projector.normal(step.face);
  if (step.normal.isZero()) step.normal = m_normals[v];
  return step;
}

Step State::on_curve(int v, double t) const {
  const Surface_curve& curve = curves[sites[v].curve];
  Step step;
  step.parameter = t;
  step.point = curve.at(t);
  step.face = projector.closest_nearby(step.point, sites[v].face).face;
  step.normal = curve.normals.empty() ? projector.normal(step.face) : curve.normal(t);
  if (step.normal.isZero()) step.normal = m_normals[v];
  return step;
}

void State::move(int v, const Step& step) {
  mesh.points[v] = step.point;
  m_normals[v] = step.normal;
  sites[v].face = step.face;
  sites[v].parameter = step.parameter;
}

void bind_to_curves(State& state, const Vertex_constraints& constraints) {
  const int first = int(state.curves.size());
  state.curves.insert(state.curves.end(), constraints.curves.begin(), constraints.curves.end());
  std::vector<Vertex_constraints::Place> places;
  for (const Vertex_constraints::Place& place : constraints.places)
    if (state.sites[place.vertex].curve < 0) places.push_back(place);
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return std::tie(a.curve, a.t, a.vertex) < std::tie(b.curve, b.t, b.vertex);
  });
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && places[end].curve == places[begin].curve) ++end;
    const Surface_curve& curve = state.curves[std::size_t(first + places[begin].curve)];
    for (std::size_t i = begin; i < end; ++i) {
      const int v = places[i].vertex;
      Site& site = state.sites[v];
      site.curve = first + places[i].curve;
      const bool around = curve.closed && end > begin + 1;
      site.previous = i > begin ? places[i - 1].vertex : around ? places[end - 1].vertex : -1;
      site.next = i + 1 < end ? places[i + 1].vertex : around ? places[begin].vertex : -1;
      site.parameter = places[i].t;
      if (site.freedom == Freedom::fixed) continue;
      site.freedom = Freedom::curve;
      state.move(v, state.on_curve(v, site.parameter));
    }
  }
}

namespace {

// Makes a curve of each boundary loop of the input. Returns the parameters of the corners on each.
std::vector<std::vector<double>> add_boundary_curves(State& state) {
  const Triangle_surface& input = state.input;
  const std::vector<int> corners = feature_edges(input, 0).corners;
  std::vector<std::vector<double>> corner_parameters;
  for (const std::vector<int>& loop : boundary_loops(input)) {
    std::vector<Point> points;
    corner_parameters.emplace_back();
    double arc = 0;
    for (int h : loop) {
      points.push_back(input.points[input.source(h)]);
      if (std::binary_search(corners.begin(), corners.end(), input.source(h)))
        corner_parameters.back().push_back(arc);
      arc += (input.points[input.target(h)] - points.back()).norm();
    }
    points.push_back(points.front());
    state.curves.push_back(make_surface_curve(points, true));
  }
  return corner_parameters;
}

// The curve that a loop of the quads lies nearest to, or -1.
int nearest_curve(const State& state, const std::vector<int>& loop) {
  int best = -1;
  double best_sum = std::numeric_limits<double>::infinity();
  for (int c = 0; c < int(state.curves.size()); ++c) {
    const Surface_curve& curve = state.curves[c];
    double sum = 0;
    for (int v : loop)
      sum += (curve.at(curve.nearest(state.mesh.points[v], 0, curve.length())) - state.mesh.points[v])
                 .squaredNorm();
    if (sum < best_sum) {
      best_sum = sum;
      best = c;
    }
  }
  return best;
}

// Moves the nearest place of a loop to each corner of its curve. Tells which places hold a corner.
std::vector<char> hold_corners(const Surface_curve& curve, const std::vector<double>& corners,
                               std::vector<double>& s) {
  const int n = int(s.size());
  std::vector<char> held(n, 0);
  for (double c : corners) {
    const auto gap = [&](int i) { return std::abs(std::remainder(s[i] - c, curve.length())); };
    int nearest = 0;
    for (int i = 1; i < n; ++i)
      if (gap(i) < gap(nearest)) nearest = i;
    if (held[nearest]) continue;
    held[nearest] = 1;
    s[nearest] -= std::remainder(s[nearest] - c, curve.length());
  }
  return held;
}

void bind_loop(State& state, const std::vector<int>& loop, int on, const std::vector<double>& corners) {
  const int n = int(loop.size());
  const Surface_curve& curve = state.curves[on];
  std::vector<double> s = parameters_on(curve, loop, state.mesh.points);
  const std::vector<char> held = hold_corners(curve, corners, s);
  for (int i = 0; i < n; ++i) {
    Site& site = state.sites[loop[i]];
    site.curve = on;
    site.parameter = s[i];
    site.previous = loop[(i + n - 1) % n];
    site.next = loop[(i + 1) % n];
    if (site.freedom == Freedom::fixed) continue;
    site.freedom = Freedom::curve;
    const Closest_point c = state.projector.closest(curve.at(s[i]), site.face);
    state.move(loop[i], {curve.at(s[i]), state.projector.normal(c.face), c.face, s[i]});
    if (held[i]) site.freedom = Freedom::fixed;
  }
}

} // namespace

int bind_boundary(State& state) {
  const std::vector<std::vector<int>> loops = loops_of(state.mesh);
  if (loops.empty()) return 0;
  const std::vector<std::vector<double>> corners = add_boundary_curves(state);
  int bound = 0;
  for (const std::vector<int>& loop : loops) {
    bound += int(loop.size());
    const int curve = nearest_curve(state, loop);
    if (curve >= 0 && loop.size() >= 3)
      bind_loop(state, loop, curve, corners[curve]);
    else
      for (int v : loop) state.sites[v].freedom = Freedom::fixed; // the input is closed: nothing to slide on
  }
  return bound;
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
