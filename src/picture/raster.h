// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to the renderer: which face and which line or dot each sample sees.
#ifndef REEBQUAD_PICTURE_RASTER_H
#define REEBQUAD_PICTURE_RASTER_H

#include "picture/projection.h"

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A point's place on the grid of 1/256 sample, on which coverage is decided exactly.
struct Grid_point {
  std::int32_t x = 0, y = 0;
  float z = 0, q = 1;
  bool valid = false;
};

/// Twice the signed area of a, b, c in grid units; positive if they turn clockwise on the picture (y points
/// down). Exact.
inline std::int64_t turn(const Grid_point& a, const Grid_point& b, std::int64_t x, std::int64_t y) {
  return std::int64_t(b.x - a.x) * (y - a.y) - std::int64_t(b.y - a.y) * (x - a.x);
}

constexpr std::int32_t grid_unit = 256;
inline std::int64_t grid_of_sample(int i) {
  return std::int64_t(i) * grid_unit + grid_unit / 2;
}

/// A face is drawn as one or two triangles; piece 2 f + k is the k-th triangle of face f.
using Corners = std::array<int, 3>;

/// A line or dot on the picture: from `a` to `b` (equal for a dot), with its radius and its lift in samples.
struct Rod {
  float ax, ay, az, bx, by, bz, radius, lift, xray;
  Colour colour;
  bool valid;
};

/// The nearest rod's axis: squared distance of (x, y) and the parameter of the nearest point.
float squared_distance(const Rod& rod, float x, float y, float& parameter);

/// Everything of the scene, on the picture.
struct Projected_scene {
  int columns = 0, rows = 0; ///< in samples
  std::vector<Grid_point> points;
  std::vector<Corners> pieces; ///< two a face; corners 0 to 3, the first -1 where there is no triangle
  std::vector<Rod> rods;       ///< lines, then dots
  std::size_t first_dot = 0;
  float pixel = 1; ///< samples in a pixel
};

Projected_scene project(const Scene& scene, const Projection& projection, int columns, int rows, int samples);

/// The samples of rows `first` to `last` - 1 of the picture, and what each sees.
struct Band {
  int first = 0, last = 0, columns = 0;
  std::vector<float> depth;        ///< of the nearest face
  std::vector<std::int32_t> piece; ///< the nearest face's piece, or -1
  std::vector<float> rod_depth;
  std::vector<std::int32_t> rod; ///< the nearest line or dot, or -1

  void start(int first_row, int last_row, int width, bool with_rods);
};

void rasterize_piece(const Projected_scene& scene, const Scene& source, std::int32_t piece, Band& band);
void rasterize_rod(const Projected_scene& scene, std::int32_t rod, Band& band);

/// For each band of `height` rows, the pieces (or rods) that touch it, in ascending order.
struct Bins {
  std::vector<std::int32_t> start, items;
};
Bins bin_pieces(const Projected_scene& scene, const Scene& source, int height);
Bins bin_rods(const Projected_scene& scene, int height);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_PICTURE_RASTER_H
