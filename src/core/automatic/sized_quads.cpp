// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/sized_quads.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Runs in all: two, as a rule, where the first misses; a fourth hardly ever comes nearer.
constexpr int most_runs = 4;
// How far from 1 the mean may be without another run.
constexpr double near_enough = 0.1;

struct Size_range {
  double least = std::numeric_limits<double>::infinity(), greatest = 0, mean = 0;
};

Result<Size_range> range_of(const Triangle_surface& surface, const Size_function& size) {
  Size_range range;
  int number = 0;
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    if (surface.outgoing[std::size_t(v)] < 0) continue;
    const double s = size(surface.points[std::size_t(v)]);
    if (!(s > 0) || !std::isfinite(s))
      return make_error(Error_code::impossible_request, "a size is not a positive number",
                        Element_kind::vertex, v);
    range.least = std::min(range.least, s);
    range.greatest = std::max(range.greatest, s);
    range.mean += s;
    ++number;
  }
  if (number > 0) range.mean /= number;
  return range;
}

int ratio_for(const Size_range& range) {
  int ratio = 1;
  while (ratio < 8 && range.greatest > std::sqrt(2.0) * ratio * range.least) ratio *= 2;
  return ratio;
}

} // namespace

double mean_relative_size(const Quad_mesh& mesh, const Size_function& size) {
  double sum = 0;
  std::int64_t sides = 0;
  for (const Quad& q : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i) { // an inner edge counts twice, once from each side
      const Point &a = mesh.points[std::size_t(q[i])], &b = mesh.points[std::size_t(q[(i + 1) % 4])];
      sum += (b - a).norm() / size(0.5 * (a + b));
      ++sides;
    }
  return sides > 0 ? sum / double(sides) : 0;
}

Result<Quadrangulation> quadrangulate(const Triangle_surface& surface, const Size_function& size,
                                      const Quadrangulation_options& options, Observer* observer) {
  const Result<Size_range> range = range_of(surface, size);
  if (!range) return range.error();
  Quadrangulation_options asked = options;
  asked.adaptive.ratio = ratio_for(*range);
  asked.edge_length = asked.adaptive.ratio == 1 ? range->mean : range->greatest;
  double scale = 1, nearest = std::numeric_limits<double>::infinity();
  std::optional<Quadrangulation> best;
  for (int run = 0; run < most_runs; ++run) {
    if (asked.adaptive.ratio > 1) asked.adaptive.size = [&](const Point& p) { return scale * size(p); };
    Result<Quadrangulation> result = quadrangulate(surface, asked, observer);
    // A size that cannot be corrected further is no reason to lose what there is, unless the user says stop.
    if (!result && (!best || result.error().code == Error_code::cancelled)) return result.error();
    if (!result) break;
    const double mean = mean_relative_size(result->mesh, size);
    const double miss = std::abs(std::log(mean));
    if (miss < nearest) {
      nearest = miss;
      best = std::move(*result);
    }
    if (std::abs(mean - 1) <= near_enough || !(mean > 0)) break;
    scale /= mean;
    asked.edge_length /= mean;
  }
  return std::move(*best);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
