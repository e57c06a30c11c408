// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_LAYERS_H
#define REEBQUAD_VIEW_LAYERS_H

#include "view/Frame.h"

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <map>

namespace reebquad {
namespace studio {

/// The encoded geometry that the page shows, by the layer's name.
using Layers = std::map<std::string, std::shared_ptr<const std::string>>;

/// A surface with contours cut in, and what is drawn on it.
struct Charted_surface {
  const CGAL::Reeb_quadrangulation::Triangle_surface& base; ///< before the cuts
  const CGAL::Reeb_quadrangulation::Embedding& embedding;   ///< its surface and base faces
  const CGAL::Reeb_quadrangulation::Contour_network& network;
  const CGAL::Reeb_quadrangulation::Reeb_graph& graph;
  const std::vector<int>& chart_of_face;
  const std::vector<double>& values; ///< the field at the vertices of `embedding`
  /// What `line_of_chart()` gives for each chart, where it is known already.
  const std::vector<std::vector<CGAL::Reeb_quadrangulation::Point>>* lines = nullptr;
};

/// What the layers are made of; a null pointer stands for what there is not yet.
struct Layer_source {
  CGAL::Reeb_quadrangulation::Point origin =
      CGAL::Reeb_quadrangulation::Point::Zero(); ///< subtracted from all points

  const CGAL::Reeb_quadrangulation::Triangle_surface* surface = nullptr; ///< before any cuts
  std::vector<int> chart_ids; ///< the number that each chart is shown by

  const Charted_surface* charted = nullptr; ///< this and the next two go together
  std::vector<CGAL::Reeb_quadrangulation::Design_extremum> extrema;
  std::vector<int> counts; ///< of quads along contour edges, where they are known

  /// The quads as they are on the charts. A triangle is a quad whose last corner stands twice, also in
  /// `quads`.
  const CGAL::Reeb_quadrangulation::Quad_mesh* textures = nullptr;
  const CGAL::Reeb_quadrangulation::Quad_mesh* quads = nullptr; ///< the same when they are relaxed
  std::vector<int> chart_of_quad;
};

/// Makes the layers "surface", "cuts", "field", "charts", "contours", "critical", "reeb", "textures" and
/// "quads", as far as there is something to show, as src/studio/protocol.md describes them.
Layers make_layers(const Layer_source& source);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_LAYERS_H
