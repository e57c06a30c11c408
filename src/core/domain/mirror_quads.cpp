// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/mirror_quads.h>

#include "base/diagonal.h"
#include "base/quad_connectivity.h"
#include "base/segments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::source;
using internal::target;

// By the diagonal: boundary vertices lie on the cut's polyline up to rounding.
constexpr double on_the_plane = 1e-7;

// In lengths of the edges around it: a vertex nearer to the plane than the first is brought at least as far
// from it as the second.
constexpr double too_near = 1e-3, lifted = 0.03;

// A scaled Jacobian below which a projected quad is mended.
constexpr double poor_image = 0.2;

// How far the ring along the plane reaches into the quads, in lengths of their edges.
constexpr double ring_width = 1.0 / 3;

// The quads of a half on their way to those of the whole.
class Weld {
public:
  Weld(Finished_design design, const Surface_half& half, double diagonal)
      : m_design(std::move(design)), m_half(half), m_diagonal(diagonal) {}

  Finished_design& design() { return m_design; }

  /// Brings vertices to where the plane's arcs end. Returns whether one had to move.
  bool pin_ends() {
    const Triangle_surface& s = m_half.surface;
    bool moved = false;
    connect();
    for (const int at : arc_ends()) {
      const Point& end = s.points[std::size_t(at)];
      int best = -1;
      double least = std::numeric_limits<double>::infinity();
      for (const int h : m_boundary) {
        const double d = (point(source(quads(), h)) - end).norm();
        if (d < least) {
          least = d;
          best = source(quads(), h);
        }
      }
      if (best < 0) continue;
      m_pinned.push_back(best);
      if (least <= on_the_plane * m_diagonal) continue;
      point(best) = end;
      moved = true;
    }
    return moved;
  }

  /// Finds which edges of the quads lie on the plane, and whether they are as many curves as the cut has.
  Result<void> find_plane() {
    connect();
    m_is_on_plane.assign(mesh().points.size(), 0);
    m_is_plane_edge.assign(m_opposite.size(), 0);
    for (const int h : m_boundary) {
      const Point &a = point(source(quads(), h)), &b = point(target(quads(), h));
      if (!is_near(a) || !is_near(b) || !follows_cut(0.5 * (a + b))) continue;
      m_is_plane_edge[std::size_t(h)] = 1;
      m_is_on_plane[std::size_t(source(quads(), h))] = m_is_on_plane[std::size_t(target(quads(), h))] = 1;
    }
    int curves = 0, arcs = 0;
    std::vector<char> seen(m_opposite.size(), 0);
    for (const int first : m_boundary) {
      int edges = 0, ends = 0, all = 0;
      for (int h = first; !seen[std::size_t(h)]; h = next_on_boundary(h)) {
        seen[std::size_t(h)] = 1;
        ++all;
        edges += m_is_plane_edge[std::size_t(h)];
        ends += m_is_plane_edge[std::size_t(h)] && !m_is_plane_edge[std::size_t(next_on_boundary(h))];
      }
      curves += all > 0 && edges == all;
      arcs += ends;
    }
    if (curves == m_half.curves && (arcs == m_half.arcs || m_design.quads.holes > 0)) return {};
    return make_error(
        Error_code::internal_error,
        "the quads of the half do not follow the plane of the mirror: " + std::to_string(curves) +
            " curves and " + std::to_string(arcs) + " arcs instead of " + std::to_string(m_half.curves) +
            " and " + std::to_string(m_half.arcs));
  }

  /// Whether both sides would share more than vertices and edges on the plane. \pre `find_plane()`
  bool needs_ring() const {
    for (int h = 0; h < int(m_opposite.size()); ++h) {
      const bool a = m_is_on_plane[std::size_t(source(quads(), h))],
                 b = m_is_on_plane[std::size_t(target(quads(), h))];
      if (a && b && !m_is_plane_edge[std::size_t(h)]) return true;
      if (m_is_plane_edge[std::size_t(h)] && m_is_plane_edge[std::size_t(internal::next(h))]) return true;
    }
    for (const Quad& q : quads())
      for (std::size_t i = 0; i < 2; ++i)
        if (m_is_on_plane[std::size_t(q[i])] && m_is_on_plane[std::size_t(q[i + 2])]) return true;
    return false;
  }

