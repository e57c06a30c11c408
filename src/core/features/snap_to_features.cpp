// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/snap_to_chains.h"

#include "base/compatibility.h"
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include "features/feature_lines.h"
#include "relax/quad_shape.h"

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

// Where a vertex is to go, and how far that is: to an edge in units of its shortest edge, to a corner of its
// mean one.
struct Wish {
  double distance = 0;
  int vertex = -1;
  Point target = Point::Zero();
  int curve = -1; ///< or a corner
  double t = 0;   ///< on the curve
};

class Snapper {
public:
  Snapper(Quad_mesh& mesh, const Surface_projector& projector, const Snap_options& options,
          Vertex_constraints& constraints, const internal::Line_way& lines = {})
      : m_mesh(mesh), m_projector(projector), m_input(projector.surface()), m_options(options),
        m_line_way(lines), m_constraints(constraints), m_given(constraints.fixed), m_held(constraints.fixed),
        m_quads_of(mesh.points.size()), m_shortest(mesh.points.size(), 1e300),
        m_on_boundary(mesh.points.size(), 0), m_normal(mesh.points.size()) {
    m_constraints.fixed.resize(mesh.points.size(), 0);
    m_given.resize(mesh.points.size(), 0);
    m_held.resize(mesh.points.size(), 0);
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

  // Chains whose entry in `is_refused` is nonzero, if it has entries, are none; `points` are corners that
  // count without sharp edges too.
  Snap_report run(const Feature_edges& features, const std::vector<int>& points,
                  const std::vector<char>& is_refused = {}) {
    collect(features, points, is_refused);
    if (!m_segments.empty() || !m_corners.empty()) {
      for (std::size_t v = 0; v < m_normal.size(); ++v)
        m_normal[v] = m_projector.normal(m_projector.closest(m_mesh.points[v]).face);
      if (m_segments.empty()) {
        snap_corners();
      } else {
        const Segments& list = m_segments;
        const Tree tree(list.begin(), list.end());
        if (m_options.lines && m_line_way.first) lay_lines(tree);
        snap_corners();
        snap_edges(tree);
      }
    }
    return m_report;
  }

  const std::vector<int>& chain_of_curve() const { return m_chain_of_curve; }

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

  void collect(const Feature_edges& features, const std::vector<int>& points,
               const std::vector<char>& is_refused) {
    std::vector<char> on_kept(m_input.number_of_vertices(), 0);
    for (int v : points) on_kept[v] = 1;
    for (std::size_t c = 0; c < features.chains.size(); ++c) {
      const Feature_chain& chain = features.chains[c];
      if (chain.boundary || (c < is_refused.size() && is_refused[c])) continue;
      double length = 0;
      for (int h : chain.halfedges)
        length += (m_input.points[m_input.target(h)] - m_input.points[m_input.source(h)]).norm();
      if (length < m_options.shortest_chain * m_mean_edge) continue;
      for (int h : chain.halfedges) on_kept[m_input.source(h)] = on_kept[m_input.target(h)] = 1;
      add_curve(chain);
      m_chain_of_curve.resize(m_constraints.curves.size(), int(c));
    }
    for (int v : features.corners)
      if (on_kept[v]) m_corners.push_back(m_input.points[v]);
  }

  void add_curve(const Feature_chain& chain) {
    std::vector<Point> points{m_input.points[m_input.source(chain.halfedges[0])]};
    std::vector<Point> normals;
    for (int h : chain.halfedges) {
      const Point& p = m_input.points[m_input.target(h)];
      if (p == points.back()) continue;
      points.push_back(p);
      const Point left = m_projector.normal(m_input.face(h)),
                  right = m_projector.normal(m_input.face(m_input.opposite[h]));
      normals.push_back((left + right).stableNormalized());
    }
    if (points.size() < 2) return;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      m_segments.emplace_back(to_kernel(points[i]), to_kernel(points[i + 1]));
      m_segment_of.push_back({int(m_constraints.curves.size()), int(i)});
    }
    m_constraints.curves.push_back(make_surface_curve(points, chain.closed));
    m_constraints.curves.back().normals = std::move(normals);
  }

