// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/outward.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

constexpr double clear_cosine = 0.2; // quads that stand across a sample say nothing of its side

class Facing_comparison {
public:
  Facing_comparison(const Quad_mesh& mesh, const Soup_topology& topology, const Split_quads& split,
                    const Triangle_tree& tree, const Input_surface& input)
      : m_mesh(mesh), m_topology(topology), m_split(split), m_tree(tree), m_input(input),
        m_facing(topology.components.size()), m_source(topology.components.size(), -1) {
    for (const Triangle& t : input.triangles)
      for (int v : t) m_box.extend(input.points()[v]);
  }

  std::vector<Facing> run(int per_component) {
    int last = -1;
    for (const Input_sample& sample : sample_triangles(m_input, per_component)) last = compare(sample, last);
    for (std::size_t c = 0; c < m_facing.size(); ++c) decide(int(c));
    return m_facing;
  }

private:
  Point vector_area_of(int triangle) const { return vector_area(corners(m_mesh, m_split.quad[triangle])); }

  int component_of(int triangle) const {
    return m_topology.component[m_mesh.quads[m_split.quad[triangle]][0]];
  }

  int compare(const Input_sample& sample, int last) {
    const Triangle_tree::Nearest near = m_tree.nearest(sample.centre, last);
    const int c = component_of(near.triangle);
    m_source[c] = m_input.topology.component[sample.vertex];
    const double area = sample.vector_area.norm(), size = vector_area_of(near.triangle).norm();
    if (!(area > 0) || near.squared_distance > size) return near.triangle;
    const Point normal = sample.vector_area / area;
    const double side = cosine(normal, near.triangle);
    if (std::abs(side) < clear_cosine) return near.triangle;
    // Within twice the distance, and what points may be off by rounding and mending.
    const double reach = 2 * std::sqrt(near.squared_distance) + 1e-7 * m_box.diagonal().norm();
    const bool both = m_tree.any_within(sample.centre, reach * reach, [&](int t) {
      const double other = cosine(normal, t);
      return std::abs(other) >= clear_cosine && (other > 0) != (side > 0);
    });
    Facing& facing = m_facing[c];
    (both ? facing.undecided : side > 0 ? facing.agreeing : facing.opposed) += area;
    return near.triangle;
  }

  double cosine(const Point& normal, int triangle) const {
    return normal.dot(vector_area_of(triangle).stableNormalized());
  }

  void decide(int c) {
    Facing& facing = m_facing[c];
    const double decided = facing.agreeing + facing.opposed;
    if (decided > 0.05 * (decided + facing.undecided)) {
      facing.is_known = true;
      facing.is_turned = facing.opposed >= facing.agreeing;
      return;
    }
    if (m_source[c] < 0 || m_topology.components[c].boundary_loops > 0 ||
        m_input.topology.components[m_source[c]].boundary_loops > 0)
      return;
    const auto [quads, quad_area] = volume(m_mesh.points, m_split.triangles, m_topology.component, c);
    const auto [input, area] =
        volume(m_input.points(), m_input.triangles, m_input.topology.component, m_source[c]);
    const double least = 1e-14 * m_box.diagonal().norm() * std::max(quad_area, area);
    if (!(std::abs(quads) > least && std::abs(input) > least)) return;
    facing.is_known = true;
    facing.is_turned = (quads > 0) != (input > 0);
  }

  // The signed volume of one component, about the middle of the box, and its area.
  std::pair<double, double> volume(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                                   const std::vector<int>& component, int c) const {
    const Point origin = m_box.center();
    double volume = 0, area = 0;
    for (const Triangle& t : triangles) {
      if (component[t[0]] != c) continue;
      const Point a = points[t[0]] - origin, b = points[t[1]] - origin, d = points[t[2]] - origin;
      const Point normal = (b - a).cross(d - a);
      volume += a.dot(normal) / 6;
      area += normal.norm() / 2;
    }
    return {volume, area};
  }

  const Quad_mesh& m_mesh;
  const Soup_topology& m_topology;
  const Split_quads& m_split;
  const Triangle_tree& m_tree;
  const Input_surface& m_input;
  std::vector<Facing> m_facing;
  std::vector<int> m_source; // a component of the input near each component of the quads
  Eigen::AlignedBox3d m_box;
};

} // namespace

std::vector<Facing> compare_facing(const Quad_mesh& mesh, const Soup_topology& topology,
                                   const Split_quads& split, const Triangle_tree& tree,
                                   const Input_surface& input, int per_component) {
  return Facing_comparison(mesh, topology, split, tree, input).run(per_component);
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
