// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_DEVIATION_H
#define CGAL_REEB_QUADRANGULATION_DEVIATION_H

#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Result.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <array>
#include <vector>

/// \file
/// Where quads do not keep the shape of a surface: distances place by place, sharp edges and corners that are
/// lost. For pictures and lists; `certify()` proves bounds.

namespace CGAL {
namespace Reeb_quadrangulation {

/// A place that is farther from the other side than those around it.
struct Deviation_place {
  Point point = Point::Zero();
  double distance = 0;
  bool on_surface = false; ///< of the surface, far from the quads; else of the quads, far from the surface
};

/// Lengths are in the surface's unit. A quad is two triangles, split at its shorter diagonal.
struct Deviation {
  double diagonal = 0;            ///< of the surface's bounding box
  std::vector<double> of_surface; ///< of each vertex of the surface, to the quads
  /// Of each quad the greatest distance that was measured: of its corners and its middle to the surface, and
  /// of those vertices of the surface that it is the nearest quad to. Zero where a quad has a corner that is
  /// no point, or twice the same.
  std::vector<double> of_quads;
  double greatest_of_surface = 0, greatest_of_quads = 0; ///< of the quads' corners and middles
  std::vector<Deviation_place> worst; ///< the greatest first; each is far from those before it
  int corners = 0;                    ///< as `Shape_kept` counts them
  std::vector<Point> lost_corners; ///< those without a vertex of the quads; see `Shape_kept::missed_corners`
  double sharp_length = 0;         ///< of all sharp lines of two mean edges of the quads or longer
  double lost_sharp_length = 0;    ///< of these, what no edge of quads runs along
  /// The edges of such lines of which less than half is run along.
  std::vector<std::array<Point, 2>> lost_sharp_edges;
};

struct Deviation_options {
  int places = 8;                     ///< most that are listed in `worst`
  double apart = 0.05;                ///< by the diagonal: how far such places are from each other
  double least = 1e-4;                ///< by the diagonal: nearer ones are not listed
  const Observer* observer = nullptr; ///< may be null
};

/// Measures both directions. Fails with `impossible_request` where one side has no face, and with
/// `cancelled`.
/// O((n + m) log (n + m)).
Result<Deviation> measure_deviation(const Quad_mesh& quads, const Triangle_surface& surface,
                                    const Deviation_options& options = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_DEVIATION_H
