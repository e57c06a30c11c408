// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/snap_to_features.h>

#include <CGAL/Reeb_quadrangulation/internal/compatibility.h>
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include "feature_lines.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Kernel = Simple_cartesian<double>;
using Segment = Kernel::Segment_3;
using Segments = std::vector<Segment>;
using Primitive = internal::Aabb_segment_primitive<Kernel, Segments::const_iterator>;
using Tree = AABB_tree<internal::Aabb_traits<Kernel, Primitive>>;

Kernel::Point_3 to_kernel(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

// Where a vertex is to go, and how far that is in units of its shortest edge.
struct Wish {
  double distance;
  int vertex;
  Point target;
};

class Snapper {
public:
  Snapper(Quad_mesh& mesh, const Surface_projector& projector, const Snap_options& options,
          std::vector<char>& fixed)
      : m_mesh(mesh), m_projector(projector), m_input(projector.surface()), m_options(options),
        m_fixed(fixed), m_quads_of(mesh.points.size()), m_shortest(mesh.points.size(), 1e300),
        m_on_boundary(mesh.points.size(), 0) {
    m_fixed.resize(mesh.points.size(), 0);
    for (int q = 0; q < int(mesh.quads.size()); ++q)
      for (int i = 0; i < 4; ++i) {
        const int a = mesh.quads[q][i], b = mesh.quads[q][(i + 1) % 4];
        m_quads_of[a].push_back(q);
        const double length = (mesh.points[b] - mesh.points[a]).norm();
        m_shortest[a] = std::min(m_shortest[a], length);
        m_shortest[b] = std::min(m_shortest[b], length);
        m_mean_edge += length / (4.0 * double(mesh.quads.size()));
      }
    mark_boundary();
  }

  Snap_report run(const Feature_edges& features) {
    collect(features);
    if (!m_segments.empty()) {
      snap_corners();
      snap_edges();
    }
    return m_report;
  }

private:
  // A vertex inside has as many edges as quads around it; on the boundary it has one more.
  void mark_boundary() {
    for (std::size_t v = 0; v < m_quads_of.size(); ++v) {
      std::vector<int> neighbours;
      for (int q : m_quads_of[v]) {
        const Quad& quad = m_mesh.quads[q];
        const int i = int(std::find(quad.begin(), quad.end(), int(v)) - quad.begin());
        neighbours.push_back(quad[(i + 1) % 4]);
        neighbours.push_back(quad[(i + 3) % 4]);
      }
      std::sort(neighbours.begin(), neighbours.end());
      const std::size_t edges = std::unique(neighbours.begin(), neighbours.end()) - neighbours.begin();
      m_on_boundary[v] = edges != m_quads_of[v].size();
    }
  }

  void collect(const Feature_edges& features) {
    std::vector<char> on_kept(m_input.number_of_vertices(), 0);
    for (const Feature_chain& chain : features.chains) {
      if (chain.boundary) continue;
      double length = 0;
      for (int h : chain.halfedges)
        length += (m_input.points[m_input.target(h)] - m_input.points[m_input.source(h)]).norm();
      if (length < m_options.shortest_chain * m_mean_edge) continue;
      internal::Feature_curve curve{{m_input.points[m_input.source(chain.halfedges[0])]}, {0}, chain.closed};
      for (int h : chain.halfedges) {
        const Point p = curve.points.back(), q = m_input.points[m_input.target(h)];
        on_kept[m_input.source(h)] = on_kept[m_input.target(h)] = 1;
        if (p == q) continue;
        m_segments.emplace_back(to_kernel(p), to_kernel(q));
        m_places.push_back({int(m_curves.size()), int(curve.arc.size()) - 1});
        curve.points.push_back(q);
        curve.arc.push_back(curve.arc.back() + (q - p).norm());
      }
      if (curve.points.size() > 1) m_curves.push_back(std::move(curve));
    }
    for (int v : features.corners)
      if (on_kept[v]) m_corners.push_back(m_input.points[v]);
  }

  bool worst_allows(int v, const Point& target) const {
    for (int q : m_quads_of[v]) {
      std::array<Point, 4> before, after;
      for (int i = 0; i < 4; ++i) {
        before[i] = m_mesh.points[m_mesh.quads[q][i]];
        after[i] = m_mesh.quads[q][i] == v ? target : before[i];
      }
      const double new_value = scaled_jacobian(after[0], after[1], after[2], after[3]);
      if (new_value >= m_options.worst_jacobian) continue;
      if (new_value <= 0 || new_value < scaled_jacobian(before[0], before[1], before[2], before[3]))
        return false;
    }
    return true;
  }

  // Nearest first, so that of two candidates the better one is taken and bounds the other by its quads.
  int grant(std::vector<Wish>& wishes) {
    std::sort(wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.vertex < b.vertex;
    });
    int granted = 0;
    for (const Wish& wish : wishes) {
      if (m_fixed[wish.vertex] || !worst_allows(wish.vertex, wish.target)) continue;
      m_mesh.points[wish.vertex] = wish.target;
      m_fixed[wish.vertex] = 1;
      ++granted;
    }
    return granted;
  }

  void snap_corners() {
    std::vector<Segment> edges; // of the quad mesh, to find the vertices near a corner
    std::vector<int> from;
    for (const Quad& quad : m_mesh.quads)
      for (int i = 0; i < 4; ++i) {
        const int a = quad[i], b = quad[(i + 1) % 4];
        if (a > b || m_mesh.points[a] == m_mesh.points[b]) continue;
        edges.emplace_back(to_kernel(m_mesh.points[a]), to_kernel(m_mesh.points[b]));
        from.push_back(a);
        from.push_back(b);
      }
    const Segments& list = edges;
    Tree tree(list.begin(), list.end());
    for (const Point& corner : m_corners) {
      const auto nearest = tree.closest_point_and_primitive(to_kernel(corner));
      const std::size_t e = nearest.second - list.begin();
      std::vector<Wish> wishes;
      for (int v : {from[2 * e], from[2 * e + 1]}) {
        const double distance = (m_mesh.points[v] - corner).norm() / m_shortest[v];
        if (!m_on_boundary[v] && distance <= 1.2 * m_options.reach) wishes.push_back({distance, v, corner});
      }
      if (wishes.size() == 2 && wishes[1].distance < wishes[0].distance) std::swap(wishes[0], wishes[1]);
      bool taken = false;
      for (std::size_t i = 0; i < wishes.size() && !taken; ++i) {
        std::vector<Wish> one{wishes[i]};
        taken = grant(one) == 1;
      }
      ++(taken ? m_report.corners : m_report.missed_corners);
    }
  }

  void snap_edges() {
    const Segments& list = m_segments;
    Tree tree(list.begin(), list.end());
    if (m_options.lines) lay_lines(tree);
    std::vector<Wish> wishes;
    for (int v = 0; v < int(m_mesh.points.size()); ++v) {
      if (m_fixed[v] || m_on_boundary[v] || m_quads_of[v].empty()) continue;
      const Kernel::Point_3 p = tree.closest_point(to_kernel(m_mesh.points[v]));
      const Point target(p.x(), p.y(), p.z());
      const double distance = (m_mesh.points[v] - target).norm() / m_shortest[v];
      if (distance <= m_options.reach) wishes.push_back({distance, v, target});
    }
    m_report.vertices = m_report.on_lines + grant(wishes);
  }

  void lay_lines(const Tree& tree) {
    std::vector<internal::Feature_seed> seeds;
    for (int v = 0; v < int(m_mesh.points.size()); ++v) {
      if (m_quads_of[v].empty()) continue;
      const auto found = tree.closest_point_and_primitive(to_kernel(m_mesh.points[v]));
      const auto [curve, segment] = m_places[std::size_t(found.second - m_segments.cbegin())];
      const Point p(found.first.x(), found.first.y(), found.first.z());
      const internal::Feature_curve& c = m_curves[curve];
      seeds.push_back({v, curve, c.arc[segment] + (p - c.points[segment]).norm()});
    }
    m_report.on_lines =
        internal::lay_lines_on_features(m_mesh, m_projector, m_curves, seeds, m_options, m_fixed);
  }

  Quad_mesh& m_mesh;
  const Surface_projector& m_projector;
  const Triangle_surface& m_input;
  const Snap_options& m_options;
  std::vector<char>& m_fixed;
  std::vector<std::vector<int>> m_quads_of;
  std::vector<double> m_shortest;
  std::vector<char> m_on_boundary;
  double m_mean_edge = 0;
  Segments m_segments;
  std::vector<std::pair<int, int>> m_places; ///< per segment: its curve, and which one of that it is
  std::vector<internal::Feature_curve> m_curves;
  std::vector<Point> m_corners;
  Snap_report m_report;
};

} // namespace

Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector, const Snap_options& options,
                             std::vector<char>& fixed) {
  return snap_to_features(mesh, projector, feature_edges(projector.surface(), options.feature_angle), options,
                          fixed);
}

Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector,
                             const Feature_edges& features, const Snap_options& options,
                             std::vector<char>& fixed) {
  return Snapper(mesh, projector, options, fixed).run(features);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
