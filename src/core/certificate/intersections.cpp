// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 exact(const Point& p) {
  return Kernel::Point_3(p.x(), p.y(), p.z());
}

// Nearly all pairs are apart, and exact predicates are slow just where surfaces are flat. So a plane that
// separates a pair is tried first: for any direction at all, if the computed extents along it differ by more
// than the rounding error, the pair is apart. The differences p - origin and the three products and two sums
// of the dot product each add a relative error of 2^-53, so 8 times that, times |d| |p - origin|, bounds the
// error; 1e-14 leaves a factor of ten.
constexpr double rounding = 1e-14;

// The corners of a triangle; where two triangles share vertices, these come first and in the same order.
struct Corners {
  Point p[3];
};

bool is_apart_along(const Point& direction, const Corners& s, const Corners& t, const Point& origin,
                    bool shared_origin) {
  double greatest = -std::numeric_limits<double>::infinity(), least = -greatest, size = 0;
  for (int i = shared_origin ? 1 : 0; i < 3; ++i) {
    const Point a = s.p[i] - origin, b = t.p[i] - origin;
    greatest = std::max(greatest, direction.dot(a));
    least = std::min(least, direction.dot(b));
    size = std::max({size, a.squaredNorm(), b.squaredNorm()});
  }
  const double squared = size * direction.squaredNorm();
  if (!(squared > 1e-200 && squared < 1e200))
    return false; // the bound does not hold near under- and overflow
  const double margin = rounding * std::sqrt(squared);
  // At a shared origin both sides must keep clear of the plane through it.
  return shared_origin ? greatest < -margin && least > margin : least - greatest > 2 * margin;
}

bool are_clearly_apart(const Corners& s, const Corners& t) {
  const Point ns = (s.p[1] - s.p[0]).cross(s.p[2] - s.p[0]), nt = (t.p[1] - t.p[0]).cross(t.p[2] - t.p[0]);
  const auto apart = [&](const Point& d) {
    return is_apart_along(d, s, t, s.p[0], false) || is_apart_along(-d, s, t, s.p[0], false);
  };
  if (apart(ns) || apart(nt)) return true;
  for (int i = 0; i < 3; ++i)
    if (apart(ns.cross(s.p[(i + 1) % 3] - s.p[i])) || apart(nt.cross(t.p[(i + 1) % 3] - t.p[i]))) return true;
  return false;
}

// Both triangles begin with the shared vertex.
bool are_clearly_apart_beyond_vertex(const Corners& s, const Corners& t) {
  const Point v = s.p[0];
  const auto middle = [&](const Corners& c) -> Point {
    return (c.p[1] - v).normalized() + (c.p[2] - v).normalized();
  };
  const Point direction = middle(t) - middle(s);
  return is_apart_along(direction, s, t, v, true);
}

// Both triangles begin with the shared edge. They overlap only if they lie in one plane and on one side of
// the edge; then they also do so in every projection.
bool are_clearly_apart_beyond_edge(const Corners& s, const Corners& t) {
  const Point edge = s.p[1] - s.p[0], a = s.p[2] - s.p[0], b = t.p[2] - s.p[0];
  const Point na = edge.cross(a), nb = edge.cross(b);
  const double margin = rounding * edge.norm() * std::max(a.norm(), b.norm());
  if (!(margin > 1e-200 && margin < 1e200)) return false;
  for (int i = 0; i < 3; ++i)
    if ((na[i] > margin && nb[i] < -margin) || (na[i] < -margin && nb[i] > margin)) return true;
  return false;
}

bool overlap_at_edge(const Corners& s, const Corners& t) {
  if (are_clearly_apart_beyond_edge(s, t)) return false;
  const auto p = exact(s.p[0]), q = exact(s.p[1]), a = exact(s.p[2]), b = exact(t.p[2]);
  return CGAL::orientation(p, q, a, b) == CGAL::COPLANAR &&
         CGAL::coplanar_orientation(p, q, a, b) == CGAL::POSITIVE;
}

