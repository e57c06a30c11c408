// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/feature_lines.h"
#include "relax/quad_shape.h"

#include "base/quad_connectivity.h"
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// A line is cut so often at most where it makes quads too bad.
constexpr int most_cuts = 12;

// Vertices give way that are so many edges away, for each edge that a line may be moved.
constexpr double rings_per_reach = 4;

// Sweeps that spread the way of a line over the rings around it, the first time and later.
constexpr int sweeps_per_ring = 8, most_sweeps = 120, few_sweeps = 8;

// A straight line of edges along a part of a curve. Arc lengths ascend; on closed curves they may leave [0,
// length).
struct Line {
  int curve = -1;
  std::vector<int> vertices;
  std::vector<double> t;
  double score = 0;

  int size() const { return int(vertices.size()); }
  void add(int v, double at) {
    vertices.push_back(v);
    t.push_back(at);
  }
};

class Lines {
public:
  Lines(Quad_mesh& mesh, const Surface_projector& projector, const std::vector<Surface_curve>& curves,
        const Snap_options& options, double worst, std::vector<char>& held,
        std::vector<Vertex_constraints::Place>& places, const Line_choice& choice)
      : m_mesh(mesh), m_projector(projector), m_curves(curves), m_options(options), m_choice(choice),
        m_worst(worst), m_held(held), m_places(places), m_outgoing(mesh.points.size(), -1),
        m_valence(mesh.points.size(), 0), m_edge(mesh.points.size(), 0), m_boundary(mesh.points.size(), 0),
        m_ends(curves.size(), {-1, -1}), m_taken(curves.size()), m_index(mesh.points.size(), -1),
        m_rings(std::max(4, int(std::lround(rings_per_reach * options.line_reach)))) {
    connect_quads(mesh.quads, int(mesh.points.size()), m_opposite);
    for (int h = 0; h < int(m_opposite.size()); ++h) {
      const int a = from(h), b = to(h);
      if (m_outgoing[a] < 0) m_outgoing[a] = h;
      m_edge[a] += (mesh.points[a] - mesh.points[b]).norm();
      ++m_valence[a];
      if (m_opposite[h] < 0) m_boundary[a] = m_boundary[b] = 1;
    }
    for (std::size_t v = 0; v < m_edge.size(); ++v)
      if (m_valence[v] > 0) m_edge[v] /= m_valence[v];
    for (int v = 0; v < int(held.size()); ++v)
      if (held[v]) note_end(v);
  }

  int run(const std::vector<Feature_seed>& seeds) {
    std::vector<Line> lines;
    std::vector<char> seen(m_opposite.size(), 0);
    for (const Feature_seed& seed : seeds) {
      const int h = along(seed);
      if (h < 0 || seen[h]) continue;
      lines.push_back(grow(seed, h, seen));
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Line& a, const Line& b) { return a.score > b.score; });
    int laid = 0;
    for (const Line& line : lines)
      for (Line& part : free_parts(line)) laid += lay(std::move(part));
    return laid;
  }

