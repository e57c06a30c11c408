// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layout_view.h"

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

std::vector<double> embedded_values(const Design& design, const Embedding& embedding) {
  std::vector<double> values = design.field->values;
  values.resize(embedding.surface.points.size(), 0);
  for (const Contour_edge& edge : design.network.edges)
    for (const int v : edge.vertices)
      if (design.network.is_crossing(v)) values[v] = edge.value;
  return values;
}

} // namespace

Layout_view::Layout_view(const Editor& editor)
    : embedded(embed_design(editor.working_surface(), editor.design())),
      graph(reeb_graph(editor.design().atlas, editor.design().network)),
      values(embedded_values(editor.design(), embedded.embedding)), charted{editor.working_surface(),
                                                                            embedded.embedding,
                                                                            editor.design().network,
                                                                            graph,
                                                                            embedded.chart_of_face,
                                                                            values} {}

} // namespace reebquad