  /// Lays a quad along each edge on the plane: the vertices there become inner ones. Returns how many.
  int add_ring() {
    const std::vector<int> valence = valences();
    const std::vector<Point> inward = inward_places();
    std::vector<int> outer(mesh().points.size(), -1);
    for (std::size_t v = 0; v < inward.size(); ++v) {
      if (!m_is_on_plane[v]) continue;
      outer[v] = int(mesh().points.size());
      const Point on = mesh().points[v];
      mesh().points.push_back(on);
      mesh().points[v] = inward[v];
    }
    int added = 0;
    for (std::size_t h = 0; h < m_is_plane_edge.size(); ++h) {
      if (!m_is_plane_edge[h]) continue;
      const int a = source(quads(), int(h)), b = target(quads(), int(h));
      mesh().quads.push_back({outer[std::size_t(a)], outer[std::size_t(b)], b, a});
      const int chart = m_design.quads.chart_of_quad[std::size_t(internal::quad_of(int(h)))];
      m_design.quads.chart_of_quad.push_back(chart);
      ++added;
    }
    for (std::size_t v = 0; v < inward.size(); ++v)
      if (m_is_on_plane[v] && !is_arc_end(int(v))) count(valence[v] + 1);
    for (std::vector<int>* list : {&m_design.quads.held_vertices, &m_pinned})
      for (int& v : *list)
        if (outer[std::size_t(v)] >= 0) v = outer[std::size_t(v)];
    return added;
  }

  /// Relaxes the quads again, with the ends of arcs held.
  Result<void> finish(const Finish_options& options, Observer* observer) {
    const Surface_projector projector(m_half.surface);
    if (!options.relax) {
      for (Point& p : mesh().points) p = projector.closest(p).point;
      return {};
    }
    Finish_options again = options; // of quads that are subdivided already
    again.adaptive.ratio = 1;
    Stitched_mesh quads = m_design.quads;
    quads.held_vertices.insert(quads.held_vertices.end(), m_pinned.begin(), m_pinned.end());
    Result<Finished_design> finished = finish_design(std::move(quads), projector, again, observer);
    if (!finished) return finished.error();
    mesh() = std::move(finished->quads.mesh);
    m_design.relaxation = std::move(finished->relaxation);
    m_design.features = finished->features;
    m_design.guides = std::move(finished->guides);
    return {};
  }

  /// Relaxation may leave a vertex on the border of the half that belongs inside, where it would meet its
  /// image: it gets the place beside the plane where its worst quad is best. With all of them on one side,
  /// two quads of different sides meet in the plane only.
  void lift() {
    std::vector<std::vector<int>> quads_at(mesh().points.size());
    std::vector<double> size(mesh().points.size(), 0);
    for (int h = 0; h < 4 * int(quads().size()); ++h) {
      const std::size_t v = std::size_t(source(quads(), h));
      quads_at[v].push_back(internal::quad_of(h));
      size[v] += (point(target(quads(), h)) - mesh().points[v]).norm();
    }
    std::optional<Surface_projector> projector;
    for (std::size_t v = 0; v < size.size(); ++v) {
      if (m_is_on_plane[v] || quads_at[v].empty()) continue;
      size[v] /= double(quads_at[v].size());
      if (m_half.plane.signed_distance(mesh().points[v]) > too_near * size[v]) continue;
      if (!projector) projector.emplace(m_half.surface);
      lift(v, size[v], quads_at[v], *projector);
    }
  }

  /// The quads and their images. \pre `find_plane()`, and not `needs_ring()`
  Mirrored_design doubled(int ring_quads) {
    Mirrored_design result;
    result.ring_quads = ring_quads;
    const Mirror_grid grid(m_half.plane, m_half.surface.points);
    const std::vector<int> valence = valences();
    Stitched_mesh& q = m_design.quads;
    for (auto& [v, number] : q.valences) number *= 2;
    const int n = int(mesh().points.size()), m = int(mesh().quads.size());
    for (int v = 0; v < n; ++v) {
      Point& p = mesh().points[std::size_t(v)];
      const bool on = m_is_on_plane[std::size_t(v)];
      p = grid.rounded(on ? m_half.plane.projected(p) : p);
      result.image.push_back(v);
      result.on_plane += on;
      if (on && !is_arc_end(v)) count(2 * valence[std::size_t(v)] - 2);
    }
    for (int v = 0; v < n; ++v) {
      if (m_is_on_plane[std::size_t(v)]) continue;
      result.image[std::size_t(v)] = int(mesh().points.size());
      result.image.push_back(v);
      mesh().points.push_back(m_half.plane.reflected(Point(mesh().points[std::size_t(v)])));
    }
    const std::vector<int>& image = result.image;
    for (int i = 0; i < m; ++i) {
      const Quad quad = mesh().quads[std::size_t(i)];
      mesh().quads.push_back({image[std::size_t(quad[0])], image[std::size_t(quad[3])],
                              image[std::size_t(quad[2])], image[std::size_t(quad[1])]});
      q.chart_of_quad.push_back(q.chart_of_quad[std::size_t(i)]);
    }
    double_lists(image);
    result.whole = std::move(m_design);
    return result;
  }

private:
  Quad_mesh& mesh() { return m_design.quads.mesh; }
  const Quad_mesh& mesh() const { return m_design.quads.mesh; }
  const std::vector<Quad>& quads() const { return m_design.quads.mesh.quads; }
  Point& point(int v) { return mesh().points[std::size_t(v)]; }

