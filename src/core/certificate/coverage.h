// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_COVERAGE_H
#define REEBQUAD_CERTIFICATE_COVERAGE_H

#include "certificate/geometry.h"
#include "certificate/input_surface.h"
#include "certificate/tree.h"

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// Which quad is nearest to a point; from one point to the next near it is quickest. Refers to all that it is
/// made of.
class Nearest_quad {
public:
  Nearest_quad(const Quad_mesh& mesh, const Split_quads& split, const Triangle_tree& tree)
      : m_mesh(mesh), m_split(split), m_tree(tree) {}

  bool empty() const { return m_tree.empty(); }
  Quad_corners operator()(const Point& p) {
    m_last = m_tree.nearest(p, m_last).triangle;
    return corners(m_mesh, m_split.quad[m_last]);
  }

private:
  const Quad_mesh& m_mesh;
  const Split_quads& m_split;
  const Triangle_tree& m_tree;
  int m_last = -1;
};

/// The parts of the sharp edges' length that edges of quads run along, and edges or first diagonals; see
/// `Mesh_statistics`.
struct Covered_edges {
  double by_edges = 0, by_triangles = 0;
};

/// Nothing if the sharp edges have no length. `mean_edge` is of the quads.
std::optional<Covered_edges> covered_sharp_edges(Nearest_quad& nearest, const std::vector<Point>& points,
                                                 const std::vector<std::pair<int, int>>& sharp,
                                                 double mean_edge);

/// Whether a quad has a corner within a tenth of its mean edge of a point.
bool has_vertex_at(const Quad_corners& quad, const Point& at);

/// Edges of the quads that are so marked, each once.
std::vector<std::pair<int, int>> edges_of(const Quad_mesh& mesh, const std::vector<char>& usable);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_COVERAGE_H