  bool worst_allows(int v, const Point& target) const {
    for (int q : m_quads_of[v]) {
      std::array<Point, 4> before, after;
      Point outward = Point::Zero();
      for (int i = 0; i < 4; ++i) {
        const int w = m_mesh.quads[q][i];
        before[i] = m_mesh.points[w];
        after[i] = w == v ? target : before[i];
        if (w != v) outward += m_normal[w];
      }
      // No quad may come to face away from the surface.
      const auto facing = [&](const std::array<Point, 4>& x) {
        return (x[2] - x[0]).cross(x[3] - x[1]).dot(outward) > 0;
      };
      if (!facing(after) && facing(before)) return false;
      const double new_value = internal::quad_shape(after[0], after[1], after[2], after[3]);
      if (new_value >= m_options.worst_jacobian) continue;
      if (new_value <= 0 || new_value < internal::quad_shape(before[0], before[1], before[2], before[3]))
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
    for (const Wish& wish : wishes) granted += grant(wish);
    return granted;
  }

  bool grant(const Wish& wish) {
    if (m_held[wish.vertex] || !worst_allows(wish.vertex, wish.target)) return false;
    m_mesh.points[wish.vertex] = wish.target;
    m_held[wish.vertex] = 1;
    if (wish.curve >= 0)
      m_constraints.places.push_back({wish.vertex, wish.curve, wish.t});
    else
      m_constraints.fixed[wish.vertex] = 1;
    return true;
  }

  double mean_edge(int v) const {
    double sum = 0;
    for (int q : m_quads_of[v]) {
      const Quad& quad = m_mesh.quads[q];
      const int i = int(std::find(quad.begin(), quad.end(), v) - quad.begin());
      sum += (m_mesh.points[quad[(i + 1) % 4]] - m_mesh.points[v]).norm() +
             (m_mesh.points[quad[(i + 3) % 4]] - m_mesh.points[v]).norm();
    }
    return sum / (2.0 * double(m_quads_of[v].size()));
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
    const std::vector<Point> taken = held_points();
    for (const Point& corner : m_corners) {
      if (std::find(taken.begin(), taken.end(), corner) != taken.end()) {
        ++m_report.corners; // by a line
        continue;
      }
      const auto nearest = tree.closest_point_and_primitive(to_kernel(corner));
      const std::size_t e = nearest.second - list.begin();
      const std::vector<Wish> wishes = wishes_for(corner, {from[2 * e], from[2 * e + 1]});
      const bool granted =
          std::any_of(wishes.begin(), wishes.end(), [&](const Wish& wish) { return grant(wish); });
      ++(granted ? m_report.corners : m_report.missed_corners);
    }
  }

  std::vector<Point> held_points() const {
    std::vector<Point> points;
    for (std::size_t v = 0; v < m_mesh.points.size(); ++v)
      if (m_constraints.fixed[v]) points.push_back(m_mesh.points[v]);
    return points;
  }

  // The vertices of the quads at the ends of the edge nearest to a corner, the nearest first.
  std::vector<Wish> wishes_for(const Point& corner, const std::array<int, 2>& ends) const {
    std::vector<int> around;
    for (int end : ends)
      for (int q : m_quads_of[end])
        around.insert(around.end(), m_mesh.quads[q].begin(), m_mesh.quads[q].end());
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    std::vector<Wish> wishes;
    for (int v : around) {
      const double distance = (m_mesh.points[v] - corner).norm() / mean_edge(v);
      if (!m_on_boundary[v] && distance <= m_options.corner_reach)
        wishes.push_back({distance, v, corner, -1, 0});
    }
    std::stable_sort(wishes.begin(), wishes.end(),
                     [](const Wish& a, const Wish& b) { return a.distance < b.distance; });
    return wishes;
  }

  // The nearest point of a sharp edge.
  Wish wish_of(int v, const Tree& tree) const {
    const auto found = tree.closest_point_and_primitive(to_kernel(m_mesh.points[v]));
    const auto [curve, segment] = m_segment_of[std::size_t(found.second - m_segments.cbegin())];
    const Point p(found.first.x(), found.first.y(), found.first.z());
    const Surface_curve& c = m_constraints.curves[curve];
    const double t = c.arc[segment] + (p - c.points[segment]).norm();
    return {(m_mesh.points[v] - p).norm() / m_shortest[v], v, p, curve, t};
  }

  std::vector<Wish> wishes_of_all(const Tree& tree) const {
    std::vector<Wish> wishes(m_mesh.points.size());
    for (int v = 0; v < int(wishes.size()); ++v)
      if (!m_quads_of[v].empty()) wishes[v] = wish_of(v, tree);
    return wishes;
  }

  void snap_edges(const Tree& tree) {
    if (m_options.lines) lay_lines(tree);
    std::vector<Wish> near = wishes_of_all(tree);
    note_given(near);
    near.erase(std::remove_if(near.begin(), near.end(),
                              [&](const Wish& w) {
                                return w.vertex < 0 || m_on_boundary[w.vertex] ||
                                       w.distance > m_options.reach;
                              }),
               near.end());
    m_report.vertices = m_report.on_lines + grant(near);
    if (m_options.crossings) snap_crossings(wishes_of_all(tree));
  }

  // Vertices that are held on sharp edges have their places there too, though they do not slide.
  void note_given(const std::vector<Wish>& near) {
    for (const Wish& w : near)
      if (w.vertex >= 0 && m_given[w.vertex] && w.distance < 1e-6)
        m_constraints.places.push_back({w.vertex, w.curve, w.t});
  }

  // Which side of its sharp edge a vertex lies on: 1 or -1; 0 beyond an end.
  int side(const Wish& near) const {
    const Surface_curve& c = m_constraints.curves[near.curve];
    if (!c.closed && (near.t <= 0 || near.t >= c.length())) return 0;
    const Point across = c.normal(near.t).cross(c.tangent(near.t));
    return (m_mesh.points[near.vertex] - near.target).dot(across) < 0 ? -1 : 1;
  }

  // Where an edge crosses a sharp edge between its ends, the nearer of these, or else the other one, comes to
  // lie there.
  void snap_crossings(const std::vector<Wish>& near) {
    std::vector<std::pair<double, std::array<int, 2>>> crossings;
    for (const Quad& quad : m_mesh.quads)
      for (int i = 0; i < 4; ++i) {
        std::array<int, 2> ends{quad[i], quad[(i + 1) % 4]};
        if (ends[0] < ends[1] && crosses(near[ends[0]], near[ends[1]]))
          crossings.push_back({nearer_first(near, ends), ends});
      }
    std::sort(crossings.begin(), crossings.end());
    for (const auto& [distance, ends] : crossings) {
      if (m_held[ends[0]] || m_held[ends[1]]) continue;
      if (grant(near[ends[0]]) || grant(near[ends[1]]))
        ++m_report.vertices;
      else
        ++m_report.missed_crossings;
    }
  }

  bool crosses(const Wish& a, const Wish& b) const {
    if (m_held[a.vertex] || m_held[b.vertex] || m_on_boundary[a.vertex] || m_on_boundary[b.vertex])
      return false;
    if (a.curve != b.curve || side(a) * side(b) != -1) return false;
    const double length = (m_mesh.points[a.vertex] - m_mesh.points[b.vertex]).norm();
    return offset(a) <= length && offset(b) <= length;
  }

  double offset(const Wish& wish) const { return (m_mesh.points[wish.vertex] - wish.target).norm(); }

  // The distance of the nearer end in edges.
  double nearer_first(const std::vector<Wish>& near, std::array<int, 2>& ends) const {
    const double length = (m_mesh.points[ends[0]] - m_mesh.points[ends[1]]).norm();
    if (offset(near[ends[1]]) < offset(near[ends[0]])) std::swap(ends[0], ends[1]);
    return offset(near[ends[0]]) / length;
  }

  void lay_lines(const Tree& tree) {
    std::vector<internal::Feature_seed> seeds;
    for (const Wish& wish : wishes_of_all(tree))
      if (wish.vertex >= 0) seeds.push_back({wish.vertex, wish.curve, wish.t});
    m_report.on_lines += internal::lay_lines_on_features(
        m_mesh, m_projector, m_constraints.curves, seeds, m_options,
        m_line_way.worst.value_or(m_options.worst_jacobian), m_held, m_constraints.places);
    hold_ends();
  }

  // What lies on the end of a sharp edge is held there, and does not slide.
  void hold_ends() {
    const auto is_end = [&](const Vertex_constraints::Place& place) {
      const Surface_curve& c = m_constraints.curves[std::size_t(place.curve)];
      const Point& p = m_mesh.points[std::size_t(place.vertex)];
      if (c.closed || (p != c.points.front() && p != c.points.back())) return false;
      m_constraints.fixed[std::size_t(place.vertex)] = 1;
      return true;
    };
    std::vector<Vertex_constraints::Place>& places = m_constraints.places;
    places.erase(std::remove_if(places.begin(), places.end(), is_end), places.end());
  }

  Quad_mesh& m_mesh;
  const Surface_projector& m_projector;
  const Triangle_surface& m_input;
  const Snap_options& m_options;
  internal::Line_way m_line_way;
  Vertex_constraints& m_constraints;
  std::vector<char> m_given; ///< vertices that were held before
  std::vector<char> m_held;  ///< vertices that stay or have been moved
  std::vector<std::vector<int>> m_quads_of;
  std::vector<double> m_shortest;
  std::vector<char> m_on_boundary;
  std::vector<Point> m_normal; ///< of the surface where each vertex was at first
  double m_mean_edge = 0;
  Segments m_segments;
  std::vector<std::pair<int, int>> m_segment_of; ///< per segment: its curve, and which one of that it is
  std::vector<Point> m_corners;
  std::vector<int> m_chain_of_curve;
  Snap_report m_report;
};

// How far the middle of a diagonal is from the curve that one of its ends lies on, in units of its length;
// large if its ends are not both on curves.
double distance_from_curve(const Quad_mesh& mesh, const Vertex_constraints& constraints,
                           const std::vector<int>& place_of, int a, int b) {
  const auto on_feature = [&](int v) { return place_of[v] >= 0 || constraints.fixed[v]; };
  double least = 1;
  if (!on_feature(a) || !on_feature(b)) return least;
  const Point middle = 0.5 * (mesh.points[a] + mesh.points[b]);
  const double length = (mesh.points[a] - mesh.points[b]).norm();
  for (int v : {a, b}) {
    if (place_of[v] < 0) continue;
    const Vertex_constraints::Place& place = constraints.places[std::size_t(place_of[v])];
    const Surface_curve& curve = constraints.curves[std::size_t(place.curve)];
    const Point p = curve.at(curve.nearest(middle, place.t - length, place.t + length));
    least = std::min(least, (p - middle).norm() / length);
  }
  return least;
}

} // namespace

