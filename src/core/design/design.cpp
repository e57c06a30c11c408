// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Design.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Reeb_quadrangulation {

Surface_point surface_point(const Design_chart& chart, const Texture_place& place) {
  CGAL_precondition(place.quad < 0);
  const std::vector<Chart_location> found = locate(*chart.chart, *chart.map, {place.v}, {place.u});
  return {position(*chart.chart, found[0]), -1};
}

int Design::index_of(int id) const {
  for (std::size_t c = 0; c < charts.size(); ++c)
    if (charts[c]->id == id) return int(c);
  return -1;
}

Embedded_design embed_design(const Triangle_surface& surface, const Design& design) {
  Embedded_design result;
  Result<Embedding> embedding = embed(surface, design.network);
  CGAL_assertion(bool(embedding));
  Result<Atlas> atlas = build_atlas(*embedding, design.network, {}, &design.atlas);
  CGAL_assertion(bool(atlas));
  result.embedding = std::move(*embedding);
  result.chart_of_face = std::move(atlas->chart_of_face);
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
