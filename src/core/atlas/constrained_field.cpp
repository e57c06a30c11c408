// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/constrained_field.h>

#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// What `values` have at a network vertex, linear along edges.
double value_at(const Triangle_surface& surface, const std::vector<double>& values,
                const Contour_network& network, int vertex) {
  if (!network.is_crossing(vertex)) return values[vertex];
  const Edge_crossing& c = network.crossing(vertex);
  const double a = values[surface.source(c.halfedge)], b = values[surface.target(c.halfedge)];
  return a + c.t * (b - a);
}

struct Mean {
  double sum = 0;
  int count = 0;
  void add(double x) {
    sum += x;
    ++count;
  }
};

} // namespace

std::map<int, double> contour_constraints(const Triangle_surface& surface, const std::vector<double>& values,
                                          const Contour_network& network, const std::vector<int>& edges) {
  CGAL_precondition(int(values.size()) == surface.number_of_vertices());
  std::map<int, Mean> asked, on_contours;
  for (int e : edges) {
    const Contour_edge& edge = network.edges[e];
    CGAL_precondition(!network.is_removed(edge));
    for (int v : edge.vertices)
      if (!network.is_crossing(v)) on_contours[v].add(edge.value);
    for (std::size_t i = 0; i < edge.faces.size(); ++i) {
      if (edge.faces[i] < 0) continue; // along an edge of the surface, whose ends are on the contour
      const int from = edge.vertices[i], to = edge.vertices[i + 1];
      const Point p = network.position(surface, from), d = network.position(surface, to) - p;
      const double at_p = value_at(surface, values, network, from),
                   at_q = value_at(surface, values, network, to), length = d.squaredNorm();
      for (int v : surface.triangles[edge.faces[i]]) {
        const double t = length > 0 ? std::clamp((surface.points[v] - p).dot(d) / length, 0.0, 1.0) : 0.0;
        asked[v].add(edge.value + values[v] - (at_p + t * (at_q - at_p)));
      }
    }
  }
  for (const auto& [v, mean] : on_contours) asked[v] = mean;
  std::map<int, double> constraints;
  for (const auto& [v, mean] : asked) constraints[v] = mean.sum / mean.count;
  return constraints;
}

Result<std::vector<double>> constrained_field(const Triangle_surface& surface, const Designed_field& field,
                                              const Contour_network& network, const std::vector<int>& edges,
                                              const Field_solver_options& options) {
  std::map<int, double> fixed = contour_constraints(surface, field.values, network, edges);
  for (const std::vector<int>* extrema : {&field.minima, &field.maxima})
    for (int v : *extrema) fixed[v] = field.values[v];
  for (const std::vector<int>& loop : boundary_loops(surface))
    for (int h : loop) fixed[surface.source(h)] = field.values[surface.source(h)];
  std::vector<double> values(surface.number_of_vertices(), 0.0);
  std::vector<char> is_fixed(values.size(), 0);
  for (const auto& [v, value] : fixed) {
    values[v] = value;
    is_fixed[v] = 1;
  }
  const Result<Dirichlet_problem> problem = Dirichlet_problem::factorize(
      surface, clamped_cotangent_weights(surface), is_fixed, field.elimination_order, options);
  if (!problem) return problem.error();
  if (const Result<void> solved = problem->solve(surface, values); !solved) return solved.error();
  return values;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
