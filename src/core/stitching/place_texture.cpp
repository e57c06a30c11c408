// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/place_texture.h>

#include "base/strictly_increasing.h"

#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

using internal::strictly_increasing;

namespace {

// Whether the rows' levels go from 0 to 1. A single row could join two nodes by two edges, where two charts
// meet in both.
bool are_levels(const std::vector<double>& u) {
  return u.size() >= 3 && u.front() == 0 && u.back() == 1 && strictly_increasing(u);
}

} // namespace

std::vector<double> graded_rows(const Height_profile& profile, int rows, double grading) {
  CGAL_precondition(grading > 0);
  if (grading == 1 || rows < 2) return equal_rows(profile, rows);
  const double ratio = std::pow(grading, 1.0 / (rows - 1));
  std::vector<double> heights(1, 0.0);
  double row = 1;
  for (int i = 0; i < rows; ++i, row *= ratio) heights.push_back(heights.back() + row);
  std::vector<double> levels;
  for (double height : heights) levels.push_back(profile.level_at(height / heights.back()));
  levels.front() = 0;
  levels.back() = 1;
  return strictly_increasing(levels) ? levels : equal_rows(profile, rows);
}

namespace {

// The mean of V - natural V along each walk, weighted by the walk's natural steps.
std::array<double, 2> mean_turns(const Chart& chart, const Chart_parameterization& map,
                                 const std::array<std::vector<double>, 2>& x) {
  std::array<double, 2> mean{{0, 0}};
  for (int w = 0; w < 2; ++w) {
    const std::vector<double>& natural = map.natural(chart.walks[w].side);
    for (std::size_t i = 0; i + 1 < x[w].size(); ++i)
      mean[w] += 0.5 * (x[w][i] - natural[i] + x[w][i + 1] - natural[i + 1]) * (natural[i + 1] - natural[i]);
  }
  return mean;
}

// The places of the walks' vertices around the chart, from 0 to 1.
std::array<std::vector<double>, 2> places_around(const Chart& chart, const Contour_samples& samples) {
  std::array<std::vector<double>, 2> x;
  for (int w = 0; w < 2; ++w) {
    x[w] = walk_coordinates(chart.walks[w], samples);
    const double n = x[w].back();
    for (double& value : x[w]) value /= n;
  }
  return x;
}

} // namespace

double best_turn(const Chart& chart, const Contour_samples& samples, const Chart_parameterization& map) {
  const std::array<double, 2> mean = mean_turns(chart, map, places_around(chart, samples));
  const int columns = int(std::lround(walk_coordinates(chart.walks[1], samples).back()));
  return columns * (mean[0] - mean[1]);
}

namespace {

constexpr int smoothed_rings = 6, smoothing_steps = 10; // around dislocations

Result<void> place_dislocations(const Chart& chart, const Chart_parameterization& map, int columns,
                                const std::vector<double>& levels, const Texture_placement& placement,
                                Placed_texture& placed) {
  std::vector<Dislocation> dislocations;
  for (const Texture_placement::Dislocation_at& d : placement.dislocations) {
    const Eigen::Vector2d p = plane_point(chart, map, d.at);
    dislocations.push_back({p.x(), p.y(), d.columns});
  }
  Result<Dislocated_texture> made = dislocated_annulus_texture(columns, levels, dislocations);
  if (!made) return made.error();
  placed.texture = std::move(made->texture);
  placed.location = locate(chart, map, placed.texture.v, placed.texture.u);
  std::vector<int> ends;
  for (const std::array<int, 2>& pair : made->ends) ends.insert(ends.end(), pair.begin(), pair.end());
  smooth_around(ends, smoothed_rings, smoothing_steps, chart, map, placed);
  return {};
}

} // namespace

Result<Placed_texture> place_annulus(const Chart& chart, const Contour_samples& samples, int rows,
                                     Chart_parameterization& map, const Texture_maker& maker,
                                     const Texture_placement& placement) {
  std::array<std::vector<double>, 2> x = places_around(chart, samples);
  const std::array<double, 2> mean = mean_turns(chart, map, x);
  Placed_texture placed;
  const int columns = int(std::lround(walk_coordinates(chart.walks[0], samples).back()));
  const int above = int(std::lround(walk_coordinates(chart.walks[1], samples).back()));
  const int shift = int(std::lround(above * (mean[0] - mean[1]))) + placement.shift;
  for (double& value : x[1]) value += double(shift) / above;
  if (Result<void> solved = map.solve_columns(chart, x[0], x[1]); !solved) return solved.error();
  const std::vector<double> levels =
      maker.levels ? maker.levels(map.profile(), rows) : graded_rows(map.profile(), rows, placement.grading);
  if (maker.levels && !are_levels(levels))
    return make_error(Error_code::impossible_request,
                      "the levels of a chart's rows do not increase from 0 to 1 in two steps or more");
  placed.offset = {0, shift};
  if (!placement.dislocations.empty()) {
    if (Result<void> done = place_dislocations(chart, map, columns, levels, placement, placed); !done)
      return done.error();
    CGAL_postcondition(int(placed.texture.sides[1].size()) == above);
    return placed;
  }
  placed.texture = maker.annulus ? maker.annulus(columns, levels) : regular_annulus_texture(columns, levels);
  if (maker.annulus)
    if (Result<void> checked = check_texture(placed.texture, {columns, columns}, false); !checked)
      return checked.error();
  placed.location = locate(chart, map, placed.texture.v, placed.texture.u);
  return placed;
}

