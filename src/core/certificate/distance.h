// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_DISTANCE_H
#define REEBQUAD_CERTIFICATE_DISTANCE_H

#include "certificate/geometry.h"
#include "certificate/topology.h"
#include "certificate/tree.h"

#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// The input's triangles that are usable and finite: their connectivity, and the list that geometry is done
/// on.
struct Input_surface {
  const Triangle_surface& surface;
  Soup_topology topology;
  std::vector<Triangle> triangles;
};

Input_surface read_input(const Triangle_surface& surface);

/// A triangle of the input that stands for `stride` triangles of its component.
struct Input_sample {
  Point centre;
  Point vector_area; ///< normal times area, times the stride
};

/// Every k-th triangle of each component, with the least k that takes at most about `per_component` (0: all).
std::vector<Input_sample> sample_triangles(const Input_surface& input, int per_component);

/// See `Certificate_distance`. `quad_tree` is over the split quads. Nothing if the observer cancels.
/// \pre neither side is empty.
std::optional<Certificate_distance> measure_distance(const Quad_mesh& mesh, const std::vector<char>& usable,
                                                     const Triangle_tree& quad_tree,
                                                     const Input_surface& input,
                                                     const Certificate_options& options);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_DISTANCE_H