  void connect() {
    internal::connect_quads(quads(), int(mesh().points.size()), m_opposite);
    m_boundary.clear();
    for (int h = 0; h < int(m_opposite.size()); ++h)
      if (m_opposite[std::size_t(h)] < 0) m_boundary.push_back(h);
  }

  double worst_of(const std::vector<int>& list) const {
    double worst = 1;
    for (const int q : list) {
      const Quad& c = quads()[std::size_t(q)];
      const std::vector<Point>& p = mesh().points;
      worst = std::min(worst, scaled_jacobian(p[std::size_t(c[0])], p[std::size_t(c[1])],
                                              p[std::size_t(c[2])], p[std::size_t(c[3])]));
    }
    return worst;
  }

  void lift(std::size_t v, double size, const std::vector<int>& around, const Surface_projector& projector) {
    const Point from = mesh().points[v], n = m_half.plane.normal;
    const Point side = n.unitOrthogonal(), other = n.cross(side);
    Point best = from;
    double best_quality = -std::numeric_limits<double>::infinity();
    for (const double up : {0.05, 0.1, 0.2, 0.4, 0.8})
      for (int i = 0; i <= 16; ++i) {
        const double angle = i * std::acos(-1.0) / 4, way = i == 16 ? 0 : i < 8 ? 0.25 : 0.6;
        const Point target =
            from + size * (up * n + way * (std::cos(angle) * side + std::sin(angle) * other));
        mesh().points[v] = projector.closest(target).point;
        if (m_half.plane.signed_distance(mesh().points[v]) < lifted * size) continue;
        const double quality = worst_of(around);
        if (quality <= best_quality) continue;
        best_quality = quality;
        best = mesh().points[v];
      }
    mesh().points[v] = best;
  }

  // Of a boundary halfedge the one that follows it around the mesh.
  int next_on_boundary(int h) const {
    for (h = internal::next(h); m_opposite[std::size_t(h)] >= 0;)
      h = internal::next(m_opposite[std::size_t(h)]);
    return h;
  }

  bool is_near(const Point& p) const {
    return std::abs(m_half.plane.signed_distance(p)) <= on_the_plane * m_diagonal;
  }

  // Whether the boundary edge of the half that is nearest to a point is one of the cut.
  bool follows_cut(const Point& p) const {
    if (m_half.arcs == 0) return true;
    const Triangle_surface& s = m_half.surface;
    double cut = std::numeric_limits<double>::infinity(), own = cut;
    for (int h = 0; h < s.number_of_halfedges(); ++h) {
      if (!s.is_boundary(h)) continue;
      double& least = m_half.on_plane[std::size_t(h)] ? cut : own;
      least = std::min(least, squared_distance_to_segment(p, s.points[std::size_t(s.source(h))],
                                                          s.points[std::size_t(s.target(h))]));
    }
    return cut <= own;
  }

