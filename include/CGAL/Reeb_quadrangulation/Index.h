// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_INDEX_H
#define CGAL_REEB_QUADRANGULATION_INDEX_H

namespace CGAL {
namespace Reeb_quadrangulation {

/// An index that says what it is an index of, for functions that take several: it becomes an `int` unasked,
/// but neither an `int` nor the index of something else becomes one.
template <class Tag> class Index {
public:
  explicit constexpr Index(int value) : m_value(value) {}
  constexpr operator int() const { return m_value; }

private:
  int m_value;
};

/// Of a contour edge: `Contour_network::edges`.
using Contour_id = Index<struct Contour_tag>;
/// Of a node: `Contour_network::nodes`.
using Node_id = Index<struct Node_tag>;
/// Of a chart in its atlas, which is not its identity for life, `Design_chart::id`.
using Chart_index = Index<struct Chart_tag>;
/// Of a vertex of the surface.
using Vertex_index = Index<struct Vertex_tag>;
/// Of a halfedge of the surface.
using Halfedge_index = Index<struct Halfedge_tag>;
/// A vertex's place in a `Vertex_order`.
using Rank = Index<struct Rank_tag>;

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_INDEX_H
