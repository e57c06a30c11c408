// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_STITCH_H
#define CGAL_REEB_QUADRANGULATION_STITCH_H

#include <CGAL/Reeb_quadrangulation/Guide.h>
#include <CGAL/Reeb_quadrangulation/Placed_texture.h>
#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include <map>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The stitched quad mesh and what every vertex is.
struct Stitched_mesh {
  Quad_mesh mesh;
  std::vector<int> node_vertex; ///< per node of the network; -1 for one that no contour or quad has any more
  std::vector<int> chart_of_quad;
  std::map<int, int> valences;    ///< predicted from the layout alone: valence -> number of vertices inside
  std::vector<int> extraordinary; ///< the vertices that resolving T-junctions made extraordinary
  std::vector<int> interpolated;  ///< the vertices that resolving T-junctions added, beside the surface
  int t_junctions = 0;            ///< vertices of one side of a contour edge that the other had not
  int holes = 0;                  ///< quads of the textures that were left out
  std::vector<int>
      held_vertices; ///< those around holes, and anchors: relaxation is to leave them where they are
  /// If there are holes: the Euler characteristic and the number of boundary loops of each component of what
  /// is left.
  std::vector<std::pair<int, int>> components;
  std::vector<Guide_line> guides; ///< that the quads shall follow when they are finished
};

/// Joins the placed textures. Where the charts on both sides of a contour edge have a vertex in the same
/// place, they meet by identity; where one has more between two such places, the nearest meet and the others
/// are T-junctions, which `resolve_t_junctions()` takes away in the coarser chart. Quads that are holes are
/// left out at the end. Fails with `refused_edit` where a side has no vertex at a node or the quads at a
/// vertex are not one fan because of holes, and as `resolve_t_junctions()` does.
Result<Stitched_mesh> stitch_textures(const std::vector<Point>& points, const Contour_network& network,
                                      const Atlas& atlas, const Contour_samples& samples,
                                      const std::vector<const Placed_texture*>& textures,
                                      const T_junction_options& options = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_STITCH_H
