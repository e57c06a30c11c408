// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/raster.h"

#include "base/quad_cut.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {
namespace {

Grid_point on_grid(const Screen_point& s) {
  Grid_point g;
  if (!s.valid) return g;
  g.x = std::int32_t(std::floor(s.x * grid_unit + 0.5));
  g.y = std::int32_t(std::floor(s.y * grid_unit + 0.5));
  g.z = float(s.z);
  g.q = float(s.q);
  g.valid = true;
  return g;
}

bool is_drawable(const std::vector<Grid_point>& points, const Scene::Face& face) {
  for (int i = 0; i < 4; ++i)
    if (face[i] < 0 ? i < 3 : !points[face[i]].valid) return false;
  return true;
}

/// The two triangles of a face.
std::array<Corners, 2> pieces_of(const Scene& scene, const std::vector<Grid_point>& points,
                                 const Scene::Face& face) {
  const Corners none{-1, -1, -1};
  if (!is_drawable(points, face)) return {none, none};
  if (face[3] < 0) return {Corners{0, 1, 2}, none};
  const auto p = [&](int i) -> const Point& { return scene.points[face[i]]; };
  if (internal::first_corner_of_cut(p(0), p(1), p(2), p(3)) == 0) return {Corners{0, 1, 2}, Corners{0, 2, 3}};
  return {Corners{0, 1, 3}, Corners{1, 2, 3}};
}

Rod make_rod(const Screen_point& a, const Screen_point& b, double width, double lift, double xray,
             Colour colour, double pixel) {
  Rod rod;
  rod.ax = float(a.x), rod.ay = float(a.y), rod.az = float(a.z);
  rod.bx = float(b.x), rod.by = float(b.y), rod.bz = float(b.z);
  rod.radius = float(std::min(std::max(width, 0.0), 1000.0) / 2 * pixel);
  rod.lift = float(lift * pixel);
  rod.xray = float(std::min(std::max(xray, 0.0), 1.0));
  rod.colour = colour;
  rod.valid = a.valid && b.valid && width > 0 && std::isfinite(lift);
  return rod;
}

struct Row_range {
  int first, last; // inclusive
};

/// Sample rows whose centres may lie within the grid rows `low` to `high`.
Row_range sample_rows(std::int32_t low, std::int32_t high) {
  const auto down = [](std::int32_t v) {
    return v >= 0 ? v / grid_unit : -((-v + grid_unit - 1) / grid_unit);
  };
  return {down(low), down(high)};
}

Row_range rows_of(const Projected_scene& scene, const Scene& source, std::size_t piece) {
  const Corners& c = scene.pieces[piece];
  if (c[0] < 0) return {0, -1};
  const Scene::Face& face = source.faces[piece / 2];
  const auto ys =
      std::minmax({scene.points[face[c[0]]].y, scene.points[face[c[1]]].y, scene.points[face[c[2]]].y});
  return sample_rows(ys.first, ys.second);
}

/// Counting sort of items into bands by their rows; `rows(i)` is empty for an item that is not drawn.
template <class Rows> Bins bin(std::size_t number, int total_rows, int height, Rows rows) {
  Bins bins;
  const int bands = (total_rows + height - 1) / height;
  bins.start.assign(bands + 1, 0);
  const auto for_each_band = [&](auto visit) {
    for (std::size_t i = 0; i < number; ++i) {
      const Row_range r = rows(i);
      if (r.last < r.first || r.last < 0 || r.first >= total_rows) continue;
      const int last = std::min(r.last, total_rows - 1) / height;
      for (int b = std::max(r.first, 0) / height; b <= last; ++b) visit(b, std::int32_t(i));
    }
  };
  for_each_band([&](int b, std::int32_t) { ++bins.start[b + 1]; });
  for (int b = 0; b < bands; ++b) bins.start[b + 1] += bins.start[b];
  bins.items.resize(bins.start[bands]);
  std::vector<std::int32_t> next(bins.start.begin(), bins.start.end() - 1);
  for_each_band([&](int b, std::int32_t i) { bins.items[next[b]++] = i; });
  return bins;
}

} // namespace

float squared_distance(const Rod& rod, float x, float y, float& parameter) {
  const float dx = rod.bx - rod.ax, dy = rod.by - rod.ay, px = x - rod.ax, py = y - rod.ay;
  const float length = dx * dx + dy * dy;
  parameter = length > 0 ? std::min(std::max((px * dx + py * dy) / length, 0.0f), 1.0f) : 0.0f;
  const float ex = px - parameter * dx, ey = py - parameter * dy;
  return ex * ex + ey * ey;
}

Projected_scene project(const Scene& scene, const Projection& projection, int columns, int rows,
                        int samples) {
  Projected_scene out;
  out.columns = columns;
  out.rows = rows;
  out.pixel = float(samples);
  out.points.reserve(scene.points.size());
  for (const Point& p : scene.points) out.points.push_back(on_grid(projection(p)));
  out.pieces.reserve(2 * scene.faces.size());
  for (const Scene::Face& face : scene.faces)
    for (const Corners& piece : pieces_of(scene, out.points, face)) out.pieces.push_back(piece);
  for (const Scene_line& l : scene.lines)
    out.rods.push_back(
        make_rod(projection(l.a), projection(l.b), l.width, l.lift, l.xray, l.colour, samples));
  out.first_dot = out.rods.size();
  for (const Scene_dot& d : scene.dots) {
    const Screen_point c = projection(d.centre);
    out.rods.push_back(make_rod(c, c, 2 * d.radius, d.lift, d.xray, d.colour, samples));
  }
  return out;
}

