// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_DESIGN_DRAWING_H
#define REEBQUAD_VIEW_DESIGN_DRAWING_H

#include "view/Design_field.h"
#include "view/Layers.h"

namespace reebquad {
namespace studio {

/// The surface of a design with its contours cut in, put together from the charts. What was found out about a
/// chart is kept as long as the chart is, so that an edit costs what is new, and O(F) to write down which
/// chart each face belongs to.
class Design_drawing {
public:
  using Design = CGAL::Reeb_quadrangulation::Design;

  /// Keeps a reference to the surface.
  explicit Design_drawing(const CGAL::Reeb_quadrangulation::Triangle_surface& surface);

  /// Draws a design that lives on the surface.
  void update(const Design& design);
  /// What `update()` drew; with references to this and to the design. \pre `design` is the one that was
  /// drawn, `graph` its graph
  Charted_surface charted(const Design& design, const CGAL::Reeb_quadrangulation::Reeb_graph& graph) const;

private:
  /// What is drawn of a chart.
  struct Drawn_chart {
    std::shared_ptr<const CGAL::Reeb_quadrangulation::Design_chart> chart;
    Chart_levels levels;
    std::vector<double> values; ///< of the field, at the vertices of its mesh
    std::vector<int> pieces;    ///< the faces of its mesh that are not whole faces of the surface
    std::vector<CGAL::Reeb_quadrangulation::Point> line; ///< see `Charted_surface::lines`
  };

  Drawn_chart draw(const std::shared_ptr<const CGAL::Reeb_quadrangulation::Design_chart>& chart,
                   const Chart_levels& levels) const;
  void begin(const Design& design);
  void add(int index);

  const CGAL::Reeb_quadrangulation::Triangle_surface& m_surface;
  std::map<const CGAL::Reeb_quadrangulation::Design_chart*, std::shared_ptr<const Drawn_chart>> m_known;
  std::vector<std::shared_ptr<const Drawn_chart>> m_charts; ///< of the design
  CGAL::Reeb_quadrangulation::Embedding m_cut;              ///< its surface (not connected) and base faces
  std::vector<int> m_chart_of_face;
  std::vector<double> m_values;
  std::vector<std::vector<CGAL::Reeb_quadrangulation::Point>> m_lines;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_DESIGN_DRAWING_H