int turn_to_features(Quad_mesh& mesh, const Vertex_constraints& constraints) {
  std::vector<int> place_of(mesh.points.size(), -1);
  for (std::size_t i = 0; i < constraints.places.size(); ++i)
    place_of[std::size_t(constraints.places[i].vertex)] = int(i);
  int along = 0;
  for (Quad& q : mesh.quads) {
    const double first = distance_from_curve(mesh, constraints, place_of, q[0], q[2]);
    const double second = distance_from_curve(mesh, constraints, place_of, q[1], q[3]);
    if (std::min(first, second) > 0.1) continue;
    ++along;
    if (second < first) std::rotate(q.begin(), q.begin() + 1, q.end());
  }
  return along;
}

Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector, const Snap_options& options,
                             Vertex_constraints& constraints) {
  return snap_to_features(mesh, projector, feature_edges(projector.surface(), options.feature_angle), options,
                          constraints);
}

Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector,
                             const Feature_edges& features, const Snap_options& options,
                             Vertex_constraints& constraints) {
  return Snapper(mesh, projector, options, constraints).run(features, {});
}

Snap_report snap_to_features(Quad_mesh& mesh, const Surface_projector& projector,
                             const Given_features& features, const Snap_options& options,
                             Vertex_constraints& constraints) {
  Snap_options every_chain = options;
  every_chain.shortest_chain = 0;
  return Snapper(mesh, projector, every_chain, constraints).run(features.edges, features.points);
}

Snap_report internal::snap_to_chains(Quad_mesh& mesh, const Surface_projector& projector,
                                     const Chosen_features& features, const Snap_options& options,
                                     const Line_way& lines, Vertex_constraints& constraints,
                                     std::vector<int>& chain_of_curve) {
  Snapper snapper(mesh, projector, options, constraints, lines);
  const Snap_report report =
      snapper.run(features.features->edges, features.features->points, features.is_refused);
  chain_of_curve = snapper.chain_of_curve();
  return report;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