void Band::start(int first_row, int last_row, int width, bool with_rods) {
  first = first_row;
  last = last_row;
  columns = width;
  const std::size_t size = std::size_t(width) * (last - first);
  depth.assign(size, std::numeric_limits<float>::infinity());
  piece.assign(size, -1);
  rod_depth.assign(with_rods ? size : 0, std::numeric_limits<float>::infinity());
  rod.assign(with_rods ? size : 0, -1);
}

void rasterize_piece(const Projected_scene& scene, const Scene& source, std::int32_t piece, Band& band) {
  const Scene::Face& face = source.faces[piece / 2];
  const Corners& corners = scene.pieces[piece];
  const Grid_point& a = scene.points[face[corners[0]]];
  const Grid_point* b = &scene.points[face[corners[1]]];
  const Grid_point* c = &scene.points[face[corners[2]]];
  std::int64_t area = turn(a, *b, c->x, c->y);
  if (area == 0) return;
  if (area < 0) {
    std::swap(b, c);
    area = -area;
  }
  const Row_range rows = sample_rows(std::min({a.y, b->y, c->y}), std::max({a.y, b->y, c->y}));
  const Row_range columns = sample_rows(std::min({a.x, b->x, c->x}), std::max({a.x, b->x, c->x}));
  const int x0 = std::max(columns.first, 0), x1 = std::min(columns.last, band.columns - 1);
  const int y0 = std::max(rows.first, band.first), y1 = std::min(rows.last, band.last - 1);
  if (x0 > x1) return;

  // The depth is affine; clamping keeps slivers, whose gradient is huge, between their corners.
  const float z_low = std::min({a.z, b->z, c->z}), z_high = std::max({a.z, b->z, c->z});
  const double inverse = 1.0 / double(area);
  const std::int64_t step_a = -std::int64_t(c->y - b->y) * grid_unit,
                     step_b = -std::int64_t(a.y - c->y) * grid_unit,
                     step_c = -std::int64_t(b->y - a.y) * grid_unit;
  for (int y = y0; y <= y1; ++y) {
    const std::int64_t gx = grid_of_sample(x0), gy = grid_of_sample(y);
    std::int64_t ea = turn(*b, *c, gx, gy), eb = turn(*c, a, gx, gy), ec = turn(a, *b, gx, gy);
    const std::size_t row = std::size_t(y - band.first) * band.columns;
    for (int x = x0; x <= x1; ++x, ea += step_a, eb += step_b, ec += step_c) {
      if ((ea | eb | ec) < 0) continue;
      const double z = (double(ea) * a.z + double(eb) * b->z + double(ec) * c->z) * inverse;
      const float depth = std::min(std::max(float(z), z_low), z_high);
      if (depth < band.depth[row + x]) {
        band.depth[row + x] = depth;
        band.piece[row + x] = piece;
      }
    }
  }
}

void rasterize_rod(const Projected_scene& scene, std::int32_t index, Band& band) {
  const Rod& rod = scene.rods[index];
  const float reach = rod.radius + 0.5f; // half a sample beyond the rim, for soft borders
  const auto first = [](float v, int low) { return int(std::max(std::floor(v), float(low))); };
  const auto last = [](float v, int high) { return int(std::min(std::ceil(v), float(high))); };
  const int x0 = first(std::min(rod.ax, rod.bx) - reach, 0),
            x1 = last(std::max(rod.ax, rod.bx) + reach, band.columns - 1);
  const int y0 = first(std::min(rod.ay, rod.by) - reach, band.first),
            y1 = last(std::max(rod.ay, rod.by) + reach, band.last - 1);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      float t = 0;
      const float d2 = squared_distance(rod, float(x) + 0.5f, float(y) + 0.5f, t);
      if (d2 > reach * reach) continue;
      const float bulge = std::sqrt(std::max(rod.radius * rod.radius - d2, 0.0f));
      const float depth = rod.az + t * (rod.bz - rod.az) - rod.lift - bulge;
      const std::size_t at = std::size_t(y - band.first) * band.columns + x;
      if (depth < band.rod_depth[at]) {
        band.rod_depth[at] = depth;
        band.rod[at] = index;
      }
    }
}

Bins bin_pieces(const Projected_scene& scene, const Scene& source, int height) {
  return bin(scene.pieces.size(), scene.rows, height,
             [&](std::size_t i) { return rows_of(scene, source, i); });
}

Bins bin_rods(const Projected_scene& scene, int height) {
  return bin(scene.rods.size(), scene.rows, height, [&](std::size_t i) {
    const Rod& rod = scene.rods[i];
    if (!rod.valid) return Row_range{0, -1};
    const float reach = rod.radius + 1;
    return Row_range{int(std::floor(std::min(rod.ay, rod.by) - reach)),
                     int(std::ceil(std::max(rod.ay, rod.by) + reach))};
  });
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
