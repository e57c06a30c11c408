// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_MESH_STATISTICS_H
#define CGAL_REEB_QUADRANGULATION_MESH_STATISTICS_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/shape_kept.h>

#include <array>
#include <map>
#include <optional>
#include <string>

/// \file
/// Counts and qualities of a quad mesh: the numbers that quad meshing papers print beside their figures.

namespace CGAL {
namespace Reeb_quadrangulation {

/// Least, mean and greatest of a quantity; all 0 if there is none of it.
struct Value_range {
  double minimum = 0;
  double mean = 0;
  double maximum = 0;
};

/// Statistics of a quad mesh. Lengths and areas are in the mesh's unit, angles in degrees.
struct Mesh_statistics {
  int vertices = 0; ///< points that a quad uses
  int edges = 0;
  int quads = 0;         ///< quads that are measured
  int skipped_quads = 0; ///< index out of range, repeated vertex, duplicate, or a point that is not finite
  int extraordinary_vertices =
      0; ///< interior vertices of valence other than 4, boundary vertices other than 3
  int largest_valence_difference =
      0; ///< greatest |valence - 4| of an interior, |valence - 3| of a boundary vertex
  std::map<int, int> interior_valences; ///< number of edges -> number of interior vertices
  std::map<int, int> boundary_valences; ///< number of edges -> number of boundary vertices

  /// The unsigned angle between the two edges at a corner, in [0, 180]; its mean over all corners is 90 on a
  /// planar convex mesh and less where quads are warped. Corners at an edge of length 0 have none.
  Value_range angle;
  Value_range angle_deviation; ///< |angle - 90|
  std::array<int, 18>
      angle_histogram{}; ///< corners by angle, bins of 10 degrees; the last bin has both its ends

  /// Of each quad, as the Verdict library defines it (Stimpson et al., SAND2007-1751), see `certify()`. The
  /// mean and histogram are over quads.
  Value_range scaled_jacobian;
  int inverted_quads = 0; ///< scaled Jacobian not positive
  std::array<int, 20>
      scaled_jacobian_histogram{}; ///< quads, 20 equal bins on [-1, 1]; the last has both its ends

  Value_range edge_length; ///< each edge once
  Value_range
      quad_area; ///< half the length of the diagonals' cross product: the area projected along the normal
  double quad_area_ratio = 0; ///< greatest by least quad area; infinite if a quad has none

  /// The fraction of the input's area whose nearest quad is larger than 10 mean quad areas: parts of the
  /// input that the quads hardly sample, typically a limb without an extremum. Absent without an input.
  std::optional<double> undersampled_area;

  /// The fraction of the length of the input's sharp edges that edges of quads run along: no farther from
  /// them than a twentieth of their own length, and turned by no more than 20 degrees. Absent without an
  /// input, or without a sharp edge.
  std::optional<double> covered_sharp_edges;

  /// The same with the first diagonals of quads, corner 0 to corner 2, along which most programs cut them:
  /// where these run along a sharp edge too, the surface is folded there.
  std::optional<double> folded_sharp_edges;
};

/// What else to measure.
struct Statistics_options {
  /// The undersampled area is measured at the centres of every k-th triangle, with k such that at most about
  /// so many are taken of each component; 0: all.
  int input_samples = 20000;
  double feature_angle = 45; ///< degrees between the normals of the faces of a sharp edge
};

/// Measures a quad mesh, and with `input` also how it samples that surface. Any arrays are accepted: what
/// cannot be measured is skipped and counted. Shares no code with the stages that make quad meshes. O(m log
/// m) for m quads, and O(n log n + k log m) for n input triangles and k samples.
Mesh_statistics quad_statistics(const Quad_mesh& mesh, const Triangle_surface* input = nullptr,
                                const Statistics_options& options = {});

/// Fills in what `certify()` has measured already of the input: the undersampled area and the sharp edges.
void add_shape(Mesh_statistics& statistics, const Shape_kept& shape);

/// The statistics as one JSON object (schema: doc/Reeb_quadrangulation/report_schema.md); numbers that are
/// not finite become null.
std::string to_json(const Mesh_statistics& statistics);

/// The statistics as aligned lines for the terminal, ended by a line break.
std::string to_text(const Mesh_statistics& statistics);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_MESH_STATISTICS_H
