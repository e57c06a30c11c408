// SPDX-License-Identifier: GPL-3.0-or-later
// Segments among which the nearest to a point is found.
#ifndef REEBQUAD_BASE_SEGMENT_TREE_H
#define REEBQUAD_BASE_SEGMENT_TREE_H

#include "base/compatibility.h"

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

class Segment_tree {
  using Kernel = Simple_cartesian<double>;
  using Segments = std::vector<Kernel::Segment_3>;
  using Primitive = Aabb_segment_primitive<Kernel, Segments::const_iterator>;

public:
  struct Nearest {
    Point point = Point::Zero();
    double squared_distance = 0;
    std::size_t segment = 0; ///< in the order in which they were added
  };

  /// \pre before `build()`
  void add(const Point& a, const Point& b) { m_segments.emplace_back(to_kernel(a), to_kernel(b)); }
  void build() {
    m_tree.rebuild(m_segments.cbegin(), m_segments.cend());
    if (!m_segments.empty()) m_tree.accelerate_distance_queries();
  }

  bool empty() const { return m_segments.empty(); }

  /// \pre the tree is built and not empty, here and below
  Nearest nearest(const Point& p) const {
    const Kernel::Point_3 query = to_kernel(p);
    const auto found = m_tree.closest_point_and_primitive(query);
    return {Point(found.first.x(), found.first.y(), found.first.z()),
            CGAL::squared_distance(found.first, query), std::size_t(found.second - m_segments.cbegin())};
  }
  double squared_distance(const Point& p) const { return m_tree.squared_distance(to_kernel(p)); }
  double squared_length(std::size_t segment) const { return m_segments[segment].squared_length(); }

private:
  static Kernel::Point_3 to_kernel(const Point& p) { return {p.x(), p.y(), p.z()}; }

  Segments m_segments;
  AABB_tree<Aabb_traits<Kernel, Primitive>> m_tree;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_SEGMENT_TREE_H
