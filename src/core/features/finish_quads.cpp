// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/blame.h"
#include "features/finish_guides.h"
#include "features/snap_to_chains.h"
#include "relax/reach.h"
#include "relax/relax_state.h"

#include <CGAL/Reeb_quadrangulation/kept_features.h>

#include <algorithm>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A vertex so near to a sharp edge, in lengths of its quads' edges, was put onto it by the design: rounding
// is all that it is away.
constexpr double on_it = 0.01;

// Quads without defects that snapping spoils are mended within a few attempts or, as a rule, not at all.
constexpr int attempts_of_good_quads = 4;

// Before and while quads are laid onto sharp edges they get so many sweeps: more would pull them off edges
// that they nearly meet. All the others come once it is decided what is kept.
constexpr int sweeps_onto_features = 20;

// So often chains are refused; each time quads are snapped and relaxed anew.
constexpr int most_refusals = 6;

// Once quads are relaxed around the vertices on sharp edges, more vertices come near these; after the second
// round hardly any.
constexpr int rounds_onto_crossings = 2;

// A scaled Jacobian below which a quad is poor: it may not become poorer for the sake of a sharp edge.
constexpr double poor_quad = 0.3;

// The least scaled Jacobian that quads on sharp edges should have, and what part of these a lower one costs.
constexpr double good_worst = 0.5, price_of_worst = 0.5;

// What the sweeps in the end may cost of that, for each part that is not kept: where most is lost, the shape
// is smooth, and its edges that happen to be sharp come and go.
constexpr double loss_of_settling = 0.06;

// Bold lines are laid over quads as bad as this: most of them get good again around the line.
constexpr double bold_worst = 0.1;

// How much of the mean scaled Jacobian sharp edges are worth.
constexpr double worth_of_edges = 0.03;

// A mean scaled Jacobian from which on quads are good as a whole, which they have to stay.
constexpr double good_mean = 0.9;

class Finisher {
public:
  Finisher(const Surface_projector& projector, const Relax_options& relaxation, const Snap_options& snapping,
           Observer* observer, const std::vector<int>& held)
      : m_projector(projector), m_relaxation(relaxation), m_snapping(snapping), m_observer(observer),
        m_held(held) {
    if (snapping.feature_angle > 0)
      m_features.edges = feature_edges(projector.surface(), snapping.feature_angle);
  }

  // With the user's features: they are worth more than good quads.
  Finisher(const Surface_projector& projector, const Relax_options& relaxation, const Snap_options& snapping,
           const Given_features& features, Observer* observer, const std::vector<int>& held)
      : m_projector(projector), m_relaxation(relaxation), m_snapping(snapping), m_features(features),
        m_is_given(true), m_observer(observer), m_held(held) {}

  // At last vertices go to where the surface is far from all quads, and onto guides.
  Result<Finished_quads> run(Quad_mesh mesh, const std::vector<Guide_line>& guides = {}) const {
    Result<Finished_quads> quads = reached(std::move(mesh));
    if (!quads || guides.empty()) return quads;
    const Vertex_constraints rest = designed(quads->mesh);
    if (Result<void> done =
            internal::finish_on_guides(*quads, m_projector, guides, rest, m_relaxation, m_observer);
        !done)
      return done.error();
    return quads;
  }

private:
  Result<Finished_quads> reached(Quad_mesh mesh) const {
    Result<Finished_quads> quads = relaxed(std::move(mesh));
    if (!quads || !m_relaxation.untangle || m_relaxation.iterations == 0) return quads;
    if (m_observer) m_observer->progress("reach", 0);
    relaxation::reach(quads->mesh, m_projector, designed(quads->mesh), m_relaxation, quads->relaxation,
                      m_observer);
    if (m_observer && m_observer->cancelled())
      return make_error(Error_code::cancelled, "stopped while relaxing");
    return quads;
  }