private:
  int from(int h) const { return source(m_mesh.quads, h); }
  int to(int h) const { return target(m_mesh.quads, h); }
  const Surface_curve& curve(const Line& line) const { return m_curves[line.curve]; }
  double distance(int c, int v, double t) const { return (m_curves[c].at(t) - m_mesh.points[v]).norm(); }

  // A vertex may lie on ends of curves.
  void note_end(int v) {
    for (std::size_t c = 0; c < m_curves.size(); ++c) {
      if (m_curves[c].closed) continue;
      if (m_mesh.points[v] == m_curves[c].points.front()) m_ends[c][0] = v;
      if (m_mesh.points[v] == m_curves[c].points.back()) m_ends[c][1] = v;
    }
  }

  template <class Use> void for_each_outgoing(int v, const Use& use) const {
    int h = m_outgoing[v];
    for (int i = 0; i < m_valence[v] && h >= 0; ++i) {
      use(h);
      h = m_opposite[previous(h)];
    }
  }

  // The halfedge out of a vertex that goes with the curve, or -1.
  int along(const Feature_seed& seed) const {
    if (m_boundary[seed.vertex] ||
        distance(seed.curve, seed.vertex, seed.t) > m_options.line_reach * m_edge[seed.vertex])
      return -1;
    const Point tangent = m_curves[seed.curve].tangent(seed.t);
    int best = -1;
    double most = m_choice.least_cosine;
    for_each_outgoing(seed.vertex, [&](int h) {
      const Point way = m_mesh.points[to(h)] - m_mesh.points[seed.vertex];
      if (const double cosine = way.dot(tangent) / way.norm(); cosine > most && goes_right(seed, to(h))) {
        most = cosine;
        best = h;
      }
    });
    return best;
  }

  // Whether an edge belongs to the family of lines that is wanted.
  bool goes_right(const Feature_seed& seed, int w) const {
    if (m_choice.way == Guide_way::nearer || m_choice.flow.empty()) return true;
    const std::vector<Point>& points = m_choice.unbent ? *m_choice.unbent : m_mesh.points;
    const Point way = points[w] - points[seed.vertex];
    const Surface_curve& c = m_curves[seed.curve];
    const double at = seed.t / c.length() * double(m_choice.flow.size() - 1);
    const std::size_t i = std::size_t(std::clamp(std::lround(at), 0L, long(m_choice.flow.size()) - 1));
    const double along = std::abs(way.dot(m_choice.flow[i])) / way.norm();
    return (along * along > 0.5) == (m_choice.way == Guide_way::flow);
  }

  // The halfedge that goes straight on from the target of one, or -1.
  int straight(int h) const {
    const int v = to(h);
    return m_boundary[v] || m_valence[v] != 4 ? -1 : next(m_opposite[next(h)]);
  }

  // Goes on by halfedges as long as they follow the curve.
  template <class Seen>
  Line follow(const Feature_seed& seed, int h, bool forward, double rest, Seen seen) const {
    Line line;
    line.curve = seed.curve;
    const Surface_curve& c = curve(line);
    double t = seed.t;
    for (; h >= 0; h = straight(h)) {
      const int w = to(h);
      const double length = (m_mesh.points[w] - m_mesh.points[from(h)]).norm();
      const double there =
          c.nearest(m_mesh.points[w], forward ? t : t - 2 * length, forward ? t + 2 * length : t);
      seen(h);
      if (m_boundary[w] || std::abs(there - t) < 0.4 * length ||
          distance(line.curve, w, there) > m_options.line_reach * m_edge[w] ||
          (c.closed && std::abs(there - seed.t) > rest - 0.5 * m_edge[w]))
        break;
      line.add(w, t = there);
    }
    return line;
  }

  Line grow(const Feature_seed& seed, int start, std::vector<char>& seen) const {
    const double length = m_curves[seed.curve].length();
    Line line = follow(seed, start, true, length, [&](int h) { seen[h] = 1; });
    const double rest = length - (line.t.empty() ? 0 : line.t.back() - seed.t);
    const int arriving = m_valence[seed.vertex] == 4 ? m_opposite[start] : -1;
    const Line back = follow(seed, arriving < 0 ? -1 : straight(arriving), false, rest, [&](int h) {
      if (m_opposite[h] >= 0) seen[m_opposite[h]] = 1;
    });
    Line all;
    all.curve = seed.curve;
    for (int i = back.size(); i-- > 0;) all.add(back.vertices[i], back.t[i]);
    all.add(seed.vertex, seed.t);
    for (int i = 0; i < line.size(); ++i) all.add(line.vertices[i], line.t[i]);
    for (int i = 0; i + 1 < all.size(); ++i)
      all.score += (all.t[i + 1] - all.t[i]) * (1 - 0.4 * distance(all.curve, all.vertices[i], all.t[i]) /
                                                        (m_options.line_reach * m_edge[all.vertices[i]]));
    return all;
  }

  // The parts of a line whose vertices may still be moved and whose part of the curve no line has.
  std::vector<Line> free_parts(const Line& line) const {
    std::vector<Line> parts(1);
    for (int i = 0; i < line.size(); ++i) {
      const int v = line.vertices[i];
      const bool stays = m_held[v] && distance(line.curve, v, line.t[i]) > 1e-6 * m_edge[v];
      if (stays || (is_taken(line.curve, v, line.t[i]) && !is_end_of_line(line.curve, v, line.t[i])))
        parts.emplace_back();
      else
        parts.back().add(v, line.t[i]);
    }
    for (Line& part : parts) part.curve = line.curve;
    return parts;
  }

  bool is_taken(int c, int v, double t) const {
    const double turn = m_curves[c].closed ? m_curves[c].length() : 0, margin = 0.7 * m_edge[v];
    for (const auto& [low, high] : m_taken[c])
      for (double s : {t - turn, t, t + turn})
        if (s > low - margin && s < high + margin) return true;
    return false;
  }

  // Whether another line may go on from a vertex that lies on a curve.
  bool is_end_of_line(int c, int v, double t) const {
    if (!m_choice.joins || !m_held[v] || distance(c, v, t) > 1e-6 * m_edge[v]) return false;
    const double turn = m_curves[c].closed ? m_curves[c].length() : 0, near = 1e-3 * m_edge[v];
    for (const auto& [low, high] : m_taken[c])
      for (double s : {t - turn, t, t + turn})
        if (std::abs(s - low) < near || std::abs(s - high) < near) return true;
    return false;
  }

  int lay(Line line) {
    int laid = 0;
    for (int round = 0; round <= most_cuts; ++round) {
      to_corners(line);
      if (line.size() < 3) break;
      const std::vector<int> around = draw_along(line);
      const std::vector<char> bad = bad_vertices(line, around);
      const bool good = std::find(bad.begin(), bad.end(), 1) == bad.end();
      if (good) {
        for (int v : around) m_mesh.points[v] = m_moved[std::size_t(m_index[v])];
        for (int i = 0; i < line.size(); ++i) laid += hold(line.vertices[i], line.curve, line.t[i]);
        note_end(line.vertices.front());
        note_end(line.vertices.back());
        m_taken[line.curve].push_back({line.t.front(), line.t.back()});
      }
      for (int v : around) m_index[v] = -1;
      if (good) break;
      line = longest_part(line, bad);
    }
    return laid;
  }

  bool hold(int v, int c, double t) {
    if (m_held[v]) return false;
    m_held[v] = 1;
    const double length = m_curves[c].length();
    m_places.push_back({v, c, m_curves[c].closed ? t - length * std::floor(t / length) : t});
    return true;
  }

  // Ends near the ends of the curve come to lie there, unless another vertex does; the others are spread.
  void to_corners(Line& line) const {
    if (!curve(line).closed) {
      if (line.size() > 1 && line.t[0] < m_choice.end_reach * (line.t[1] - line.t[0])) to_end(line, 0, 0, 0);
      const int last = line.size() - 1;
      const double rest = last < 1 ? 0 : curve(line).length() - line.t[last];
      if (last > 0 && rest < m_choice.end_reach * (line.t[last] - line.t[last - 1]))
        to_end(line, last, 1, curve(line).length());
    }
    for (int sweep = 0; sweep < 5; ++sweep)
      for (int i = 1; i + 1 < line.size(); ++i)
        if (!m_held[line.vertices[i]]) line.t[i] = 0.5 * line.t[i] + 0.25 * (line.t[i - 1] + line.t[i + 1]);
  }

  void to_end(Line& line, int i, int end, double t) const {
    const int v = line.vertices[i], there = m_ends[line.curve][end];
    if (there >= 0 && there != v) {
      line.vertices.erase(line.vertices.begin() + i);
      line.t.erase(line.t.begin() + i);
    } else if (!m_held[v])
      line.t[i] = t;
  }

  // Where the vertices of a line and those around it come to lie: `m_moved`, in the order of the vertices
  // that it returns.
  std::vector<int> draw_along(const Line& line) {
    std::vector<int> around = line.vertices;
    m_moved.clear();
    for (int i = 0; i < line.size(); ++i) m_index[line.vertices[i]] = i;
    find_around(around);
    for (int v : around) m_moved.push_back(m_mesh.points[v]);
    std::vector<int> faces(around.size(), -1);
    const int steps = steps_of(line);
    std::vector<Point> way(around.size(), Point::Zero());
    for (int step = 0; step < steps; ++step) {
      const bool is_last = step + 1 == steps;
      for (int i = 0; i < line.size(); ++i)
        if (!m_held[line.vertices[i]])
          way[i] = (curve(line).at(line.t[i]) - m_moved[i]) / double(steps - step);
      // Every step goes nearly the same way as the one before.
      give_way(line, around, way, step == 0 ? std::min(sweeps_per_ring * m_rings, most_sweeps) : few_sweeps);
      for (std::size_t i = 0; i < around.size(); ++i) {
        if (i < line.vertices.size() && (is_last || m_held[line.vertices[i]])) {
          if (!m_held[line.vertices[i]]) m_moved[i] = curve(line).at(line.t[i]);
          continue;
        }
        if (faces[i] < 0) faces[i] = m_projector.closest(m_moved[i]).face;
        const Closest_point found = m_projector.closest_nearby(m_moved[i] + way[i], faces[i]);
        m_moved[i] = found.point;
        faces[i] = found.face;
      }
    }
    return around;
  }

  // In how many steps a line comes onto its curve.
  int steps_of(const Line& line) const {
    if (!(m_choice.step > 0)) return 1;
    double most = 0;
    for (int i = 0; i < line.size(); ++i) {
      const int v = line.vertices[i];
      most = std::max(most, distance(line.curve, v, line.t[i]) / m_edge[v]);
    }
    return std::max(1, int(std::ceil(most / m_choice.step)));
  }

  // The vertices in the rings around a line that may move.
  void find_around(std::vector<int>& around) {
    std::size_t begin = 0;
    for (int ring = 0; ring < m_rings; ++ring) {
      const std::size_t end = around.size();
      for (; begin < end; ++begin)
        for_each_outgoing(around[begin], [&](int h) {
          const int w = to(h);
          if (m_index[w] >= 0 || m_boundary[w] || m_held[w]) return;
          m_index[w] = int(around.size());
          around.push_back(w);
        });
    }
  }

  // The ways of the vertices around a line, by those of its own.
  void give_way(const Line& line, const std::vector<int>& around, std::vector<Point>& way, int sweeps) const {
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t i = line.vertices.size(); i < around.size(); ++i) {
        Point sum = Point::Zero();
        for_each_outgoing(around[i], [&](int h) {
          if (m_index[to(h)] >= 0) sum += way[std::size_t(m_index[to(h)])];
        });
        way[i] = sum / m_valence[around[i]];
      }
  }

  // The vertices of a line, by their places in it, that make a quad too bad.
  std::vector<char> bad_vertices(const Line& line, const std::vector<int>& around) const {
    std::vector<char> bad(line.vertices.size(), 0);
    for (int v : around)
      for_each_outgoing(v, [&](int h) {
        std::array<Point, 4> before, after;
        for (int i = 0; i < 4; ++i) {
          const int w = m_mesh.quads[std::size_t(quad_of(h))][std::size_t(i)];
          before[i] = m_mesh.points[w];
          after[i] = m_index[w] < 0 ? before[i] : m_moved[std::size_t(m_index[w])];
        }
        const double quality = quad_shape(after[0], after[1], after[2], after[3]);
        if (quality >= m_worst) return;
        if (quality > 0 && quality >= quad_shape(before[0], before[1], before[2], before[3])) return;
        mark_nearest(line, before, bad);
      });
    return bad;
  }

  void mark_nearest(const Line& line, const std::array<Point, 4>& quad, std::vector<char>& bad) const {
    const Point centre = 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
    std::size_t best = 0;
    double least = -1;
    for (std::size_t i = 0; i < bad.size(); ++i)
      if (const double d = (m_mesh.points[line.vertices[i]] - centre).squaredNorm(); least < 0 || d < least) {
        least = d;
        best = i;
      }
    bad[best] = 1;
  }

  static Line longest_part(const Line& line, const std::vector<char>& bad) {
    int best = 0, most = 0;
    for (int i = 0, first = 0; i <= line.size(); ++i)
      if (i == line.size() || bad[i]) {
        if (i - first > most) {
          most = i - first;
          best = first;
        }
        first = i + 1;
      }
    Line part;
    part.curve = line.curve;
    for (int i = best; i < best + most; ++i) part.add(line.vertices[i], line.t[i]);
    return part;
  }

  Quad_mesh& m_mesh;
  const Surface_projector& m_projector;
  const std::vector<Surface_curve>& m_curves;
  const Snap_options& m_options;
  const Line_choice& m_choice;
  double m_worst;
  std::vector<char>& m_held;
  std::vector<Vertex_constraints::Place>& m_places;
  std::vector<int> m_opposite, m_outgoing, m_valence;
  std::vector<double> m_edge; ///< mean length at each vertex
  std::vector<char> m_boundary;
  std::vector<std::array<int, 2>> m_ends;                      ///< per curve: the vertices on its ends, or -1
  std::vector<std::vector<std::pair<double, double>>> m_taken; ///< per curve: what lines have
  std::vector<int> m_index;                                    ///< in what is moved at present, or -1
  std::vector<Point> m_moved;
  int m_rings; ///< of vertices around a line that give way
};

} // namespace

int lay_lines_on_features(Quad_mesh& mesh, const Surface_projector& projector,
                          const std::vector<Surface_curve>& curves, const std::vector<Feature_seed>& seeds,
                          const Snap_options& options, double worst, std::vector<char>& held,
                          std::vector<Vertex_constraints::Place>& places, const Line_choice& choice) {
  return Lines(mesh, projector, curves, options, worst, held, places, choice).run(seeds);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
