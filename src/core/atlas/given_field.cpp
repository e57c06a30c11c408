// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas/given_field.h"

#include <CGAL/Reeb_quadrangulation/Order_graph.h>
#include <CGAL/Reeb_quadrangulation/transfer_attribute.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Values on a boundary loop may differ by this share of the range: a function that was computed elsewhere is
// constant there up to rounding, or up to single precision.
constexpr double constant_up_to = 1e-6;

Error impossible(const std::string& sentence, int vertex = -1) {
  return make_error(Error_code::impossible_request, sentence,
                    vertex < 0 ? Element_kind::none : Element_kind::vertex, vertex);
}

Result<void> check(const Triangle_surface& surface, const std::vector<double>& values, double persistence) {
  if (surface.number_of_faces() == 0)
    return make_error(Error_code::not_a_surface, "the surface has no faces");
  if (connected_components(surface).second != 1)
    return make_error(Error_code::not_a_surface, "the surface has several components");
  if (int(values.size()) != surface.number_of_vertices())
    return impossible("the function has " + std::to_string(values.size()) + " values, the surface " +
                      std::to_string(surface.number_of_vertices()) + " vertices");
  for (std::size_t v = 0; v < values.size(); ++v)
    if (!std::isfinite(values[v])) return impossible("a value of the function is not finite", int(v));
  if (!(persistence >= 0 && persistence < 1))
    return impossible("the persistence of a function's extrema lies between 0 and 1, and is less than 1");
  return {};
}

// To 0 .. 1 over the vertices that have a face. Halves, for the range of finite values may be infinite.
Result<std::vector<double>> scaled(const Triangle_surface& surface, const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (surface.outgoing[v] < 0) continue;
    low = std::min(low, 0.5 * values[v]);
    high = std::max(high, 0.5 * values[v]);
  }
  if (!(high > low)) return impossible("the function is constant");
  std::vector<double> to_one(values.size(), 0.0);
  for (std::size_t v = 0; v < values.size(); ++v)
    if (surface.outgoing[v] >= 0) to_one[v] = (0.5 * values[v] - low) / (high - low);
  return to_one;
}

// Whether the function, from 0 to 1, has a maximum on a boundary loop, by the neighbours of the loop that lie
// beyond its own values; where there are none, by the half of the range that it lies in.
Result<bool> is_maximum_on(const Triangle_surface& surface, const std::vector<int>& loop,
                           const std::vector<double>& values) {
  double low = 1, high = 0;
  for (int h : loop) {
    low = std::min(low, values[std::size_t(surface.source(h))]);
    high = std::max(high, values[std::size_t(surface.source(h))]);
  }
  if (high - low > constant_up_to)
    return impossible("the function is not constant on a boundary loop, so that contours would end there",
                      surface.source(loop[0]));
  bool is_below = false, is_above = false;
  for (int h : loop)
    for (int spoke = h; spoke >= 0; spoke = surface.rotate_ccw(spoke)) {
      const double value = values[std::size_t(surface.target(spoke))];
      is_below = is_below || value < low;
      is_above = is_above || value > high;
    }
  if (is_below && is_above)
    return impossible("the function rises and falls from a boundary loop, which is no extremum then",
                      surface.source(loop[0]));
  return is_below || (!is_above && low > 0.5);
}

// The extrema of the closed surface that are persistent; loops are extrema whatever their persistence.
void find_extrema(const Triangle_surface& surface, const std::vector<std::vector<int>>& loops,
                  double persistence, Designed_field& field) {
  const Closed_surface closed = close_boundaries(surface);
  std::vector<double> values;
  std::vector<signed char> level;
  close_field(closed, loops, field, values, level);
  const Order_graph graph = order_graph(closed.surface, order_vertices(values, level), values);
  for (const std::array<int, 2>& pair : graph.pairs) {
    const auto vertex = [&](int i) { return graph.nodes[std::size_t(pair[std::size_t(i)])].vertex; };
    if (std::abs(values[std::size_t(vertex(1))] - values[std::size_t(vertex(0))]) <= persistence) continue;
    for (int node : pair) {
      const Order_graph::Node& found = graph.nodes[std::size_t(node)];
      if (found.vertex >= closed.original_vertices) continue;
      if (found.kind == Critical_kind::minimum) field.minima.push_back(found.vertex);
      if (found.kind == Critical_kind::maximum) field.maxima.push_back(found.vertex);
    }
  }
}

void name_values(Designed_field& field) {
  for (auto* list : {&field.minima, &field.maxima}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
    for (int v : *list) field.extremal_values[v] = field.values[std::size_t(v)];
  }
}

} // namespace

Result<Designed_field> design_function(const Triangle_surface& surface, const std::vector<double>& values,
                                       double persistence) {
  if (Result<void> fine = check(surface, values, persistence); !fine) return fine.error();
  Result<std::vector<double>> to_one = scaled(surface, values);
  if (!to_one) return to_one.error();
  Designed_field field;
  field.values = std::move(*to_one);
  const std::vector<std::vector<int>> loops = boundary_loops(surface);
  for (const std::vector<int>& loop : loops) {
    const Result<bool> is_maximum = is_maximum_on(surface, loop, field.values);
    if (!is_maximum) return is_maximum.error();
    field.boundary_is_maximum.push_back(*is_maximum);
  }
  find_extrema(surface, loops, persistence, field);
  name_values(field);
  return field;
}

Result<Designed_field> carried_field(const Triangle_surface& from, const Surface_projector& on_from,
                                     const Designed_field& field, const Triangle_surface& to,
                                     const std::vector<int>& vertex_in_to) {
  Designed_field carried;
  carried.values.assign(std::size_t(to.number_of_vertices()), 0.0);
  std::vector<char> is_old(carried.values.size(), 0);
  for (std::size_t v = 0; v < vertex_in_to.size(); ++v) {
    const std::size_t w = std::size_t(vertex_in_to[v]);
    if (to.points[w] != from.points[v]) continue; // it was collapsed into another one
    carried.values[w] = field.values[v];
    is_old[w] = 1;
  }
  for (std::size_t w = 0; w < carried.values.size(); ++w) {
    if (is_old[w]) continue;
    const Closest_point place = on_from.closest(to.points[w]);
    const auto weight = internal::barycentric_coordinates(from, place.face, place.point);
    const Triangle& t = from.triangles[std::size_t(place.face)];
    for (std::size_t i = 0; i < 3; ++i) carried.values[w] += weight[i] * field.values[std::size_t(t[i])];
    carried.values[w] = std::min(1.0, std::max(0.0, carried.values[w]));
  }
  for (int v : field.minima) carried.minima.push_back(vertex_in_to[std::size_t(v)]);
  for (int v : field.maxima) carried.maxima.push_back(vertex_in_to[std::size_t(v)]);
  name_values(carried);
  for (int w : carried.minima)
    if (std::binary_search(carried.maxima.begin(), carried.maxima.end(), w))
      return impossible("a minimum and a maximum of the function are too near to each other", w);
  std::vector<char> is_high(carried.values.size(), 0);
  const std::vector<std::vector<int>> loops = boundary_loops(from);
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (int h : loops[i])
      if (field.boundary_is_maximum[i]) is_high[std::size_t(vertex_in_to[std::size_t(from.source(h))])] = 1;
  for (const std::vector<int>& loop : boundary_loops(to))
    carried.boundary_is_maximum.push_back(std::any_of(
        loop.begin(), loop.end(), [&](int h) { return is_high[std::size_t(to.source(h))] != 0; }));
  return carried;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
