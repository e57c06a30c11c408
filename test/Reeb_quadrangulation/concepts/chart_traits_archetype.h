// SPDX-License-Identifier: GPL-3.0-or-later
// A model of ReebChartTraits that has what the concept lists and nothing else.
#ifndef REEBQUAD_TEST_CHART_TRAITS_ARCHETYPE_H
#define REEBQUAD_TEST_CHART_TRAITS_ARCHETYPE_H

#include <CGAL/Reeb_quadrangulation/Atlas.h>

namespace archetype {

class Chart_traits {
public:
  class FT { // neither default constructible nor assignable, without arithmetic
  public:
    explicit FT(int value) : m_value(value) {}
    FT(const FT&) = default;
    FT& operator=(const FT&) = delete;
    explicit operator double() const { return m_value; }

  private:
    int m_value;
  };
  class Edge_weight {
  public:
    Edge_weight(int interior, int border) : m_interior(interior), m_border(border) {}
    Edge_weight& operator=(const Edge_weight&) = delete;
    Edge_weight(const Edge_weight&) = default;
    FT operator()(const CGAL::Reeb_quadrangulation::Triangle_surface& mesh, int halfedge) const {
      return FT(mesh.is_boundary(halfedge) ? m_border : m_interior);
    }

  private:
    int m_interior, m_border;
  };

  explicit Chart_traits(int interior) : m_interior(interior) {}
  Chart_traits& operator=(const Chart_traits&) = delete;
  Chart_traits(const Chart_traits&) = default;
  Edge_weight edge_weight_object(const CGAL::Reeb_quadrangulation::Chart&) const {
    return Edge_weight(m_interior, 1);
  }

private:
  int m_interior;
};

} // namespace archetype

#endif // REEBQUAD_TEST_CHART_TRAITS_ARCHETYPE_H
