// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/draft.h"
#include "design/guide_lines.h"

#include "base/quad_connectivity.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

bool has_irregular_texture(const Design& design) {
  return std::any_of(design.charts.begin(), design.charts.end(), [](const auto& chart) {
    return chart->edited || !chart->settings.dislocations.empty();
  });
}

Result<Stitched_mesh> stitch_design(const Triangle_surface& surface,
                                    const internal::Lazy_projector& projector, const Design& design) {
  std::vector<const Placed_texture*> textures;
  T_junction_options options;
  for (const auto& chart : design.charts) {
    textures.push_back(&chart->texture);
    options.fixed.insert(options.fixed.end(), chart->texture.texture.quads.size(), chart->settings.locked);
  }
  const std::vector<Point> points = network_points(surface, design.network);
  Result<Stitched_mesh> stitched =
      stitch_textures(points, design.network, design.atlas, design.samples, textures, options);
  if (!stitched && stitched.error().element == Element_kind::face &&
      options.fixed[std::size_t(stitched.error().index)]) {
    std::int64_t quad = stitched.error().index;
    std::size_t c = 0;
    for (; quad >= std::int64_t(textures[c]->texture.quads.size()); ++c)
      quad -= std::int64_t(textures[c]->texture.quads.size());
    return refuse("the quads of a locked chart would be split where its neighbours are denser", {},
                  Element_kind::chart, design.charts[c]->id);
  }
  if (stitched && !design.guides.empty()) stitched->guides = guide_lines(*projector, design);
  if (!stitched || !has_irregular_texture(design)) return stitched;
  if (const int q = internal::find_fault(stitched->mesh.quads, int(stitched->mesh.points.size())); q >= 0)
    return refuse("quads of neighbouring charts would be folded onto each other", {}, Element_kind::chart,
                  design.charts[std::size_t(stitched->chart_of_quad[std::size_t(q)])]->id);
  for (int v : stitched->interpolated)
    stitched->mesh.points[v] = projector->closest(stitched->mesh.points[v]).point;
  return stitched;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
