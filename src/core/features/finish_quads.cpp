// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/finish_on_features.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A vertex so near to a sharp edge, in lengths of its quads' edges, was put onto it by the design: rounding is all
// that it is away.
constexpr double on_it = 0.01;

// Quads without defects that snapping spoils are mended within a few attempts or, as a rule, not at all.
constexpr int attempts_of_good_quads = 4;

// Once quads are relaxed around the vertices on sharp edges, more vertices come near these; after the second round
// hardly any.
constexpr int rounds_onto_crossings = 2;

// A scaled Jacobian below which a quad is poor: it may not become poorer for the sake of a sharp edge.
constexpr double poor_quad = 0.2;

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

  // Quads are first relaxed without regard to sharp edges. Of the ways onto these, the first is taken that makes
  // them no worse.
  Result<Finished_quads> run(Quad_mesh mesh) const {
    Finished_quads plain;
    plain.mesh = std::move(mesh);
    Finished_quads freer = plain; // what lies on sharp edges may go too, where quads are bad otherwise
    if (Result<void> relaxed = relax(plain, designed(plain.mesh), m_relaxation); !relaxed)
      return relaxed.error();
    if (plain.relaxation.inverted_after + plain.relaxation.intersections_after > 0) {
      if (Result<void> relaxed = relax(freer, held(freer.mesh), m_relaxation); !relaxed)
        return relaxed.error();
      if (is_worse(plain.relaxation, freer.relaxation)) plain = std::move(freer);
    }
    if (m_features.edges.chains.empty() && m_features.points.empty()) return plain;
    for (const Snap_options& way : ways()) {
      Result<Finished_quads> snapped = snap(plain, way);
      if (!snapped || !is_worse(snapped->relaxation, plain.relaxation)) return snapped;
    }
    return plain;
  }

private:
  // From what is asked for to what hardly touches the quads.
  std::vector<Snap_options> ways() const {
    std::vector<Snap_options> result{m_snapping};
    Snap_options less = m_snapping;
    less.lines = false;
    if (m_snapping.lines) result.push_back(less);
    less.crossings = false;
    less.corner_reach = less.reach;
    result.push_back(less);
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

  Result<Finished_quads> snap(Finished_quads quads, const Snap_options& way) const {
    const Relax_report before = quads.relaxation;
    // Good quads that are spoilt by this, and not soon mended, are better left as they were.
    Relax_options gentle = m_relaxation;
    if (before.inverted_after + before.intersections_after == 0)
      gentle.attempts = std::min(gentle.attempts, attempts_of_good_quads);
    // Quads that are raised turn away from what they were laid onto, which the user has asked for.
    if (m_is_given) gentle.wanted = 0;
    std::vector<int> left = before.off_surface;
    double offset = before.largest_offset;
    const int rounds = way.crossings ? rounds_onto_crossings : 1;
    for (int round = 0; round < rounds; ++round) {
      Vertex_constraints onto(held(quads.mesh));
      for (int v : left) onto.fixed[std::size_t(v)] = 1; // brought back, they would have to leave again
      quads.features = snap(quads.mesh, way, onto);
      if (quads.features.corners + quads.features.vertices == 0) return quads;
      if (Result<void> relaxed = relax(quads, onto, gentle); !relaxed) return relaxed.error();
      left.insert(left.end(), quads.relaxation.off_surface.begin(), quads.relaxation.off_surface.end());
      offset = std::max(offset, quads.relaxation.largest_offset);
      quads.relaxation.off_surface = left;
      quads.relaxation.largest_offset = offset;
      turn_to_features(quads.mesh, onto);
    }
    quads.relaxation.worst_before = before.worst_before;
    quads.relaxation.mean_before = before.mean_before;
    quads.relaxation.inverted_before = before.inverted_before;
    return quads;
  }

  // Fewer defects are always better. Sharp edges are worth a little of the quads' mean quality, but good quads
  // stay good.
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

Result<Finished_quads> finish_quads(Quad_mesh mesh, const Triangle_surface& input,
                                    const Relax_options& relaxation, const Snap_options& features,
                                    Observer* observer, const std::vector<int>& held) {
  return finish_quads(std::move(mesh), Surface_projector(input), relaxation, features, observer, held);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