// Two triangles with one common vertex meet elsewhere only if the far side of one of them meets the other.
bool overlap_at_vertex(const Corners& s, const Corners& t) {
  if (are_clearly_apart_beyond_vertex(s, t)) return false;
  const Kernel::Triangle_3 ks(exact(s.p[0]), exact(s.p[1]), exact(s.p[2])),
      kt(exact(t.p[0]), exact(t.p[1]), exact(t.p[2]));
  return CGAL::do_intersect(Kernel::Segment_3(ks[1], ks[2]), kt) ||
         CGAL::do_intersect(Kernel::Segment_3(kt[1], kt[2]), ks);
}

bool meet(const Corners& s, const Corners& t) {
  if (are_clearly_apart(s, t)) return false;
  return CGAL::do_intersect(Kernel::Triangle_3(exact(s.p[0]), exact(s.p[1]), exact(s.p[2])),
                            Kernel::Triangle_3(exact(t.p[0]), exact(t.p[1]), exact(t.p[2])));
}

// Whether two triangles meet in more than their common vertices; both have an area.
bool meet_beyond_shared(const std::vector<Point>& points, Triangle s, Triangle t) {
  int shared = 0;
  for (int i = 0; i < 3; ++i) {
    const auto found = std::find(t.begin() + shared, t.end(), s[i]);
    if (found == t.end()) continue;
    std::swap(s[shared], s[i]);
    std::swap(t[shared], *found);
    ++shared;
  }
  const Corners cs{{points[s[0]], points[s[1]], points[s[2]]}},
      ct{{points[t[0]], points[t[1]], points[t[2]]}};
  switch (shared) {
  case 0: return meet(cs, ct);
  case 1: return overlap_at_vertex(cs, ct);
  case 2: return overlap_at_edge(cs, ct);
  default: return true;
  }
}

std::vector<char> triangles_with_area(const std::vector<Point>& points,
                                      const std::vector<Triangle>& triangles) {
  std::vector<char> result(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    result[i] = !CGAL::collinear(exact(points[t[0]]), exact(points[t[1]]), exact(points[t[2]]));
  }
  return result;
}

// `part_of` gives each triangle the quad that it is a part of.
template <class Part_of>
std::optional<std::vector<std::pair<int, int>>>
intersecting(const std::vector<Point>& points, const std::vector<Triangle>& triangles, const Part_of& part_of,
             const Triangle_tree& tree, int limit, const Observer* observer) {
  const std::vector<char> has_area = triangles_with_area(points, triangles);
  std::set<std::pair<int, int>> found;
  for (int i = 0; i < int(triangles.size()) && int(found.size()) < limit; ++i) {
    if (i % 256 == 0 && observer && observer->cancelled()) return std::nullopt;
    if (!has_area[i]) continue;
    tree.for_boxes_meeting(i, [&](int j) {
      if (!has_area[j] || part_of(i) == part_of(j) || int(found.size()) >= limit) return;
      const std::pair<int, int> pair{part_of(i), part_of(j)}; // the quads ascend with their triangles
      if (found.count(pair) == 0 && meet_beyond_shared(points, triangles[i], triangles[j]))
        found.insert(pair);
    });
  }
  return std::vector<std::pair<int, int>>(found.begin(), found.end());
}

} // namespace

std::optional<std::vector<std::pair<int, int>>> intersecting_quads(const std::vector<Point>& points,
                                                                   const Split_quads& split,
                                                                   const Triangle_tree& tree, int limit,
                                                                   const Observer* observer) {
  return intersecting(
      points, split.triangles, [&](int t) { return split.quad[t]; }, tree, limit, observer);
}

std::optional<std::vector<std::pair<int, int>>> intersecting_triangles(const std::vector<Point>& points,
                                                                       const std::vector<Triangle>& triangles,
                                                                       const Triangle_tree& tree, int limit,
                                                                       const Observer* observer) {
  return intersecting(
      points, triangles, [](int t) { return t; }, tree, limit, observer);
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
