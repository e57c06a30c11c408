// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_INPUT_SURFACE_H
#define REEBQUAD_CERTIFICATE_INPUT_SURFACE_H

#include "certificate/topology.h"

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// The input's triangles that are usable and finite: their connectivity, and the list that geometry is done
/// on.
struct Input_surface {
  const Triangle_surface& surface;
  Soup_topology topology; ///< of all usable triangles
  std::vector<Triangle> triangles;
  std::vector<int> index; ///< of each of these among the triangles of `surface`
  const std::vector<Point>& points() const { return surface.points; }
};

/// \pre the triangles at each vertex are one fan, else boundary loops are miscounted
Input_surface read_input(const Triangle_surface& surface);

/// The same of the triangles of any file: the first of all points that are equal stands for them.
Input_surface read_soup(const Triangle_surface& surface);

/// A triangle of the input that stands for `stride` triangles of its component.
struct Input_sample {
  Point centre;
  Point vector_area; ///< normal times area, times the stride
  int vertex = -1;   ///< a corner of the triangle
};

/// Every k-th triangle of each component, with the least k that takes at most about `per_component` (0: all).
std::vector<Input_sample> sample_triangles(const Input_surface& input, int per_component);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_INPUT_SURFACE_H
