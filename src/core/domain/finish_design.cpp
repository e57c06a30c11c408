// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/finish_guides.h"

#include <CGAL/Reeb_quadrangulation/finish_design_on_features.h>

#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// What a turn of the lines between fine and coarse quads costs, times what is asked for: the next one is
// tried where the one before inverts quads.
constexpr double turn_costs[] = {1.0, 0.25, 4.0};

class Design_finisher {
public:
  // With features, these count; without, sharp edges.
  Design_finisher(const Surface_projector& projector, const Given_features* features,
                  const Finish_options& options, Observer* observer)
      : m_projector(projector), m_features(features), m_options(options), m_observer(observer) {}

  Result<Finished_design> run(Stitched_mesh quads) const {
    Finished_design base;
    base.quads = std::move(quads);
    if (Result<void> finished = finish(base); !finished) return finished.error();
    if (m_options.adaptive.ratio == 1) return base;
    std::optional<Finished_design> best;
    for (int ratio = m_options.adaptive.ratio; ratio > 1; ratio /= 2)
      for (const double cost : turn_costs) {
        Finished_design adapted = base;
        if (Result<void> done = adapt(adapted, ratio, cost); !done) return done.error();
        if (Result<void> done = finish(adapted); !done) return done.error();
        if (adapted.relaxation.inverted_after <= base.relaxation.inverted_after) return adapted;
        if (!best || adapted.relaxation.inverted_after < best->relaxation.inverted_after)
          best = std::move(adapted);
      }
    return std::move(*best);
  }

private:
  Result<void> finish(Finished_design& design) const {
    if (!m_options.relax) return {};
    Quad_mesh& mesh = design.quads.mesh;
    const std::vector<int>& held = design.quads.held_vertices;
    Result<Finished_quads> finished =
        internal::finish_quads(std::move(mesh), m_projector, m_features, m_options.relaxation,
                               m_options.features, m_observer, held, design.quads.guides);
    if (!finished) return finished.error();
    mesh = std::move(finished->mesh);
    design.relaxation = std::move(finished->relaxation);
    design.features = finished->features;
    design.guides = std::move(finished->guides);
    return {};
  }

  // Vertices keep their indices, so that those that are held are known afterwards.
  Result<void> adapt(Finished_design& design, int ratio, double cost) const {
    Adaptive_options options = m_options.adaptive;
    options.ratio = ratio;
    options.lines.turn_cost *= cost;
    Stitched_mesh& quads = design.quads;
    Result<Adapted_quads> adapted = adapt_quads(quads.mesh, m_projector, options);
    if (!adapted) return adapted.error();
    quads.mesh = std::move(adapted->mesh);
    std::vector<int> chart;
    for (int parent : adapted->parent) chart.push_back(quads.chart_of_quad[std::size_t(parent)]);
    quads.chart_of_quad = std::move(chart);
    for (const auto& [valence, number] : adapted->valence_changes)
      if ((quads.valences[valence] += number) == 0) quads.valences.erase(valence);
    design.subdivided_quads = adapted->subdivided;
    design.t_junctions = adapted->t_junctions;
    return {};
  }

  const Surface_projector& m_projector;
  const Given_features* m_features;
  const Finish_options& m_options;
  Observer* m_observer;
};

Result<Finished_design> finished(Stitched_mesh quads, const Surface_projector& projector,
                                 const Given_features* features, const Finish_options& options,
                                 Observer* observer) {
  const int ratio = options.adaptive.ratio;
  if (ratio != 1 && ratio != 2 && ratio != 4 && ratio != 8)
    return make_error(Error_code::impossible_request, "the ratio of adaptive quads is 1, 2, 4 or 8");
  if (observer) observer->progress("relaxation", 0);
  return Design_finisher(projector, features, options, observer).run(std::move(quads));
}

} // namespace

Result<Finished_design> finish_design(Stitched_mesh quads, const Surface_projector& projector,
                                      const Finish_options& options, Observer* observer) {
  if (options.marks.empty()) return finished(std::move(quads), projector, nullptr, options, observer);
  const Result<Marked_features> marked =
      marked_features(projector.surface(), options.marks, options.features.feature_angle);
  if (!marked) return marked.error();
  return finished(std::move(quads), projector, &marked->features, options, observer);
}

Result<Finished_design> finish_design(Stitched_mesh quads, const Surface_projector& projector,
                                      const Given_features& features, const Finish_options& options,
                                      Observer* observer) {
  return finished(std::move(quads), projector, &features, options, observer);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
