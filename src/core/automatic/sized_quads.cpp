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

// The sizes at the vertices; those of vertices without a triangle are not looked at.
Result<std::vector<double>> sizes_on(const Triangle_surface& surface, const Size_function& size) {
  std::vector<double> sizes(surface.points.size(), 1.0);
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    if (surface.outgoing[std::size_t(v)] < 0) continue;
    const double s = sizes[std::size_t(v)] = size(surface.points[std::size_t(v)]);
    if (!(s > 0) || !std::isfinite(s))
      return make_error(Error_code::impossible_request, "a size is not a positive number",
                        Element_kind::vertex, v);
  }
  return sizes;
}

// The edge of as many squares of one size as there are of the sizes that are asked for.
double mean_edge(const Triangle_surface& surface, const std::vector<double>& sizes) {
  double quads = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    double mean = 0;
    for (int v : surface.triangles[std::size_t(f)]) mean += 1 / (3 * sizes[std::size_t(v)]);
    quads += mean * mean * area(surface, f);
  }
  return std::sqrt(area(surface) / quads);
}

} // namespace

Size_report size_report(const Quad_mesh& mesh, const Size_function& size) {
  Size_report report;
  std::vector<std::pair<double, double>> parts; // what is met of the size, area
  double whole = 0;
  for (const Quad& q : mesh.quads) {
    Point middle = Point::Zero();
    double length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &a = mesh.points[std::size_t(q[i])], &b = mesh.points[std::size_t(q[(i + 1) % 4])];
      length += 0.25 * (b - a).norm();
      middle += 0.25 * a;
    }
    const Point d = mesh.points[std::size_t(q[2])] - mesh.points[std::size_t(q[0])];
    const Point e = mesh.points[std::size_t(q[3])] - mesh.points[std::size_t(q[1])];
    const double area = 0.5 * d.cross(e).norm(), ratio = length / size(middle);
    whole += area;
    report.mean += area * ratio;
    if (std::abs(ratio - 1) <= 0.2) report.met += area;
    parts.emplace_back(ratio, area);
  }
  if (!(whole > 0)) return {};
  report.mean /= whole;
  report.met /= whole;
  std::sort(parts.begin(), parts.end());
  double before = 0;
  for (const auto& [ratio, area] : parts) {
    for (const auto& [part, place] :
         {std::make_pair(0.05, &report.least), {0.5, &report.median}, {0.95, &report.greatest}})
      if (before <= part * whole) *place = ratio;
    before += area;
  }
  return report;
}

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
  Result<std::vector<double>> sizes = sizes_on(surface, size);
  if (!sizes) return sizes.error();
  if (surface.number_of_faces() == 0)
    return make_error(Error_code::not_a_surface, "the surface has no faces");
  Quadrangulation_options asked = options;
  asked.edge_length = mean_edge(surface, *sizes);
  asked.sizes = std::move(*sizes);
  asked.adaptive.ratio = 1;
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<Quadrangulation> best;
  for (int run = 0; run < most_runs; ++run) {
    Result<Quadrangulation> result = quadrangulate(surface, asked, observer);
    // A size that cannot be corrected further is no reason to lose what there is, unless the user says stop.
    if (!result && (!best || result.error().code == Error_code::cancelled)) return result.error();
    if (!result) break;
    // Over the edges small quads count most, over the area large ones.
    const double mean =
        std::sqrt(mean_relative_size(result->mesh, size) * size_report(result->mesh, size).mean);
    const double miss = std::abs(std::log(mean));
    if (miss < nearest) {
      nearest = miss;
      best = std::move(*result);
    }
    if (std::abs(mean - 1) <= near_enough || !(mean > 0)) break;
    asked.edge_length /= mean;
  }
  return std::move(*best);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
