// SPDX-License-Identifier: GPL-3.0-or-later
#include "automatic/mirrored.h"

#include "base/parallel_for.h"
#include "base/stage_recorder.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// What is asked of the half.
Quadrangulation_options half_options(const Quadrangulation_options& options, const Mirror_plane& plane) {
  Quadrangulation_options half = options;
  half.mirror.reset();
  half.quads = std::max(1, (options.quads + 1) / 2);
  if (options.adaptive.quads > 0) half.adaptive.quads = std::max(1, (options.adaptive.quads + 1) / 2);
  for (Placed_extremum& e : half.extrema)
    if (plane.signed_distance(e.point) < 0) e.point = plane.reflected(e.point);
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
  result.subdivided_quads = whole.subdivided_quads;
  result.t_junctions = whole.t_junctions;
  result.mirror->image = std::move(mirrored.image);
  result.mirror->on_plane = mirrored.on_plane;
  result.mirror->ring_quads = mirrored.ring_quads;
  result.mirror->largest_shift = mirrored.largest_shift;
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
  design.subdivided_quads = result.subdivided_quads;
  design.t_junctions = result.t_junctions;
  return design;
}

} // namespace

Result<Quadrangulation> quadrangulate_mirrored(const Triangle_surface& surface,
                                               const Quadrangulation_options& options, Observer* observer) {
  if (options.given_features)
    return make_error(Error_code::impossible_request,
                      "features that are given are those of the whole surface: a mirror excludes them");
  if (surface.number_of_faces() == 0)
    return make_error(Error_code::not_a_surface, "the surface has no faces");
  Stage_recorder recorder(observer, {"mirror planes", "mirror"});
  recorder.progress("mirror planes", 0);
  const Surface_projector whole(surface);
  const Result<Found_mirror> found = choose_mirror(whole, *options.mirror, &recorder);
  if (!found) return found.error();
  const Result<Surface_half> half = halve_surface(surface, found->plane);
  if (!half) return half.error();
  recorder.end();
  Result<Quadrangulation> result = quadrangulate(half->surface, half_options(options, half->plane), observer);
  if (!result) return result;
  recorder.progress("mirror", 0);
  result->recipe.mirror = Mirror{half->plane, options.mirror->positions};
  result->mirror.emplace();
  result->mirror->mirror = *result->recipe.mirror;
  result->mirror->deviation = found->deviation;
  Finish_options finish = result->recipe.finish;
  finish.relaxation.threads = number_of_threads(options.threads);
  Result<Mirrored_design> mirrored =
      mirror_design(finished_of(*result), *half, whole, options.mirror->positions, finish, &recorder);
  if (!mirrored) return mirrored.error();
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
