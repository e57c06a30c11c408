// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/finish_guides.h"

#include "base/segment_tree.h"
#include "features/feature_lines.h"
#include "relax/mesh_quality.h"
#include "relax/relax_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// How far lines may be moved, in edges. The farther, the longer is the part of a stroke that one line
// follows, and the more quads give way.
constexpr std::array<double, 4> guide_reaches = {1, 2.5, 6, 12};

// Degrees and a part of its length: a stroke that is followed so well needs no farther reach.
constexpr double good_angle = 2, good_part = 0.95;

// So often lines are laid anew over quads that were brought nearer; by so many degrees this has to pay.
constexpr int guide_rounds = 2;
constexpr double guide_gain = 0.2;

// A line begins with an edge that makes less than about 46 degrees with the stroke, and comes onto it by
// steps of less than an edge.
constexpr double least_guide_cosine = 0.69, guide_step = 0.8;

// An end of a stroke that is nearer to the last vertex of a line, in edges, gets that vertex.
constexpr double guide_end_reach = 1.1;

// The quads around a line may become as bad as this before they are relaxed.
constexpr double worst_at_guides = 0.05;

// Vertices are free that are so many edges away from a line, for each edge that it may be moved, and more.
constexpr double guide_rings_per_reach = 4;
constexpr int guide_rings = 6;

// Bent quads need more sweeps than those that come from a layout.
constexpr int guide_sweeps = 40;

// What a guide spoils is mended within a few attempts or, as a rule, not at all.
constexpr int guide_attempts = 4;

// The mean scaled Jacobian of the quads away from a guide does not fall below this part of what it was.
constexpr double jacobian_kept = 0.98;

// What of a guide's outcome counts most: an edge's length of distance is as bad as so many degrees.
constexpr double degrees_per_edge = 20;

double jacobian_of(const Quad_mesh& mesh, const Quad& q) {
  return scaled_jacobian(mesh.points[std::size_t(q[0])], mesh.points[std::size_t(q[1])],
                         mesh.points[std::size_t(q[2])], mesh.points[std::size_t(q[3])]);
}

// Quads whose shortest edge is less than that part of their longest: their angles may be good all the same.
// Few may be, for each vertex that lies on the guide.
constexpr double squeezed = 1.0 / 30, squeezed_part = 0.1;

int squeezed_quads(const Quad_mesh& mesh) {
  return int(std::count_if(mesh.quads.begin(), mesh.quads.end(), [&](const Quad& q) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double d =
          (mesh.points[std::size_t(q[i])] - mesh.points[std::size_t(q[(i + 1) % 4])]).squaredNorm();
      least = std::min(least, d);
      most = std::max(most, d);
    }
    return least < squeezed * squeezed * most;
  }));
}

// Quads brought onto one guide.
struct On_guide {
  Quad_mesh mesh;
  Relax_report relaxation;
  std::vector<Vertex_constraints::Place> places; ///< on the guide's curve, which is the last one
  Followed_guide followed;
  std::array<double, 2> jacobians{{0, 0}};

  bool is_good() const { return followed.angle < good_angle && followed.on > good_part; }
  double cost() const { return followed.angle + degrees_per_edge * std::min(1.0, followed.distance); }
};

class Guide_finisher {
public:
  Guide_finisher(Finished_quads& quads, const Surface_projector& projector,
                 const Vertex_constraints& constraints, const Relax_options& relaxation, Observer* observer)
      : m_quads(quads), m_projector(projector), m_constraints(constraints), m_relaxation(relaxation),
        m_observer(observer) {
    m_constraints.fixed.resize(quads.mesh.points.size(), 0);
    for (int v : quads.relaxation.off_surface) m_constraints.fixed[std::size_t(v)] = 1;
    m_relaxation.iterations = guide_sweeps;
    m_relaxation.more_iterations = 0;
    m_relaxation.attempts = std::min(m_relaxation.attempts, guide_attempts);
  }

  Result<void> run(const std::vector<Guide_line>& guides) {
    m_quads.guides.assign(guides.size(), {});
    std::vector<std::size_t> order(guides.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return guides[a].guide.strength > guides[b].guide.strength;
    });
    for (const std::size_t i : order) {
      if (m_observer) m_observer->progress("guides", 0);
      if (m_observer && m_observer->cancelled())
        return make_error(Error_code::cancelled, "stopped while quads were brought onto guides");
      if (Result<void> done = follow(guides[i], m_quads.guides[i]); !done) return done;
    }
    return {};
  }

