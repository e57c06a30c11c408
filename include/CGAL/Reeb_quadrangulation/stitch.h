// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_STITCH_H
#define CGAL_REEB_QUADRANGULATION_STITCH_H

#include <CGAL/Reeb_quadrangulation/Quad_texture.h>
#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include <map>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The samples of the contour edges: `counts[e]` equal steps in a parameter that both charts of the edge share, so that their sides
/// meet by identity.
struct Contour_samples {
  std::vector<int> counts; ///< per contour edge
  std::vector<std::vector<double>>
      parameter; ///< per contour edge: of each polyline vertex, strictly from 0 to 1
};

/// The shared parameter of each contour edge (`points` are those of the network's vertices): arc length, blended by `blend` in [0, 1] with the mean of the natural V of the
/// annuli on its sides, where they are strictly monotone. Independent of the counts. Edges with an entry in `known` keep it, so
/// that an edit on one side of a contour leaves the samples of the other side where they are.
std::vector<std::vector<double>> contour_parameters(const std::vector<Point>& points,
                                                    const Contour_network& network, const Atlas& atlas,
                                                    const std::vector<const Chart_parameterization*>& maps,
                                                    double blend,
                                                    std::vector<std::vector<double>> known = {});

/// The positions of a walk's vertices in sample steps, from 0 at its first vertex; one more entry than vertices, the last is
/// the walk's number of samples.
std::vector<double> walk_coordinates(const Walk& walk, const Contour_samples& samples);

/// A chart's texture and how its sides meet the walks' samples: texture vertex `sides[w][i]` is sample `steps[w][i] - offset[w]` of
/// walk `w`, modulo their number.
struct Placed_texture {
  Quad_texture texture;
  std::array<int, 2> offset{{0, 0}};
  std::vector<Chart_location> location; ///< of each texture vertex
  /// Where each side's vertices lie, in sample steps: increasing, in [0, number of samples). Empty: entry i at i, until an edit
  /// adds vertices between samples or takes some away.
  std::array<std::vector<double>, 2> steps;
  /// The (V, U) of vertices that the user has put where they are. The final relaxation leaves them there, as long as they are not moved.
  std::vector<Eigen::Vector2d> anchors{};

  double step(int side, int entry) const { return steps[side].empty() ? entry : steps[side][entry]; }
};

/// The vertices that lie at the anchors, in increasing order. O((A + V) log A) for A anchors.
std::vector<int> anchored_vertices(const Placed_texture& placed);

/// What the user decides about a chart's texture.
struct Texture_placement {
  int shift = 0;      ///< annulus: columns by which the HIGH walk is turned east, beyond the best fit
  double grading = 1; ///< annulus: height of the uppermost row over that of the lowest, positive
  int corner = -1;    ///< disc: the sample of the walk where the corner (0, 0) lies; -1 = the best fit
};

/// The U of `rows + 1` level lines whose rows' heights grow geometrically by `grading` from the first to the last.
std::vector<double> graded_rows(const Height_profile& profile, int rows, double grading);

/// Solves V of an annulus for the samples, turning the HIGH walk by the whole number of columns that fits the natural V best, and
/// fills it with `rows` rows of equal height, or as `maker` does. A texture that does not fit is an `impossible_request`.
Result<Placed_texture> place_annulus(const Chart& chart, const Contour_samples& samples, int rows,
                                     Chart_parameterization& map, const Texture_maker& maker = {},
                                     const Texture_placement& placement = {});

/// Maps a disc to a x b, its corners where they span the largest quadrilateral, and fills it regularly, or as `maker` does.
Result<Placed_texture> place_disc(const Chart& chart, const Contour_samples& samples, int a, int b,
                                  Chart_parameterization& map, const Texture_maker& maker = {},
                                  const Texture_placement& placement = {});

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
  /// If there are holes: the Euler characteristic and the number of boundary loops of each component of what is left.
  std::vector<std::pair<int, int>> components;
};

/// Joins the placed textures. Where the charts on both sides of a contour edge have a vertex in the same place, they meet by
/// identity; where one has more between two such places, the nearest meet and the others are T-junctions, which
/// `resolve_t_junctions()` takes away in the coarser chart. Quads that are holes are left out at the end. Fails with
/// `refused_edit` where a side has no vertex at a node or the quads at a vertex are not one fan because of holes, and as
/// `resolve_t_junctions()` does.
Result<Stitched_mesh> stitch_textures(const std::vector<Point>& points, const Contour_network& network,
                                      const Atlas& atlas, const Contour_samples& samples,
                                      const std::vector<const Placed_texture*>& textures,
                                      const T_junction_options& options = {});

/// Joins the placed textures by identity of their samples. \pre The textures' sides have the samples' numbers.
Stitched_mesh stitch(const std::vector<Point>& points, const Contour_network& network, const Atlas& atlas,
                     const Contour_samples& samples, const std::vector<const Placed_texture*>& textures);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_STITCH_H