  // Quads are first relaxed without regard to sharp edges. Of the ways onto these that
  // make them no worse, the one that is worth most is taken.
  Result<Finished_quads> relaxed(Quad_mesh mesh) const {
    Finished_quads plain;
    plain.mesh = std::move(mesh);
    Finished_quads freer = plain; // what lies on sharp edges may go too, where quads are bad otherwise
    const bool has_features = !m_features.edges.chains.empty() || !m_features.points.empty();
    Relax_options first = m_relaxation;
    if (has_features) first.iterations = std::min(first.iterations, sweeps_onto_features);
    if (Result<void> relaxed = relax(plain, designed(plain.mesh), first); !relaxed) return relaxed.error();
    if (plain.relaxation.inverted_after + plain.relaxation.intersections_after > 0) {
      if (Result<void> relaxed = relax(freer, held(freer.mesh), first); !relaxed) return relaxed.error();
      if (is_worse(plain.relaxation, freer.relaxation)) plain = std::move(freer);
    }
    if (!has_features) return plain;
    std::optional<Candidate> best;
    const std::vector<Way> all = ways();
    for (std::size_t i = 0; i < all.size(); ++i) {
      Result<std::optional<Candidate>> found = onto_features(plain, all[i]);
      if (!found) return found.error();
      if (*found && (!best || (*found)->worth() > best->worth())) best = std::move(**found);
      if (best && best->refused == 0 && !all[i].lines.first) break; // what follows keeps less
    }
    if (best) return settled(std::move(best->quads), std::move(best->onto), best->kept);
    Vertex_constraints onto = designed(plain.mesh);
    const double part = kept(plain.mesh);
    return settled(std::move(plain), std::move(onto), part);
  }

  // The other sweeps, with what lies on features sliding along them. They may hardly cost any of these.
  Result<Finished_quads> settled(Finished_quads quads, Vertex_constraints onto, double before) const {
    if (m_relaxation.iterations <= sweeps_onto_features) return quads;
    Finished_quads after = quads;
    onto.fixed.resize(quads.mesh.points.size(), 0);
    for (int v : quads.relaxation.off_surface) onto.fixed[std::size_t(v)] = 1;
    if (Result<void> relaxed = relax(after, onto, gentle(quads.relaxation)); !relaxed) return relaxed.error();
    turn_to_features(after.mesh, onto);
    const double loss = worth(before, quads.relaxation) - worth(kept(after.mesh), after.relaxation);
    if (is_worse(after.relaxation, quads.relaxation) ||
        loss > (m_is_given ? 0 : loss_of_settling * (1 - before)))
      return quads;
    keep_history(quads.relaxation, after.relaxation);
    return after;
  }

  // Quads that are spoilt by what is done to them, and not soon mended, are better left as they were.
  Relax_options gentle(const Relax_report& before) const {
    Relax_options result = m_relaxation;
    if (before.inverted_after + before.intersections_after == 0)
      result.attempts = std::min(result.attempts, attempts_of_good_quads);
    // Quads that are raised turn away from what they were laid onto, which the user has asked for.
    if (m_is_given) result.wanted = 0;
    return result;
  }

  // What one relaxation has found and done, the report of a later one tells too.
  static void keep_history(const Relax_report& before, Relax_report& after) {
    after.worst_before = before.worst_before;
    after.mean_before = before.mean_before;
    after.inverted_before = before.inverted_before;
    after.off_surface.insert(after.off_surface.begin(), before.off_surface.begin(), before.off_surface.end());
    after.largest_offset = std::max(after.largest_offset, before.largest_offset);
  }

  // Quads on features, and how much of these they keep.
  struct Candidate {
    Finished_quads quads;
    Vertex_constraints onto;
    double kept = 0;
    int refused = 0; // chains

    double worth() const { return Finisher::worth(kept, quads.relaxation); }
  };

  // What is kept, less what the worst quad is below a good one.
  static double worth(double kept, const Relax_report& relaxation) {
    return kept - price_of_worst * std::max(0.0, good_worst - relaxation.worst_after);
  }

  // A way onto the features.
  struct Way {
    Snap_options snapping;
    internal::Line_way lines = {};
  };

  // Quads after one way onto the features, with what put them there.
  struct Snapped {
    Finished_quads quads;
    Vertex_constraints onto;
    std::vector<int> chain_of_curve;
  };

