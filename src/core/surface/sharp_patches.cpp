// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sharp_patches.h"

#include "base/sharp_edge.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// A face of a shape turns at its corners; what turns by less is a curve.
constexpr double corner_turn = 40;

// Corners among which the best four are looked for, one by one.
constexpr std::size_t most_corners = 10;

std::vector<std::vector<int>> flood(const Triangle_surface& s, double angle, std::vector<int>& patch_of) {
  std::vector<Point> normals;
  normals.reserve(std::size_t(s.number_of_faces()));
  for (int f = 0; f < s.number_of_faces(); ++f) normals.push_back(internal::area_normal(s, f));
  const double cosine = internal::cosine_of(angle);
  std::vector<std::vector<int>> patches;
  std::vector<int> stack;
  patch_of.assign(std::size_t(s.number_of_faces()), -1);
  for (int first = 0; first < s.number_of_faces(); ++first) {
    if (patch_of[first] >= 0) continue;
    const int patch = int(patches.size());
    patches.emplace_back();
    patch_of[first] = patch;
    stack.assign(1, first);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      patches.back().push_back(f);
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int g = s.opposite[h] < 0 ? -1 : s.opposite[h] / 3;
        if (g < 0 || patch_of[g] >= 0 || internal::is_sharp(normals[f], normals[g], cosine)) continue;
        patch_of[g] = patch;
        stack.push_back(g);
      }
    }
    std::sort(patches.back().begin(), patches.back().end());
  }
  return patches;
}

// Turning around each target inside the patch, as boundary loops are traced.
Sharp_loop trace(const Triangle_surface& s, const std::vector<char>& is_border, int first,
                 std::vector<char>& seen) {
  Sharp_loop loop;
  std::vector<int> vertices;
  for (int h = first; !seen[h];) {
    seen[h] = 1;
    loop.halfedges.push_back(h);
    vertices.push_back(s.source(h));
    loop.is_simple = loop.is_simple && s.opposite[h] >= 0;
    for (h = Triangle_surface::next(h); !is_border[h]; h = Triangle_surface::next(s.opposite[h])) {
    }
  }
  std::sort(vertices.begin(), vertices.end());
  loop.is_simple = loop.is_simple && loop.halfedges.size() > 2 &&
                   std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
  return loop;
}

// The angle of the patch at the vertex between two halfedges of its border, in degrees.
double inner_angle(const Triangle_surface& s, int in, int out) {
  double sum = 0;
  for (int h = Triangle_surface::next(in);; h = Triangle_surface::next(s.opposite[h])) {
    const Point& p = s.points[s.source(h)];
    const Point a = s.points[s.target(h)] - p, b = s.points[s.source(Triangle_surface::previous(h))] - p;
    sum += std::atan2(a.cross(b).norm(), a.dot(b));
    if (h == out) break;
  }
  return sum * 180 / std::acos(-1.0);
}

double length(const Triangle_surface& s, int h) {
  return (s.points[s.target(h)] - s.points[s.source(h)]).norm();
}

// Adds the vertex nearest to the middle of the longest part between the corners; false if it has none.
bool add_middle(const Triangle_surface& s, const Sharp_loop& loop, std::vector<int>& corners) {
  const std::size_t n = loop.halfedges.size();
  int best = -1;
  double longest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t from = std::size_t(corners[i]);
    std::size_t steps = (std::size_t(corners[(i + 1) % corners.size()]) + n - from) % n;
    if (steps == 0) steps = n;
    std::vector<double> along(1, 0.0);
    for (std::size_t k = 0; k < steps; ++k)
      along.push_back(along.back() + length(s, loop.halfedges[(from + k) % n]));
    if (steps < 2 || along.back() <= longest) continue;
    longest = along.back();
    std::size_t middle = 1;
    for (std::size_t k = 1; k < steps; ++k)
      if (std::abs(along[k] - 0.5 * longest) < std::abs(along[middle] - 0.5 * longest)) middle = k;
    best = int((from + middle) % n);
  }
  if (best < 0) return false;
  corners.insert(std::lower_bound(corners.begin(), corners.end(), best), best);
  return true;
}

} // namespace

std::vector<Sharp_patch> sharp_patches(const Triangle_surface& s, double angle) {
  std::vector<int> patch_of;
  std::vector<std::vector<int>> floods = flood(s, angle, patch_of);
  std::vector<char> is_border(std::size_t(s.number_of_halfedges()), 0), seen(is_border.size(), 0);
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    is_border[h] = s.opposite[h] < 0 || patch_of[s.opposite[h] / 3] != patch_of[h / 3];
  std::vector<Sharp_patch> patches(floods.size());
  for (std::size_t p = 0; p < floods.size(); ++p) patches[p].faces = std::move(floods[p]);
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    if (is_border[h] && !seen[h]) patches[patch_of[h / 3]].loops.push_back(trace(s, is_border, h, seen));
  return patches;
}

std::vector<int> turns_of(const Triangle_surface& s, const Sharp_loop& loop, double turn, bool inward) {
  std::vector<int> turns;
  const std::size_t n = loop.halfedges.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = inner_angle(s, loop.halfedges[(i + n - 1) % n], loop.halfedges[i]);
    if (angle < 180 - turn || (!inward && angle > 180 + turn)) turns.push_back(int(i));
  }
  return turns;
}

std::vector<int> rectangle_in(const Triangle_surface& s, const Sharp_loop& loop) {
  std::vector<int> corners = turns_of(s, loop, corner_turn, true);
  if (corners.empty() || corners.size() > most_corners) return {};
  while (corners.size() < 4)
    if (!add_middle(s, loop, corners)) return {};
  const auto at = [&](std::size_t i) { return s.points[s.source(loop.halfedges[std::size_t(corners[i])])]; };
  std::vector<int> best;
  double largest = -1;
  const std::size_t n = corners.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c)
        for (std::size_t d = c + 1; d < n; ++d) {
          const double area = Point(at(c) - at(a)).cross(Point(at(d) - at(b))).norm();
          if (area <= largest * (1 + 1e-9)) continue;
          largest = area;
          best = {corners[a], corners[b], corners[c], corners[d]};
        }
  return best;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