namespace {

// The points of a walk's samples.
std::vector<Point> sample_points(const Chart& chart, const Walk& walk, const std::vector<double>& x) {
  std::vector<Point> points;
  const std::size_t n = walk.vertices.size();
  std::size_t i = 0;
  for (int k = 0; k < int(std::lround(x.back())); ++k) {
    while (i + 1 < n && x[i + 1] <= k) ++i;
    const Point &p = chart.mesh.points[walk.vertices[i]], &q = chart.mesh.points[walk.vertices[(i + 1) % n]];
    points.push_back(p + (k - x[i]) / (x[i + 1] - x[i]) * (q - p));
  }
  return points;
}

// Twice the area of the quadrilateral of corners that begins at sample c, for each that is another one.
std::vector<double> areas_of_corners(const std::vector<Point>& p, int a, int b) {
  const int n = int(p.size());
  std::vector<double> areas;
  for (int c = 0; c < (a == b ? a : a + b); ++c) {
    const Point d1 = p[(c + a + b) % n] - p[c], d2 = p[(c + 2 * a + b) % n] - p[(c + a) % n];
    areas.push_back(d1.cross(d2).norm());
  }
  return areas;
}

int best_corner(const std::vector<Point>& p, int a, int b) {
  int best = 0;
  double largest = -1;
  const std::vector<double> areas = areas_of_corners(p, a, b);
  for (int c = 0; c < int(areas.size()); ++c)
    if (areas[c] > largest * (1 + 1e-9)) {
      largest = areas[c];
      best = c;
    }
  return best;
}

} // namespace

std::vector<double> areas_between_corners(const Chart& chart, const Contour_samples& samples) {
  const Walk& walk = chart.walks[0];
  const std::vector<double> x = walk_coordinates(walk, samples);
  const int half = int(std::lround(x.back())) / 2, a = (half + 1) / 2;
  const int first = walk.side == Side::high ? half - a : a;
  return areas_of_corners(sample_points(chart, walk, x), first, half - first);
}

Result<Placed_texture> place_disc(const Chart& chart, const Contour_samples& samples, int a, int b,
                                  Chart_parameterization& map, const Texture_maker& maker,
                                  const Texture_placement& placement) {
  const Walk& walk = chart.walks[0];
  const bool clockwise = walk.side == Side::high;
  const std::vector<double> x = walk_coordinates(walk, samples);
  const int n = int(std::lround(x.back()));
  CGAL_precondition(n == 2 * (a + b));
  // Clockwise, the side goes up b first: exchange the roles so that corners are found by the same steps.
  const int first = clockwise ? b : a, second = clockwise ? a : b;
  const int corner = placement.corner >= 0 ? placement.corner % n
                                           : best_corner(sample_points(chart, walk, x), first, second);
  std::vector<double> px, py;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    double s = x[i] - corner;
    if (s < 0) s += n;
    double along, across;
    if (s < first) {
      along = s;
      across = 0;
    } else if (s < first + second) {
      along = first;
      across = s - first;
    } else if (s < 2 * first + second) {
      along = 2 * first + second - s;
      across = second;
    } else {
      along = 0;
      across = n - s;
    }
    px.push_back(clockwise ? across : along);
    py.push_back(clockwise ? along : across);
  }
  if (Result<void> solved = map.solve_rectangle(chart, px, py); !solved) return solved.error();
  Placed_texture placed;
  placed.texture = maker.disc ? maker.disc(a, b, clockwise) : regular_disc_texture(a, b, clockwise);
  if (maker.disc)
    if (Result<void> checked = check_texture(placed.texture, {n}, clockwise); !checked)
      return checked.error();
  placed.offset = {-corner, 0};
  placed.location = locate(chart, map, placed.texture.v, placed.texture.u);
  return placed;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