  // Chains that make quads worse are refused, until the others do no harm; nothing if they always do.
  Result<std::optional<Candidate>> onto_features(const Finished_quads& plain, const Way& way) const {
    internal::Chosen_features chosen(m_features);
    int refused = 0;
    for (int round = 0; round < most_refusals; ++round) {
      Result<Snapped> snapped = snap(plain, way, chosen);
      if (!snapped) return snapped.error();
      if (!is_worse(snapped->quads.relaxation, plain.relaxation)) {
        const double part = kept(snapped->quads.mesh);
        return std::optional<Candidate>(
            Candidate{std::move(snapped->quads), std::move(snapped->onto), part, refused});
      }
      const std::vector<int> guilty = blamed(plain, *snapped);
      if (guilty.empty()) break;
      for (int chain : guilty) chosen.is_refused[std::size_t(chain)] = 1;
      refused += int(guilty.size());
    }
    return std::optional<Candidate>();
  }

  double kept(const Quad_mesh& mesh) const {
    return kept_part(kept_chains(mesh, m_projector.surface(), m_features.edges));
  }

  // The chains that made quads worse than they may be.
  std::vector<int> blamed(const Finished_quads& plain, const Snapped& snapped) const {
    const Quad_mesh& mesh = snapped.quads.mesh;
    const Relax_report &before = plain.relaxation, &after = snapped.quads.relaxation;
    const std::vector<int> chain = internal::chains_around(mesh, snapped.onto, snapped.chain_of_curve);
    const auto shape = [](const Quad_mesh& m, std::size_t q) {
      const Quad& v = m.quads[q];
      return scaled_jacobian(m.points[v[0]], m.points[v[1]], m.points[v[2]], m.points[v[3]]);
    };
    std::vector<int> bad;
    const bool has_defects = after.inverted_after > before.inverted_after ||
                             after.intersections_after > before.intersections_after;
    const double least = has_defects ? 0.01 : std::min(poor_quad, before.worst_after);
    for (std::size_t q = 0; q < mesh.quads.size(); ++q)
      if (const double s = shape(mesh, q); s < least && s < shape(plain.mesh, q)) bad.push_back(int(q));
    if (after.intersections_after > before.intersections_after)
      for (const auto& [a, b] : relaxation::intersecting_quads(mesh)) bad.insert(bad.end(), {a, b});
    std::vector<int> guilty = internal::chains_at(mesh, bad, chain);
    if (!guilty.empty()) return guilty;
    const double wanted =
        std::max(before.mean_after - worth_of_edges, before.mean_after >= good_mean ? good_mean : 0.0);
    return internal::costliest_chains(plain.mesh, mesh, chain,
                                      (wanted - after.mean_after) * double(mesh.quads.size()));
  }

  // From the boldest to what hardly touches the quads.
  std::vector<Way> ways() const {
    Snap_options all = m_snapping;
    if (m_is_given) all.shortest_chain = 0;
    std::vector<Way> result;
    if (all.lines) {
      Snap_options far = all;
      far.line_reach *= 2;
      result.push_back({far, {true, bold_worst}});
      result.push_back({far, {true, {}}});
    }
    result.push_back({all});
    Snap_options less = all;
    less.lines = false;
    if (all.lines) result.push_back({less});
    less.crossings = false;
    less.corner_reach = less.reach;
    result.push_back({less});
    return result;
  }

  // What is held, and what the design has put onto sharp edges already.
  Vertex_constraints designed(Quad_mesh& mesh) const {
    Vertex_constraints result(held(mesh));
    Snap_options near = m_snapping;
    near.reach = std::min(near.reach, on_it);
    near.corner_reach = std::min(near.corner_reach, on_it);
    near.lines = near.crossings = false;
    snap(mesh, near, result);
    return result;
  }

  Snap_report snap(Quad_mesh& mesh, const Snap_options& way, Vertex_constraints& onto) const {
    return m_is_given ? snap_to_features(mesh, m_projector, m_features, way, onto)
                      : snap_to_features(mesh, m_projector, m_features.edges, way, onto);
  }