  std::vector<int> arc_ends() const {
    std::vector<int> ends;
    for (const std::vector<int>& loop : boundary_loops(m_half.surface))
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int h = loop[i], following = loop[(i + 1) % loop.size()];
        if (m_half.on_plane[std::size_t(h)] != m_half.on_plane[std::size_t(following)])
          ends.push_back(m_half.surface.target(h));
      }
    return ends;
  }

  // Whether a vertex on the plane also has an edge of another boundary: of the surface's own, or of a hole.
  bool is_arc_end(int v) const {
    return std::any_of(m_boundary.begin(), m_boundary.end(), [&](int h) {
      return !m_is_plane_edge[std::size_t(h)] && (source(quads(), h) == v || target(quads(), h) == v);
    });
  }

  std::vector<int> valences() const {
    std::vector<int> valence(mesh().points.size(), 0);
    for (int h = 0; h < int(m_opposite.size()); ++h) {
      if (m_opposite[std::size_t(h)] >= 0 && m_opposite[std::size_t(h)] < h) continue;
      ++valence[std::size_t(source(quads(), h))];
      ++valence[std::size_t(target(quads(), h))];
    }
    return valence;
  }

  // Regular vertices are counted only where all are.
  void count(int valence) {
    std::map<int, int>& all = m_design.quads.valences;
    if (valence != 4 || all.count(4)) ++all[valence];
  }

  // Where the vertices on the plane go to make room for a ring.
  std::vector<Point> inward_places() const {
    const std::size_t n = mesh().points.size();
    std::vector<Point> sum(n, Point::Zero()), across(n, Point::Zero());
    std::vector<int> number(n, 0), quads_at(n, 0);
    for (int h = 0; h < int(m_opposite.size()); ++h) {
      const std::size_t a = std::size_t(source(quads(), h)), b = std::size_t(target(quads(), h));
      across[a] += mesh().points[std::size_t(target(quads(), internal::next(h)))];
      ++quads_at[a];
      if (m_is_plane_edge[std::size_t(h)] || m_opposite[std::size_t(h)] > h) continue;
      sum[a] += mesh().points[b];
      sum[b] += mesh().points[a];
      ++number[a];
      ++number[b];
    }
    std::vector<Point> places = mesh().points;
    for (std::size_t v = 0; v < n; ++v) {
      if (!m_is_on_plane[v]) continue;
      const Point inner = number[v] > 0 ? Point(sum[v] / number[v]) : Point(across[v] / quads_at[v]);
      places[v] += ring_width * (inner - places[v]);
    }
    return places;
  }

  void double_lists(const std::vector<int>& image) {
    Stitched_mesh& q = m_design.quads;
    for (std::vector<int>* list : {&q.extraordinary, &q.interpolated}) {
      const std::vector<int> half = *list;
      for (int v : half)
        if (image[std::size_t(v)] != v) list->push_back(image[std::size_t(v)]);
    }
    q.t_junctions *= 2;
    q.holes *= 2;
    m_design.subdivided_quads *= 2;
    m_design.t_junctions *= 2;
    if (q.holes > 0) q.components = internal::quad_components(q.mesh.quads, int(q.mesh.points.size()));
  }

  Finished_design m_design;
  const Surface_half& m_half;
  double m_diagonal;
  std::vector<int> m_opposite, m_boundary, m_pinned;
  std::vector<char> m_is_on_plane, m_is_plane_edge;
};

// Moves images by as much as the surface there differs from the image of the surface here: a vertex that has
// left the surface stays off. What that inverts is mended, by moves of the images alone.
Result<void> project(Mirrored_design& design, const Mirror_plane& plane, const Surface_projector& whole,
                     double diagonal, const Finish_options& options, Observer* observer) {
  Quad_mesh& mesh = design.whole.quads.mesh;
  const std::vector<Point> reflected = mesh.points;
  std::vector<char> fixed(mesh.points.size(), 1);
  for (std::size_t v = 0; v < design.image.size(); ++v) {
    const std::size_t w = std::size_t(design.image[v]);
    if (w <= v) continue;
    fixed[w] = 0;
    const Point foot = plane.reflected(whole.closest(mesh.points[v]).point);
    mesh.points[w] += whole.closest(foot).point - foot;
  }
  const bool is_worse = std::any_of(mesh.quads.begin(), mesh.quads.end(), [&](const Quad& q) {
    const auto quality = [&](const std::vector<Point>& p) {
      return scaled_jacobian(p[std::size_t(q[0])], p[std::size_t(q[1])], p[std::size_t(q[2])],
                             p[std::size_t(q[3])]);
    };
    return quality(mesh.points) < poor_image && quality(reflected) >= poor_image;
  });
  if (is_worse && options.relax) {
    Relax_options mending = options.relaxation;
    mending.iterations = mending.more_iterations = 0;
    mending.wanted = std::min(mending.wanted, poor_image);
    Result<Relax_report> mended = relax_quads(mesh, whole, Vertex_constraints(fixed), mending, observer);
    if (!mended) return mended.error();
  }
  for (std::size_t v = 0; v < reflected.size(); ++v)
    design.largest_shift = std::max(design.largest_shift, (mesh.points[v] - reflected[v]).norm() / diagonal);
  return {};
}

} // namespace

Result<Mirrored_design> mirror_design(Finished_design half_design, const Surface_half& half,
                                      const Surface_projector& whole, Mirror_positions positions,
                                      const Finish_options& options, Observer* observer) {
  const double diagonal = internal::diagonal_of(half.surface.points);
  Weld weld(std::move(half_design), half, diagonal);
  bool unfinished = half.arcs > 0 && weld.pin_ends();
  if (Result<void> found = weld.find_plane(); !found) return found.error();
  int ring_quads = 0;
  if (weld.needs_ring()) {
    ring_quads = weld.add_ring();
    unfinished = true;
  }
  if (unfinished) {
    if (Result<void> finished = weld.finish(options, observer); !finished) return finished.error();
    if (Result<void> found = weld.find_plane(); !found) return found.error();
  }
  weld.lift();
  Mirrored_design result = weld.doubled(ring_quads);
  if (positions != Mirror_positions::projected) return result;
  if (Result<void> done = project(result, half.plane, whole, diagonal, options, observer); !done)
    return done.error();
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
