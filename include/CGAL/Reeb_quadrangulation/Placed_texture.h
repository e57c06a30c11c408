// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PLACED_TEXTURE_H
#define CGAL_REEB_QUADRANGULATION_PLACED_TEXTURE_H

#include <CGAL/Reeb_quadrangulation/Quad_texture.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The samples of the contour edges: `counts[e]` equal steps in a parameter that both charts of the edge
/// share, so that their sides meet by identity.
struct Contour_samples {
  std::vector<int> counts; ///< per contour edge
  std::vector<std::vector<double>>
      parameter; ///< per contour edge: of each polyline vertex, strictly from 0 to 1
};

/// The shared parameter of each contour edge (`points` are those of the network's vertices): arc length,
/// blended by `blend` in [0, 1] with the mean of the natural V of the annuli on its sides, where they are
/// strictly monotone. Independent of the counts. Edges with an entry in `known` keep it, so that an edit on
/// one side of a contour leaves the samples of the other side where they are. With a `density` for each
/// vertex of the network, lengths count so many times there.
std::vector<std::vector<double>> contour_parameters(const std::vector<Point>& points,
                                                    const Contour_network& network, const Atlas& atlas,
                                                    const std::vector<const Chart_parameterization*>& maps,
                                                    double blend, std::vector<std::vector<double>> known = {},
                                                    const std::vector<double>& density = {});

/// The positions of a walk's vertices in sample steps, from 0 at its first vertex; one more entry than
/// vertices, the last is the walk's number of samples.
std::vector<double> walk_coordinates(const Walk& walk, const Contour_samples& samples);

/// A chart's texture and how its sides meet the walks' samples: texture vertex `sides[w][i]` is sample
/// `steps[w][i] - offset[w]` of walk `w`, modulo their number.
struct Placed_texture {
  Quad_texture texture;
  std::array<int, 2> offset{{0, 0}};
  std::vector<Chart_location> location; ///< of each texture vertex
  /// Where each side's vertices lie, in sample steps: increasing, in [0, number of samples). Empty: entry i
  /// at i, until an edit adds vertices between samples or takes some away.
  std::array<std::vector<double>, 2> steps;
  /// The (V, U) of vertices that the user has put where they are. The final relaxation leaves them there, as
  /// long as they are not moved.
  std::vector<Eigen::Vector2d> anchors{};

  double step(int side, int entry) const { return steps[side].empty() ? entry : steps[side][entry]; }
};

/// The vertices that lie at the anchors, in increasing order. O((A + V) log A) for A anchors.
std::vector<int> anchored_vertices(const Placed_texture& placed);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PLACED_TEXTURE_H
