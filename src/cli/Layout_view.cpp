// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layout_view.h"

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

std::vector<double> embedded_values(const Reeb_layout& layout) {
  std::vector<double> values = layout.values;
  values.resize(layout.embedding.surface.points.size(), 0);
  for (const Contour_edge& edge : layout.network.edges)
    for (const int v : edge.vertices)
      if (layout.network.is_crossing(v)) values[v] = edge.value;
  return values;
}

} // namespace

Layout_view::Layout_view(const Quadrangulation& result)
    : values(embedded_values(result.layout)), charted{result.working_surface,
                                                      result.layout.embedding,
                                                      result.layout.network,
                                                      result.layout.graph,
                                                      result.layout.atlas.chart_of_face,
                                                      values} {}

} // namespace reebquad
