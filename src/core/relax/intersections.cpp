// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/relax_state.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

Kernel::Point_3 exact(const Point& p) {
  return Kernel::Point_3(p.x(), p.y(), p.z());
}

// The two triangles of a quad, cut along its shorter diagonal.
std::array<Triangle, 2> halves(const Quad_mesh& mesh, int q) {
  const Quad& v = mesh.quads[q];
  const double d02 = (mesh.points[v[0]] - mesh.points[v[2]]).squaredNorm();
  const double d13 = (mesh.points[v[1]] - mesh.points[v[3]]).squaredNorm();
  if (d02 < d13 || (d02 == d13 && std::min(v[0], v[2]) < std::min(v[1], v[3])))
    return {Triangle{v[0], v[1], v[2]}, Triangle{v[0], v[2], v[3]}};
  return {Triangle{v[0], v[1], v[3]}, Triangle{v[1], v[2], v[3]}};
}

// Whether the corners of b that are not its first `shared` ones lie clearly on one side of the plane of a.
bool on_one_side(const std::array<Point, 3>& a, const std::array<Point, 3>& b, int shared) {
  const Point n = (a[1] - a[0]).cross(a[2] - a[0]);
  double low = 0, high = 0, size = 0;
  for (int i = shared; i < 3; ++i) {
    const Point d = b[i] - a[0];
    const double height = n.dot(d);
    low = i == shared ? height : std::min(low, height);
    high = i == shared ? height : std::max(high, height);
    size = std::max(size, d.squaredNorm());
  }
  const double margin = 1e-12 * std::sqrt(size * n.squaredNorm()); // far above the rounding of four products
  return low > margin || high < -margin;
}

// Whether two triangles meet in more than their common corners.
bool meet(const std::vector<Point>& points, Triangle s, Triangle t) {
  int shared = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = shared; j < 3; ++j)
      if (s[i] == t[j]) {
        std::swap(s[i], s[shared]);
        std::swap(t[j], t[shared]);
        ++shared;
        break;
      }
  if (shared == 3) return true;
  std::array<Point, 3> a, b;
  for (int i = 0; i < 3; ++i) {
    a[i] = points[s[i]];
    b[i] = points[t[i]];
  }
  if (on_one_side(a, b, shared) || on_one_side(b, a, shared)) return false;
  const auto p = exact(a[0]), q = exact(a[1]), r = exact(a[2]), u = exact(b[0]), v = exact(b[1]),
             w = exact(b[2]);
  if (CGAL::collinear(p, q, r) || CGAL::collinear(u, v, w)) return false; // an inverted quad already
  if (shared == 2)
    return CGAL::coplanar(p, q, r, w) && CGAL::coplanar_orientation(p, q, r, w) == CGAL::POSITIVE;
  const Kernel::Triangle_3 first(p, q, r), second(u, v, w);
  if (shared == 0) return CGAL::do_intersect(first, second);
  return CGAL::do_intersect(Kernel::Segment_3(q, r), second) ||
         CGAL::do_intersect(Kernel::Segment_3(v, w), first);
}

} // namespace

bool quads_meet(const Quad_mesh& mesh, int i, int j) {
  for (const Triangle& s : halves(mesh, i))
    for (const Triangle& t : halves(mesh, j))
      if (meet(mesh.points, s, t)) return true;
  return false;
}

std::vector<std::pair<int, int>> intersecting_quads(const Quad_mesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.quads.size());
  for (int q = 0; q < int(mesh.quads.size()); ++q) {
    Point low = mesh.points[mesh.quads[q][0]], high = low;
    for (int v : mesh.quads[q]) {
      low = low.cwiseMin(mesh.points[v]);
      high = high.cwiseMax(mesh.points[v]);
    }
    boxes.emplace_back(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), q);
  }
  std::vector<std::pair<int, int>> found;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const std::pair<int, int> pair = std::minmax(a.info(), b.info());
    if (quads_meet(mesh, pair.first, pair.second)) found.push_back(pair);
  });
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL
