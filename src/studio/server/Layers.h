// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_STUDIO_LAYERS_H
#define REEBQUAD_STUDIO_LAYERS_H

#include "Frame.h"

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <map>

namespace reebquad {
namespace studio {

/// The encoded geometry that the page shows, by the layer's name.
using Layers = std::map<std::string, std::shared_ptr<const std::string>>;

/// What the layers are made of; a null pointer stands for what there is not yet.
struct Layer_source {
  const CGAL::Reeb_quadrangulation::Triangle_surface* surface = nullptr; ///< shown while there is no design
  CGAL::Reeb_quadrangulation::Point origin =
      CGAL::Reeb_quadrangulation::Point::Zero(); ///< subtracted from all points

  const CGAL::Reeb_quadrangulation::Design* design = nullptr; ///< this and the next four go together
  const CGAL::Reeb_quadrangulation::Embedded_design* embedded = nullptr;
  const CGAL::Reeb_quadrangulation::Reeb_graph* graph = nullptr;
  const std::vector<double>* values = nullptr; ///< the field at the vertices of the embedded surface
  const std::vector<int>* chart_ids = nullptr; ///< the identity of each chart of the atlas

  const CGAL::Reeb_quadrangulation::Stitched_mesh* quads = nullptr;
};

/// Makes the layers "surface", "field", "charts", "contours", "critical", "reeb" and "quads", as far as there is something to
/// show, as src/studio/protocol.md describes them.
Layers make_layers(const Layer_source& source);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_STUDIO_LAYERS_H