private:
  Result<void> follow(const Guide_line& line, Guide_outcome& outcome) {
    const Result<Stroke> stroke = trace_stroke(m_projector, line.guide);
    if (!stroke) {
      outcome.reason = stroke.error().message;
      return {};
    }
    outcome.before = outcome.after = followed_guide(m_quads.mesh, stroke->curve);
    std::optional<On_guide> best;
    for (int round = 0; round < guide_rounds && !(best && best->is_good()); ++round) {
      const Quad_mesh& from = best ? best->mesh : m_quads.mesh;
      Result<std::optional<On_guide>> found = best_of_reaches(line, stroke->curve, from, outcome.reason);
      if (!found) return found.error();
      if (!*found || (best && (*found)->cost() > best->cost() - guide_gain)) break;
      best = std::move(**found);
    }
    if (best && line.guide.strength < 1) {
      weaken(line.guide.strength, *best);
      measure(*best, stroke->curve);
      if (!is_kept(*best, outcome.reason)) best.reset();
    }
    if (!best || (best->followed.angle >= outcome.before.angle && best->followed.on <= outcome.before.on)) {
      if (outcome.reason.empty()) outcome.reason = "no line of quads' edges comes nearer to it";
      return {};
    }
    outcome.reason.clear();
    outcome.kept = true;
    outcome.after = best->followed;
    outcome.vertices = int(best->places.size());
    outcome.jacobian_before = best->jacobians[0];
    outcome.jacobian_after = best->jacobians[1];
    take(std::move(*best), line.guide.strength == 1 ? &stroke->curve : nullptr);
    return {};
  }

  // The best of what all reaches give, with lines of the quads `from`; nothing if none may be.
  Result<std::optional<On_guide>> best_of_reaches(const Guide_line& line, const Surface_curve& curve,
                                                  const Quad_mesh& from, std::string& reason) const {
    std::optional<On_guide> best;
    for (const double reach : guide_reaches) {
      Result<std::optional<On_guide>> found = brought(line, curve, reach, from, reason);
      if (!found) return found.error();
      if (*found && (!best || (*found)->cost() < best->cost())) best = std::move(**found);
      if (best && best->is_good()) break;
    }
    return best;
  }

  // What one reach gives; nothing, and a reason, if that may not be.
  Result<std::optional<On_guide>> brought(const Guide_line& line, const Surface_curve& curve, double reach,
                                          const Quad_mesh& from, std::string& reason) const {
    On_guide on;
    on.mesh = from;
    on.places = laid(line, curve, reach, on.mesh);
    if (on.places.empty()) return std::optional<On_guide>();
    Vertex_constraints constraints = m_constraints;
    hold_far(on.places, int(std::ceil(guide_rings_per_reach * reach)) + guide_rings, constraints.fixed);
    for (Vertex_constraints::Place& place : on.places) place.curve = int(constraints.curves.size());
    constraints.curves.push_back(curve);
    constraints.places.insert(constraints.places.end(), on.places.begin(), on.places.end());
    Result<Relax_report> relaxed = relax_quads(on.mesh, m_projector, constraints, m_relaxation, m_observer);
    if (!relaxed) return relaxed.error();
    on.relaxation = std::move(*relaxed);
    measure(on, curve);
    return is_kept(on, reason) ? std::optional<On_guide>(std::move(on)) : std::optional<On_guide>();
  }

  void measure(On_guide& on, const Surface_curve& curve) const {
    on.followed = followed_guide(on.mesh, curve);
    on.jacobians = jacobians_away(on);
  }

  // Whether quads are as good as they have to be; a reason if not.
  bool is_kept(const On_guide& on, std::string& reason) const {
    if (on.relaxation.inverted_after > m_quads.relaxation.inverted_after)
      reason = "quads would be inverted";
    else if (on.relaxation.intersections_after > m_quads.relaxation.intersections_after)
      reason = "quads would intersect";
    else if (on.jacobians[1] < jacobian_kept * on.jacobians[0])
      reason = "quads away from it would lose their shape";
    else if (squeezed_quads(on.mesh) >
             squeezed_quads(m_quads.mesh) + int(squeezed_part * double(on.places.size())))
      reason = "quads would be squeezed";
    else
      return true;
    return false;
  }

  // Lays lines, and returns the places of their vertices.
  std::vector<Vertex_constraints::Place> laid(const Guide_line& line, const Surface_curve& curve,
                                              double reach, Quad_mesh& mesh) const {
    Snap_options options;
    options.line_reach = reach;
    Line_choice choice;
    choice.least_cosine = least_guide_cosine;
    choice.way = line.guide.way;
    choice.flow = line.flow;
    choice.unbent = &m_quads.mesh.points;
    choice.step = guide_step;
    choice.joins = true;
    choice.end_reach = guide_end_reach;
    std::vector<char> held = m_constraints.fixed;
    for (const Vertex_constraints::Place& place : m_constraints.places) held[std::size_t(place.vertex)] = 1;
    std::vector<Vertex_constraints::Place> places;
    lay_lines_on_features(mesh, m_projector, {curve}, seeds(curve, mesh), options, worst_at_guides, held,
                          places, choice);
    return places;
  }

  std::vector<Feature_seed> seeds(const Surface_curve& curve, const Quad_mesh& mesh) const {
    Segment_tree segments;
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
      segments.add(curve.points[i], curve.points[i + 1]);
    segments.build();
    std::vector<char> used(mesh.points.size(), 0);
    for (const Quad& q : mesh.quads)
      for (int v : q) used[std::size_t(v)] = 1;
    std::vector<Feature_seed> result;
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (!used[v]) continue;
      const Segment_tree::Nearest near = segments.nearest(mesh.points[v]);
      result.push_back(
          {int(v), 0, curve.arc[near.segment] + (near.point - curve.points[near.segment]).norm()});
    }
    return result;
  }

  // Vertices that are more than so many edges away from all places do not move.
  void hold_far(const std::vector<Vertex_constraints::Place>& places, int rings,
                std::vector<char>& fixed) const {
    const std::vector<Quad>& quads = m_quads.mesh.quads;
    std::vector<int> ring(fixed.size(), -1);
    for (const Vertex_constraints::Place& place : places) ring[std::size_t(place.vertex)] = 0;
    for (int r = 1; r <= rings; ++r)
      for (const Quad& q : quads)
        for (std::size_t i = 0; i < 4; ++i) {
          const std::size_t a = std::size_t(q[i]), b = std::size_t(q[(i + 1) % 4]);
          if (ring[a] == r - 1 && ring[b] < 0) ring[b] = r;
          if (ring[b] == r - 1 && ring[a] < 0) ring[a] = r;
        }
    for (std::size_t v = 0; v < fixed.size(); ++v)
      if (ring[v] < 0) fixed[v] = 1;
  }

  // Takes every vertex back to a part of its way.
  void weaken(double strength, On_guide& on) const {
    for (std::size_t v = 0; v < on.mesh.points.size(); ++v) {
      const Point& from = m_quads.mesh.points[v];
      if (on.mesh.points[v] == from) continue;
      const Point p = from + strength * (on.mesh.points[v] - from);
      on.mesh.points[v] = m_projector.closest_nearby(p, m_projector.closest(p).face).point;
    }
    Relax_report& report = on.relaxation;
    const relaxation::Mesh_quality quality = relaxation::mesh_quality(on.mesh);
    report.worst_after = quality.worst;
    report.mean_after = quality.mean;
    report.inverted_after = quality.inverted;
    report.intersections_after = int(relaxation::intersecting_quads(on.mesh).size());
  }

  // The mean scaled Jacobians, before and after, of the quads without a vertex on the guide.
  std::array<double, 2> jacobians_away(const On_guide& on) const {
    std::vector<char> on_it(on.mesh.points.size(), 0);
    for (const Vertex_constraints::Place& place : on.places) on_it[std::size_t(place.vertex)] = 1;
    std::array<double, 2> sum{{0, 0}};
    int number = 0;
    for (const Quad& q : on.mesh.quads) {
      if (std::any_of(q.begin(), q.end(), [&](int v) { return on_it[std::size_t(v)]; })) continue;
      sum[0] += jacobian_of(m_quads.mesh, q);
      sum[1] += jacobian_of(on.mesh, q);
      ++number;
    }
    if (number == 0) return {{1, 1}};
    return {{sum[0] / number, sum[1] / number}};
  }

  // On a guide that is exact, `curve`, vertices stay.
  void take(On_guide&& on, const Surface_curve* curve) {
    m_quads.mesh = std::move(on.mesh);
    Relax_report& report = m_quads.relaxation;
    report.worst_after = on.relaxation.worst_after;
    report.mean_after = on.relaxation.mean_after;
    report.inverted_after = on.relaxation.inverted_after;
    report.intersections_after = on.relaxation.intersections_after;
    report.moved_vertices = std::max(report.moved_vertices, on.relaxation.moved_vertices);
    report.largest_offset = std::max(report.largest_offset, on.relaxation.largest_offset);
    for (int v : on.relaxation.off_surface) {
      report.off_surface.push_back(v);
      m_constraints.fixed[std::size_t(v)] = 1;
    }
    if (!curve) return;
    for (Vertex_constraints::Place place : on.places) {
      place.curve = int(m_constraints.curves.size());
      place.t = curve->nearest(m_quads.mesh.points[std::size_t(place.vertex)], 0, curve->length());
      m_constraints.places.push_back(place);
    }
    m_constraints.curves.push_back(*curve);
  }

  Finished_quads& m_quads;
  const Surface_projector& m_projector;
  Vertex_constraints m_constraints;
  Relax_options m_relaxation;
  Observer* m_observer;
};

} // namespace

Result<void> finish_on_guides(Finished_quads& quads, const Surface_projector& projector,
                              const std::vector<Guide_line>& guides, const Vertex_constraints& constraints,
                              const Relax_options& relaxation, Observer* observer) {
  return Guide_finisher(quads, projector, constraints, relaxation, observer).run(guides);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
