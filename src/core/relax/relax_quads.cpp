// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include "base/parallel_for.h"
#include "relax/mesh_quality.h"
#include "relax/relax_state.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

namespace {

// Half axes of the rectangle nearest in shape to a parallelogram with half axes u, v: both keep their length
// and turn by the same angle until they are orthogonal. A parallelogram that faces away from `outward`
// becomes a square.
void make_rectangle(Point& u, Point& v, const Point& outward) {
  const double lu = u.norm(), lv = v.norm();
  const Point a = u / lu, b = v / lv;
  const Point plus = a + b, minus = a - b;
  const double lp = plus.norm(), lm = minus.norm();
  if (lu > 0 && lv > 0 && lp > 1e-6 && lm > 1e-6 && u.cross(v).dot(outward) > 0) {
    u = lu * std::sqrt(0.5) * (plus / lp + minus / lm);
    v = lv * std::sqrt(0.5) * (plus / lp - minus / lm);
  } else {
    u = 0.5 * (u + v.cross(outward));
    v = outward.cross(u);
  }
}

// Where vertex v would be if its quads were rectangles.
Point wanted_position(const State& state, const Regime& regime, int v) {
  Point sum = Point::Zero(), around = Point::Zero();
  double weights = 0;
  for (int k = state.first[v]; k < state.first[v + 1]; ++k) {
    const int i = state.corners[k] % 4;
    const Quad& q = state.mesh.quads[state.corners[k] / 4];
    const std::vector<Point>& p = state.mesh.points;
    const Point &x0 = p[q[0]], &x1 = p[q[1]], &x2 = p[q[2]], &x3 = p[q[3]];
    const Point centre = 0.25 * (x0 + x1 + x2 + x3);
    Point a = 0.25 * (x1 - x0 + x2 - x3), b = 0.25 * (x3 - x0 + x2 - x1);
    make_rectangle(a, b, state.normal(v));
    const double la = a.norm(), lb = b.norm();
    if (!(la > 0 && lb > 0)) continue;
    if (regime.memory > 0) {
      const std::array<double, 2>& original = state.original_lengths[state.corners[k] / 4];
      a *= 1 + regime.memory * (original[0] / la - 1);
      b *= 1 + regime.memory * (original[1] / lb - 1);
    }
    const double weight = std::pow(la + lb, -regime.favour_small);
    sum += weight * (centre + (i == 1 || i == 2 ? a : Point(-a)) + (i >= 2 ? b : Point(-b)));
    around += weight * 0.5 * (p[q[(i + 1) % 4]] + p[q[(i + 3) % 4]]);
    weights += weight;
  }
  if (!(weights > 0)) return state.mesh.points[v];
  return ((1 - regime.evenness) * sum + regime.evenness * around) / weights;
}

// How much of its step a vertex takes: on tips and ridges little, so that quads do not slide off the limbs of
// a body and cut their ends away. `bend` is the height of v above its neighbours' average, in units of their
// distance.
double mobility(const State& state, int v, double& size) {
  Point sum = Point::Zero();
  double length = 0;
  for (int k = state.first[v]; k < state.first[v + 1]; ++k) {
    const Quad& q = state.mesh.quads[state.corners[k] / 4];
    const Point d = state.mesh.points[q[(state.corners[k] % 4 + 1) % 4]] - state.mesh.points[v];
    sum += d;
    length += d.norm();
  }
  size = length / std::max(1, state.first[v + 1] - state.first[v]);
  const double bend = length > 0 ? std::abs(sum.dot(state.normal(v))) / length : 0;
  return std::clamp(1.15 - 2.5 * bend, 0.0, 0.9);
}

bool try_step(State& state, int v, const Point& target, const Sweep& sweep) {
  const Step step = state.constrain(v, target);
  if (const double after = state.worst_around(v, step); after < sweep.good_enough) {
    const double before = state.worst_around(v);
    // Where quads are inverted, steps towards rectangles may untangle best when nothing holds them back.
    const bool free = sweep.lenient && before <= 0;
    if (!free && after < before) return false;
  }
  state.move(v, step);
  return true;
}

} // namespace

namespace {

constexpr int vertices_at_once = 200; // below this a thread costs more than it saves

} // namespace