  Result<Snapped> snap(const Finished_quads& plain, const Way& way,
                       const internal::Chosen_features& chosen) const {
    Snapped result;
    Finished_quads& quads = result.quads;
    quads = plain;
    const Relax_report before = plain.relaxation;
    Relax_options few = gentle(before);
    few.iterations = std::min(few.iterations, sweeps_onto_features);
    std::vector<int> left = before.off_surface;
    double offset = before.largest_offset;
    const int rounds = way.snapping.crossings ? rounds_onto_crossings : 1;
    for (int round = 0; round < rounds; ++round) {
      Vertex_constraints onto(held(quads.mesh));
      for (int v : left) onto.fixed[std::size_t(v)] = 1; // brought back, they would have to leave again
      quads.features = internal::snap_to_chains(quads.mesh, m_projector, chosen, way.snapping, way.lines,
                                                onto, result.chain_of_curve);
      if (quads.features.corners + quads.features.vertices == 0) {
        quads = plain;
        return result;
      }
      if (Result<void> relaxed = relax(quads, onto, few); !relaxed) return relaxed.error();
      left.insert(left.end(), quads.relaxation.off_surface.begin(), quads.relaxation.off_surface.end());
      offset = std::max(offset, quads.relaxation.largest_offset);
      quads.relaxation.off_surface = left;
      quads.relaxation.largest_offset = offset;
      turn_to_features(quads.mesh, onto);
      result.onto = std::move(onto);
    }
    quads.relaxation.worst_before = before.worst_before;
    quads.relaxation.mean_before = before.mean_before;
    quads.relaxation.inverted_before = before.inverted_before;
    return result;
  }

  // Fewer defects are always better. Sharp edges are worth a little of the quads' mean quality, but good
  // quads stay good.
  bool is_worse(const Relax_report& a, const Relax_report& b) const {
    if (a.inverted_after > b.inverted_after || a.intersections_after > b.intersections_after) return true;
    if (a.inverted_after < b.inverted_after || a.intersections_after < b.intersections_after) return false;
    if (m_is_given) return false;
    return (a.worst_after < b.worst_after && a.worst_after < poor_quad) ||
           a.mean_after < b.mean_after - worth_of_edges ||
           (a.mean_after < good_mean && b.mean_after >= good_mean);
  }

  std::vector<char> held(const Quad_mesh& mesh) const {
    std::vector<char> fixed(mesh.points.size(), 0);
    for (int v : m_held) fixed[std::size_t(v)] = 1;
    return fixed;
  }

  Result<void> relax(Finished_quads& quads, const Vertex_constraints& constraints,
                     const Relax_options& options) const {
    Result<Relax_report> report = relax_quads(quads.mesh, m_projector, constraints, options, m_observer);
    if (!report) return report.error();
    quads.relaxation = *report;
    return {};
  }

  const Surface_projector& m_projector;
  const Relax_options& m_relaxation;
  const Snap_options& m_snapping;
  Given_features m_features; // sharp edges, without an angle none, or what is given
  bool m_is_given = false;
  Observer* m_observer;
  const std::vector<int>& m_held;
};

} // namespace

Result<Finished_quads> finish_quads(Quad_mesh mesh, const Surface_projector& projector,
                                    const Relax_options& relaxation, const Snap_options& features,
                                    Observer* observer, const std::vector<int>& held) {
  return Finisher(projector, relaxation, features, observer, held).run(std::move(mesh));
}

Result<Finished_quads> finish_quads(Quad_mesh mesh, const Surface_projector& projector,
                                    const Given_features& features, const Relax_options& relaxation,
                                    const Snap_options& options, Observer* observer,
                                    const std::vector<int>& held) {
  return Finisher(projector, relaxation, options, features, observer, held).run(std::move(mesh));
}

Result<Finished_quads> internal::finish_quads(Quad_mesh mesh, const Surface_projector& projector,
                                              const Given_features* features, const Relax_options& relaxation,
                                              const Snap_options& options, Observer* observer,
                                              const std::vector<int>& held,
                                              const std::vector<Guide_line>& guides) {
  if (features)
    return Finisher(projector, relaxation, options, *features, observer, held).run(std::move(mesh), guides);
  return Finisher(projector, relaxation, options, observer, held).run(std::move(mesh), guides);
}

Result<Finished_quads> finish_quads(Quad_mesh mesh, const Triangle_surface& input,
                                    const Relax_options& relaxation, const Snap_options& features,
                                    Observer* observer, const std::vector<int>& held) {
  return finish_quads(std::move(mesh), Surface_projector(input), relaxation, features, observer, held);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
