// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/nesting.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

bool is_closed(const Triangle_surface& surface) {
  return std::find(surface.opposite.begin(), surface.opposite.end(), -1) == surface.opposite.end();
}

double signed_volume(const Triangle_surface& surface) {
  if (surface.points.empty()) return 0;
  // From a corner, so that a far origin does not spoil it.
  const Point origin = surface.points[0];
  double sum = 0;
  for (const Triangle& t : surface.triangles)
    sum += (surface.points[t[0]] - origin)
               .dot((surface.points[t[1]] - origin).cross(surface.points[t[2]] - origin));
  return sum / 6;
}

namespace {

using Kernel = Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 flat(const Point& p) {
  return Kernel::Point_2(p[0], p[1]);
}

Kernel::Point_3 kernel_point(const Point& p) {
  return Kernel::Point_3(p[0], p[1], p[2]);
}

/// Tells what lies in one closed component, by counting the triangles above a point. All decisions are exact;
/// where the line upward meets an edge or a vertex, the point is thought to be moved a little along x, and
/// less along y. (CGAL's Side_of_triangle_mesh does not come to an end where triangles have no area.)
class Interior {
public:
  explicit Interior(const Triangle_surface& surface) : m_surface(surface) {
    for (const Point& p : surface.points) m_box.extend(p);
    m_rows = std::clamp(int(std::sqrt(double(surface.number_of_faces()))), 1, 256);
    // Counted, then filled: the triangles whose extent along y meets a row.
    m_begin.assign(std::size_t(m_rows) + 1, 0);
    for (const bool fill : {false, true}) {
      std::vector<int> end(m_begin.begin(), m_begin.end() - 1);
      for (int f = 0; f < surface.number_of_faces(); ++f)
        for (int r = row(lowest(f, 1)); r <= row(-lowest(f, 1, -1)); ++r)
          if (fill)
            m_triangles[std::size_t(end[std::size_t(r)]++)] = f;
          else
            ++m_begin[std::size_t(r) + 1];
      if (fill) break;
      std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
      m_triangles.resize(std::size_t(m_begin.back()));
    }
  }

  /// Of up to four vertices that do not lie on the surface, all are inside, and there is one.
  bool contains(const Triangle_surface& inner) const {
    const std::size_t n = inner.points.size(), asked = std::min<std::size_t>(n, 16);
    int inside = 0;
    for (std::size_t i = 0; i < asked && inside < 4; ++i) {
      const int side = side_of(inner.points[i * n / asked]);
      if (side < 0) return false;
      inside += side;
    }
    return inside > 0;
  }

private:
  const Point& corner(int f, int i) const { return m_surface.points[m_surface.triangles[f][i]]; }

  double lowest(int f, int axis, double sign = 1) const {
    return std::min({sign * corner(f, 0)[axis], sign * corner(f, 1)[axis], sign * corner(f, 2)[axis]});
  }

  int row(double y) const {
    const double height = m_box.sizes()[1];
    return height > 0 ? std::clamp(int(m_rows * ((y - m_box.min()[1]) / height)), 0, m_rows - 1) : 0;
  }

  /// 1 inside, -1 outside, 0 on a plane of a triangle above or below, where nothing is said.
  int side_of(const Point& q) const {
    if (!m_box.contains(q)) return -1;
    const std::size_t r = std::size_t(row(q[1]));
    bool inside = false;
    for (int i = m_begin[r]; i < m_begin[r + 1]; ++i) {
      const int f = m_triangles[std::size_t(i)];
      if (lowest(f, 0) > q[0] || -lowest(f, 0, -1) < q[0] || -lowest(f, 2, -1) < q[2] || !covers(f, q))
        continue;
      const Point &a = corner(f, 0), &b = corner(f, 1), &c = corner(f, 2);
      const int up = orientation(flat(a), flat(b), flat(c));
      const int above = orientation(kernel_point(a), kernel_point(b), kernel_point(c), kernel_point(q));
      if (up * above == 0) return 0;
      inside ^= up * above < 0;
    }
    return inside ? 1 : -1;
  }

  /// Whether the triangle seen from above covers the point: an odd number of its sides passes it on the
  /// right.
  bool covers(int f, const Point& q) const {
    bool odd = false;
    for (int i = 0; i < 3; ++i) {
      const Point &a = corner(f, i), &b = corner(f, (i + 1) % 3);
      if ((a[1] <= q[1]) == (b[1] <= q[1])) continue;
      const bool upward = a[1] <= q[1];
      const int side = orientation(flat(a), flat(b), flat(q));
      odd ^= upward ? side > 0 : side < 0; // on the line counts as moved to the right of it
    }
    return odd;
  }

  const Triangle_surface& m_surface;
  Eigen::AlignedBox3d m_box;
  int m_rows = 1;
  std::vector<int> m_begin, m_triangles;
};

} // namespace

std::vector<int> nesting_depths(const std::vector<Mended_component>& components) {
  std::vector<int> depth(components.size(), 0), closed;
  std::vector<Eigen::AlignedBox3d> boxes(components.size());
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (!is_closed(components[c].surface)) continue;
    closed.push_back(int(c));
    for (const Point& p : components[c].surface.points) boxes[c].extend(p);
  }
  const auto left = [&](int c) { return boxes[c].min()[0]; };
  std::sort(closed.begin(), closed.end(),
            [&](int c, int d) { return left(c) != left(d) ? left(c) < left(d) : c < d; });
  for (int outer : closed) {
    const auto begin = std::lower_bound(closed.begin(), closed.end(), left(outer),
                                        [&](int c, double x) { return left(c) < x; });
    std::vector<int> candidates;
    for (auto it = begin; it != closed.end() && left(*it) <= boxes[outer].max()[0]; ++it)
      if (*it != outer && boxes[outer].contains(boxes[*it])) candidates.push_back(*it);
    if (candidates.empty()) continue;
    const Interior interior(components[outer].surface);
    for (int inner : candidates)
      if (interior.contains(components[inner].surface)) ++depth[inner];
  }
  return depth;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