int smooth(State& state, const Regime& regime, const Sweep& sweep) {
  std::vector<char> accepted(state.number_of_vertices(), 0);
  for (const std::vector<int>& colour : state.colours)
    internal::parallel_for(int(colour.size()), state.threads, vertices_at_once, [&](int i) {
      const int v = colour[i];
      if (state.sites[v].freedom == Freedom::fixed || (sweep.mask && !(*sweep.mask)[v])) return;
      double size;
      double part = mobility(state, v, size);
      if (state.on_ridge(v)) part = 0.9; // which it cannot leave
      const Point from = state.mesh.points[v],
                  way = sweep.stride * part * (wanted_position(state, regime, v) - from);
      if (way.squaredNorm() < 1e-5 * size * size) return; // has come to rest
      accepted[v] = try_step(state, v, from + way, sweep) || try_step(state, v, from + 0.4 * way, sweep);
    });
  return int(std::count(accepted.begin(), accepted.end(), 1));
}

} // namespace relaxation

namespace {

using relaxation::mesh_quality;
using relaxation::Mesh_quality;
using relaxation::State;

// Scaled Jacobians. Most layouts reach the first in the usual sweeps. Below the second the layout itself is
// too coarse or too twisted: there more sweeps were seen to help little and to end in bad quads.
constexpr double good_mean = 0.92;
constexpr double hopeful_mean = 0.87;
constexpr int between_measures = 10;

Result<void> check_constraints(const Quad_mesh& mesh, const Vertex_constraints& constraints) {
  const std::vector<char>& fixed = constraints.fixed;
  if (!fixed.empty() && fixed.size() != mesh.points.size())
    return make_error(Error_code::impossible_request, "the list of fixed vertices has " +
                                                          std::to_string(fixed.size()) + " entries for " +
                                                          std::to_string(mesh.points.size()) + " vertices");
  std::vector<char> placed(mesh.points.size(), 0);
  for (const auto& [v, curve, t] : constraints.places) {
    if (v < 0 || v >= int(placed.size()) || curve < 0 || curve >= int(constraints.curves.size()))
      return make_error(Error_code::impossible_request,
                        "a vertex or a curve that does not exist is named by a place on a curve",
                        Element_kind::vertex, v);
    if (placed[v]++)
      return make_error(Error_code::impossible_request, "a vertex is to slide on two curves",
                        Element_kind::vertex, v);
  }
  return {};
}

Result<void> check(const Quad_mesh& mesh, const Vertex_constraints& constraints,
                   const Relax_options& options) {
  for (int q = 0; q < int(mesh.quads.size()); ++q) {
    const Quad& quad = mesh.quads[q];
    for (int i = 0; i < 4; ++i) {
      if (quad[i] < 0 || quad[i] >= int(mesh.points.size()))
        return make_error(Error_code::not_a_surface, "a quad names a vertex that does not exist",
                          Element_kind::face, q);
      for (int j = 0; j < i; ++j)
        if (quad[i] == quad[j])
          return make_error(Error_code::not_a_surface, "a quad names a vertex twice", Element_kind::face, q);
    }
  }
  if (options.iterations < 0 || options.more_iterations < 0)
    return make_error(Error_code::impossible_request, "the number of iterations is negative");
  if (options.attempts < 0)
    return make_error(Error_code::impossible_request, "the number of attempts is negative");
  if (!(options.wanted >= 0 && options.wanted <= 1))
    return make_error(Error_code::impossible_request, "the wanted scaled Jacobian is not between 0 and 1");
  if (options.threads < 1)
    return make_error(Error_code::impossible_request, "the number of threads is not positive");
  return check_constraints(mesh, constraints);
}

// What bends a whole chart goes in sweeps that step too far, which is successive over-relaxation: sixty of
// them come as far as two hundred others. A few sweeps are for what is near by, and do not; nor do the last
// ones, so that vertices come to rest.
constexpr double long_stride = 1.6;
constexpr int few_sweeps = 20, resting_sweeps = 5;

// The i-th of so many sweeps. Steps may make a quad worse down to a quality that is good enough, and in the
// first half of the sweeps to a lower one; but never worse than the worst quad of all was.
relaxation::Sweep sweep(int i, int sweeps, double worst) {
  const bool early = i < sweeps / 2;
  const bool strides = sweeps > few_sweeps && i < sweeps - resting_sweeps;
  return {std::max(early ? 0.2 : 0.5, worst), early, nullptr, strides ? long_stride : 1};
}

// Inverted quads count most. Where there are none, neither the worst quad nor the mean may get worse.
bool is_worse(const Mesh_quality& after, const Mesh_quality& before) {
  if (after.inverted != before.inverted) return after.inverted > before.inverted;
  return after.mean < before.mean || (before.inverted == 0 && after.worst < before.worst);
}

// More sweeps where the quads are nearly, but not yet, good on average. False if cancelled.
bool relax_further(State& state, int most, double worst, Observer* observer) {
  if (mesh_quality(state.mesh).mean < hopeful_mean) return true;
  for (int i = 0; i < most; ++i) {
    if (observer && observer->cancelled()) return false;
    if (observer) observer->progress("relax further", double(i) / most);
    if (i % between_measures == 0 && mesh_quality(state.mesh).mean >= good_mean) break;
    relaxation::Sweep careful = sweep(i, most, worst);
    careful.stride = 1;
    if (relaxation::smooth(state, {}, careful) == 0) break;
  }
  return true;
}

// Vertices that are not fixed and have left the surface.
void measure_offsets(const State& state, Relax_report& report) {
  double extent = 0;
  for (const Point& p : state.mesh.points) extent = std::max(extent, p.cwiseAbs().maxCoeff());
  for (int v = 0; v < state.number_of_vertices(); ++v) {
    if (state.sites[v].freedom == relaxation::Freedom::fixed || state.sites[v].face < 0) continue;
    const Point& p = state.mesh.points[v];
    const double offset = std::sqrt(state.projector.closest_nearby(p, state.sites[v].face).squared_distance);
    if (offset <= 1e-9 * extent) continue; // rounding
    report.off_surface.push_back(v);
    report.largest_offset = std::max(report.largest_offset, offset);
  }
}

} // namespace

Result<Relax_report> relax_quads(Quad_mesh& mesh, const Surface_projector& projector,
                                 const Vertex_constraints& constraints, const Relax_options& options,
                                 Observer* observer) {
  if (Result<void> checked = check(mesh, constraints, options); !checked) return checked.error();
  const std::vector<Point> original = mesh.points;
  const Mesh_quality before = mesh_quality(mesh);
  Relax_report report;
  const auto cancelled = [&] {
    if (!observer || !observer->cancelled()) return false;
    mesh.points = original;
    return true;
  };

  State state(mesh, projector, constraints, options.threads);
  report.boundary_vertices = relaxation::bind_boundary(state);
  relaxation::bind_to_curves(state, constraints);
  state.colour_vertices();
  const State::Snapshot placed = state.snapshot();
  const Mesh_quality on_surface = mesh_quality(mesh);
  for (int i = 0; i < options.iterations; ++i) {
    if (cancelled()) return make_error(Error_code::cancelled, "stopped while relaxing");
    if (observer) observer->progress("relax", double(i) / options.iterations);
    // The first sweeps may pass through worse quads than the last ones.
    if (relaxation::smooth(state, {}, sweep(i, options.iterations, on_surface.worst)) == 0) break;
  }
  if (options.iterations > 0 && !relax_further(state, options.more_iterations, on_surface.worst, observer)) {
    mesh.points = original;
    return make_error(Error_code::cancelled, "stopped while relaxing");
  }
  if (options.untangle) {
    relaxation::untangle(state, 0.2, 20, nullptr, observer);
    std::vector<int> defects = relaxation::repair(state, placed, options.attempts, observer);
    if (options.wanted > 0) defects = relaxation::polish(state, options.wanted, defects, observer);
    if (std::any_of(defects.begin(), defects.end(), [](int n) { return n > 0; }))
      report.intersections_after = int(relaxation::intersecting_quads(mesh).size());
  }
  if (cancelled()) return make_error(Error_code::cancelled, "stopped while relaxing");

  Mesh_quality after = mesh_quality(mesh);
  if (is_worse(after, on_surface)) {
    for (int v = 0; v < state.number_of_vertices(); ++v) state.restore(placed, v);
    after = on_surface;
    if (before.inverted < on_surface.inverted) {
      mesh.points = original;
      after = before;
    }
    report.intersections_after = int(relaxation::intersecting_quads(mesh).size());
  }
  report.worst_before = before.worst;
  report.mean_before = before.mean;
  report.inverted_before = before.inverted;
  report.worst_after = after.worst;
  report.mean_after = after.mean;
  report.inverted_after = after.inverted;
  measure_offsets(state, report);
  for (std::size_t v = 0; v < original.size(); ++v) report.moved_vertices += original[v] != mesh.points[v];
  return report;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
