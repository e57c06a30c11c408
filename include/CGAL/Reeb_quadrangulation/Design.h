// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_DESIGN_H
#define CGAL_REEB_QUADRANGULATION_DESIGN_H

#include <CGAL/Reeb_quadrangulation/Guide.h>
#include <CGAL/Reeb_quadrangulation/Pole_kind.h>
#include <CGAL/Reeb_quadrangulation/Surface_point.h>
#include <CGAL/Reeb_quadrangulation/Texture_place.h>
#include <CGAL/Reeb_quadrangulation/place_texture.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// An extremum of a design.
struct Design_extremum {
  int vertex = -1;
  bool is_maximum = false;
  double value = 0; ///< of the field, 0 to 1
  Pole_kind pole = Pole_kind::quarter;
  int segment = -1; ///< of a half-pole: its contour edge; `vertex` is then a vertex of the surface near it
};

/// Where columns of an annulus end or begin, by a point on the surface, so that it outlives its chart: where
/// contours change, it belongs to the annulus that then has the point.
struct Design_dislocation {
  Point at = Point::Zero();
  int columns = -2; ///< see `Dislocation::columns`

  bool operator==(const Design_dislocation& o) const { return at == o.at && columns == o.columns; }
};

/// What the user asked of a chart.
struct Chart_settings {
  int columns = 0; ///< of an annulus, at its low side; 0 = free
  int rows = 0;
  int corner = -1; ///< of a disc: the sample where its first corner lies; -1 = the best fit
  Texture_placement placement() const {
    Texture_placement p;
    p.shift = shift;
    p.grading = grading;
    p.corner = corner;
    return p;
  }
  int shift = 0;
  double grading = 1;
  bool locked = false;
  std::vector<Design_dislocation> dislocations{}; ///< of an annulus

  /// How many more columns an annulus has at its high side than at its low side.
  int columns_gained() const {
    int sum = 0;
    for (const Design_dislocation& d : dislocations) sum += d.columns;
    return sum;
  }

  bool operator==(const Chart_settings& o) const {
    return columns == o.columns && rows == o.rows && corner == o.corner && shift == o.shift &&
           grading == o.grading && locked == o.locked && dislocations == o.dislocations;
  }
};

/// A chart of a design with its map and its texture: an immutable value that states share.
struct Design_chart {
  int id = -1; ///< for life: a chart keeps it as long as the contours around it stay
  std::shared_ptr<const Chart> chart;
  std::shared_ptr<const Chart_parameterization> map; ///< of an annulus, with V solved for the present counts
  Placed_texture texture;
  bool edited = false;             ///< the texture is the user's, no longer the regular one of `grid`
  int texture_id = -1;             ///< of an edited texture, for life: also when the chart is cut anew
  std::array<int, 2> grid{{0, 0}}; ///< columns, at the low side of an annulus, and rows of the chart's own
                                   ///< texture
  double height = 0;               ///< of an annulus
  Chart_settings settings;
};

/// A point on the surface that means a place of a chart's texture, for edits: see `edge_place()` and its
/// like. \pre The place is a point (V, U).
Surface_point surface_point(const Design_chart& chart, const Texture_place& place);

/// The field on the whole surface that contours were last traced from. Contours that were edited since are no
/// level lines of it.
struct Surface_field {
  std::vector<double> values;    ///< per vertex, without extrema that are not wanted; see `remove_extrema()`
  int cleanup_rounds = 0;        ///< that this took
  std::vector<int> lost_extrema; ///< vertices that were suggested as extrema, and are none
  std::map<int, double> boundary_values = {}; ///< see `Designed_field::boundary_values`
};

/// A guide of a design.
struct Design_guide {
  Guide guide;
  int contour = -1; ///< the contour edge that was drawn along it, or -1; other edits may have moved that
};

/// How well the counts meet what was asked for.
struct Count_report {
  std::int64_t quads = 0; ///< of the regular textures
  bool target_met = true; ///< within 5 % of the target, if there is one
  double worst_ratio = 1; ///< see `Sampling::worst_ratio`
  int worst_edge = -1;    ///< the contour edge where it occurs
};

/// The state of a design: everything that the quad mesh follows from.
struct Design {
  Contour_network network;
  std::vector<Design_extremum> extrema; ///< by increasing vertex
  Contour_samples samples;
  Count_report counts;
  std::shared_ptr<const Surface_field> field; ///< none in the first design
  int target_quads = 0;                       ///< as last asked for; 0 if an edge length was
  double edge_length = 0;                     ///< of the quads, as the counts have been chosen for
  int next_chart = 0;                         ///< the identity that the next chart gets
  std::vector<std::shared_ptr<const Design_chart>> charts; ///< parallel to the atlas's
  Atlas atlas;                                             ///< without `chart_of_face`; see `embed_design()`
  std::vector<Design_guide> guides;                        ///< in the order in which they were added

  /// The index of the chart with an identity, or -1.
  int index_of(int id) const;
};

/// A design's contours as edges of the surface: what pictures need. It is made when it is asked for, since it
/// is as large as the surface.
struct Embedded_design {
  Embedding embedding;
  std::vector<int> chart_of_face; ///< of the embedding: index into `Design::charts`
};

/// O(F). \pre `surface` is the one that the design lives on.
Embedded_design embed_design(const Triangle_surface& surface, const Design& design);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_DESIGN_H
