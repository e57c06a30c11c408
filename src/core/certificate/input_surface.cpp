// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/input_surface.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

std::uint64_t hash(const Point& p) {
  std::uint64_t h = 0;
  for (int i = 0; i < 3; ++i) {
    const double x = p[i] == 0 ? 0 : p[i]; // 0 and -0 are equal
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    h = (h ^ bits) * 0x9e3779b97f4a7c15ull;
    h ^= h >> 29;
  }
  return h;
}

// For each point the first of those that are equal to it. Points that are not numbers are equal to none.
std::vector<int> first_equals(const std::vector<Point>& points) {
  std::vector<std::pair<std::uint64_t, int>> order(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) order[v] = {hash(points[v]), int(v)};
  std::sort(order.begin(), order.end());
  std::vector<int> first(points.size());
  for (std::size_t i = 0, begin = 0; i < order.size(); ++i) {
    if (order[i].first != order[begin].first) begin = i;
    const int v = order[i].second;
    first[v] = v;
    for (std::size_t j = begin; j < i && first[v] == v; ++j)
      if (points[order[j].second] == points[v]) first[v] = order[j].second;
  }
  return first;
}

// Takes the triangles that are usable and finite.
void take_triangles(Input_surface& input, const std::vector<Triangle>& triangles) {
  const std::vector<Point>& points = input.points();
  input.triangles.reserve(triangles.size());
  input.index.reserve(triangles.size());
  std::vector<char> finite(points.size());
  for (std::size_t v = 0; v < finite.size(); ++v) finite[v] = points[v].allFinite();
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    if (!input.topology.usable[f] || !finite[t[0]] || !finite[t[1]] || !finite[t[2]]) continue;
    input.triangles.push_back(t);
    input.index.push_back(int(f));
  }
}

} // namespace

Input_surface read_input(const Triangle_surface& surface) {
  Input_surface input{surface, analyse(surface.triangles, int(surface.points.size()), Fans::single), {}, {}};
  take_triangles(input, surface.triangles);
  return input;
}

Input_surface read_soup(const Triangle_surface& surface) {
  const std::vector<int> first = first_equals(surface.points);
  const int n = int(first.size());
  std::vector<Triangle> triangles = surface.triangles;
  for (Triangle& t : triangles)
    for (int& v : t)
      if (v >= 0 && v < n) v = first[v];
  Input_surface input{surface, analyse(triangles, n, Fans::single), {}, {}};
  take_triangles(input, triangles);
  return input;
}

std::vector<Input_sample> sample_triangles(const Input_surface& input, int per_component) {
  const std::vector<Point>& points = input.points();
  std::vector<int> seen(input.topology.components.size(), 0);
  std::vector<Input_sample> samples;
  for (const Triangle& t : input.triangles) {
    const int component = input.topology.component[t[0]];
    const int faces = input.topology.components[component].faces;
    const int stride = per_component > 0 ? (faces + per_component - 1) / per_component : 1;
    if (seen[component]++ % stride != 0) continue;
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    samples.push_back({(a + b + c) / 3, 0.5 * stride * (b - a).cross(c - a), t[0]});
  }
  return samples;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
