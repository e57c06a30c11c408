// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/deviation.h>

#include "certificate/coverage.h"
#include "certificate/sharp_lines.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using namespace certification;

constexpr int between_questions = 4096; // distances after which the observer is asked

double mean_length(const Quad_mesh& quads, const std::vector<char>& usable) {
  double sum = 0;
  const auto edges = edges_of(quads, usable);
  for (const auto& [v, w] : edges) sum += (quads.points[w] - quads.points[v]).norm();
  return edges.empty() ? 0 : sum / double(edges.size());
}

class Deviation_measure {
public:
  Deviation_measure(const Quad_mesh& quads, const Triangle_surface& surface, const Deviation_options& options)
      : m_quads(quads), m_options(options), m_input(read_input(surface)),
        m_usable(analyse(quads.quads, int(quads.points.size()), Fans::unknown).usable),
        m_split(split_quads(quads, m_usable)), m_tree(quads.points, m_split.triangles) {}

  Result<Deviation> run() {
    if (m_input.triangles.empty() || m_tree.empty())
      return make_error(Error_code::impossible_request,
                        "there are no quads, or no surface, to measure between");
    Eigen::AlignedBox3d box;
    for (const Triangle& t : m_input.triangles)
      for (const int v : t) box.extend(m_input.points()[v]);
    m_result.diagonal = box.diagonal().norm();
    m_result.of_quads.assign(m_quads.quads.size(), 0);
    m_result.of_surface.assign(m_input.points().size(), 0);
    if (!measure_quads() || !measure_surface()) return make_error(Error_code::cancelled, "cancelled");
    list_worst();
    measure_sharp_lines();
    return std::move(m_result);
  }

private:
  bool goes_on(std::size_t done) const {
    return done % between_questions != 0 || !m_options.observer || !m_options.observer->cancelled();
  }

  bool measure_quads() {
    const Triangle_tree surface(m_input.points(), m_input.triangles);
    int hint = -1;
    for (std::size_t q = 0; q < m_quads.quads.size(); ++q) {
      if (!goes_on(q)) return false;
      const Quad_corners quad = m_usable[q] ? corners(m_quads, int(q)) : Quad_corners{};
      if (!m_usable[q] || !is_finite(quad)) continue;
      const std::array<Point, 5> points{quad[0], quad[1], quad[2], quad[3],
                                        0.25 * (quad[0] + quad[1] + quad[2] + quad[3])};
      for (const Point& p : points) {
        const Triangle_tree::Nearest nearest = surface.nearest(p, hint);
        hint = nearest.triangle;
        const double distance = std::sqrt(nearest.squared_distance);
        m_result.of_quads[q] = std::max(m_result.of_quads[q], distance);
        m_places.push_back({p, distance, false});
      }
      m_result.greatest_of_quads = std::max(m_result.greatest_of_quads, m_result.of_quads[q]);
    }
    return true;
  }

  bool measure_surface() {
    std::vector<char> used(m_input.points().size(), 0);
    for (const Triangle& t : m_input.triangles)
      for (const int v : t) used[v] = 1;
    int hint = -1;
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (!goes_on(v)) return false;
      if (!used[v]) continue;
      const Triangle_tree::Nearest nearest = m_tree.nearest(m_input.points()[v], hint);
      hint = nearest.triangle;
      const double distance = std::sqrt(nearest.squared_distance);
      m_result.of_surface[v] = distance;
      double& of_quad = m_result.of_quads[m_split.quad[nearest.triangle]];
      of_quad = std::max(of_quad, distance);
      m_result.greatest_of_surface = std::max(m_result.greatest_of_surface, distance);
      m_places.push_back({m_input.points()[v], distance, true});
    }
    return true;
  }

  // Equal distances in the order in which they were found.
  void list_worst() {
    std::stable_sort(m_places.begin(), m_places.end(),
                     [](const auto& a, const auto& b) { return a.distance > b.distance; });
    const double apart = m_options.apart * m_result.diagonal;
    for (const Deviation_place& place : m_places) {
      if (int(m_result.worst.size()) >= m_options.places ||
          place.distance < m_options.least * m_result.diagonal)
        break;
      const auto is_near = [&](const Deviation_place& other) {
        return (other.point - place.point).norm() < apart;
      };
      if (std::none_of(m_result.worst.begin(), m_result.worst.end(), is_near))
        m_result.worst.push_back(place);
    }
    m_places.clear();
  }

  void measure_sharp_lines() {
    const double mean_edge = mean_length(m_quads, m_usable);
    const std::vector<Point>& points = m_input.points();
    const auto sharp = sharp_edges(m_input, Sharp_limits::angle);
    Nearest_quad nearest(m_quads, m_split, m_tree);
    for (const auto& edge : long_lines(points, sharp, Sharp_limits::long_line * mean_edge)) {
      const double length = (points[edge.second] - points[edge.first]).norm();
      const auto covered = covered_sharp_edges(nearest, points, {edge}, mean_edge);
      if (!covered) continue;
      m_result.sharp_length += length;
      m_result.lost_sharp_length += (1 - covered->by_edges) * length;
      if (covered->by_edges < 0.5)
        m_result.lost_sharp_edges.push_back({points[edge.first], points[edge.second]});
    }
    for (const int v :
         certification::corners(points, sharp, Sharp_limits::angle, Sharp_limits::corner_line * mean_edge)) {
      ++m_result.corners;
      if (!has_vertex_at(nearest(points[v]), points[v])) m_result.lost_corners.push_back(points[v]);
    }
  }

  const Quad_mesh& m_quads;
  const Deviation_options& m_options;
  const Input_surface m_input;
  const std::vector<char> m_usable;
  const Split_quads m_split;
  const Triangle_tree m_tree;
  std::vector<Deviation_place> m_places;
  Deviation m_result;
};

} // namespace

Result<Deviation> measure_deviation(const Quad_mesh& quads, const Triangle_surface& surface,
                                    const Deviation_options& options) {
  return Deviation_measure(quads, surface, options).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
