// SPDX-License-Identifier: GPL-3.0-or-later
#include "automatic/mirrored.h"

#include "base/parallel_for.h"
#include "base/stage_recorder.h"
#include "domain/mirror_report.h"
#include "surface/size_at.h"

#include <CGAL/Reeb_quadrangulation/design_energy.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// What is asked of the half.
Quadrangulation_options half_options(const Quadrangulation_options& options, const Surface_half& part,
                                     const Surface_projector& whole) {
  const Mirror_plane& plane = part.plane;
  Quadrangulation_options half = options;
  if (!options.sizes.empty()) {
    const Size_at size(whole, options.sizes);
    half.sizes.clear();
    for (const Point& p : part.surface.points) half.sizes.push_back(size(p));
  }
  half.mirror.reset();
  half.quads = std::max(1, (options.quads + 1) / 2);
  if (options.adaptive.quads > 0) half.adaptive.quads = std::max(1, (options.adaptive.quads + 1) / 2);
  for (Placed_extremum& e : half.extrema)
    if (plane.signed_distance(e.point) < 0) e.point = plane.reflected(e.point);
  for (Guide& guide : half.guides) {
    int beyond = 0;
    for (const Point& p : guide.points) beyond += plane.signed_distance(p) < 0;
    if (2 * beyond > int(guide.points.size()))
      for (Point& p : guide.points) p = plane.reflected(p);
  }
  return half;
}

// The result of a half with the quads of the whole.
void double_result(Quadrangulation& result, Mirrored_design&& mirrored) {
  Finished_design& whole = mirrored.whole;
  result.mesh = std::move(whole.quads.mesh);
  result.valences = std::move(whole.quads.valences);
  result.chart_of_quad = std::move(whole.quads.chart_of_quad);
  result.relaxation = std::move(whole.relaxation);
  result.features = whole.features;
  result.guides = std::move(whole.guides);
  result.subdivided_quads = whole.subdivided_quads;
  result.t_junctions = whole.t_junctions;
}

// The finished quads of a half as the engine had them when it had made them.
Finished_design finished_of(Quadrangulation& result) {
  Finished_design design;
  design.quads = result.editor.quads();
  design.quads.mesh = std::move(result.mesh);
  design.quads.valences = std::move(result.valences);
  design.quads.chart_of_quad = std::move(result.chart_of_quad);
  design.relaxation = std::move(result.relaxation);
  design.features = result.features;
  design.guides = std::move(result.guides);
  design.subdivided_quads = result.subdivided_quads;
  design.t_junctions = result.t_junctions;
  return design;
}

// Of several planes that are tried, designs are made that nobody sees.
constexpr int most_planes = 3;

constexpr int energy_samples = 4000;

// What the design of a half would cost; infinite where there is none.
double energy_of(const Surface_projector& whole, const Mirror_plane& plane,
                 const Quadrangulation_options& options, Observer& observer) {
  const Result<Surface_half> half = halve_surface(whole.surface(), plane);
  if (!half) return std::numeric_limits<double>::infinity();
  const Quadrangulation_options asked = half_options(options, *half, whole);
  Result<Recipe> recipe = automatic_recipe(asked);
  if (!recipe) return std::numeric_limits<double>::infinity();
  Result<Editor> editor = Editor::create(half->surface, recipe->options, &observer);
  if (!editor || !editor->apply(recipe->edits[0], &observer)) return std::numeric_limits<double>::infinity();
  return design_energy(editor->quads(), Surface_projector(half->surface),
                       sample_surface(half->surface, energy_samples))
      .total(options.energy);
}

// The plane that is asked for; of the best ones across axes, or of the others if there is none, that with the
// least design energy.
Result<Found_mirror> chosen_mirror(const Surface_projector& whole, const Quadrangulation_options& options,
                                   Observer& observer) {
  const Mirror_request& request = *options.mirror;
  if (request.choice != Mirror_choice::best) return choose_mirror(whole, request, &observer);
  std::vector<Found_mirror> found = find_mirror_planes(whole, request.tolerance, &observer);
  if (found.size() < 2) return choose_mirror(whole, request, &observer);
  const bool has_axis = found.front().plane.axis() >= 0;
  double best = std::numeric_limits<double>::infinity();
  Mirror_request given = request;
  given.choice = Mirror_choice::given;
  given.plane = found.front().plane;
  int tried = 0;
  for (const Found_mirror& mirror : found) {
    if ((mirror.plane.axis() >= 0) != has_axis || tried++ == most_planes) continue;
    const double energy = energy_of(whole, mirror.plane, options, observer);
    if (observer.cancelled()) return make_error(Error_code::cancelled, "the search of mirrors was cancelled");
    if (energy >= best) continue;
    best = energy;
    given.plane = mirror.plane;
  }
  return choose_mirror(whole, given, &observer);
}

} // namespace

Result<Quadrangulation> quadrangulate_mirrored(const Triangle_surface& surface,
                                               const Quadrangulation_options& options, Observer* observer) {
  if (options.given_features)
    return make_error(Error_code::impossible_request,
                      "features that are given are those of the whole surface: a mirror excludes them");
  if (!options.field.empty())
    return make_error(Error_code::impossible_request,
                      "a function that is given is one of the whole surface: a mirror excludes it");
  if (surface.number_of_faces() == 0)
    return make_error(Error_code::not_a_surface, "the surface has no faces");
  Stage_recorder recorder(observer, {"mirror planes", "mirror"});
  recorder.progress("mirror planes", 0);
  if (!options.sizes.empty())
    if (Result<void> fine = check_sizes(surface, options.sizes); !fine) return fine.error();
  const Surface_projector whole(surface);
  const Result<Found_mirror> found = chosen_mirror(whole, options, recorder);
  if (!found) return found.error();
  const Result<Surface_half> half = halve_surface(surface, found->plane);
  if (!half) return half.error();
  recorder.end();
  Result<Quadrangulation> result =
      quadrangulate(half->surface, half_options(options, *half, whole), observer);
  if (!result) return result;
  recorder.progress("mirror", 0);
  result->recipe.mirror = Mirror{half->plane, options.mirror->positions};
  Finish_options finish = result->recipe.finish;
  finish.relaxation.threads = number_of_threads(options.threads);
  Result<Mirrored_design> mirrored =
      mirror_design(finished_of(*result), *half, whole, options.mirror->positions, finish, &recorder);
  if (!mirrored) return mirrored.error();
  result->mirror = mirror_report(*result->recipe.mirror, found->deviation, *mirrored);
  double_result(*result, std::move(*mirrored));
  result->genus = (2 - euler_characteristic(surface) - int(boundary_loops(surface).size())) / 2;
  const std::vector<Stage_time> own = recorder.finish();
  result->stages.insert(result->stages.begin(), own.front());
  result->stages.insert(result->stages.end(), own.begin() + 1, own.end());
  return result;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
