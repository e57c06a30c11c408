// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SIZED_QUADS_H
#define CGAL_REEB_QUADRANGULATION_SIZED_QUADS_H

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <functional>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The length, in the units of the surface, that edges of quads shall have at a point near it.
using Size_function = std::function<double(const Point&)>;

/// How well a mesh meets sizes: of each quad the mean length of its edges over the size in its middle.
struct Size_report {
  double mean = 0;                            ///< by area
  double met = 0;                             ///< the part of the area whose quads are met within 20 %
  double least = 0, median = 0, greatest = 0; ///< the 5th, 50th and 95th percentile of the area
};

/// Measures a mesh; zeros where it has no area.
Size_report size_report(const Quad_mesh& mesh, const Size_function& size);

/// The mean, over the edges of a mesh, of an edge's length divided by the size at its middle: 1 if the sizes
/// are met in the mean. 0 for a mesh without edges. \pre the sizes there are positive
double mean_relative_size(const Quad_mesh& mesh, const Size_function& size);

/// As `quadrangulate()`, with edges of absolute lengths: counts, rows and samples follow the sizes, and so do
/// dislocations if `options.dislocations` permits some; see `Quadrangulation_options::sizes`. The lengths
/// that a layout's integers and the relaxation make are measured and the run is repeated, up to four times in
/// all, until the geometric mean of `mean_relative_size()` and of `size_report().mean` is within 0.1 of 1;
/// else the nearest result is returned. Sizes that are coarser than the layout's least counts permit are not
/// met. `options.quads`, `edge_length` and `adaptive.ratio` are not read. Fails with `impossible_request`,
/// naming the vertex, where the size at a vertex of the surface is not a positive finite number. \pre
/// `surface` is connected by `connect()`.
Result<Quadrangulation> quadrangulate(const Triangle_surface& surface, const Size_function& size,
                                      const Quadrangulation_options& options = {},
                                      Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SIZED_QUADS_H
